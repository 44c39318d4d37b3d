#include "links/refine.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "links/cull.h"
#include "links/occluder_set.h"
#include "links/shaft.h"
#include "scene/error.h"

namespace viewcover {
namespace {

// Occluders kept one by one while a shaft is refined; what is beyond stays in unopened clusters,
// so that a shaft costs the same in a large scene. Links are stored with every surface opened.
constexpr std::size_t kOccludersPerShaft = 32;
constexpr std::size_t kOccludersPerCluster = 16;

// Pairs of finest nodes below which a subtree is refined by one thread: some milliseconds.
constexpr double kPairsPerTask = 512;

// Batches of a refinement that can be continued: small parts of a large scene, and so many in the
// first wave that a small scene is done with the second.
constexpr std::size_t kBatches = 256;
constexpr std::size_t kFirstWave = 16;
constexpr double kLargestGrowth = 64;
// Of the time between checkpoints: a wave that ended a little early is saved.
constexpr double kSoonEnough = 0.5;

struct RegionNode : PlanarPolygon {
  RegionAddress address;
  double area = 0;
  bool is_face = false;          ///< of a cell: looks to its front only
  bool lies_on_surface = false;  ///< of a face: perhaps

  bool looks_at(std::span<const Point> corners) const { return !is_face || has_in_front(corners); }
  /// Is what it sees wholly seen to its front, or without a surface that it may lie on between?
  bool vouches_for(std::span<const Point> corners) const {
    return !lies_on_surface ||
           std::ranges::all_of(corners, [&](const Point& x) { return plane.side(x) >= 0; });
  }
};

/// Is a surface in the plane of the polygon, and near it there?
bool may_lie_on_surface(const ConvexPolygon& polygon, const Plane& plane, const Scene& scene) {
  const Box box = bounding_box(polygon);
  return std::ranges::any_of(scene.surfaces, [&](const Surface& surface) {
    return bounding_box(surface.polygon).intersects(box) &&
           std::ranges::all_of(surface.polygon,
                               [&](const Point& corner) { return plane.side(corner) == 0; });
  });
}

/// All nodes of the quadtrees over the region's polygons, and the faces of its cells, which are not
/// subdivided.
class RegionNodes {
 public:
  RegionNodes(const ViewingRegion& region, const Scene& scene)
      : level_(region.level), polygons_(region.polygon_count()) {
    nodes_.resize(polygons_ * offset(level_ + 1) + region.face_count());
    for (std::size_t p = 0; p < region.parts.size(); ++p) {
      const PartId part(p);
      const Plane plane(region.parts[p]);
      const int finest = finest_level(part);
      for (int level = 0; level <= finest; ++level) {
        for (std::size_t path = 0; path < std::size_t{1} << (2 * level); ++path) {
          const RegionAddress address(part, level, path);
          RegionNode& node = at(address);
          node.address = address;
          node.polygon = level == 0 ? region.parts[p] : node.polygon;
          node.plane = plane;
          node.area = area(node.polygon);
          node.is_face = region.is_face(address);
          node.lies_on_surface = node.is_face && may_lie_on_surface(node.polygon, plane, scene);
          if (level == finest) continue;
          const auto children = quarters(node.polygon);
          for (int digit = 0; digit < 4; ++digit) {
            at(address.child(digit)).polygon = children[static_cast<std::size_t>(digit)];
          }
        }
      }
    }
  }

  const RegionNode& operator[](RegionAddress address) const { return nodes_[index(address)]; }
  bool is_finest(const RegionNode& node) const { return levels_below(node) == 0; }
  /// Finest nodes below the node.
  double leaves(const RegionNode& node) const { return std::ldexp(1.0, 2 * levels_below(node)); }

 private:
  int finest_level(PartId part) const { return part.value < polygons_ ? level_ : 0; }
  int levels_below(const RegionNode& node) const {
    return finest_level(node.address.owner()) - node.address.level();
  }
  static std::size_t offset(int level) { return ((std::size_t{1} << (2 * level)) - 1) / 3; }
  std::size_t index(RegionAddress address) const {
    const std::size_t part = address.owner().value, each = offset(level_ + 1);
    return part < polygons_ ? part * each + offset(address.level()) + address.path()
                            : polygons_ * each + part - polygons_;
  }
  RegionNode& at(RegionAddress address) { return nodes_[index(address)]; }

  int level_;
  std::size_t polygons_;
  std::vector<RegionNode> nodes_;
};

struct ElementNode : PlanarPolygon {
  ElementAddress address;
  double area = 0;

  std::array<ElementNode, 4> children() const {
    auto polygons = quarters(polygon);
    std::array<ElementNode, 4> nodes;
    for (int digit = 0; digit < 4; ++digit) {
      ElementNode& node = nodes[static_cast<std::size_t>(digit)];
      node.polygon = std::move(polygons[static_cast<std::size_t>(digit)]);
      node.plane = plane;
      node.address = address.child(digit);
      node.area = viewcover::area(node.polygon);
    }
    return nodes;
  }
};

/// The recursion of figure 4. Every subtree writes to a LinkSet of its own; those of siblings are
/// put together in order, so the result does not depend on who computed which.
class Refinement {
 public:
  Refinement(const Scene& scene, const ClusterTree& clusters, const ViewingRegion& region,
             const VisibilityBackend& backend, const RefineOptions& options,
             RefineProgress* progress)
      : scene_(scene),
        clusters_(clusters),
        occluders_(scene, clusters, region),
        regions_(region, scene),
        backend_(backend),
        options_(options),
        progress_(progress) {
    for (const Surface& surface : scene.surfaces) {
      if (surface.is_target) total_pairs_ += leaves(area(surface.polygon));
    }
    surfaces_per_batch_ = scene.surfaces.size() * region.parts.size() / kBatches;
    total_pairs_ *= static_cast<double>(region.polygon_count() * region.regions_per_part() +
                                        region.face_count());
  }

  /// A part of the region and a cluster, with the occluders that may be between them.
  struct Batch {
    PartId part;
    ClusterNode cluster = 0;
    ShaftOccluders candidates;
  };

  /// In the order of refinement; together all pairs of the region and the scene.
  std::vector<Batch> batches(std::size_t parts) const {
    std::vector<Batch> all;
    for (std::size_t part = 0; part < parts; ++part) {
      ShaftOccluders everything;
      everything.push_back({.node = 0});
      add_batches({PartId(part), 0, everything}, all);
    }
    return all;
  }

  LinkSet visit(const Batch& batch) const {
    return visit_cluster(regions_[RegionAddress(batch.part)], batch.cluster, batch.candidates);
  }

  /// Reports batches that another run has done.
  void skip(std::span<const Batch> done, std::size_t links) const {
    double pairs = 0;
    for (const Batch& batch : done) {
      pairs += pairs_of(clusters_.nodes()[batch.cluster]) *
               regions_.leaves(regions_[RegionAddress(batch.part)]);
    }
    report(pairs, links);
  }

 private:
  using Candidates = std::span<const ShaftOccluder>;

  void add_batches(const Batch& batch, std::vector<Batch>& all) const {
    const ClusterTree::Node& node = clusters_.nodes()[batch.cluster];
    if (node.count > surfaces_per_batch_ && !node.is_leaf()) {
      const Shaft shaft(occluders_, regions_[RegionAddress(batch.part)], node.box);
      ShaftOccluders kept;
      if (!cull(shaft, batch.candidates, kOccludersPerCluster, kept)) {
        add_batches({batch.part, batch.cluster + 1, kept}, all);
        add_batches({batch.part, node.right, kept}, all);
        return;
      }
    }
    all.push_back(batch);
  }

  /// Pairs of one region and the finest elements of a cluster's targets.
  double pairs_of(const ClusterTree::Node& node) const {
    double pairs = 0;
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const OccluderId place(node.first + i);
      if (!scene_[clusters_.surface(place)].is_target) continue;
      pairs += leaves(area(occluders_.polygon(place)));
    }
    return pairs;
  }

  /// Everything in a cluster, seen from a region that is not subdivided yet.
  LinkSet visit_cluster(const RegionNode& region, ClusterNode index, Candidates candidates) const {
    const ClusterTree::Node& node = clusters_.nodes()[index];
    if (node.is_leaf()) {
      ElementNode element;
      const OccluderId place(node.first);
      const SurfaceId surface = clusters_.surface(place);
      if (!scene_[surface].is_target) return {};
      element.polygon = scene_[surface].polygon;
      element.plane = occluders_.plane(place);
      element.address = ElementAddress(surface);
      element.area = area(element.polygon);
      return visit_element(region, element, candidates);
    }
    const auto all_hidden = [&](Verdict verdict) {
      LinkSet links;
      for (std::uint32_t i = 0; i < node.count; ++i) {
        if (scene_[clusters_.surface(OccluderId(node.first + i))].is_target) links.count(verdict);
      }
      report(pairs_of(node) * regions_.leaves(region), 0);
      return links;
    };
    if (!region.looks_at(box_corners(node.box))) return all_hidden(Verdict::kHiddenNotFacing);
    const Shaft shaft(occluders_, region, node.box);
    ShaftOccluders kept;
    if (cull(shaft, candidates, kOccludersPerCluster, kept)) {
      return all_hidden(Verdict::kHiddenByOne);
    }
    const std::array<ClusterNode, 2> children = {index + 1, node.right};
    const bool parallel = node.count * regions_.leaves(region) > kPairsPerTask;
    return visit_all<2>(parallel,
                        [&](std::size_t i) { return visit_cluster(region, children[i], kept); });
  }

  LinkSet visit_element(const RegionNode& region, const ElementNode& element,
                        Candidates candidates) const {
    const double pairs = regions_.leaves(region) * leaves(element.area);
    LinkSet links;
    if (pairs <= kPairsPerTask) {
      if (progress_ != nullptr && progress_->stop) throw Interrupted();
      refine_pair(region, element, candidates, links);
      report(pairs, links.size());
      return links;
    }
    ShaftOccluders kept;
    Shaft shaft = make_shaft(region, element);
    if (settle(shaft, region, element, candidates, kept, links)) {
      report(pairs, links.size());
      return links;
    }
    if (subdivides_region(region, element)) {
      return visit_all<4>(true, [&](std::size_t i) {
        return visit_element(regions_[region.address.child(static_cast<int>(i))], element, kept);
      });
    }
    const auto children = element.children();
    return visit_all<4>(true,
                        [&](std::size_t i) { return visit_element(region, children[i], kept); });
  }

  /// The same for small subtrees: no tasks, one LinkSet.
  void refine_pair(const RegionNode& region, const ElementNode& element, Candidates candidates,
                   LinkSet& links) const {
    ShaftOccluders kept;
    Shaft shaft = make_shaft(region, element);
    if (settle(shaft, region, element, candidates, kept, links)) return;
    if (subdivides_region(region, element)) {
      for (int digit = 0; digit < 4; ++digit) {
        refine_pair(regions_[region.address.child(digit)], element, kept, links);
      }
    } else {
      for (const ElementNode& child : element.children()) {
        refine_pair(region, child, kept, links);
      }
    }
  }

  Shaft make_shaft(const RegionNode& region, const ElementNode& element) const {
    return {occluders_, region.address, region, element.address, element, options_.one_sided};
  }

  /// The lines of figure 4 from shaft culling to the thresholds. True if the pair is done with;
  /// otherwise `kept` holds the occluders left in its shaft.
  bool settle(Shaft& shaft, const RegionNode& region, const ElementNode& element,
              Candidates candidates, ShaftOccluders& kept, LinkSet& links) const {
    if (!shaft.is_facing() || !region.looks_at(element.polygon)) {
      links.count(Verdict::kHiddenNotFacing);
      return true;
    }
    if (cull(shaft, candidates, kOccludersPerShaft, kept)) {
      links.count(Verdict::kHiddenByOne);
      return true;
    }
    const bool finest = is_finest(region, element);
    // What goes into the matrix is decided, and stored, with every surface opened.
    if (finest && !open_all(shaft, kept)) {
      links.count(Verdict::kHiddenByOne);
      return true;
    }
    Verdict verdict = Verdict::kFullyVisible;
    if (!kept.empty()) {
      shaft.set_occluders(kept);
      verdict = backend_.decide(shaft, finest ? Effort::kFull : Effort::kCheap);
      if (verdict == Verdict::kFullyVisible) kept.clear();
      if (!is_visible(verdict)) {
        links.count(verdict);
        return true;
      }
    }
    // Full visibility holds for all parts, unless some of the region is behind the element.
    const bool holds_for_parts = verdict == Verdict::kFullyVisible && shaft.is_wholly_facing() &&
                                 region.vouches_for(element.polygon);
    if (!finest && !holds_for_parts) return false;
    SmallList<OccluderId, 96> list;
    for (const ShaftOccluder& occluder : kept) {
      list.emplace_back(clusters_.nodes()[occluder.node].first);
    }
    links.add({region.address, element.address, verdict}, list);
    return true;
  }

  /// Puts the surfaces below the clusters among the occluders in their place; false, unfinished, if
  /// one of them blocks the shaft.
  bool open_all(const Shaft& shaft, ShaftOccluders& kept) const {
    ShaftOccluders surfaces, opened;
    for (const ShaftOccluder& occluder : kept) {
      if (clusters_.nodes()[occluder.node].is_leaf()) {
        surfaces.push_back(occluder);
      } else {
        if (cull(shaft, {&occluder, 1}, kOpenAll, opened)) return false;
        surfaces.insert(surfaces.end(), opened.begin(), opened.end());
      }
    }
    kept = std::move(surfaces);
    return true;
  }

  bool is_finest(const RegionNode& region, const ElementNode& element) const {
    return regions_.is_finest(region) && element.area <= options_.element_area;
  }
  /// The larger of the two is subdivided, unless it is at its threshold. Requires that not both
  /// are.
  bool subdivides_region(const RegionNode& region, const ElementNode& element) const {
    if (regions_.is_finest(region)) return false;
    return element.area <= options_.element_area || region.area >= element.area;
  }

  /// Finest elements below an element of this area, if quarters are of equal area.
  double leaves(double area) const {
    double count = 1;
    for (; area > options_.element_area; area /= 4) count *= 4;
    return count;
  }

  template <std::size_t N, class Visit>
  LinkSet visit_all(bool parallel, const Visit& visit) const {
    std::array<LinkSet, N> parts;
    if (parallel) {
      tbb::parallel_for(std::size_t{0}, N, [&](std::size_t i) { parts[i] = visit(i); });
    } else {
      for (std::size_t i = 0; i < N; ++i) parts[i] = visit(i);
    }
    LinkSet links;
    for (LinkSet& part : parts) links.append(std::move(part));
    return links;
  }

  void report(double pairs, std::size_t links) const {
    if (progress_ == nullptr) return;
    progress_->share_done += pairs / total_pairs_;
    progress_->links += links;
  }

  const Scene& scene_;
  const ClusterTree& clusters_;
  OccluderSet occluders_;
  RegionNodes regions_;
  const VisibilityBackend& backend_;
  RefineOptions options_;
  RefineProgress* progress_;
  double total_pairs_ = 0;
  std::size_t surfaces_per_batch_ = 0;
};

}  // namespace

LinkSet refine(const Scene& scene, const ClusterTree& clusters, const ViewingRegion& region,
               const VisibilityBackend& backend, const RefineOptions& options,
               RefineProgress* progress, RefineCheckpoints* checkpoints) {
  double largest = 0;
  for (const Surface& surface : scene.surfaces) {
    largest = std::max(largest, area(surface.polygon));
  }
  if (!(options.element_area > 0) ||
      std::ldexp(largest, -2 * kMaxSubdivisionLevel) > options.element_area) {
    throw InputError(
        "--element-area",
        "the largest surface would be subdivided more than " +
            std::to_string(kMaxSubdivisionLevel) + " times",
        "use " + std::to_string(std::ldexp(largest, -2 * kMaxSubdivisionLevel)) + " or more");
  }
  const Refinement refinement(scene, clusters, region, backend, options, progress);
  const std::vector<Refinement::Batch> batches = refinement.batches(region.parts.size());
  LinkSet links;
  std::size_t done = 0;
  if (checkpoints != nullptr) {
    links = std::move(checkpoints->links);
    done = checkpoints->batches_done;
    refinement.skip(std::span(batches).first(done), links.size());
  }
  // Threads wait for each other at the end of a wave; so a wave lasts as long as the time from one
  // checkpoint to the next.
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  std::size_t wave = checkpoints != nullptr ? batches.size() / kFirstWave + 1 : batches.size();
  Clock::time_point saved = Clock::now();
  while (done < batches.size()) {
    const Clock::time_point start = Clock::now();
    wave = std::min(wave, batches.size() - done);
    std::vector<LinkSet> found(wave);
    tbb::parallel_for(std::size_t{0}, wave,
                      [&](std::size_t i) { found[i] = refinement.visit(batches[done + i]); });
    for (LinkSet& part : found) links.append(std::move(part));
    done += wave;
    if (checkpoints == nullptr) continue;
    const Clock::time_point now = Clock::now();
    const double scale =
        std::min(checkpoints->seconds / Seconds(now - start).count(), kLargestGrowth);
    wave = static_cast<std::size_t>(static_cast<double>(wave) * scale) + 1;
    if (Seconds(now - saved).count() < kSoonEnough * checkpoints->seconds) continue;
    checkpoints->save(done, links);
    saved = now;
  }
  return links;
}

double default_element_area(const Scene& scene) {
  const Point size = scene.bounds.sizes();
  const double surface = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
  return 0.01 * surface / 6;
}

}  // namespace viewcover
