#include "links/link_set.h"

#include <cassert>
#include <utility>

namespace viewcover {
namespace {

constexpr std::uint32_t kMore = 0x80;

void put(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
  for (; number >= kMore; number >>= 7) {
    bytes.push_back(static_cast<std::uint8_t>(number | kMore));
  }
  bytes.push_back(static_cast<std::uint8_t>(number));
}

std::uint32_t take(const std::vector<std::uint8_t>& bytes, std::size_t& at) {
  std::uint32_t number = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint32_t byte = bytes[at++];
    number |= (byte & (kMore - 1)) << shift;
    if (byte < kMore) return number;
  }
}

}  // namespace

void LinkSet::add(const Link& link, std::span<const OccluderId> occluders) {
  assert(is_visible(link.verdict));
  links_.push_back({link.region, link.element, packed_lists_.size(), link.verdict});
  count(link.verdict);
  std::uint32_t next = 0;
  for (const OccluderId id : occluders) {
    assert(id.value >= next);
    put(packed_lists_, id.value - next);
    next = id.value + 1;
  }
}

void LinkSet::append(LinkSet&& other) {
  if (links_.empty() && packed_lists_.empty()) {
    links_ = std::move(other.links_);
    packed_lists_ = std::move(other.packed_lists_);
  } else {
    const std::size_t offset = packed_lists_.size();
    for (Stored link : other.links_) {
      link.list_begin += offset;
      links_.push_back(link);
    }
    packed_lists_.insert(packed_lists_.end(), other.packed_lists_.begin(),
                         other.packed_lists_.end());
  }
  for (std::size_t v = 0; v < kVerdictCount; ++v) verdicts_[v] += other.verdicts_[v];
  other = LinkSet();
}

Link LinkSet::operator[](std::size_t index) const {
  const Stored& link = links_[index];
  return {link.region, link.element, link.verdict};
}

std::vector<OccluderId> LinkSet::occluders(std::size_t index) const {
  std::vector<OccluderId> list;
  std::size_t at = links_[index].list_begin;
  const std::size_t end =
      index + 1 < links_.size() ? links_[index + 1].list_begin : packed_lists_.size();
  std::uint32_t next = 0;
  while (at < end) {
    const std::uint32_t id = next + take(packed_lists_, at);
    list.emplace_back(id);
    next = id + 1;
  }
  return list;
}

std::size_t LinkSet::memory_bytes() const {
  return links_.capacity() * sizeof(Stored) + packed_lists_.capacity();
}

}  // namespace viewcover
