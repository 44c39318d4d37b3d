#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "exact/statistics.h"
#include "links/shaft.h"
#include "links/visibility_backend.h"

namespace viewcover {

/// Exact visibility (papers/exact.md): every verdict is a theorem. Random segments answer for most
/// pairs that see each other; what they leave open is decided by subtracting blocking cones in
/// Pluecker space.
///
/// Shafts that will be subdivided anyway are decided as far as that is cheap; at the subdivision
/// limit always. Cost: bench/exact.txt. Thread-safe.
class ExactBackend final : public VisibilityBackend {
 public:
  /// `seed`: of the run, for the random segments. No verdict but the choice between kFullyVisible
  /// and kVisibleWitness depends on it.
  explicit ExactBackend(std::uint64_t seed) : seed_(seed) {}

  std::string_view name() const override { return "exact"; }
  Guarantee guarantee() const override { return Guarantee::kExact; }
  Verdict decide(const Shaft& shaft, Effort effort) const override;
  bool sees_part(const PointShaft& shaft) const override;
  std::optional<SightLine> find_sight_line(const Shaft& shaft) const override;
  std::vector<std::pair<std::string, std::uint64_t>> statistics() const override;

 private:
  enum Count : std::size_t {
    kDecidedByRandomSegment,
    kDecidedByCells,
    kLeftOpen,
    kWitnessesConfirmed,
    kWitnessesNotFound,
    kSeenByRandomSegment,
    kSeenOrNotByCells,
    kSingleSigns,
    kFilteredSigns,
    kFixedWidthSigns,
    kQuadSigns,
    kBigIntegerSigns,
    kCells,
    kSplits,
    kCountKinds
  };
  void add(Count what, std::uint64_t count = 1) const {
    counts_[what].fetch_add(count, std::memory_order_relaxed);
  }
  void add(const ExactStatistics& statistics) const;

  std::uint64_t seed_;
  mutable std::array<std::atomic<std::uint64_t>, kCountKinds> counts_{};
};

}  // namespace viewcover
