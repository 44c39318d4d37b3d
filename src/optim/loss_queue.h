#pragma once

#include <cstdint>
#include <vector>

namespace viewcover {

/// Rows in the order in which they are given up: least loss first, of equal losses the one that has
/// been there longest. A binary heap that knows where every row is.
/// Not safe for concurrent use; every operation but top() costs O(log #rows in it).
class LossQueue {
 public:
  using Index = std::uint32_t;
  using Loss = std::int64_t;

  explicit LossQueue(std::size_t rows) : place_(rows, kNowhere) {}

  bool empty() const { return heap_.empty(); }
  Index top() const { return heap_.front().row; }
  bool contains(Index row) const { return place_[row] != kNowhere; }

  /// `since`: when the row was chosen; different for different rows.
  void push(Index row, Loss loss, std::uint64_t since);
  void erase(Index row);
  /// Nothing happens if the row is not in the queue.
  void change(Index row, Loss loss);

 private:
  struct Entry {
    Loss loss;
    std::uint64_t since;
    Index row;

    bool before(const Entry& other) const {
      return loss != other.loss ? loss < other.loss : since < other.since;
    }
  };
  static constexpr Index kNowhere = ~Index{0};

  void put(std::size_t place, const Entry& entry);
  /// Moves an entry to where it belongs, starting at a free place.
  void settle(std::size_t place, Entry entry);

  std::vector<Entry> heap_;
  std::vector<Index> place_;
};

}  // namespace viewcover
