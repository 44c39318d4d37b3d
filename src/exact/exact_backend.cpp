#include "exact/exact_backend.h"

#include <array>

#include "exact/sight_decision.h"
#include "exact/witness_search.h"
#include "links/random_segments.h"

namespace viewcover {
namespace {

// Random segments before a decision: enough for most pairs that see each other, and little beside
// a decision.
constexpr int kSegments = 16;
// Cells that a shaft may cost that will be subdivided anyway: hidden once is hidden for all parts.
constexpr std::uint64_t kCheapCells = 1000;

}  // namespace

Verdict ExactBackend::decide(const Shaft& shaft, Effort effort) const {
  const SegmentCounts segments = try_random_segments(shaft, {.most = kSegments, .seed = seed_});
  const auto nodes = shaft.occluder_set().clusters().nodes();
  SmallList<std::span<const Point>, 96> surfaces;
  for (const ShaftOccluder& occluder : shaft.occluders()) {
    const ClusterTree::Node& node = nodes[occluder.node];
    if (node.is_leaf()) surfaces.push_back(shaft.occluder_set().polygon(OccluderId(node.first)));
  }
  const bool all_open = surfaces.size() == shaft.occluders().size();
  if (segments.free > 0) {
    add(kDecidedByRandomSegment);
    return Verdict::kVisibleWitness;
  }
  if (surfaces.empty()) {
    add(kLeftOpen);
    return Verdict::kAssumedVisible;
  }
  const ShaftPolygons polygons{shaft.region().polygon, shaft.element().polygon, surfaces,
                               shaft.one_sided()};
  ExactStatistics statistics;
  exact::LinePool pool(statistics);
  RandomNumbers random(seed_);
  const Verdict verdict = exact::decide_by_cells(
      pool, polygons,
      {.known_blocked = true,  // culling leaves only what meets the shaft
       .may_be_blocked = !all_open,
       .most_cells = effort == Effort::kCheap ? kCheapCells : exact::kAnyNumberOfCells},
      [&](const exact::ShaftPart& part, const exact::LineCell& cell,
          const exact::RealLineBracket& bracket) {
        const bool confirmed =
            exact::witness_in_cell(polygons, part, cell, bracket, random, statistics).has_value();
        add(confirmed ? kWitnessesConfirmed : kWitnessesNotFound);
      });
  add(verdict == Verdict::kAssumedVisible ? kLeftOpen : kDecidedByCells);
  add(kSingleSigns, statistics.single_signs);
  add(kFilteredSigns, statistics.filtered_signs);
  add(kFixedWidthSigns, statistics.fixed_width_signs);
  add(kQuadSigns, statistics.quad_signs);
  add(kBigIntegerSigns, statistics.big_integer_signs);
  add(kCells, statistics.cells);
  add(kSplits, statistics.splits);
  return verdict;
}

std::vector<std::pair<std::string, std::uint64_t>> ExactBackend::statistics() const {
  constexpr std::array<const char*, kCountKinds> kNames = {"decided_by_random_segment",
                                                           "decided_by_cells",
                                                           "left_open",
                                                           "witnesses_confirmed",
                                                           "witnesses_not_found",
                                                           "single_signs",
                                                           "filtered_signs",
                                                           "fixed_width_signs",
                                                           "quad_signs",
                                                           "big_integer_signs",
                                                           "cells",
                                                           "splits"};
  std::vector<std::pair<std::string, std::uint64_t>> result;
  for (std::size_t i = 0; i < kCountKinds; ++i) result.emplace_back(kNames[i], counts_[i].load());
  return result;
}

}  // namespace viewcover
