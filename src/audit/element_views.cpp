#include "audit/element_views.h"

#include <array>
#include <numeric>

namespace viewcover {
namespace {

using Seen = ElementView::Seen;
using Visit = std::function<void(std::size_t, ElementView&&)>;
using flat::FlatLine;
using flat::FlatPolygon;

/// The way down the quadtree over a surface.
class Descent {
 public:
  Descent(const ViewpointScene& from, SurfaceId surface, std::span<const ElementAddress> elements,
          const Visit& visit)
      : from_(from),
        surface_(surface),
        elements_(elements),
        visit_(visit),
        plane_(from.planar().surface_plane(surface)) {}

  void run() {
    const ConvexPolygon& polygon = from_.planar().scene()[surface_].polygon;
    auto occluders = from_.occluders(surface_, from_.view_of(surface_, polygon));
    if (!occluders) return;
    occluders_ = *std::move(occluders);
    borders_.resize(occluders_.size());
    std::vector<std::size_t> all(occluders_.size());
    std::iota(all.begin(), all.end(), 0);
    enter(ElementAddress(surface_), polygon, 0, elements_.size(), all);
  }

 private:
  /// `first`, `last`: the elements within the node; `occluders`: what may block sight lines to it.
  void enter(ElementAddress node, const ConvexPolygon& polygon, std::size_t first, std::size_t last,
             std::span<const std::size_t> occluders) {
    if (first == last) return;
    const ViewedPolygon view = from_.view_of(surface_, polygon);
    std::vector<std::size_t> left;
    for (const std::size_t occluder : occluders) {
      const Blocks blocks = from_.blocks(occluders_[occluder], polygon, view);
      if (blocks == Blocks::kEverything) return;
      if (blocks == Blocks::kPart) left.push_back(occluder);
    }
    if (left.empty()) {
      for (std::size_t i = first; i < last; ++i) visit_(i, {.seen = Seen::kWholly});
    } else if (elements_[first] == node) {
      subtract_shadows(first, polygon, left);
    } else {
      const std::array<ConvexPolygon, 4> children = quarters(polygon);
      for (int digit = 0; digit < 4; ++digit) {
        const ElementAddress child = node.child(digit);
        std::size_t end = first;
        while (end < last && child.contains(elements_[end])) ++end;
        enter(child, children[static_cast<std::size_t>(digit)], first, end, left);
        first = end;
      }
    }
  }

  void subtract_shadows(std::size_t index, const ConvexPolygon& polygon,
                        std::span<const std::size_t> occluders) {
    std::vector<FlatPolygon> lit, before;
    lit.push_back(plane_.flat(polygon));
    bool any_shaded = false;
    for (const std::size_t occluder : occluders) {
      const std::vector<const FlatLine*> borders = borders_across(occluder, polygon);
      before.swap(lit);
      lit.clear();
      for (FlatPolygon& part : before) {
        const bool apart = std::ranges::any_of(
            borders, [&](const FlatLine* border) { return part.is_right_of(*border); });
        if (apart) {
          lit.push_back(std::move(part));
          continue;
        }
        for (std::size_t k = 0; k < borders.size() && !part.is_empty(); ++k) {
          if (auto outside = part.cut(*borders[k])) lit.push_back(std::move(*outside));
        }
        any_shaded |= !part.is_empty();
      }
      if (lit.empty()) return;
    }
    if (any_shaded) {
      visit_(index, {.seen = Seen::kInPart, .parts = std::move(lit)});
    } else {
      visit_(index, {.seen = Seen::kWholly});
    }
  }

  /// The borders of the occluder's shadow, inside to their left, that have some of the polygon
  /// outside.
  std::vector<const FlatLine*> borders_across(std::size_t occluder, const ConvexPolygon& polygon) {
    const SurfaceId id = occluders_[occluder].id;
    const std::span<const SightPlane> edges = occluders_[occluder].view.edges();
    std::vector<std::optional<FlatLine>>& borders = borders_[occluder];
    borders.resize(edges.size() + 1);
    std::vector<const FlatLine*> across;
    const auto any_corner = [&](auto&& is_outside) {
      return std::any_of(polygon.begin(), polygon.end(), is_outside);
    };
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (!any_corner([&](const Point& x) { return edges[k].side(x) < 0; })) continue;
      if (!borders[k]) borders[k] = plane_.meet(from_.edge_plane(id, k));
      across.push_back(&*borders[k]);
    }
    // What lies before the occluder is not in its shadow.
    const Plane& plane = from_.planar().plane(id);
    const int near = from_.side(id);
    if (any_corner([&](const Point& x) { return plane.side(x) * near > 0; })) {
      if (!borders.back()) borders.back() = plane_.meet(from_.own_plane(id));
      across.push_back(&*borders.back());
    }
    return across;
  }

  const ViewpointScene& from_;
  SurfaceId surface_;
  std::span<const ElementAddress> elements_;
  const Visit& visit_;
  const SurfacePlane& plane_;
  std::vector<ViewedOccluder> occluders_;
  std::vector<std::vector<std::optional<FlatLine>>> borders_;  // by occluder, made when needed
};

}  // namespace

void view_elements(const ViewpointScene& from, SurfaceId surface,
                   std::span<const ElementAddress> elements, bool one_sided, const Visit& visit) {
  const int side = from.side(surface);
  if (side == 0 || (one_sided && side < 0)) return;
  Descent(from, surface, elements, visit).run();
}

}  // namespace viewcover
