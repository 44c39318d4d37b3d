#include "full_coverage/position_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <functional>

#include "viewpoints/position_annealing.h"

namespace viewcover {
namespace {

/// Positions tried for what is still unseen: random ones in each region; the best are annealed.
constexpr std::size_t kRandomPositions = 4, kAnnealed = 16, kEvaluations = 64;
/// Special positions near an annealed one that are looked round, too.
constexpr std::size_t kBestSpecial = 3;
constexpr std::size_t kMostPoolLooks = 400, kMostAimed = 64;

}  // namespace

double PositionSearch::value_of(const Viewpoint& viewpoint,
                                std::span<const WeightedPlace> places) const {
  double value = 0;
  for (const WeightedPlace& place : places) {
    if (views_.region_sees(viewpoint.region, place.place.column) &&
        witnesses_.is_seen(viewpoint.position, place.place)) {
      value += place.weight;
    }
  }
  return value;
}

std::vector<ValuedViewpoint> PositionSearch::anneal_in(std::size_t region,
                                                       std::optional<Point> start,
                                                       std::span<const WeightedPlace> places,
                                                       std::uint64_t seed) const {
  std::vector<WeightedPlace> seen;
  double most = 0;
  for (const WeightedPlace& place : places) {
    if (!views_.region_sees(region, place.place.column)) continue;
    seen.push_back(place);
    most += place.weight;
  }
  std::vector<ValuedViewpoint> found;
  if (seen.empty()) return found;
  const auto value = [&](const Point& position) -> std::optional<double> {
    if (!views_.is_free(region, position)) return std::nullopt;
    return value_of({position, region}, seen);
  };
  const AnnealedPosition annealed =
      anneal_position(views_.positions(region), most, value,
                      {.seed = seed, .evaluations = kEvaluations, .start = start});
  if (annealed.records.empty()) return found;
  const Viewpoint best{annealed.records.back(), region};
  found.push_back({best, annealed.benefit});
  std::vector<ValuedViewpoint> special;
  const auto add = [&](const Viewpoint& viewpoint) {
    special.push_back({viewpoint, value_of(viewpoint, places)});
  };
  std::ranges::for_each(special_.near(best), add);
  std::ranges::stable_sort(special, std::greater(), &ValuedViewpoint::value);
  special.resize(std::min(special.size(), kBestSpecial));
  for (const ValuedViewpoint& valued : std::vector(special)) {
    std::ranges::for_each(special_.beside(valued.viewpoint), add);
  }
  for (const ValuedViewpoint& valued : special) {
    if (valued.value >= annealed.benefit) found.push_back(valued);
  }
  std::ranges::stable_sort(found, std::greater(), &ValuedViewpoint::value);
  return found;
}

std::vector<std::vector<ValuedViewpoint>> PositionSearch::anneal(
    std::span<const std::size_t> regions, std::span<const WeightedPlace> places,
    std::uint64_t seed) {
  std::vector<std::vector<ValuedViewpoint>> found(regions.size());
  tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t i) {
    if (limits_.due()) return;
    found[i] = anneal_in(regions[i], std::nullopt, places, mixed(seed + i + 1));
  });
  looked_ += regions.size() * kEvaluations;
  return found;
}

/// Goes down to a part of a region that sees the place until a position in it does.
std::optional<Viewpoint> PositionSearch::position_that_sees(const ElementTarget& place) const {
  constexpr int kDeepest = 8;
  for (std::size_t i = 0; i < views_.region_count(); ++i) {
    if (!views_.region_sees(i, place.column)) continue;
    RegionCell cell{views_.region().address(i), i, views_.positions(i).region()};
    if (!views_.cell_sees_place(cell, place)) continue;
    for (int depth = 0; depth < kDeepest; ++depth) {
      const Point middle = views_.positions(i).nearest(cell.shape.middle());
      if (witnesses_.is_seen(middle, place) && views_.is_free(i, middle)) {
        return Viewpoint{middle, i};
      }
      if (cell.address.level() == kMaxSubdivisionLevel) break;
      const std::array<RegionShape, 4> quarters = cell.shape.quarters();
      int digit = 0;
      while (digit < 4 && !views_.cell_sees_place({cell.address.child(digit), i,
                                                   quarters[static_cast<std::size_t>(digit)]},
                                                  place)) {
        ++digit;
      }
      if (digit == 4) break;
      cell = {cell.address.child(digit), i, quarters[static_cast<std::size_t>(digit)]};
    }
  }
  return std::nullopt;
}

std::vector<ValuedViewpoint> PositionSearch::best(std::span<const WeightedPlace> places,
                                                  const WitnessPool& pool, double worth_aiming) {
  const std::uint64_t seed = next_seed();
  std::vector<ValuedViewpoint> tried(views_.region_count() * kRandomPositions);
  tbb::parallel_for(std::size_t{0}, tried.size(), [&](std::size_t job) {
    const std::size_t region = job / kRandomPositions;
    RandomNumbers random(mixed(seed + job));
    const Viewpoint viewpoint{views_.positions(region).random(random), region};
    if (!views_.is_free(region, viewpoint.position) || limits_.due()) return;
    tried[job] = {viewpoint, value_of(viewpoint, places)};
  });
  const std::size_t step = 1 + pool.size() / kMostPoolLooks;
  std::vector<ValuedViewpoint> known((pool.size() + step - 1) / step);
  tbb::parallel_for(std::size_t{0}, known.size(), [&](std::size_t i) {
    known[i] = {pool[i * step], value_of(pool[i * step], places)};
  });
  tried.insert(tried.end(), known.begin(), known.end());
  // What nothing sees by chance is looked for.
  std::vector<WeightedPlace> hard;
  for (const WeightedPlace& place : places) {
    if (place.weight < worth_aiming || hard.size() == kMostAimed) {
      break;
    }
    hard.push_back(place);
  }
  std::vector<ValuedViewpoint> aimed(hard.size());
  tbb::parallel_for(std::size_t{0}, hard.size(), [&](std::size_t i) {
    const bool is_seen = std::ranges::any_of(tried, [&](const ValuedViewpoint& valued) {
      return valued.value > 0 && witnesses_.is_seen(valued.viewpoint.position, hard[i].place);
    });
    if (is_seen || limits_.due()) return;
    if (const auto viewpoint = position_that_sees(hard[i].place)) {
      aimed[i] = {*viewpoint, value_of(*viewpoint, places)};
    }
  });
  tried.insert(tried.end(), aimed.begin(), aimed.end());
  std::erase_if(tried, [](const ValuedViewpoint& valued) { return valued.value == 0; });
  std::ranges::stable_sort(tried, std::greater(), &ValuedViewpoint::value);
  looked_ += tried.size();

  std::vector<ValuedViewpoint> starts;
  for (const ValuedViewpoint& valued : tried) {
    if (starts.size() == kAnnealed) break;
    if (std::ranges::none_of(starts, [&](const ValuedViewpoint& start) {
          return start.viewpoint.region == valued.viewpoint.region;
        })) {
      starts.push_back(valued);
    }
  }
  std::vector<std::vector<ValuedViewpoint>> annealed(starts.size());
  tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t i) {
    if (limits_.due()) return;
    annealed[i] = anneal_in(starts[i].viewpoint.region, starts[i].viewpoint.position, places,
                            mixed(seed + tried.size() + i));
  });
  looked_ += starts.size() * kEvaluations;
  for (const auto& found : annealed) tried.insert(tried.end(), found.begin(), found.end());
  std::ranges::stable_sort(tried, std::greater(), &ValuedViewpoint::value);
  return tried;
}

}  // namespace viewcover
