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

AnnealedPosition anneal_position(const RegionPositions& positions, double most,
                                 const PositionBenefit& benefit_of,
                                 const AnnealingOptions& options) {
  RandomNumbers random(options.seed);
  AnnealedPosition result;
  Point current = options.start.value_or(positions.random(random));
  double current_benefit = -1;
  for (std::size_t i = 0; i < options.evaluations; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(options.evaluations);
    const Point next =
        i == 0 ? current : positions.near(current, between(kFirstStep, kLastStep, share), random);
    const double chance = random.open_unit();
    const std::optional<double> benefit = benefit_of(next);
    if (!benefit) continue;
    ++result.evaluations;
    if (result.records.empty() || *benefit > result.benefit) {
      result.records.push_back(next);
      result.benefit = *benefit;
    }
    const double temperature = most * between(kFirstTemperature, kLastTemperature, share);
    if (*benefit >= current_benefit ||
        chance < std::exp((*benefit - current_benefit) / temperature)) {
      current = next;
      current_benefit = *benefit;
    }
    if (result.benefit >= most) break;
  }
  return result;
}

AnnealedPosition anneal_position(const RegionViews& views, std::size_t region,
                                 const ColumnWeights& weights, const AnnealingOptions& options) {
  std::vector<BitRows::Word> row(weights.mask.size());
  const auto weight_seen = [&](const Point& position) -> std::optional<double> {
    if (!views.is_free(region, position)) return std::nullopt;
    std::ranges::fill(row, BitRows::Word{0});
    views.look(region, position, row, weights.mask);
    return weights.of(row);
  };
  return anneal_position(views.positions(region), weights.of(views.matrix().bits.row(region)),
                         weight_seen, options);
}

}  // namespace viewcover
