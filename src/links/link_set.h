#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "links/verdict.h"
#include "scene/address.h"
#include "scene/types.h"

namespace viewcover {

/// A visible pair of a region node and an element node (paper, section 2.2).
struct Link {
  RegionAddress region;
  ElementAddress element;
  Verdict verdict = Verdict::kAssumedVisible;
};

/// All links of a run with their occluder lists, in the order of refinement, and the count of each
/// kind of verdict. The same for any number of threads.
///
/// Occluder lists are kept packed (ascending differences in 7-bit groups): 32 bytes a link and
/// about 1 byte an occluder. Reading is safe from several threads.
class LinkSet {
 public:
  /// `occluders` ascending.
  void add(const Link& link, std::span<const OccluderId> occluders);
  /// Counts a verdict that makes no link.
  void count(Verdict verdict) { ++verdicts_[static_cast<std::size_t>(verdict)]; }
  /// Appends `other`, which is left empty.
  void append(LinkSet&& other);

  std::size_t size() const { return links_.size(); }
  Link operator[](std::size_t index) const;
  /// The surfaces that may block the link's shaft, ascending places in the cluster tree.
  std::vector<OccluderId> occluders(std::size_t index) const;
  std::uint64_t verdicts(Verdict verdict) const {
    return verdicts_[static_cast<std::size_t>(verdict)];
  }
  /// Links [first, size()) with their lists as bytes, for files.
  std::string to_bytes(std::size_t first) const;
  /// Appends what to_bytes made and counts its verdicts; false, with some of it appended, for bytes
  /// that are none.
  bool add_bytes(std::string_view bytes);
  void set_verdicts(Verdict verdict, std::uint64_t count) {
    verdicts_[static_cast<std::size_t>(verdict)] = count;
  }

  /// Bytes held, lists included.
  std::size_t memory_bytes() const;

 private:
  struct Stored {
    RegionAddress region;
    ElementAddress element;
    std::uint64_t list_begin = 0;
    Verdict verdict = Verdict::kAssumedVisible;
  };
  std::vector<Stored> links_;
  std::vector<std::uint8_t> packed_lists_;
  std::array<std::uint64_t, kVerdictCount> verdicts_{};
};

}  // namespace viewcover
