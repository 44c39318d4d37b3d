#include "show/page_data.h"

#include <bit>
#include <cstring>

#include "show/colour.h"
#include "show/cutaway.h"

namespace viewcover {
namespace {

static_assert(std::endian::native == std::endian::little, "typed arrays of the page");

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

template <class Number>
std::string encoded(const std::vector<Number>& numbers) {
  return base64({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)});
}

template <class From>
std::string encoded_numbers(const std::vector<From>& numbers) {
  return encoded(std::vector<std::uint32_t>(numbers.begin(), numbers.end()));
}

Json bit_rows(const BitRows& bits) {
  const std::size_t stride = (bits.columns() + 7) / 8;
  std::string bytes;
  bytes.reserve(bits.rows() * stride);
  for (std::size_t row = 0; row < bits.rows(); ++row) {
    bytes.append(reinterpret_cast<const char*>(bits.row(row).data()), stride);
  }
  return {{"rows", bits.rows()}, {"columns", bits.columns()}, {"bits", base64(bytes)}};
}

Json encoded_polygons(std::span<const ConvexPolygon> polygons) {
  std::string counts;
  std::vector<float> corners;
  for (const ConvexPolygon& polygon : polygons) {
    // A polygon is a fan to the page; one with more corners than a byte counts loses the rest.
    const std::size_t count = std::min<std::size_t>(polygon.size(), 255);
    counts += static_cast<char>(static_cast<unsigned char>(count));
    for (std::size_t i = 0; i < count; ++i) {
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        corners.push_back(static_cast<float>(polygon[i][axis]));
      }
    }
  }
  return {{"counts", base64(counts)}, {"corners", encoded(corners)}};
}

Json rgb(Colour colour) { return {colour.red, colour.green, colour.blue}; }

Json stops(Colour (*of)(double)) {
  constexpr int kSteps = 16;
  Json list = Json::array();
  for (int i = 0; i <= kSteps; ++i) list.push_back(rgb(of(static_cast<double>(i) / kSteps)));
  return list;
}

Json palette() {
  constexpr std::size_t kCategories = 8;
  Json categories = Json::array();
  for (std::size_t i = 0; i < kCategories; ++i) categories.push_back(rgb(category(i)));
  return {{"never", rgb(kNeverSeen)},     {"quiet", rgb(kUnchanged)},
          {"hardly", rgb(kHardlySeen)},   {"region", rgb(kRegionColour)},
          {"chosen", rgb(kChosenColour)}, {"lit", rgb({252, 222, 110})},
          {"dim", rgb({70, 76, 88})},     {"ramp", stops(ramp)},
          {"missed", stops(missed_ramp)}, {"excess", stops(excess_ramp)},
          {"categories", categories}};
}

void add_scene(const RunData& run, const CommonElements& shown, Json& data) {
  const Scene& scene = run.bundle.scene;
  std::vector<ConvexPolygon> pieces, surfaces;
  std::vector<std::uint32_t> piece_surface, surface_group;
  for (const ElementAddress element : shown.addresses) {
    pieces.push_back(subdivided(scene[element.owner()].polygon, element));
    piece_surface.push_back(element.owner().value);
  }
  for (const Surface& surface : scene.surfaces) {
    surfaces.push_back(surface.polygon);
    surface_group.push_back(surface.group.value);
  }
  std::vector<float> planes;
  for (const CutPlane& plane : cut_planes(scene, run.region_pictures())) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      planes.push_back(static_cast<float>(plane.normal[axis]));
    }
    planes.push_back(static_cast<float>(plane.offset));
  }
  data["name"] = scene.name;
  data["groups"] = scene.groups;
  data["pieces"] = encoded_polygons(pieces);
  data["piece_surface"] = encoded(piece_surface);
  data["piece_element"] = encoded_numbers(shown.first);
  data["surfaces"] = encoded_polygons(surfaces);
  data["surface_group"] = encoded(surface_group);
  data["cut_planes"] = encoded(planes);
}

void add_results(const RunData& run, Json& data) {
  data["areas"] = encoded(std::vector<float>(run.areas.begin(), run.areas.end()));
  data["times_visible"] = encoded(run.bundle.times_visible);
  data["regions"] = encoded_polygons(run.region_pictures());
  data["seen"] = bit_rows(run.seen);
  data["covers"] = Json::array();
  for (const CoverRow& cover : run.covers) {
    data["covers"].push_back({{"regions", cover.regions},
                              {"covered", cover.covered_percent},
                              {"bound", cover.upper_bound_percent},
                              {"seconds", cover.seconds},
                              {"evaluations", cover.evaluations}});
  }
  data["viewpoints"] = Json::array();
  for (const ViewpointRow& viewpoint : run.viewpoints) {
    const Point& p = viewpoint.position;
    data["viewpoints"].push_back({{"position", {p.x(), p.y(), p.z()}},
                                  {"region", viewpoint.region},
                                  {"covered", viewpoint.covered_percent},
                                  {"seconds", viewpoint.seconds}});
  }
  data["seen_from_viewpoints"] = bit_rows(run.seen_from_viewpoints);
}

void add_difference(const PageContent& content, Json& data) {
  std::vector<std::uint32_t> missed, excess;
  for (const Difference& difference : content.shown.differences) {
    missed.push_back(difference.missed);
    excess.push_back(difference.excess);
  }
  data["other_run"] = content.other->record;
  data["other_name"] = content.other_name;
  data["other_seen"] = bit_rows(content.other->seen);
  data["piece_other"] = encoded_numbers(content.shown.second);
  data["missed"] = encoded(missed);
  data["excess"] = encoded(excess);
}

}  // namespace

std::string page_data(const PageContent& content) {
  Json data;
  data["run"] = content.run.record;
  data["name_of_run"] = content.run_name;
  data["up_axis"] = content.up_axis;
  data["view"] = {{"azimuth", content.view.azimuth}, {"elevation", content.view.elevation}};
  data["palette"] = palette();
  add_scene(content.run, content.shown, data);
  add_results(content.run, data);
  if (content.other != nullptr) add_difference(content, data);
  std::string text;
  for (const char character : data.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (character == '<') {
      text += "\\u003c";
    } else {
      text += character;
    }
  }
  return text;
}

}  // namespace viewcover
