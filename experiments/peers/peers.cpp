/// viewcover_peers PEER BUNDLE RAYS SEED: what others would do first, against an exact run.
///
/// For each region and each element of an exact bundle, flat, without a hierarchy and on one
/// thread:
///  - `embree`: RAYS random segments between the two, each shot at the whole scene in single
///    precision; visible if one reaches the element
///  - `one-occluder`: shaft culling; hidden only if one occluder blocks the whole shaft, the
///    conservative test of the paper alone
/// Prints one JSON object: seconds, and how far the pairs called visible are from the exact ones.

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <stdexcept>

#include "links/cull.h"
#include "links/sampling.h"
#include "report/run_data.h"
#include "scene/cluster_tree.h"
#include "scene/error.h"
#include "show/ray_scene.h"

namespace viewcover {
namespace {

class Peer {
 public:
  virtual ~Peer() = default;
  virtual bool sees(std::size_t region, std::size_t element) const = 0;
};

std::vector<ConvexPolygon> polygons_of(const RunData& run) {
  std::vector<ConvexPolygon> polygons;
  for (const ElementAddress element : run.bundle.elements) {
    polygons.push_back(subdivided(run.bundle.scene[element.owner()].polygon, element));
  }
  return polygons;
}

/// Errors: InputError for boxes, which the peers do not look from.
std::vector<ConvexPolygon> regions_of(const RunData& run) {
  std::vector<ConvexPolygon> polygons;
  for (const RegionShape& region : run.regions) {
    if (region.is_box()) throw InputError("DIR", "has boxes as regions", "use polygons");
    polygons.push_back(region.polygon());
  }
  return polygons;
}

class EmbreePeer final : public Peer {
 public:
  EmbreePeer(const RunData& run, int rays, std::uint64_t seed)
      : regions_(regions_of(run)),
        elements_(polygons_of(run)),
        surfaces_(surfaces_of(run)),
        rays_(rays),
        seed_(seed) {}

  bool sees(std::size_t region, std::size_t element) const override {
    // A hit this near the end is the element itself, or what it lies on.
    constexpr float kEnd = 1 - 1e-4F;
    const PolygonSampler from(regions_[region]), to(elements_[element]);
    Samples4 samples(mixed(mixed(seed_) + region * elements_.size() + element), rays_, false);
    for (int i = 0; i < rays_; ++i) {
      const auto [a, b, c, d] = samples.next();
      const Point start = from.point(a, b), end = to.point(c, d);
      if (surfaces_.hit(start, end - start).distance >= kEnd) return true;
    }
    return false;
  }

 private:
  static std::vector<ConvexPolygon> surfaces_of(const RunData& run) {
    std::vector<ConvexPolygon> polygons;
    for (const Surface& surface : run.bundle.scene.surfaces) polygons.push_back(surface.polygon);
    return polygons;
  }

  std::vector<ConvexPolygon> regions_, elements_;
  RayScene surfaces_;
  int rays_;
  std::uint64_t seed_;
};

class OneOccluderPeer final : public Peer {
 public:
  explicit OneOccluderPeer(const RunData& run)
      : run_(run),
        clusters_(run.bundle.scene),
        region_(make_viewing_region(regions_of(run), {}, 0)),
        occluders_(run.bundle.scene, clusters_, region_) {
    for (const ConvexPolygon& region : region_.parts) regions_.push_back({region, Plane(region)});
    for (const ConvexPolygon& element : polygons_of(run)) {
      elements_.push_back({element, Plane(element)});
    }
  }

  bool sees(std::size_t region, std::size_t element) const override {
    const Shaft shaft(occluders_, RegionAddress(PartId(region)), regions_[region],
                      run_.bundle.elements[element], elements_[element], run_.bundle.one_sided);
    constexpr ShaftOccluder kWholeScene;
    ShaftOccluders kept;
    return shaft.is_facing() && !cull(shaft, {&kWholeScene, 1}, kOpenAll, kept);
  }

 private:
  const RunData& run_;
  ClusterTree clusters_;
  ViewingRegion region_;
  OccluderSet occluders_;
  std::vector<PlanarPolygon> regions_, elements_;
};

struct Pairs {
  std::size_t count = 0;
  double area = 0;
};

std::string compared(const RunData& run, const Peer& peer) {
  const auto begin = std::chrono::steady_clock::now();
  Pairs exact, missed, excess;
  for (std::size_t region = 0; region < run.regions.size(); ++region) {
    for (std::size_t element = 0; element < run.areas.size(); ++element) {
      const bool seen = peer.sees(region, element), is_visible = run.seen.test(region, element);
      for (const auto& [applies, pairs] :
           {std::pair(is_visible, &exact), std::pair(is_visible && !seen, &missed),
            std::pair(!is_visible && seen, &excess)}) {
        pairs->count += applies;
        pairs->area += applies ? run.areas[element] : 0;
      }
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const auto share = [&](const Pairs& part) {
    return fmt::format("{{\"count\":{},\"area\":{}}}",
                       static_cast<double>(part.count) / static_cast<double>(exact.count),
                       part.area / exact.area);
  };
  return fmt::format(
      "{{\"exact_pairs\":{},\"missed\":{},\"excess\":{},\"Q_u\":{},\"Q_o\":{},\"seconds\":{}}}\n",
      exact.count, missed.count, excess.count, share(missed), share(excess), seconds.count());
}

template <class Number>
Number number(std::string_view text) {
  Number value{};
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc()) {
    throw std::runtime_error(fmt::format("{} is no number", text));
  }
  return value;
}

int run_peer(std::span<const std::string_view> arguments) {
  if (arguments.size() != 4) {
    throw std::runtime_error("usage: viewcover_peers embree|one-occluder BUNDLE RAYS SEED");
  }
  const RunData run = load_run_data(arguments[1]);
  std::unique_ptr<Peer> peer;
  if (arguments[0] == "embree") {
    peer = std::make_unique<EmbreePeer>(run, number<int>(arguments[2]),
                                        number<std::uint64_t>(arguments[3]));
  } else {
    peer = std::make_unique<OneOccluderPeer>(run);
  }
  fmt::print("{}", compared(run, *peer));
  return 0;
}

}  // namespace
}  // namespace viewcover

int main(int argc, char** argv) {
  const std::vector<std::string_view> arguments(argv + 1, argv + argc);
  try {
    return viewcover::run_peer(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "viewcover_peers: {}\n", error.what());
    return 2;
  }
}
