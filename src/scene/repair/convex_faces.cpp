#include "scene/repair/convex_faces.h"

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "scene/error.h"
#include "scene/repair/convex_parts.h"

namespace viewcover {
namespace {

using Coordinates = std::array<double, 3>;
using CornerIds = std::vector<std::uint32_t>;

constexpr double kMostSteps = 0x1p32;

// The smallest rotation of a cyclic sequence, which starts with its smallest number.
CornerIds rotated_to_smallest(const CornerIds& ids) {
  const auto first = std::min_element(ids.begin(), ids.end());
  CornerIds smallest, rotated;
  for (auto start = first; start != ids.end(); start = std::find(start + 1, ids.end(), *first)) {
    rotated.assign(start, ids.end());
    rotated.insert(rotated.end(), ids.begin(), start);
    if (smallest.empty() || rotated < smallest) smallest = rotated;
  }
  return smallest;
}

class Welder {
 public:
  std::uint32_t id(const Point& point) {
    const auto next = static_cast<std::uint32_t>(ids_.size());
    // -0 and 0 are one coordinate: adding 0 makes them so.
    return ids_.try_emplace({point.x() + 0.0, point.y() + 0.0, point.z() + 0.0}, next)
        .first->second;
  }
  std::size_t size() const { return ids_.size(); }

 private:
  std::unordered_map<Coordinates, std::uint32_t, boost::hash<Coordinates>> ids_;
};

std::vector<char> vertices_in_use(const PolygonSoup& soup) {
  std::vector<char> is_used(soup.vertices.size(), 0);
  for (const PolygonSoup::Face& face : soup.faces) {
    for (const std::uint32_t vertex : face) is_used[vertex] = 1;
  }
  return is_used;
}

// The vertices on the lattice; those that no face uses are left as they are.
std::vector<Point> rounded_vertices(const PolygonSoup& soup, const Lattice& lattice, Welder& welder,
                                    Repairs& repairs) {
  std::vector<Point> rounded = soup.vertices;
  const std::vector<char> is_used = vertices_in_use(soup);
  std::size_t used = 0;
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    if (is_used[i] == 0) continue;
    ++used;
    if (!(soup.vertices[i].cwiseAbs().maxCoeff() < kMostSteps * lattice.step())) {
      throw InputError(
          soup.place_of_vertex(i), "a coordinate is too large for the lattice",
          "the magnitude must be less than " + std::to_string(kMostSteps * lattice.step()));
    }
    rounded[i] = lattice.round(soup.vertices[i]) + Point::Zero();  // no negative zeros
    welder.id(rounded[i]);
    repairs.largest_move = std::max(repairs.largest_move, (rounded[i] - soup.vertices[i]).norm());
  }
  repairs.welded_vertices = used - welder.size();
  return rounded;
}

}  // namespace

double largest_coordinate(const PolygonSoup& soup) {
  double largest = 0;
  for (const PolygonSoup::Face& face : soup.faces) {
    for (const std::uint32_t vertex : face) {
      largest = std::max(largest, soup.vertices[vertex].cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

ConvexFaces make_convex(const PolygonSoup& soup, const Lattice& lattice, bool one_sided) {
  ConvexFaces result;
  Repairs& repairs = result.repairs;
  Welder welder;
  const std::vector<Point> vertices = rounded_vertices(soup, lattice, welder, repairs);
  std::unordered_set<CornerIds, boost::hash<CornerIds>> faces_so_far;
  for (std::size_t face = 0; face < soup.faces.size(); ++face) {
    std::vector<Point> loop;
    for (const std::uint32_t vertex : soup.faces[face]) loop.push_back(vertices[vertex]);
    loop = without_straight_corners(loop);
    ConvexParts parts = convex_parts(loop);
    if (parts.kind == FaceKind::kCrossing) {
      throw InputError(soup.place_of_face(face), "the face crosses itself",
                       "faces are simple polygons, holes joined to the outline by an edge "
                       "walked twice");
    }
    if (parts.kind == FaceKind::kDegenerate) {
      ++repairs.degenerate_faces;
      continue;
    }
    CornerIds ids;
    for (const Point& corner : loop) ids.push_back(welder.id(corner));
    CornerIds key = rotated_to_smallest(ids);
    if (!one_sided) {
      std::reverse(ids.begin(), ids.end());
      key = std::min(key, rotated_to_smallest(ids));
    }
    if (!faces_so_far.insert(std::move(key)).second) {
      ++repairs.duplicate_faces;
      continue;
    }
    repairs.split_faces += parts.kind == FaceKind::kSplit;
    repairs.triangulated_faces += parts.kind == FaceKind::kTriangulated;
    for (ConvexPolygon& polygon : parts.polygons) {
      result.polygons.push_back(std::move(polygon));
      result.sources.push_back(static_cast<std::uint32_t>(face));
    }
  }
  return result;
}

std::vector<ConvexPolygon> load_convex_polygons(const std::filesystem::path& file,
                                                const Lattice& lattice) {
  const PolygonSoup soup = read_polygon_soup(file);
  ConvexFaces faces = make_convex(soup, lattice, false);
  if (faces.polygons.empty()) throw InputError(soup.file, "no face has area", "");
  return std::move(faces.polygons);
}

}  // namespace viewcover
