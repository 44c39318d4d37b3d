#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/error.h"
#include "scene/read/polygon_soup.h"
#include "scene/repair/convex_faces.h"
#include "scene/repair/crop.h"
#include "scene/repair/surface_mesh.h"

namespace viewcover {
namespace {

// Determinants multiply three coordinates: between these limits neither they nor the smallest
// products of lattice steps (2^-23 of the extent) leave the range of double.
constexpr double kLargestExtent = 0x1p100;
constexpr double kSmallestExtent = 0x1p-100;

// Coarser than this, the whole scene would be a few lattice steps.
constexpr int kFewestBits = 4;

Lattice choose_lattice(const PolygonSoup& soup, std::optional<int> exponent) {
  const double extent = largest_coordinate(soup);
  if (extent > kLargestExtent) {
    for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
      if (soup.vertices[i].cwiseAbs().maxCoeff() > kLargestExtent) {
        throw InputError(soup.place_of_vertex(i), "a coordinate is too large",
                         fmt::format("the magnitude is at most {}", kLargestExtent));
      }
    }
  }
  if (extent != 0 && extent < kSmallestExtent) {
    throw InputError(soup.file, "all coordinates are too small",
                     fmt::format("the largest magnitude is at least {}", kSmallestExtent));
  }
  // Rounding may carry the largest coordinate up to a power of two that needs one bit more.
  Lattice finest = Lattice::for_extent(extent);
  finest = Lattice::for_extent(finest.round(extent));
  if (!exponent) return finest;
  const int coarsest = finest.exponent - 23 + kFewestBits;
  if (*exponent > finest.exponent || *exponent < coarsest) {
    throw InputError(
        "--lattice", fmt::format("2^-{} does not suit the scene", *exponent),
        fmt::format("for coordinates up to {} from {} to {}", extent, coarsest, finest.exponent));
  }
  return {*exponent};
}

/// Returns how far a vertex moved at most.
double round_to(const Lattice& lattice, PolygonSoup& soup) {
  double largest = 0;
  for (Point& vertex : soup.vertices) {
    const Point rounded = lattice.round(vertex);
    largest = std::max(largest, (rounded - vertex).norm());
    vertex = rounded;
  }
  return largest;
}

/// Which groups are to be seen. A name is that of a group, OBJECT/GROUP, or of its object.
std::vector<char> targets_of(const PolygonSoup& soup, std::span<const std::string> names) {
  std::vector<char> is_target(soup.groups.size(), names.empty() ? 1 : 0);
  for (const std::string& name : names) {
    bool found = false;
    for (std::size_t i = 0; i < soup.groups.size(); ++i) {
      const std::string& group = soup.groups[i];
      if (group != name && !group.starts_with(name + "/")) continue;
      is_target[i] = 1;
      found = true;
    }
    if (found) continue;
    constexpr std::size_t kListed = 8;
    const std::size_t listed = std::min(kListed, soup.groups.size());
    throw InputError(
        "--target", fmt::format("{} has no group \"{}\"", soup.file, name),
        fmt::format("its groups are {}{}", fmt::join(std::span(soup.groups).first(listed), ", "),
                    listed < soup.groups.size() ? ", ..." : ""));
  }
  return is_target;
}

std::string counted(std::size_t count, const char* noun, const char* participle) {
  return fmt::format("{} {}{} {}", count, noun, count == 1 ? "" : "s", participle);
}

}  // namespace

std::string Repairs::summary() const {
  const std::pair<std::size_t, std::string> items[] = {
      {cropped_faces, counted(cropped_faces, "face", "left out by --crop")},
      {degenerate_faces, counted(degenerate_faces, "degenerate face", "dropped")},
      {duplicate_faces, counted(duplicate_faces, "duplicate face", "dropped")},
      {split_faces, counted(split_faces, "face", "split into convex parts")},
      {triangulated_faces, counted(triangulated_faces, "face", "triangulated")},
      {merged_surfaces, counted(merged_surfaces, "surface", "merged into a neighbour")},
      {healing.moved, counted(healing.moved, "place", "of a vertex moved to another")},
      {healing.inserted, counted(healing.inserted, "corner", "inserted in an edge")},
      {healing.bent, counted(healing.bent, "corner", "inserted inside a face")},
  };
  std::string line;
  for (const auto& [count, text] : items) {
    if (count == 0) continue;
    if (!line.empty()) line += ", ";
    line += text;
  }
  return line.empty() ? "nothing" : line;
}

double Scene::area() const {
  double sum = 0;
  for (const Surface& surface : surfaces) sum += viewcover::area(surface.polygon);
  return sum;
}

Scene load_scene(const std::filesystem::path& file, const SceneOptions& options) {
  return make_scene(read_polygon_soup(file), options);
}

Scene make_scene(PolygonSoup soup, const SceneOptions& options) {
  Scene scene;
  scene.name = std::filesystem::path(soup.file).stem().string();
  scene.faces = soup.faces.size();
  if (options.crop) scene.repairs.cropped_faces = crop(soup, *options.crop);
  scene.lattice = choose_lattice(soup, options.lattice_exponent);
  scene.warning = far_out_warning(soup, find_far_out(soup), scene.lattice.step());
  Healing healing;
  double rounding = 0;
  if (options.heal > 0) {
    // What is on the lattice is what has cracks.
    rounding = round_to(scene.lattice, soup);
    healing = heal(soup, options.heal);
  }
  ConvexFaces faces = make_convex(soup, scene.lattice, options.one_sided);
  if (faces.polygons.empty()) {
    throw InputError(soup.file, fmt::format("none of the {} faces has area", soup.faces.size()),
                     "");
  }
  faces.repairs.cropped_faces = scene.repairs.cropped_faces;
  scene.repairs = faces.repairs;
  scene.repairs.largest_move = std::max(scene.repairs.largest_move, rounding);
  scene.repairs.healing = healing;
  const std::vector<char> is_target = targets_of(soup, options.targets);
  scene.groups = std::move(soup.groups);
  scene.surfaces.reserve(faces.polygons.size());
  for (std::size_t i = 0; i < faces.polygons.size(); ++i) {
    const GroupId group = soup.face_groups[faces.sources[i]];
    scene.surfaces.push_back({std::move(faces.polygons[i]), group,
                              static_cast<std::uint32_t>(soup.number_in_file(faces.sources[i])),
                              is_target[group.value] != 0});
  }
  if (options.merge_coplanar) scene.repairs.merged_surfaces = merge_coplanar(scene.surfaces);
  if (scene.surfaces.size() > ElementAddress::kOwnerLimit) {
    throw InputError(soup.file, fmt::format("{} convex surfaces", scene.surfaces.size()),
                     fmt::format("at most {} can be numbered", ElementAddress::kOwnerLimit));
  }
  for (const Surface& surface : scene.surfaces) {
    scene.bounds.extend(bounding_box(surface.polygon));
  }
  return scene;
}

}  // namespace viewcover
