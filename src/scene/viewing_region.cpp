#include "scene/viewing_region.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "scene/error.h"
#include "scene/predicates.h"
#include "scene/read/json_text.h"
#include "scene/repair/convex_faces.h"

namespace viewcover {
namespace {

using nlohmann::json;

constexpr int kMaxRegionLevel = 10;

// Regions of the deepest level need 2 further bits a level (scene/address.h); with 27-bit
// coordinates, sign included, they have 47 of the 53 bits of a double, and differences 48. A scene
// has 24, so a region may reach 8 times as far.
constexpr int kReachBits = 26;

// Coordinates are written by people and programs with at least four significant digits: a corner
// that is off the plane or the line of the others by less is meant to lie on it. Relative to the
// diameter of the polygon.
constexpr double kWrittenPrecision = 1e-4;

std::string read_text(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw InputError(name, "no such file",
                     fmt::format("give a region as .json, {}", mesh_file_types()));
  }
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError(name, "is a folder", "give a region file");
  }
  std::ifstream in(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (!in) throw InputError(name, "cannot be read", "check its permissions");
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(name, "is empty", R"(write {"polygons": [[[x, y, z], ...], ...]})");
  }
  return text;
}

void check_keys(const json& object, const std::string& place,
                std::initializer_list<const char*> known, const char* advice) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw InputError(place, fmt::format("unknown key {}", json(key).dump()), advice);
    }
  }
}

Point lattice_point(const json& value, const std::string& place, const Lattice& lattice) {
  const bool is_point =
      value.is_array() && value.size() == 3 &&
      std::all_of(value.begin(), value.end(), [](const json& x) { return x.is_number(); });
  if (!is_point) throw InputError(place, "is not a point", "write three numbers: [x, y, z]");
  const Point point(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
  const double reach = std::ldexp(1.0, kReachBits - lattice.exponent);
  if (point.cwiseAbs().maxCoeff() > reach) {
    throw InputError(place, "lies too far from the scene to be on its lattice",
                     fmt::format("use coordinates up to {}", reach));
  }
  return lattice.round(point) + Point::Zero();  // no negative zeros
}

// A corner of a polygon being cleaned, with its 1-based number in the file.
struct Corner {
  Point point;
  std::size_t number;
};

class PolygonCleaner {
 public:
  PolygonCleaner(std::string place, std::vector<Corner> corners, const Lattice& lattice)
      : place_(std::move(place)), corners_(std::move(corners)), lattice_(lattice) {}

  // The polygon, or the triangles of a fan if it is not exactly planar on the lattice.
  std::vector<ConvexPolygon> convex_parts() {
    Box box;
    for (const Corner& corner : corners_) box.extend(corner.point);
    // Rounding moves each of two points by up to sqrt(3) / 2 lattice steps.
    tolerance_ = kWrittenPrecision * box.diagonal().norm() + std::sqrt(3.0) * lattice_.step();

    remove_repeated();
    check_has_area();
    normal_ = area_vector(points()).normalized();
    if (normal_.isZero(0)) refuse_crossing();  // as much area one way round as the other
    axis_ = projection_axis(points());
    check_planar();
    remove_straight();
    check_convex();

    const ConvexPolygon loop = points();
    if (is_planar(loop)) return {loop};
    std::vector<ConvexPolygon> fan;
    for (std::size_t i = 2; i < loop.size(); ++i) fan.push_back({loop[0], loop[i - 1], loop[i]});
    return fan;
  }

 private:
  const Corner& at(std::size_t i) const { return corners_[i % corners_.size()]; }

  ConvexPolygon points() const {
    ConvexPolygon loop;
    for (const Corner& corner : corners_) loop.push_back(corner.point);
    return loop;
  }

  // Sign of the turn at corner number i of the loop, positive for the way round of the polygon.
  int turn_at(std::size_t i) const {
    const std::size_t n = corners_.size();
    const int sign = normal_[axis_] > 0 ? 1 : -1;
    return sign * turn(at(i + n - 1).point, at(i).point, at(i + 1).point, axis_);
  }

  // Leaves one of each run of equal corners, round the loop.
  void remove_repeated() {
    const auto is_repeated = [](const Corner& a, const Corner& b) { return a.point == b.point; };
    corners_.erase(std::unique(corners_.begin(), corners_.end(), is_repeated), corners_.end());
    while (corners_.size() > 1 && is_repeated(corners_.front(), corners_.back())) {
      corners_.pop_back();
    }
  }

  // Removes corners on the straight way between their neighbours, and those that only rounding (of
  // the writer or to the lattice) put to the wrong side of it.
  void remove_straight() {
    for (std::size_t i = 0, kept = 0; corners_.size() >= 3 && kept < corners_.size();) {
      const std::size_t n = corners_.size();
      i %= n;
      if (turn_at(i) <= 0 && distance_to_chord(i) <= tolerance_) {
        corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(i));
        kept = 0;  // the turns of the neighbours have changed
      } else {
        ++i;
        ++kept;
      }
    }
  }

  double distance_to_chord(std::size_t i) const {
    const Point &from = at(i + corners_.size() - 1).point, &to = at(i + 1).point;
    const Point chord = to - from, offset = at(i).point - from;
    const double length = chord.squaredNorm();
    const double t = length == 0 ? 0 : std::clamp(offset.dot(chord) / length, 0.0, 1.0);
    return (offset - t * chord).norm();
  }

  // Exact: some three corners turn in some projection.
  void check_has_area() const {
    for (std::size_t i = 2; i < corners_.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        if (turn(at(0).point, at(1).point, at(i).point, axis) != 0) return;
      }
    }
    throw InputError(place_, "has no area",
                     fmt::format("give three or more corners that are not on a line and farther "
                                 "apart than the lattice step {:.3g}",
                                 lattice_.step()));
  }

  void check_planar() const {
    double worst = 0;
    std::size_t number = 0;
    const Point middle = corner_mean(points());
    for (const Corner& corner : corners_) {
      const double distance = std::fabs((corner.point - middle).dot(normal_));
      if (distance > worst) {
        worst = distance;
        number = corner.number;
      }
    }
    if (worst > tolerance_) {
      throw InputError(place_,
                       fmt::format("is not planar: corner {} lies {:.3g} off", number, worst),
                       "move it into the plane, or split the polygon into triangles");
    }
  }

  void check_convex() const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (turn_at(i) <= 0) {
        throw InputError(place_, fmt::format("is not convex at corner {}", at(i).number),
                         kSplitAdvice);
      }
    }
    if (!is_strictly_convex(points())) refuse_crossing();
  }

  [[noreturn]] void refuse_crossing() const {
    throw InputError(place_, "crosses itself", kSplitAdvice);
  }

  static constexpr const char* kSplitAdvice = "split the polygon into convex ones";

  std::string place_;
  std::vector<Corner> corners_;
  Lattice lattice_;
  double tolerance_ = 0;  // scene units
  Point normal_;
  int axis_ = 0;
};

std::vector<ConvexPolygon> read_polygon(const json& value, const std::string& place,
                                        const Lattice& lattice) {
  if (!value.is_array()) {
    throw InputError(place, "is not a list of corners", "write [[x, y, z], ...]");
  }
  std::vector<Corner> corners;
  for (const json& corner : value) {
    const std::size_t number = corners.size() + 1;
    corners.push_back(
        {lattice_point(corner, fmt::format("{}: corner {}", place, number), lattice), number});
  }
  if (corners.size() < 3) {
    throw InputError(place,
                     fmt::format("has {} corner{}", corners.size(), corners.size() == 1 ? "" : "s"),
                     "give three or more");
  }
  return PolygonCleaner(place, std::move(corners), lattice).convex_parts();
}

Box read_box(const json& value, const std::string& place, const Lattice& lattice) {
  constexpr const char* kAdvice = R"(write {"min": [x, y, z], "max": [x, y, z]})";
  if (!value.is_object()) throw InputError(place, "is not a box", kAdvice);
  check_keys(value, place, {"min", "max"}, kAdvice);
  for (const char* key : {"min", "max"}) {
    if (!value.contains(key)) throw InputError(place, fmt::format("has no \"{}\"", key), kAdvice);
  }
  const Box box(lattice_point(value["min"], place + ": min", lattice),
                lattice_point(value["max"], place + ": max", lattice));
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min()[axis] >= box.max()[axis]) {
      throw InputError(place, fmt::format("min is not below max in {}", "xyz"[axis]),
                       fmt::format("leave at least the lattice step {:.3g}", lattice.step()));
    }
  }
  return box;
}

int region_level(std::size_t regions_per_part) {
  std::size_t power = 1;
  for (int level = 0; level <= kMaxRegionLevel; ++level, power *= 4) {
    if (regions_per_part == power) return level;
    if (regions_per_part < power) {
      throw InputError(
          "--regions", fmt::format("{} is not a power of 4", regions_per_part),
          level == 0 ? "use 1 or more" : fmt::format("use {} or {}", power / 4, power));
    }
  }
  throw InputError("--regions", fmt::format("{} is too many", regions_per_part),
                   fmt::format("use at most {}", power / 4));
}

}  // namespace

RegionFile parse_json_region(const std::string& content, const std::string& file,
                             const Lattice& lattice) {
  constexpr const char* kAdvice = R"(use "polygons" or "boxes")";
  const json root = parse_json(content, file);
  if (!root.is_object()) {
    throw InputError(file, "is not a JSON object", R"(write {"polygons": [...], "boxes": [...]})");
  }
  check_keys(root, file, {"polygons", "boxes"}, kAdvice);
  for (const auto& [key, value] : root.items()) {
    if (!value.is_array()) {
      throw InputError(file, fmt::format("\"{}\" is not a list", key), "write [...]");
    }
  }
  const json polygons = root.value("polygons", json::array());
  const json boxes = root.value("boxes", json::array());
  if (polygons.empty() && boxes.empty()) {
    throw InputError(file, "has no polygon and no box", kAdvice);
  }

  RegionFile region;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (ConvexPolygon& part :
         read_polygon(polygons[i], fmt::format("{}: polygon {}", file, i + 1), lattice)) {
      region.polygons.push_back(std::move(part));
    }
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    region.boxes.push_back(read_box(boxes[i], fmt::format("{}: box {}", file, i + 1), lattice));
  }
  return region;
}

ViewingRegion make_viewing_region(std::vector<ConvexPolygon> polygons, std::vector<Box> boxes,
                                  int level) {
  ViewingRegion region{.parts = std::move(polygons), .level = level, .boxes = std::move(boxes)};
  for (const Box& box : region.boxes) {
    for (std::size_t path = 0; path < region.regions_per_part(); ++path) {
      const RegionAddress address(PartId(std::size_t{0}), level, path);
      for (ConvexPolygon& face : subdivided(RegionShape(box), address).faces()) {
        region.parts.push_back(std::move(face));
      }
    }
  }
  return region;
}

ViewingRegion load_viewing_region(const std::filesystem::path& file, const Lattice& lattice,
                                  std::size_t regions_per_part) {
  const int level = region_level(regions_per_part);
  RegionFile read;
  if (is_mesh_file(file)) {
    read.polygons = load_convex_polygons(file, lattice);
  } else {
    read = parse_json_region(read_text(file), file.string(), lattice);
  }
  // Addresses name polygons, boxes and the faces of cells.
  constexpr std::size_t kLimit = RegionAddress::kOwnerLimit, kFaces = ViewingRegion::kFacesOfCell;
  const std::size_t faces = read.boxes.size() << (2 * level);
  if (read.polygons.size() + read.boxes.size() >= kLimit || faces >= kLimit / kFaces / 2) {
    throw InputError(
        file.string(),
        fmt::format("has {} polygons and {} boxes", read.polygons.size(), read.boxes.size()),
        fmt::format("use fewer than {} polygons, and {} boxes times --regions", kLimit / 2,
                    kLimit / kFaces / 2));
  }
  return make_viewing_region(std::move(read.polygons), std::move(read.boxes), level);
}

}  // namespace viewcover
