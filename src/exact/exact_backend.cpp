#include "exact/exact_backend.h"

#include <array>

#include "exact/sight_decision.h"
#include "exact/view_cone.h"
#include "exact/witness_search.h"
#include "links/random_segments.h"

namespace viewcover {
namespace {

// Random segments before a decision: enough for most pairs that see each other, and little beside
// a decision.
constexpr int kSegments = 16;
// Cells that a shaft may cost that will be subdivided anyway: hidden once is hidden for all parts.
constexpr std::uint64_t kCheapCells = 1000;
// From a viewpoint a decision costs less.
constexpr int kSegmentsFromPoint = 8;

using Surfaces = SmallList<std::span<const Point>, 96>;

/// The surfaces left in a shaft, without clusters that were not opened.
Surfaces surfaces_in(const Shaft& shaft) {
  const auto nodes = shaft.occluder_set().clusters().nodes();
  Surfaces surfaces;
  for (const ShaftOccluder& occluder : shaft.occluders()) {
    const ClusterTree::Node& node = nodes[occluder.node];
    if (node.is_leaf()) surfaces.push_back(shaft.occluder_set().polygon(OccluderId(node.first)));
  }
  return surfaces;
}

}  // namespace

Verdict ExactBackend::decide(const Shaft& shaft, Effort effort) const {
  const SegmentCounts segments = try_random_segments(shaft, {.most = kSegments, .seed = seed_});
  const Surfaces surfaces = surfaces_in(shaft);
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
  add(statistics);
  return verdict;
}

bool ExactBackend::sees_part(const PointShaft& shaft) const {
  if (shaft.occluders().empty()) return true;
  if (try_random_segments(shaft, {.most = kSegmentsFromPoint, .seed = seed_}).free > 0) {
    add(kSeenByRandomSegment);
    return true;
  }
  Surfaces surfaces;
  for (const OccluderId occluder : shaft.occluders()) {
    surfaces.push_back(shaft.occluder_set().polygon(occluder));
  }
  ExactStatistics statistics;
  const bool seen =
      exact::sees_part(shaft.viewpoint(), shaft.element().polygon, surfaces, statistics);
  add(kSeenOrNotByCells);
  add(statistics);
  return seen;
}

std::optional<SightLine> ExactBackend::find_sight_line(const Shaft& shaft) const {
  const SegmentCounts segments = try_random_segments(shaft, {.most = kSegments, .seed = seed_});
  if (segments.sight_line) return segments.sight_line;
  const Surfaces surfaces = surfaces_in(shaft);
  const ShaftPolygons polygons{shaft.region().polygon, shaft.element().polygon, surfaces,
                               shaft.one_sided()};
  const SightAnswer answer = exact::decide_shaft(polygons);
  add(answer.statistics);
  if (!answer.witness) return std::nullopt;
  return SightLine{weighted_point(polygons.region, answer.witness->region_weights),
                   weighted_point(polygons.element, answer.witness->element_weights)};
}

void ExactBackend::add(const ExactStatistics& statistics) const {
  add(kSingleSigns, statistics.single_signs);
  add(kFilteredSigns, statistics.filtered_signs);
  add(kFixedWidthSigns, statistics.fixed_width_signs);
  add(kQuadSigns, statistics.quad_signs);
  add(kBigIntegerSigns, statistics.big_integer_signs);
  add(kCells, statistics.cells);
  add(kSplits, statistics.splits);
}

std::vector<std::pair<std::string, std::uint64_t>> ExactBackend::statistics() const {
  constexpr std::array<const char*, kCountKinds> kNames = {"decided_by_random_segment",
                                                           "decided_by_cells",
                                                           "left_open",
                                                           "witnesses_confirmed",
                                                           "witnesses_not_found",
                                                           "seen_by_random_segment",
                                                           "seen_or_not_by_cells",
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
