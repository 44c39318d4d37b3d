#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace viewcover::exact {

// Sets of numbers, as sorted vectors.

inline bool contains(const std::vector<std::size_t>& list, std::size_t value) {
  return std::binary_search(list.begin(), list.end(), value);
}

inline void insert(std::vector<std::size_t>& list, std::size_t value) {
  const auto place = std::lower_bound(list.begin(), list.end(), value);
  if (place == list.end() || *place != value) list.insert(place, value);
}

}  // namespace viewcover::exact
