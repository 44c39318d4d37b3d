#include "links/link_set.h"

#include <cassert>
#include <optional>
#include <utility>

namespace viewcover {
namespace {

constexpr std::uint32_t kMore = 0x80;

// In groups of 7 bits, the lowest first.
template <class Bytes>
void put(Bytes& bytes, std::uint64_t number) {
  using Byte = typename Bytes::value_type;
  for (; number >= kMore; number >>= 7) {
    bytes.push_back(static_cast<Byte>(static_cast<std::uint8_t>(number | kMore)));
  }
  bytes.push_back(static_cast<Byte>(static_cast<std::uint8_t>(number)));
}

std::uint32_t take(const std::vector<std::uint8_t>& bytes, std::size_t& at) {
  std::uint32_t number = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint32_t byte = bytes[at++];
    number |= (byte & (kMore - 1)) << shift;
    if (byte < kMore) return number;
  }
}

/// Ascending ids by what they are beyond the one before.
template <class Bytes>
void put_list(Bytes& bytes, std::span<const OccluderId> ids) {
  std::uint32_t next = 0;
  for (const OccluderId id : ids) {
    assert(id.value >= next);
    put(bytes, id.value - next);
    next = id.value + 1;
  }
}

template <class Owner>
void put_node(std::string& bytes, QuadAddress<Owner> node) {
  put(bytes, std::uint64_t{node.owner().value} + 1);
  put(bytes, static_cast<std::uint64_t>(node.level()));
  put(bytes, node.path());
}

/// Takes numbers off the front of bytes that need not be any.
class NumberReader {
 public:
  explicit NumberReader(std::string_view bytes) : bytes_(bytes) {}

  bool at_end() const { return bytes_.empty(); }
  std::optional<std::uint64_t> number() {
    std::uint64_t number = 0;
    for (int shift = 0; shift < 64 && !bytes_.empty(); shift += 7) {
      const auto byte = static_cast<std::uint8_t>(bytes_.front());
      bytes_.remove_prefix(1);
      number |= static_cast<std::uint64_t>(byte & (kMore - 1)) << shift;
      if (byte < kMore) return number;
    }
    return std::nullopt;
  }
  template <class Owner>
  std::optional<QuadAddress<Owner>> node() {
    const auto owner = number(), level = number(), path = number();
    return path ? QuadAddress<Owner>::from_file(*owner, *level, *path) : std::nullopt;
  }

 private:
  std::string_view bytes_;
};

}  // namespace

void LinkSet::add(const Link& link, std::span<const OccluderId> occluders) {
  assert(is_visible(link.verdict));
  links_.push_back({link.region, link.element, packed_lists_.size(), link.verdict});
  count(link.verdict);
  put_list(packed_lists_, occluders);
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

std::string LinkSet::to_bytes(std::size_t first) const {
  std::string bytes;
  for (std::size_t i = first; i < size(); ++i) {
    put_node(bytes, links_[i].region);
    put_node(bytes, links_[i].element);
    put(bytes, static_cast<std::uint64_t>(links_[i].verdict));
    const std::vector<OccluderId> list = occluders(i);
    put(bytes, list.size());
    put_list(bytes, list);
  }
  return bytes;
}

bool LinkSet::add_bytes(std::string_view bytes) {
  NumberReader reader(bytes);
  std::vector<OccluderId> list;
  while (!reader.at_end()) {
    const auto region = reader.node<PartId>();
    const auto element = reader.node<SurfaceId>();
    const auto verdict = reader.number(), occluders = reader.number();
    if (!region || !element || !occluders || *verdict >= kVerdictCount ||
        !is_visible(static_cast<Verdict>(*verdict))) {
      return false;
    }
    list.clear();
    std::uint64_t next = 0;
    for (std::uint64_t i = 0; i < *occluders; ++i) {
      const auto step = reader.number();
      if (!step || *step > UINT32_MAX || next + *step > UINT32_MAX) return false;
      list.emplace_back(static_cast<std::size_t>(next + *step));
      next += *step + 1;
    }
    add({*region, *element, static_cast<Verdict>(*verdict)}, list);
  }
  return true;
}

std::size_t LinkSet::memory_bytes() const {
  return links_.capacity() * sizeof(Stored) + packed_lists_.capacity();
}

}  // namespace viewcover
