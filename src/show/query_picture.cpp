#include "show/query_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "show/legend.h"
#include "show/ray_scene.h"

namespace viewcover {
namespace {

constexpr Colour kRegion{72, 72, 76}, kElement{86, 180, 233}, kSeenPart{250, 225, 110},
    kOccluder{176, 170, 160}, kWitness{0, 130, 90};

struct Face {
  ConvexPolygon polygon;
  Colour colour;
  double opacity = 1;
  bool on_element = false;  ///< lies in the element and is painted with it
};

std::vector<Face> faces_of(const QueryPicture& query) {
  std::vector<Face> faces;
  if (!query.region.empty()) faces.push_back({query.region, kRegion, 0.75});
  faces.push_back({query.element, kElement, 0.8});
  for (const ConvexPolygon& occluder : query.occluders) {
    faces.push_back({occluder, kOccluder, 0.72});
  }
  return faces;
}

Point middle(const QueryPicture& query) {
  return query.region.empty() ? query.viewpoint : corner_mean(query.region);
}

/// East runs from the region to the element, up is as near to z as that allows.
Frame shaft_frame(const QueryPicture& query) {
  Point east = corner_mean(query.element) - middle(query);
  if (east.isZero(0)) east = Point::UnitX();
  east.normalize();
  constexpr double kSteep = 0.95;
  const Point near_up = std::fabs(east.z()) > kSteep ? Point::UnitY() : Point::UnitZ();
  const Point up = (near_up - near_up.dot(east) * east).normalized();
  return {east, up.cross(east), up};
}

std::vector<Point> points_of(const QueryPicture& query) {
  std::vector<Point> points(query.element.begin(), query.element.end());
  points.insert(points.end(), query.region.begin(), query.region.end());
  if (query.region.empty()) points.push_back(query.viewpoint);
  for (const ConvexPolygon& occluder : query.occluders) {
    points.insert(points.end(), occluder.begin(), occluder.end());
  }
  return points;
}

class Drawing {
 public:
  Drawing(Image& image, const Camera& camera, const std::vector<Face>& faces)
      : image_(image),
        camera_(camera),
        line_(image.size().width / 900.0),
        scene_(polygons(faces)) {}

  /// Far faces first: enough for a few polygons that do not cut each other.
  void faces(std::vector<Face> faces, const Point& element_middle) {
    std::ranges::stable_sort(faces, std::greater(), [&](const Face& face) {
      const Point place = face.on_element ? element_middle : corner_mean(face.polygon);
      return (place - camera_.position()).norm();
    });
    for (const Face& face : faces) {
      const std::vector<Eigen::Vector2d> corners = projected(face.polygon);
      if (corners.size() < 3) continue;
      image_.fill_polygon(corners, face.colour, face.opacity);
      image_.outline_polygon(corners, kInk, 0.8, line_);
    }
  }

  void segment(const Point& from, const Point& to, Colour colour, double width) {
    constexpr int kPieces = 160;
    for (int i = 0; i < kPieces; ++i) {
      const auto at = [&](double t) -> Point { return from + t / kPieces * (to - from); };
      const auto a = camera_.project(at(i)), b = camera_.project(at(i + 1));
      if (!a || !b) continue;
      image_.draw_line(*a, *b, colour, is_covered(at(i + 0.5)) ? 0.3 : 1, width * line_);
    }
  }

  void dot(const Point& place, Colour colour, double radius) {
    if (const auto at = camera_.project(place)) {
      image_.draw_dot(*at, radius * line_, colour, kInk, line_);
    }
  }

 private:
  static std::vector<ConvexPolygon> polygons(const std::vector<Face>& faces) {
    std::vector<ConvexPolygon> all;
    for (const Face& face : faces) all.push_back(face.polygon);
    return all;
  }
  std::vector<Eigen::Vector2d> projected(const ConvexPolygon& polygon) const {
    std::vector<Eigen::Vector2d> corners;
    for (const Point& p : polygon) {
      if (const auto at = camera_.project(p)) corners.push_back(*at);
    }
    return corners;
  }
  /// Whether a polygon is in front of a place.
  bool is_covered(const Point& place) const {
    constexpr float kBefore = 0.999f;  // of the way: a line may lie in a polygon
    return scene_.hit(camera_.position(), place - camera_.position()).distance < kBefore;
  }

  Image& image_;
  const Camera& camera_;
  double line_;  ///< width of an outline, pixels
  RayScene scene_;
};

}  // namespace

void draw_query(const QueryPicture& query, const std::optional<ViewDirection>& view, PixelSize size,
                const std::filesystem::path& file) {
  Shading meaning;
  meaning.title = query.region.empty() ? "from a viewpoint" : "from a region";
  if (!query.region.empty()) meaning.entries.push_back({kRegion, "region"});
  meaning.entries.push_back({kElement, "element"});
  if (!query.visible_parts.empty()) meaning.entries.push_back({kSeenPart, "seen part"});
  if (!query.occluders.empty()) meaning.entries.push_back({kOccluder, "occluder"});
  if (query.witness) meaning.entries.push_back({kWitness, "witness"});
  std::map<std::string, Colour> kinds;
  for (const StabbingLine& line : query.lines) kinds.emplace(line.kind, Colour{});
  std::size_t number = 4;  // the strongest of the categories first
  for (auto& [kind, colour] : kinds) {
    colour = mixed(category(number++), {0, 0, 0}, 0.15);
    meaning.entries.push_back({colour, kind});
  }
  Legend legend(meaning, size.width);
  legend.set_caption(query.caption);

  const PixelSize area{size.width, size.height - legend.height()};
  const std::vector<Point> points = points_of(query);
  const auto camera =
      make_outside_camera(points, shaft_frame(query), view.value_or(ViewDirection{-116, 22}), area);
  Image image(size);
  const std::vector<Face> faces = faces_of(query);
  Drawing drawing(image, *camera, faces);
  std::vector<Face> painted = faces;
  for (const ConvexPolygon& part : query.visible_parts)
    painted.push_back({part, kSeenPart, 0.85, true});
  drawing.faces(std::move(painted), corner_mean(query.element));
  for (const StabbingLine& line : query.lines) {
    drawing.segment(line.from, line.to, kinds.at(line.kind), 1.1);
  }
  if (query.witness) {
    drawing.segment(query.witness->first, query.witness->second, kWitness, 3);
    drawing.dot(query.witness->first, kWitness, 4);
    drawing.dot(query.witness->second, kWitness, 4);
  }
  if (query.region.empty()) drawing.dot(query.viewpoint, {245, 245, 245}, 6);
  legend.draw(image, area.height);
  image.write_png(file);
}

}  // namespace viewcover
