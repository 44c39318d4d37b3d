#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <string>

#include "scene/error.h"
#include "scene/polygon_contact.h"
#include "scene/predicates.h"
#include "scene/repair/closed_surface.h"
#include "scene/viewing_region.h"

namespace viewcover {
namespace {

constexpr std::size_t kNamedFaces = 4;   // runs of face numbers in a message
constexpr std::size_t kNamedGroups = 3;  // group names in a message

std::set<std::uint32_t> source_faces(const Scene& scene, std::span<const SurfaceId> surfaces) {
  std::set<std::uint32_t> faces;
  for (const SurfaceId surface : surfaces) faces.insert(scene[surface].source_face);
  return faces;
}

// "7-12, 20 and 3 more", 1-based.
std::string face_numbers(const std::set<std::uint32_t>& faces) {
  std::string text;
  std::size_t runs = 0, left = faces.size();
  for (auto face = faces.begin(); face != faces.end() && runs < kNamedFaces; ++runs) {
    const std::uint32_t first = *face;
    std::uint32_t last = first;
    --left;
    for (++face; face != faces.end() && *face == last + 1; ++face, --left) last = *face;
    if (!text.empty()) text += ", ";
    text +=
        last == first ? fmt::format("{}", first + 1) : fmt::format("{}-{}", first + 1, last + 1);
  }
  if (left > 0) text += fmt::format(" and {} more", left);
  return text;
}

// "'table', 'lamp'", in order of appearance; empty if no group has a name.
std::string group_names(const Scene& scene, std::span<const SurfaceId> surfaces) {
  std::vector<GroupId> groups;
  for (const SurfaceId surface : surfaces) {
    const GroupId group = scene[surface].group;
    if (group.value < scene.groups.size() && !scene.groups[group.value].empty() &&
        std::find(groups.begin(), groups.end(), group) == groups.end()) {
      groups.push_back(group);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(groups.size(), kNamedGroups); ++i) {
    text += fmt::format("{}'{}'", i == 0 ? "" : ", ", scene.groups[groups[i].value]);
  }
  if (groups.size() > kNamedGroups) {
    text += fmt::format(" and {} more groups", groups.size() - kNamedGroups);
  }
  return text;
}

// "3 faces: 7-8, 20 ('table', 'lamp')".
std::string counted_faces(const Scene& scene, std::span<const SurfaceId> surfaces) {
  const auto faces = source_faces(scene, surfaces);
  std::string text =
      fmt::format("{} face{}: {}", faces.size(), faces.size() == 1 ? "" : "s", face_numbers(faces));
  const std::string groups = group_names(scene, surfaces);
  if (!groups.empty()) text += " (" + groups + ")";
  return text;
}

// A point of the polygon's interior, exact for lattice corners and their midpoints: it lies within
// the triangle of the first three corners.
Point interior_point(std::span<const Point> polygon) {
  return 0.5 * (0.5 * (polygon[0] + polygon[2]) + polygon[1]);
}

class RegionChecker {
 public:
  RegionChecker(const std::filesystem::path& file, const Scene& scene, const RegionCheck& check)
      : file_(file.string()), scene_(scene), check_(check), closed_(closed_surfaces(scene)) {
    for (const Surface& surface : scene.surfaces) {
      boxes_.push_back(bounding_box(surface.polygon));
      bounds_.extend(boxes_.back());
    }
  }

  void check_polygon(std::size_t number, const ConvexPolygon& part) const {
    const std::string name = fmt::format("region part {}", number + 1);
    if (!check_.allow_outside && is_outside(part)) refuse_outside(name);
    check_uncut(name, part);
    if (check_.clearance > 0) check_clearance(name, part);
    check_not_inside(name, part);
  }

  // Surfaces are outside the box, so that what is nearest to one is a face.
  void check_box(std::size_t number, const Box& box) const {
    const std::string name = fmt::format("region box {}", number + 1);
    if (!check_.allow_outside && !box.intersects(bounds_)) refuse_outside(name);
    check_empty(name, box);
    for (const ConvexPolygon& face : box_faces(box)) {
      if (check_.clearance > 0) check_clearance(name, face);
      check_not_inside(name, face);
    }
  }

 private:
  // Outside for certain: beyond one side of the box, or the box on one side of the part's plane.
  bool is_outside(const ConvexPolygon& part) const {
    if (!bounding_box(part).intersects(bounds_)) return true;
    int sides = 0;
    std::array<bool, 3> seen = {};
    for (const Point& corner : box_corners(bounds_)) {
      seen[static_cast<std::size_t>(orientation(part[0], part[1], part[2], corner) + 1)] = true;
    }
    for (const bool side : seen) sides += side;
    return sides == 1 && !seen[1];
  }

  [[noreturn]] void refuse_outside(const std::string& name) const {
    throw InputError(file_, name + " lies outside the scene's bounding box",
                     "move it into the scene, or pass --allow-outside");
  }

  void check_empty(const std::string& name, const Box& box) const {
    std::vector<SurfaceId> within;
    for (std::size_t s = 0; s < boxes_.size(); ++s) {
      if (box.intersects(boxes_[s]) && enters_box(scene_.surfaces[s].polygon, box)) {
        within.emplace_back(s);
      }
    }
    if (!within.empty()) {
      throw InputError(file_, name + " has inside " + counted_faces(scene_, within),
                       "move it into free space; touching is allowed");
    }
  }

  void check_uncut(const std::string& name, const ConvexPolygon& part) const {
    const Box box = bounding_box(part);
    std::vector<SurfaceId> cutting;
    for (std::size_t s = 0; s < boxes_.size(); ++s) {
      if (box.intersects(boxes_[s]) && cut_each_other(part, scene_.surfaces[s].polygon)) {
        cutting.emplace_back(s);
      }
    }
    if (!cutting.empty()) {
      throw InputError(file_, name + " is cut by " + counted_faces(scene_, cutting),
                       "move it into free space; touching is allowed");
    }
  }

  void check_clearance(const std::string& name, const ConvexPolygon& part) const {
    std::vector<SurfaceId> near;
    for (std::size_t s = 0; s < boxes_.size(); ++s) {
      if (is_nearer_than(part, scene_.surfaces[s].polygon, check_.clearance)) near.emplace_back(s);
    }
    if (!near.empty()) {
      throw InputError(file_,
                       fmt::format("{} is nearer than the clearance {} to {}", name,
                                   check_.clearance, counted_faces(scene_, near)),
                       "move it away from them, or ask for less --clearance");
    }
  }

  void check_not_inside(const std::string& name, const ConvexPolygon& part) const {
    const Box box = bounding_box(part);
    const ClosedSurface* innermost = nullptr;
    bool faces_region = false;
    for (const ClosedSurface& closed : closed_) {
      if (!closed.bounds.intersects(box) ||
          (innermost != nullptr && closed.bounds.volume() >= innermost->bounds.volume())) {
        continue;
      }
      // One point would do for a part that crosses nothing, but it may lie on the surface.
      for (const ConvexPolygon& quarter : quarters(part)) {
        const auto place = enclosure(scene_, closed, interior_point(quarter));
        if (!place || !place->is_inside) continue;
        innermost = &closed;
        faces_region = closed.is_oriented && place->winding < 0;
        break;
      }
    }
    if (innermost == nullptr || faces_region || !is_lesser_part(*innermost)) return;
    const std::string groups = group_names(scene_, innermost->surfaces);
    throw InputError(file_,
                     fmt::format("{} lies inside the closed object {}{}(faces {})", name, groups,
                                 groups.empty() ? "" : " ",
                                 face_numbers(source_faces(scene_, innermost->surfaces))),
                     "move it into free space");
  }

  // True iff more of the scene's area lies outside the bounds of the closed surface than within.
  bool is_lesser_part(const ClosedSurface& closed) const {
    double outside = 0, within = 0;
    for (std::size_t s = 0; s < boxes_.size(); ++s) {
      (closed.bounds.contains(boxes_[s]) ? within : outside) += area(scene_.surfaces[s].polygon);
    }
    return outside > within;
  }

  std::string file_;
  const Scene& scene_;
  const RegionCheck& check_;
  std::vector<ClosedSurface> closed_;
  std::vector<Box> boxes_;  // of the surfaces
  Box bounds_;
};

}  // namespace

void check_region_is_free(const std::filesystem::path& file, const Scene& scene,
                          const ViewingRegion& region, const RegionCheck& check) {
  if (!(check.clearance >= 0) || std::isinf(check.clearance)) {
    throw InputError("--clearance", fmt::format("{} is not a distance", check.clearance),
                     "use 0 or more, in scene units");
  }
  const RegionChecker checker(file, scene, check);
  for (std::size_t part = 0; part < region.polygon_count(); ++part) {
    checker.check_polygon(part, region.parts[part]);
  }
  for (std::size_t box = 0; box < region.boxes.size(); ++box) {
    checker.check_box(box, region.boxes[box]);
  }
}

}  // namespace viewcover
