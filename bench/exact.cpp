// The exact backend: random soups as in the design's figures, cost against the number of occluders,
// and a living room beside random rays. Every program run prints ratios taken within it.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <vector>

#include "approx/ray_backend.h"
#include "exact/exact_backend.h"
#include "exact/sight_query.h"
#include "links/refine.h"
#include "support/generated.h"
#include "support/random_queries.h"

namespace {

using namespace viewcover;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// As in Haumont et al. (2005). The same for the same trial.
SightQuery soup(std::size_t triangles, double least, double most, std::uint64_t trial) {
  RandomNumbers random(mixed(trial) ^ triangles);
  return testing::random_soup(random, {triangles, triangles, least, most});
}

void report_stages(benchmark::State& state, const ExactStatistics& sum, double queries) {
  const double in_floats = static_cast<double>(sum.single_signs + sum.filtered_signs),
               signs = in_floats + static_cast<double>(sum.fixed_width_signs + sum.quad_signs +
                                                       sum.big_integer_signs);
  state.counters["cells"] = static_cast<double>(sum.cells) / queries;
  state.counters["splits"] = static_cast<double>(sum.splits) / queries;
  state.counters["signs"] = signs / queries;
  state.counters["beyond_single_%"] =
      100 * (signs - static_cast<double>(sum.single_signs)) / std::max(signs, 1.0);
  state.counters["beyond_double_%"] = 100 * (signs - in_floats) / std::max(signs, 1.0);
}

/// Arguments: triangles, least and most radius in thousandths. Time is the mean of a query.
void soups(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const double least = 1e-3 * static_cast<double>(state.range(1)),
               most = 1e-3 * static_cast<double>(state.range(2));
  std::uint64_t trial = 0;
  double hidden = 0, slowest = 0, queries = 0;
  ExactStatistics sum;
  for (auto _ : state) {
    const SightQuery query = soup(count, least, most, ++trial);
    const auto start = Clock::now();
    const SightAnswer answer = decide_from_region(query);
    const double seconds = seconds_since(start);
    state.SetIterationTime(seconds);
    slowest = std::max(slowest, seconds);
    hidden += !is_visible(answer.verdict);
    sum += answer.statistics;
    ++queries;
  }
  report_stages(state, sum, queries);
  state.counters["hidden_%"] = 100 * hidden / queries;
  state.counters["slowest_ms"] = 1e3 * slowest;
}
BENCHMARK(soups)
    ->ArgNames({"triangles", "least", "most"})
    ->Args({20, 100, 600})
    ->Args({40, 100, 600})
    ->Args({60, 100, 600})
    ->Args({80, 100, 600})
    ->Args({300, 50, 300})
    ->Args({300, 75, 450})
    ->Args({1000, 40, 240})
    ->Iterations(60)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

/// Cost against the occluders that matter. Arguments: triangles, and their least radius in
/// ten-thousandths, a sixth of the largest: such that about half of the pairs are hidden, by all
/// triangles together. `exponent`: e in time ~ n^e against the first size of this run.
void growth(benchmark::State& state) {
  static std::map<std::int64_t, double> mean_by_size;
  const auto count = static_cast<std::size_t>(state.range(0));
  const double radius = 1e-4 * static_cast<double>(state.range(1));
  std::uint64_t trial = 0;
  double total = 0, queries = 0, hidden = 0;
  ExactStatistics sum;
  for (auto _ : state) {
    const SightQuery query = soup(count, radius, 6 * radius, ++trial);
    const auto start = Clock::now();
    const SightAnswer answer = decide_from_region(query);
    const double seconds = seconds_since(start);
    state.SetIterationTime(seconds);
    sum += answer.statistics;
    hidden += !is_visible(answer.verdict);
    total += seconds;
    ++queries;
  }
  report_stages(state, sum, queries);
  state.counters["hidden_%"] = 100 * hidden / queries;
  mean_by_size[state.range(0)] = total / queries;
  const auto& [first_size, first_mean] = *mean_by_size.begin();
  if (state.range(0) != first_size) {
    state.counters["exponent"] =
        std::log(total / queries / first_mean) /
        std::log(static_cast<double>(state.range(0)) / static_cast<double>(first_size));
  }
}
BENCHMARK(growth)
    ->ArgNames({"occluders", "least"})
    ->Args({10, 2600})
    ->Args({30, 1510})
    ->Args({100, 915})
    ->Args({300, 587})
    ->Args({1000, 364})
    ->Iterations(60)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

/// Living room of 316 polygons, 64 regions, elements to 0.1 m2; argument: threads. The two backends
/// in turn, so that a change in the machine's speed meets both: the ratio is exact to rays.
void living_room_exact_beside_rays(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
  const testing::LoadedScene loaded = testing::load_generated(living_room(RoomDetail::kSimple), 64);
  const ClusterTree clusters(loaded.scene);
  const auto seconds_with = [&](const VisibilityBackend& backend) {
    const auto start = Clock::now();
    benchmark::DoNotOptimize(
        refine(loaded.scene, clusters, loaded.region, backend, {.element_area = 0.1}).size());
    return seconds_since(start);
  };
  std::vector<double> ratios;
  for (auto _ : state) {
    const ExactBackend exact(1);
    const double rays = seconds_with(RayBackend({.rays = 1024}));
    const double with_exact = seconds_with(exact);
    state.SetIterationTime(with_exact);
    ratios.push_back(with_exact / rays);
    for (const auto& [name, count] : exact.statistics()) {
      state.counters[name] = static_cast<double>(count);
    }
  }
  std::sort(ratios.begin(), ratios.end());
  state.counters["least_ratio"] = ratios.front();
  state.counters["median_ratio"] = ratios[ratios.size() / 2];
  state.counters["most_ratio"] = ratios.back();
}
BENCHMARK(living_room_exact_beside_rays)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

}  // namespace

BENCHMARK_MAIN();
