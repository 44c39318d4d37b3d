#include "optim/loss_queue.h"

#include <cassert>

namespace viewcover {

void LossQueue::push(Index row, Loss loss, std::uint64_t since) {
  assert(!contains(row));
  heap_.emplace_back();
  settle(heap_.size() - 1, {loss, since, row});
}

void LossQueue::erase(Index row) {
  assert(contains(row));
  const std::size_t place = place_[row];
  place_[row] = kNowhere;
  const Entry last = heap_.back();
  heap_.pop_back();
  if (last.row != row) settle(place, last);
}

void LossQueue::change(Index row, Loss loss) {
  if (!contains(row)) return;
  Entry entry = heap_[place_[row]];
  entry.loss = loss;
  settle(place_[row], entry);
}

void LossQueue::put(std::size_t place, const Entry& entry) {
  heap_[place] = entry;
  place_[entry.row] = static_cast<Index>(place);
}

void LossQueue::settle(std::size_t place, Entry entry) {
  while (place > 0 && entry.before(heap_[(place - 1) / 2])) {
    put(place, heap_[(place - 1) / 2]);
    place = (place - 1) / 2;
  }
  for (std::size_t child = 2 * place + 1; child < heap_.size(); child = 2 * place + 1) {
    if (child + 1 < heap_.size() && heap_[child + 1].before(heap_[child])) ++child;
    if (!heap_[child].before(entry)) break;
    put(place, heap_[child]);
    place = child;
  }
  put(place, entry);
}

}  // namespace viewcover
