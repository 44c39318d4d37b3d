// What one viewpoint costs: everything seen from a point of the living room of 316 polygons.

#include <benchmark/benchmark.h>

#include <memory>

#include "approx/ray_backend.h"
#include "exact/exact_backend.h"
#include "links/refine.h"
#include "support/generated.h"
#include "viewpoints/region_views.h"

namespace {

using namespace viewcover;

struct Room {
  testing::LoadedScene loaded;
  ClusterTree clusters;
  LinkSet links;
  VisibilityMatrix matrix;
  RegionViews views;

  Room(RoomDetail detail, std::size_t regions, const VisibilityBackend& backend)
      : loaded(testing::load_generated(living_room(detail), regions)),
        clusters(loaded.scene),
        links(refine(loaded.scene, clusters, loaded.region, backend,
                     {.element_area = default_element_area(loaded.scene)})),
        matrix(make_visibility_matrix(loaded.scene, loaded.region, links)),
        views({loaded.scene, clusters, loaded.region, links, matrix, backend, false}) {}
};

/// Time is the mean of a position; all regions in turn.
void look(benchmark::State& state, RoomDetail detail, const VisibilityBackend& backend) {
  const Room room(detail, static_cast<std::size_t>(state.range(0)), backend);
  RandomNumbers random(1);
  std::vector<BitRows::Word> row(room.matrix.bits.words_per_row());
  std::size_t region = 0;
  double seen = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const Point position = room.views.positions(region).random(random);
    std::ranges::fill(row, BitRows::Word{0});
    state.ResumeTiming();
    room.views.look(region, position, row);
    state.PauseTiming();
    seen += static_cast<double>(count_bits(row));
    region = (region + 1) % room.views.region_count();
    state.ResumeTiming();
  }
  state.counters["elements_seen"] = seen / static_cast<double>(state.iterations());
}

void look_exactly(benchmark::State& state) { look(state, RoomDetail::kSimple, ExactBackend(1)); }
BENCHMARK(look_exactly)->ArgName("regions")->Arg(64)->Arg(256)->Unit(benchmark::kMillisecond);

void look_by_rays(benchmark::State& state) { look(state, RoomDetail::kSimple, RayBackend({})); }
BENCHMARK(look_by_rays)->ArgName("regions")->Arg(64)->Unit(benchmark::kMillisecond);

void look_exactly_at_1228_polygons(benchmark::State& state) {
  look(state, RoomDetail::kComplex, ExactBackend(1));
}
BENCHMARK(look_exactly_at_1228_polygons)
    ->ArgName("regions")
    ->Arg(64)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
