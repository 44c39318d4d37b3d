#include "show/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "scene/error.h"
#include "show/cutaway.h"
#include "show/image.h"
#include "show/legend.h"
#include "show/raster.h"

namespace viewcover {
namespace {

constexpr int kSamples = 3;  // 9 rays a pixel

std::vector<ConvexPolygon> polygons_of(const Scene& scene, const CommonElements& shown) {
  std::vector<ConvexPolygon> polygons;
  polygons.reserve(shown.size());
  for (const ElementAddress element : shown.addresses) {
    polygons.push_back(subdivided(scene[element.owner()].polygon, element));
  }
  return polygons;
}

/// The elements, none of whose surfaces is between the camera and the region.
std::vector<ConvexPolygon> uncut(const CommonElements& shown, std::vector<ConvexPolygon> polygons,
                                 std::span<const CutPlane> planes, const Point& camera) {
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (planes[shown.addresses[i].owner().value].cuts(camera)) polygons[i].clear();
  }
  return polygons;
}

std::vector<Point> corners_of(const Scene& scene) {
  std::vector<Point> corners;
  for (const Surface& surface : scene.surfaces) {
    corners.insert(corners.end(), surface.polygon.begin(), surface.polygon.end());
  }
  return corners;
}

/// A number for each surface, the same for surfaces of one group in one plane (as far as six digits
/// tell): no line is drawn between the triangles of a wall.
std::vector<std::uint32_t> outline_numbers(const Scene& scene) {
  constexpr double kSteps = 1e6;
  const double diagonal = scene.bounds.diagonal().norm();
  std::map<std::array<long, 5>, std::uint32_t> numbers;
  std::vector<std::uint32_t> of_surface;
  for (const Surface& surface : scene.surfaces) {
    const Point normal = area_vector(surface.polygon).normalized();
    const double offset = normal.dot(corner_mean(surface.polygon)) / diagonal;
    const auto number = static_cast<std::uint32_t>(numbers.size());
    of_surface.push_back(
        numbers
            .try_emplace({surface.group.value, std::lround(normal.x() * kSteps),
                          std::lround(normal.y() * kSteps), std::lround(normal.z() * kSteps),
                          std::lround(offset * kSteps)},
                         number)
            .first->second);
  }
  return of_surface;
}

/// The outlines of what was cut.
void draw_cut_outlines(Image& image, const Scene& scene, std::span<const CutPlane> planes,
                       std::span<const std::uint32_t> numbers, const Camera& camera) {
  using Edge = std::tuple<std::uint32_t, std::array<double, 3>, std::array<double, 3>>;
  const auto coordinates = [](const Point& p) { return std::array{p.x(), p.y(), p.z()}; };
  std::map<Edge, int> edges;  // how often within a plane
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!planes[i].cuts(camera.position())) continue;
    const ConvexPolygon& polygon = scene.surfaces[i].polygon;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      auto a = coordinates(polygon[k]), b = coordinates(polygon[(k + 1) % polygon.size()]);
      if (b < a) std::swap(a, b);
      ++edges[{numbers[i], a, b}];
    }
  }
  const double width = image.size().width / 1500.0;
  for (const auto& [edge, count] : edges) {
    const auto& [number, from, to] = edge;
    const auto a = camera.project(Point(from.data())), b = camera.project(Point(to.data()));
    if (count == 1 && a && b) image.draw_line(*a, *b, {70, 74, 84}, 0.35, width);
  }
}

void draw_viewpoints(Image& image, const RunData& run, const Camera& camera) {
  const double radius = image.size().width / 230.0;
  for (const ViewpointRow& viewpoint : run.viewpoints) {
    if (const auto place = camera.project(viewpoint.position)) {
      image.draw_dot(*place, radius, kViewpointColour, kInk, radius / 4);
    }
  }
}

std::vector<bool> chosen_flags(const RunData& run) {
  std::vector<bool> flags(run.regions.size(), false);
  for (const std::size_t region : run.chosen()) flags[region] = true;
  return flags;
}

std::string caption(const RunData& run) {
  const Json scene = run.record.value("scene", Json::object());
  std::string text = scene.value("name", std::string("scene")) + ": " +
                     std::to_string(run.bundle.scene.surfaces.size()) + " polygons, " +
                     std::to_string(run.bundle.elements.size()) + " elements, " +
                     std::to_string(run.chosen().size()) + " of " +
                     std::to_string(run.regions.size()) + " regions";
  if (!run.viewpoints.empty()) text += ", " + std::to_string(run.viewpoints.size()) + " viewpoints";
  return text;
}

}  // namespace

int up_axis_of(const RunData& run) {
  std::array<double, 3> across{};
  for (const ConvexPolygon& region : run.region_pictures()) {
    const Point normal = area_vector(region);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      across[axis] += std::fabs(normal[static_cast<Eigen::Index>(axis)]);
    }
  }
  constexpr double kClear = 2;  // regions may lie across all axes
  for (int axis = 0; axis < 3; ++axis) {
    const double others = std::max(across[static_cast<std::size_t>((axis + 1) % 3)],
                                   across[static_cast<std::size_t>((axis + 2) % 3)]);
    if (across[static_cast<std::size_t>(axis)] > kClear * others) return axis;
  }
  return 2;
}

void remove_pictures(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const char* file : {"figure.png", "report.html"}) {
    std::filesystem::remove(folder / file, ignored);
  }
  std::vector<std::filesystem::path> cameras;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("camera_") && name.ends_with(".png")) cameras.push_back(entry.path());
  }
  for (const auto& file : cameras) std::filesystem::remove(file, ignored);
}

ViewDirection default_view(const RunData& run, const CommonElements& shown, int up_axis) {
  constexpr PixelSize kSize{160, 120};
  constexpr double kStep = 45, kFirst = 235;  // degrees
  const Frame frame = Frame::with_up(up_axis);
  const std::vector<ConvexPolygon> polygons = polygons_of(run.bundle.scene, shown);
  const std::vector<CutPlane> planes = cut_planes(run.bundle.scene, run.region_pictures());
  const std::vector<Point> corners = corners_of(run.bundle.scene);
  ViewDirection best;
  std::size_t most = 0;
  for (int turn = 0; turn < 8; ++turn) {
    ViewDirection view;
    view.azimuth = kFirst + kStep * turn;
    const auto camera = make_outside_camera(corners, frame, view, kSize);
    const RayScene scene(uncut(shown, polygons, planes, camera->position()));
    std::set<std::uint32_t> met;
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        met.insert(scene.hit(camera->position(), camera->direction(x + 0.5, y + 0.5)).polygon);
      }
    }
    if (met.size() > most) {
      most = met.size();
      best = view;
    }
  }
  return best;
}

void draw_figure(const RunData& run, const CommonElements& shown, const FigureOptions& options,
                 const std::filesystem::path& file) {
  if (options.viewpoint && *options.viewpoint >= run.viewpoints.size()) {
    throw InputError("--camera " + std::to_string(*options.viewpoint + 1),
                     "there are " + std::to_string(run.viewpoints.size()) + " viewpoints",
                     "give the number of one in viewpoints.csv");
  }
  const Scene& scene = run.bundle.scene;
  const int up_axis = options.up_axis.value_or(up_axis_of(run));
  const Frame frame = Frame::with_up(up_axis);
  const Shading shading = shade(run, shown, options.colour_by);
  Legend legend(shading, options.size.width);
  legend.set_caption(caption(run));
  const PixelSize area{options.size.width, options.size.height - legend.height()};

  std::vector<ConvexPolygon> polygons = polygons_of(scene, shown);
  std::vector<CutPlane> planes(scene.surfaces.size());
  std::vector<ConvexPolygon> regions;
  std::unique_ptr<Camera> camera;
  if (options.viewpoint) {
    camera = make_panorama_camera(run.viewpoints[*options.viewpoint].position, frame, area);
    legend.set_caption("what viewpoint " + std::to_string(*options.viewpoint + 1) +
                       " sees: " + caption(run));
  } else {
    planes = cut_planes(scene, run.region_pictures());
    const std::vector<Point> corners = corners_of(scene);
    camera = make_outside_camera(
        corners, frame, options.view ? *options.view : default_view(run, shown, up_axis), area);
    polygons = uncut(shown, std::move(polygons), planes, camera->position());
    regions = run.region_pictures();
    legend.add_regions(!run.chosen().empty(), !run.viewpoints.empty());
  }

  const std::vector<std::uint32_t> numbers = outline_numbers(scene);
  std::vector<std::uint32_t> outlines;
  for (const ElementAddress element : shown.addresses) {
    outlines.push_back(numbers[element.owner().value]);
  }
  // From above, before the camera, and from the east of it, so that no two walls look the same.
  const Point light = (1.6 * frame.up + 0.9 * frame.north + 0.5 * frame.east).normalized();
  const RasterScene raster(polygons, shading.colours, std::move(outlines), regions,
                           chosen_flags(run), light);
  Image image(options.size);
  render(raster, *camera, area, kSamples, {255, 255, 255},
         [&](int x, int y, Colour colour) { image.set_pixel(x, y, colour); });
  if (!options.viewpoint) {
    draw_cut_outlines(image, scene, planes, numbers, *camera);
    draw_viewpoints(image, run, *camera);
  }
  legend.draw(image, area.height);
  image.write_png(file);
}

}  // namespace viewcover
