#include "viewpoints/position_annealing.h"

#include <algorithm>
#include <cmath>

namespace viewcover {
namespace {

// Steps, as shares of the region's extent, and temperatures, as shares of the most that the region
// could add.
constexpr double kFirstStep = 0.5, kLastStep = 0.01;
constexpr double kFirstTemperature = 0.05, kLastTemperature = 0.001;

double between(double first, double last, double share) {
  return first * std::pow(last / first, share);
}

}  // namespace

AnnealedPosition anneal_position(const RegionViews& views, std::size_t region,
                                 const ColumnWeights& weights, const AnnealingOptions& options) {
  RandomNumbers random(options.seed);
  const RegionPositions& positions = views.positions(region);
  const double most = weights.of(views.matrix().bits.row(region));
  std::vector<BitRows::Word> row(weights.mask.size());
  AnnealedPosition result;
  Point current = options.start.value_or(positions.random(random));
  double current_benefit = -1;
  for (std::size_t i = 0; i < options.evaluations; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(options.evaluations);
    const Point next =
        i == 0 ? current : positions.near(current, between(kFirstStep, kLastStep, share), random);
    const double chance = random.open_unit();
    if (!views.is_free(region, next)) continue;
    std::ranges::fill(row, BitRows::Word{0});
    views.look(region, next, row, weights.mask);
    ++result.evaluations;
    const double benefit = weights.of(row);
    if (result.records.empty() || benefit > result.benefit) {
      result.records.push_back(next);
      result.benefit = benefit;
    }
    const double temperature = most * between(kFirstTemperature, kLastTemperature, share);
    if (benefit >= current_benefit ||
        chance < std::exp((benefit - current_benefit) / temperature)) {
      current = next;
      current_benefit = benefit;
    }
    if (result.benefit >= most) break;
  }
  return result;
}

}  // namespace viewcover
