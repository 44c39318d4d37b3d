#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <span>

namespace viewcover {

/// A sequence that keeps up to N values without allocating, and reads as a span.
template <class T, std::size_t N>
class SmallList : public boost::container::small_vector<T, N> {
 public:
  using boost::container::small_vector<T, N>::small_vector;
  operator std::span<const T>() const { return {this->data(), this->size()}; }
};

}  // namespace viewcover
