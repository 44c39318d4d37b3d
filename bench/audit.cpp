// The audit: everything seen from one viewpoint, and a set of viewpoints added up, on one thread.

#include "audit/audit.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "audit/element_views.h"
#include "links/refine.h"
#include "scene/random_numbers.h"
#include "support/generated.h"

namespace {

using namespace viewcover;

/// Every surface subdivided uniformly, down to the default element area of `solve`.
std::vector<ElementAddress> elements_of(const Scene& scene) {
  const double most = default_element_area(scene);
  std::vector<ElementAddress> elements;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const SurfaceId surface(s);
    int level = 0;
    while (area(scene[surface].polygon) >
           most * static_cast<double>(std::uint64_t{1} << 2 * level)) {
      ++level;
    }
    for (std::uint64_t path = 0; path < std::uint64_t{1} << 2 * level; ++path) {
      elements.emplace_back(surface, level, path);
    }
  }
  return elements;
}

struct Room {
  testing::LoadedScene loaded;
  ClusterTree clusters;
  std::vector<ElementAddress> elements;
  std::vector<Point> viewpoints;

  explicit Room(RoomDetail detail, std::size_t count)
      : loaded(testing::load_generated(living_room(detail), 64)),
        clusters(loaded.scene),
        elements(elements_of(loaded.scene)) {
    RandomNumbers random(1);
    const Box box = bounding_box(loaded.region.parts[0]);
    for (std::size_t i = 0; i < count; ++i) {
      viewpoints.emplace_back(random.between(box.min().x(), box.max().x()),
                              random.between(box.min().y(), box.max().y()), box.min().z());
    }
  }
};

RoomDetail detail(const benchmark::State& state) {
  return state.range(0) == 316 ? RoomDetail::kSimple : RoomDetail::kComplex;
}

/// Everything seen from one viewpoint, exactly; the mean of 32 viewpoints in turn.
void one_viewpoint(benchmark::State& state) {
  const Room room(detail(state), 32);
  const PlanarScene planar(room.loaded.scene, room.clusters);
  const std::span<const ElementAddress> elements = room.elements;
  double wholly = 0, in_part = 0, views = 0;
  for (auto _ : state) {
    const ViewpointScene from(planar, room.viewpoints[static_cast<std::size_t>(views) % 32]);
    for (std::size_t first = 0, end = 0; first < elements.size(); first = end) {
      const SurfaceId surface = elements[first].owner();
      while (end < elements.size() && elements[end].owner() == surface) ++end;
      view_elements(from, surface, elements.subspan(first, end - first), false,
                    [&](std::size_t, ElementView&& view) {
                      wholly += view.seen == ElementView::Seen::kWholly;
                      in_part += view.seen == ElementView::Seen::kInPart;
                    });
    }
    ++views;
  }
  state.counters["elements"] = static_cast<double>(elements.size());
  state.counters["wholly"] = wholly / views;
  state.counters["in_part"] = in_part / views;
}
BENCHMARK(one_viewpoint)->ArgName("polygons")->Arg(316)->Arg(1228)->Unit(benchmark::kMillisecond);

/// A whole audit. Arguments: polygons, viewpoints.
void audits(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Room room(detail(state), static_cast<std::size_t>(state.range(1)));
  double pieces = 0, most = 0;
  for (auto _ : state) {
    const Audit audit =
        audit_images(room.loaded.scene, room.clusters, room.elements, room.viewpoints);
    pieces = most = 0;
    for (const ElementAudit& element : audit.elements) {
      const auto count = static_cast<double>(element.pieces.size());
      pieces += count;
      most = std::max(most, count);
    }
  }
  state.counters["pieces"] = pieces;
  state.counters["most_in_one"] = most;
}
BENCHMARK(audits)
    ->ArgNames({"polygons", "viewpoints"})
    ->Args({316, 4})
    ->Args({316, 8})
    ->Args({316, 16})
    ->Args({1228, 8})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
