// Hierarchical visibility with random rays: living rooms on one thread and on two, and growth with
// the size of the scene. Time is wall time of the cluster tree and refinement together.

#include "links/refine.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <chrono>
#include <cmath>
#include <map>

#include "approx/ray_backend.h"
#include "support/generated.h"

namespace {

using namespace viewcover;
using testing::load_generated;
using testing::LoadedScene;

double element_area_or_default(const LoadedScene& loaded, double element_area) {
  return element_area > 0 ? element_area : default_element_area(loaded.scene);
}

LinkSet solve_visibility(const LoadedScene& loaded, double element_area) {
  const ClusterTree clusters(loaded.scene);
  const RayBackend backend({.rays = 16});
  return refine(loaded.scene, clusters, loaded.region, backend,
                {.element_area = element_area_or_default(loaded, element_area)});
}

void report(benchmark::State& state, const LoadedScene& loaded, const LinkSet& links) {
  state.counters["polygons"] = static_cast<double>(loaded.scene.surfaces.size());
  state.counters["links"] = static_cast<double>(links.size());
  state.counters["bytes/link"] =
      static_cast<double>(links.memory_bytes()) / static_cast<double>(links.size());
}

/// Arguments: threads, regions, 0 for the simple and 1 for the complex room.
void living_rooms(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
  const LoadedScene loaded =
      load_generated(living_room(state.range(2) == 0 ? RoomDetail::kSimple : RoomDetail::kComplex),
                     static_cast<std::size_t>(state.range(1)));
  LinkSet links;
  for (auto _ : state) links = solve_visibility(loaded, 0.1);
  report(state, loaded, links);
}
BENCHMARK(living_rooms)
    ->ArgNames({"threads", "regions", "complex"})
    ->Args({1, 64, 0})
    ->Args({2, 64, 0})
    ->Args({1, 256, 1})
    ->Args({2, 256, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

/// The two thread counts in turn, so that a change in the machine's speed meets both: the median
/// ratio of their times is the speed-up.
void speedup_of_two_threads(benchmark::State& state) {
  const LoadedScene loaded = load_generated(living_room(RoomDetail::kComplex), 256);
  const auto seconds_with = [&](std::size_t count) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, count);
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(solve_visibility(loaded, 0.1).size());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  std::vector<double> ratios;
  for (auto _ : state) ratios.push_back(seconds_with(1) / seconds_with(2));
  std::sort(ratios.begin(), ratios.end());
  state.counters["least"] = ratios.front();
  state.counters["median"] = ratios[ratios.size() / 2];
  state.counters["most"] = ratios.back();
}
BENCHMARK(speedup_of_two_threads)->Iterations(9)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Argument: triangles. `exponent`: e in time ~ n^e against the first size of this run.
void soups(benchmark::State& state) {
  static std::map<std::int64_t, double> seconds_by_size;
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const std::int64_t size = state.range(0);
  const LoadedScene loaded = load_generated(triangle_soup(static_cast<std::size_t>(size), 1), 16);
  LinkSet links;
  double least = INFINITY;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    links = solve_visibility(loaded, 0);
    least = std::min(
        least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  report(state, loaded, links);
  seconds_by_size[size] = least;
  const auto& [first_size, first_seconds] = *seconds_by_size.begin();
  if (size != first_size) {
    state.counters["exponent"] =
        std::log(least / first_seconds) / std::log(static_cast<double>(size) / double(first_size));
  }
}
BENCHMARK(soups)
    ->ArgName("triangles")
    ->Arg(1000)
    ->Arg(4000)
    ->Arg(16000)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
