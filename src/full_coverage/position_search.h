#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "full_coverage/special_positions.h"
#include "full_coverage/witness_pool.h"
#include "optim/search_limits.h"

namespace viewcover {

/// A place and what seeing it is worth.
struct WeightedPlace {
  ElementTarget place;
  double weight = 0;
};

struct ValuedViewpoint {
  Viewpoint viewpoint;
  double value = 0;
};

/// Looks for positions that see much of given places, in parallel. The same positions for the same
/// seed and calls, whatever the threads, unless the limits expire.
class PositionSearch {
 public:
  /// All are kept by reference.
  PositionSearch(const RegionViews& views, const Witnesses& witnesses, const SearchLimits& limits,
                 std::uint64_t seed)
      : views_(views), witnesses_(witnesses), limits_(limits), special_(views), seed_(seed) {}

  const SpecialPositions& special() const { return special_; }
  /// Positions looked from so far.
  std::uint64_t looked() const { return looked_; }
  /// A seed of its own for each call.
  std::uint64_t next_seed() { return seed_ + (++jobs_ << 32); }

  /// The weight of the places that are seen.
  double value_of(const Viewpoint& viewpoint, std::span<const WeightedPlace> places) const;
  /// Positions that see something, best first: random ones in all regions, some of the pool, some
  /// aimed at places of `worth_aiming` that none of these sees, the best of them annealed.
  /// `places`: the heaviest first.
  std::vector<ValuedViewpoint> best(std::span<const WeightedPlace> places, const WitnessPool& pool,
                                    double worth_aiming);
  /// For each of the regions, annealing from a random position; as anneal_in.
  std::vector<std::vector<ValuedViewpoint>> anneal(std::span<const std::size_t> regions,
                                                   std::span<const WeightedPlace> places,
                                                   std::uint64_t seed);

 private:
  /// Annealing in a region for the places that it sees, then the special positions near the best.
  std::vector<ValuedViewpoint> anneal_in(std::size_t region, std::optional<Point> start,
                                         std::span<const WeightedPlace> places,
                                         std::uint64_t seed) const;
  std::optional<Viewpoint> position_that_sees(const ElementTarget& place) const;

  const RegionViews& views_;
  const Witnesses& witnesses_;
  const SearchLimits& limits_;
  SpecialPositions special_;
  std::uint64_t seed_, jobs_ = 0, looked_ = 0;
};

}  // namespace viewcover
