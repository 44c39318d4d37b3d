#include "app/sight_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "scene/convex_polygon.h"
#include "scene/error.h"

namespace viewcover {
namespace {

/// Products of three coordinates stay within the range of double.
constexpr double kLargest = 0x1p300, kSmallest = 0x1p-300;
constexpr std::array<std::string_view, 5> kKeys = {"id", "region", "viewpoint", "element",
                                                   "occluders"};

double coordinate(const Json& value, const std::string& place) {
  if (!value.is_number()) throw InputError(place, "is no number", "give [x, y, z]");
  const auto number = value.get<double>();
  const bool exact =
      value.is_number_unsigned()
          ? number < 0x1p64 && static_cast<std::uint64_t>(number) == value.get<std::uint64_t>()
      : value.is_number_integer() ? static_cast<std::int64_t>(number) == value.get<std::int64_t>()
                                  : std::isfinite(number);
  if (!exact) {
    throw InputError(place, "is an integer that no double holds exactly",
                     "use at most 53 significant bits");
  }
  const double size = std::fabs(number);
  if (size != 0 && (size < kSmallest || size > kLargest)) {
    throw InputError(place, "is too large or too small",
                     "give magnitudes between 2^-300 and 2^300, or 0");
  }
  return number;
}

Point point(const Json& value, const std::string& place) {
  if (!value.is_array() || value.size() != 3) {
    throw InputError(place, "is no point", "give [x, y, z]");
  }
  Point result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[static_cast<Eigen::Index>(i)] = coordinate(value[i], place);
  }
  return result;
}

ConvexPolygon polygon(const Json& value, const std::string& place) {
  if (!value.is_array() || value.size() < 3) {
    throw InputError(place, "is no polygon", "give at least 3 corners [x, y, z]");
  }
  ConvexPolygon corners;
  for (std::size_t i = 0; i < value.size(); ++i) {
    corners.push_back(point(value[i], place + " corner " + std::to_string(i + 1)));
    if (i > 0 && corners[i] == corners[i - 1]) {
      throw InputError(place, "repeats corner " + std::to_string(i), "give each corner once");
    }
  }
  if (corners.front() == corners.back()) {
    throw InputError(place, "ends with its first corner", "give each corner once");
  }
  ConvexPolygon turning;
  for (const std::size_t place_of_corner : turning_corners(corners)) {
    turning.push_back(corners[place_of_corner]);
  }
  if (turning.size() < 3 || area_vector(turning).isZero(0)) {
    throw InputError(place, "has no area", "give corners that are not on one line");
  }
  if (!is_planar(turning)) {
    throw InputError(place, "is not planar", "give corners in one plane, exactly, or triangles");
  }
  if (!is_strictly_convex(turning)) {
    throw InputError(place, "is not convex", "give convex parts, corners in order");
  }
  return corners;
}

}  // namespace

Json id_of(const Json& object) {
  return object.is_object() && object.contains("id") ? object.at("id") : Json(nullptr);
}

ReadQuery read_query(const Json& object) {
  if (!object.is_object()) {
    throw InputError("query", "is no JSON object",
                     R"(give {"id", "region" or "viewpoint", "element", "occluders"})");
  }
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(kKeys, key) == kKeys.end()) {
      throw InputError("\"" + key + "\"", "is no key of a query",
                       "use id, region or viewpoint, element, occluders");
    }
  }
  ReadQuery read;
  read.id = id_of(object);
  if (object.contains("region") == object.contains("viewpoint")) {
    throw InputError("query", "needs either \"region\" or \"viewpoint\"", "give one of them");
  }
  if (!object.contains("element")) {
    throw InputError("query", "has no \"element\"", "give a polygon to look at");
  }
  read.from_viewpoint = object.contains("viewpoint");
  if (read.from_viewpoint) {
    read.query.viewpoint = point(object.at("viewpoint"), "viewpoint");
  } else {
    read.query.region = polygon(object.at("region"), "region");
  }
  read.query.element = polygon(object.at("element"), "element");
  if (object.contains("occluders")) {
    const Json& occluders = object.at("occluders");
    if (!occluders.is_array()) {
      throw InputError("occluders", "is no list", "give a list of polygons, [] for none");
    }
    for (std::size_t i = 0; i < occluders.size(); ++i) {
      read.query.occluders.push_back(polygon(occluders[i], "occluder " + std::to_string(i + 1)));
    }
  }
  return read;
}

Json to_json(const Witness& witness, const SightQuery& query) {
  const auto coordinates = [](const Point& p) { return Json{p.x(), p.y(), p.z()}; };
  Json json;
  json["from"] = coordinates(witness.region_weights.empty()
                                 ? query.viewpoint
                                 : weighted_point(query.region, witness.region_weights));
  json["to"] = coordinates(weighted_point(query.element, witness.element_weights));
  if (!witness.region_weights.empty()) json["region_weights"] = witness.region_weights;
  json["element_weights"] = witness.element_weights;
  return json;
}

}  // namespace viewcover
