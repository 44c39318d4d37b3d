#include "viewpoints/sight_line_starts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace viewcover {
namespace {

/// Positions for each sight line, and how far the second one may be, as a share of the region; each
/// further one is nearer.
constexpr int kPositions = 6;
constexpr double kFarthest = 0.1;

}  // namespace

std::vector<Look> starts_of_sight_lines(const RegionViews& views, std::span<const SeenPair> pairs,
                                        std::uint64_t seed) {
  std::vector<std::vector<Look>> found(pairs.size());
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
    const auto [region, column] = pairs[i];
    const std::optional<SightLine> line = views.find_sight_line(region, column);
    if (!line) return;
    RandomNumbers random(mixed(mixed(seed ^ region) + column));
    const RegionPositions& positions = views.positions(region);
    Point position = positions.nearest(line->from);
    const Point start = position;
    for (int k = 0; k < kPositions; ++k) {
      found[i].push_back({region, position, ElementTarget{column, line->to}});
      position = positions.near(start, std::ldexp(kFarthest, -2 * k), random);
    }
  });
  std::vector<Look> looks;
  for (const auto& some : found) looks.insert(looks.end(), some.begin(), some.end());
  return looks;
}

std::vector<SeenPair> pairs_of_column(const RegionViews& views, std::size_t column,
                                      std::span<const std::size_t> first, std::size_t most) {
  std::vector<SeenPair> pairs;
  std::vector<std::size_t> others;
  const BitRows& bits = views.matrix().bits;
  for (std::size_t region = 0; region < bits.rows(); ++region) {
    if (!bits.test(region, column)) continue;
    if (std::ranges::binary_search(first, region) && pairs.size() < most) {
      pairs.push_back({region, column});
    } else {
      others.push_back(region);
    }
  }
  const std::size_t more = std::min(most - pairs.size(), others.size());
  for (std::size_t i = 0; i < more; ++i) {
    pairs.push_back({others[i * others.size() / more], column});
  }
  return pairs;
}

}  // namespace viewcover
