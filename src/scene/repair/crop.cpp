#include "scene/repair/crop.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "scene/error.h"
#include "scene/lattice.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

/// A face is far out if it reaches so many times as far as this share of the faces.
constexpr double kFarOut = 40, kUsual = 0.6;
/// A lattice that is coarser by less is no matter.
constexpr double kCoarser = 8;

Box bounds_of(const PolygonSoup& soup, const PolygonSoup::Face& face) {
  Box bounds;
  for (const std::uint32_t corner : face) bounds.extend(soup.vertices[corner]);
  return bounds;
}

/// Keeps the vertices that faces use, in their order.
void drop_unused_vertices(PolygonSoup& soup) {
  constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(soup.vertices.size(), kUnused);
  for (const PolygonSoup::Face& face : soup.faces) {
    for (const std::uint32_t corner : face) number[corner] = 0;
  }
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == kUnused) continue;
    number[i] = kept;
    soup.vertices[kept] = soup.vertices[i];
    if (!soup.vertex_lines.empty()) soup.vertex_lines[kept] = soup.vertex_lines[i];
    ++kept;
  }
  soup.vertices.resize(kept);
  if (!soup.vertex_lines.empty()) soup.vertex_lines.resize(kept);
  for (PolygonSoup::Face& face : soup.faces) {
    for (std::uint32_t& corner : face) corner = number[corner];
  }
}

/// The value that a share of all does not exceed. Requires one at least.
double quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

/// How far each face reaches, along the axes, from the middle of the faces.
std::vector<double> reaches(const PolygonSoup& soup) {
  std::vector<Box> boxes;
  boxes.reserve(soup.faces.size());
  for (const PolygonSoup::Face& face : soup.faces) boxes.push_back(bounds_of(soup, face));
  Point middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> centres;
    centres.reserve(boxes.size());
    for (const Box& box : boxes) centres.push_back(box.center()[axis]);
    middle[axis] = quantile(std::move(centres), 0.5);
  }
  std::vector<double> reaches;
  reaches.reserve(boxes.size());
  for (const Box& box : boxes) {
    reaches.push_back((box.max() - middle).cwiseMax(middle - box.min()).maxCoeff());
  }
  return reaches;
}

double largest_coordinate_of(const PolygonSoup& soup, const PolygonSoup::Face& face) {
  double largest = 0;
  for (const std::uint32_t corner : face) {
    largest = std::max(largest, soup.vertices[corner].cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

std::size_t crop(PolygonSoup& soup, const Box& box) {
  const std::size_t before = soup.faces.size();
  std::size_t kept = 0;
  std::vector<std::uint32_t> numbers;
  Box all;
  for (std::size_t i = 0; i < before; ++i) {
    const Box bounds = bounds_of(soup, soup.faces[i]);
    all.extend(bounds);
    if (!box.intersects(bounds)) continue;
    numbers.push_back(static_cast<std::uint32_t>(soup.number_in_file(i)));
    if (kept != i) soup.faces[kept] = std::move(soup.faces[i]);
    soup.face_groups[kept] = soup.face_groups[i];
    if (!soup.face_lines.empty()) soup.face_lines[kept] = soup.face_lines[i];
    ++kept;
  }
  if (kept == 0) {
    throw InputError("--crop", fmt::format("no face of {} is in the box", soup.file),
                     fmt::format("they lie from {},{},{} to {},{},{}", all.min().x(), all.min().y(),
                                 all.min().z(), all.max().x(), all.max().y(), all.max().z()));
  }
  soup.faces.resize(kept);
  soup.face_groups.resize(kept);
  if (!soup.face_lines.empty()) soup.face_lines.resize(kept);
  soup.numbers_in_file = std::move(numbers);
  drop_unused_vertices(soup);
  return before - kept;
}

FarOut find_far_out(const PolygonSoup& soup) {
  FarOut far;
  if (soup.faces.empty()) return far;
  const std::vector<double> reach = reaches(soup);
  const double most = kFarOut * quantile(reach, kUsual);
  double largest = 0;
  for (std::uint32_t i = 0; i < soup.faces.size(); ++i) {
    const PolygonSoup::Face& face = soup.faces[i];
    if (reach[i] <= most) {
      largest = std::max(largest, largest_coordinate_of(soup, face));
      continue;
    }
    far.faces.push_back(i);
    far.vertices.insert(far.vertices.end(), face.begin(), face.end());
  }
  std::ranges::sort(far.vertices);
  far.vertices.erase(std::unique(far.vertices.begin(), far.vertices.end()), far.vertices.end());
  if (largest > 0) far.step_without = Lattice::for_extent(largest).step();
  return far;
}

std::string far_out_warning(const PolygonSoup& soup, const FarOut& far_out, double step) {
  constexpr std::size_t kListed = 3;
  const std::size_t faces = far_out.faces.size();
  if (faces == 0 || far_out.step_without == 0 || far_out.step_without * kCoarser > step) return "";
  std::string listed;
  double largest = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    const std::uint32_t face = far_out.faces[i];
    largest = std::max(largest, largest_coordinate_of(soup, soup.faces[face]));
    if (i >= kListed) continue;
    const std::string& group = soup.groups[soup.face_groups[face].value];
    listed += fmt::format("{}{}", i == 0 ? "" : ", ", soup.number_in_file(face) + 1);
    if (!group.empty()) listed += " (" + in_quotes(group) + ")";
  }
  if (faces > kListed) listed += fmt::format(" and {} more", faces - kListed);
  return fmt::format(
      "{}: face{} {} reach{} {:.6g} from the origin, far from the rest: the lattice step is "
      "{:.2g}, and "
      "would be {:.2g} without; leave far things out with --crop",
      soup.file, faces == 1 ? "" : "s", listed, faces == 1 ? "es" : "", largest, step,
      far_out.step_without);
}

}  // namespace viewcover
