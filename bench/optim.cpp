// Region cover: how often and how fast each method reaches the best known covers of hard instances,
// and what the operations cost that the methods consist of.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "optim/cover_methods.h"
#include "optim/cover_state.h"
#include "optim/hard_instances.h"
#include "optim/reference_cover.h"
#include "optim/scored_cover.h"
#include "scene/error.h"
#include "scene/random_numbers.h"

namespace {

using namespace viewcover;

constexpr double kSecondsPerSeed = 30;
constexpr int kSeeds = 10;
constexpr double kSecondsToProve = 120;

/// One iteration a seed; its time is the time until the best known cover is reached, or until the
/// method gives up.
void reach(benchmark::State& state, const std::string& method,
           const reference::HardInstance& hard) {
  const CoverInstance instance(hard.matrix, std::vector<double>(hard.matrix.columns(), 1.0));
  std::vector<double> seconds_to_reach;
  double sizes = 0, most = 0;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    std::atomic<bool> stop = false;
    BetterCover last;
    CoverOptions options;
    options.goal = CoverGoal::kWholeCover;
    options.seed = ++seed;
    options.time_limit_seconds = kSecondsPerSeed;
    options.stop = &stop;
    options.on_better = [&](const BetterCover& better) {
      last = better;
      stop = better.chosen.size() <= hard.best;
    };
    double seconds = 0;
    try {
      const RegionCover cover = make_cover_method(method)->solve(instance, options);
      seconds = cover.steps.back().seconds;
    } catch (const Interrupted&) {
      seconds = last.seconds;
    }
    if (!instance.covers_all(last.chosen)) state.SkipWithError("not a cover");
    if (last.chosen.size() <= hard.best) seconds_to_reach.push_back(last.seconds);
    sizes += static_cast<double>(last.chosen.size());
    most = std::max(most, static_cast<double>(last.chosen.size()));
    state.SetIterationTime(seconds);
  }
  std::ranges::sort(seconds_to_reach);
  state.counters["best_known"] = static_cast<double>(hard.best);
  state.counters["reached"] = static_cast<double>(seconds_to_reach.size());
  if (!seconds_to_reach.empty()) {
    state.counters["median_s"] = seconds_to_reach[seconds_to_reach.size() / 2];
    state.counters["slowest_s"] = seconds_to_reach.back();
  }
  state.counters["mean_size"] = sizes / static_cast<double>(seed);
  state.counters["most"] = most;
}

/// How far the exact method gets, once: the smallest cover found and what is proved.
void prove(benchmark::State& state, const reference::HardInstance& hard) {
  const CoverInstance instance(hard.matrix, std::vector<double>(hard.matrix.columns(), 1.0));
  CoverOptions options;
  options.goal = CoverGoal::kWholeCover;
  options.time_limit_seconds = kSecondsToProve;
  double ones = 0;
  for (std::size_t row = 0; row < hard.matrix.rows(); ++row) {
    ones += static_cast<double>(count_bits(hard.matrix.row(row)));
  }
  for (auto _ : state) {
    const RegionCover cover = make_cover_method("exact")->solve(instance, options);
    state.counters["ones"] = ones;
    state.counters["size"] = static_cast<double>(cover.size());
    state.counters["bound"] = static_cast<double>(cover.lower_bound);
  }
}

/// 256 places in a room with furniture, its 5000 elements merged to columns of their own.
struct RoomCover {
  reference::Room room = reference::furnished_room(16, 5000, 5, 1);
  CoverInstance instance{room.matrix, room.weights};
  CoverState state{instance};
  std::vector<std::size_t> chosen = {3, 40, 71, 99, 130, 160, 181, 200, 222, 250};

  RoomCover() { state.assign(chosen); }
};

void count_columns(benchmark::State& state, const BitRows& matrix) {
  state.counters["columns"] = static_cast<double>(matrix.columns());
}

void state_exchange(benchmark::State& state) {
  RoomCover cover;
  RandomNumbers random(1);
  for (auto _ : state) {
    std::size_t& out = cover.chosen[random.below(cover.chosen.size())];
    std::size_t in = out;
    while (cover.state.contains(in)) in = random.below(cover.state.row_count());
    cover.state.remove(out);
    cover.state.add(in);
    out = in;
  }
  count_columns(state, cover.instance.rows());
}
BENCHMARK(state_exchange)->Unit(benchmark::kMicrosecond);

void state_gain(benchmark::State& state) {
  RoomCover cover;
  RandomNumbers random(1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(cover.state.gain(random.below(cover.state.row_count())));
  }
  count_columns(state, cover.instance.rows());
}
BENCHMARK(state_gain)->Unit(benchmark::kMicrosecond);

void state_gain_without(benchmark::State& state) {
  RoomCover cover;
  RandomNumbers random(1);
  for (auto _ : state) {
    std::size_t in = random.below(cover.state.row_count());
    while (cover.state.contains(in)) in = random.below(cover.state.row_count());
    const std::size_t out = cover.chosen[random.below(cover.chosen.size())];
    benchmark::DoNotOptimize(cover.state.gain_without(in, out));
  }
  count_columns(state, cover.instance.rows());
}
BENCHMARK(state_gain_without)->Unit(benchmark::kMicrosecond);

void scored_exchange(benchmark::State& state) {
  const RoomCover cover;
  const Incidence lists(cover.instance.rows());
  ScoredCover scored(lists, std::vector<ScoredCover::Score>(lists.column_count(), 1));
  for (const std::size_t row : cover.chosen) scored.add(static_cast<ScoredCover::Index>(row));
  RandomNumbers random(1);
  for (auto _ : state) {
    ScoredCover::Index in = scored.chosen().front();
    while (scored.contains(in)) {
      in = static_cast<ScoredCover::Index>(random.below(scored.row_count()));
    }
    scored.remove(scored.chosen()[random.below(scored.chosen().size())]);
    scored.add(in);
  }
  count_columns(state, cover.instance.rows());
}
BENCHMARK(scored_exchange)->Unit(benchmark::kMicrosecond);

/// Argument: whether equal columns are merged.
void union_of_ten_rows(benchmark::State& state) {
  const RoomCover cover;
  const bool merged = state.range(0) != 0;
  const BitRows& matrix = merged ? cover.instance.rows() : cover.room.matrix;
  const std::vector<double> weights =
      merged ? std::vector<double>(cover.instance.weights().begin(), cover.instance.weights().end())
             : cover.room.weights;
  for (auto _ : state) {
    benchmark::DoNotOptimize(weight_of(matrix.union_of(cover.chosen), weights));
  }
  count_columns(state, matrix);
}
BENCHMARK(union_of_ten_rows)->ArgName("merged")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int argc, char** argv) {
  const std::vector<reference::HardInstance> instances = reference::hard_instances(),
                                             library = reference::library_instances(),
                                             cameras = reference::camera_instances();
  const auto add = [](const std::string& what, const std::string& method,
                      const reference::HardInstance& hard) {
    benchmark::RegisterBenchmark(
        (what + "/" + method + "/" + hard.name).c_str(),
        [method, &hard](benchmark::State& state) { reach(state, method, hard); })
        ->Iterations(kSeeds)
        ->Unit(benchmark::kSecond)
        ->UseManualTime();
  };
  for (const CoverMethodEntry& method : cover_methods()) {
    for (const reference::HardInstance& hard : instances) {
      add("reach", std::string(method.name), hard);
    }
  }
  for (const reference::HardInstance& hard : library) add("library", "local", hard);
  for (const reference::HardInstance& hard : cameras) {
    benchmark::RegisterBenchmark(("prove/exact/" + hard.name).c_str(),
                                 [&hard](benchmark::State& state) { prove(state, hard); })
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
