#include "fuzz/readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "app/sight_json.h"
#include "exact/sight_query.h"
#include "optim/cover_file.h"
#include "scene/error.h"
#include "scene/generate/gallery.h"
#include "scene/read/json_text.h"
#include "scene/read/polygon_soup.h"
#include "scene/repair/surface_mesh.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover::fuzz {
namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

/// Runs; whatever is refused is refused in one line.
template <class Task>
void accept_or_refuse(const Task& task) {
  try {
    task();
  } catch (const InputError& error) {
    const std::string_view line = error.what();
    require(!line.empty() && line.find_first_of("\r\n") == std::string_view::npos,
            "a refusal is one line");
  }
}

void check_soup(const PolygonSoup& soup) {
  require(!soup.faces.empty() && soup.face_groups.size() == soup.faces.size(), "faces in groups");
  for (const Point& vertex : soup.vertices) require(vertex.allFinite(), "finite vertices");
  for (const PolygonSoup::Face& face : soup.faces) {
    require(face.size() >= 3, "three corners");
    for (const std::uint32_t corner : face) require(corner < soup.vertices.size(), "corners");
  }
  for (const GroupId group : soup.face_groups) require(group.value < soup.groups.size(), "groups");
}

void check_scene(const Scene& scene) {
  require(!scene.surfaces.empty(), "a scene has surfaces");
  for (const Surface& surface : scene.surfaces) {
    require(is_planar(surface.polygon) && is_strictly_convex(surface.polygon), "convex, planar");
  }
  const SurfaceMesh mesh(scene.surfaces);
  require(mesh.faces() == scene.surfaces.size(), "a mesh has all surfaces");
}

void run_soup(std::string_view content, const char* file) {
  accept_or_refuse([&] {
    const PolygonSoup soup = parse_polygon_soup(content, file);
    check_soup(soup);
    double largest = 0;
    for (const Point& p : soup.vertices) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    accept_or_refuse([&] { check_scene(make_scene(soup)); });
    SceneOptions healed;
    healed.heal = largest * 0x1p-6;
    healed.merge_coplanar = true;
    accept_or_refuse([&] { check_scene(make_scene(soup, healed)); });
  });
}

void run_region(std::string_view content) {
  accept_or_refuse([&] {
    const RegionFile region =
        parse_json_region(std::string(content), "fuzz.json", Lattice::for_extent(10));
    require(!region.polygons.empty() || !region.boxes.empty(), "a region has parts");
    for (const ConvexPolygon& polygon : region.polygons) {
      require(is_planar(polygon) && is_strictly_convex(polygon), "convex, planar");
    }
    for (const Box& box : region.boxes) {
      require((box.sizes().array() > 0).all(), "a box has a volume");
    }
  });
}

void run_plan(std::string_view content) {
  accept_or_refuse([&] {
    const GeneratedScene scene = gallery("fuzz.txt", parse_floor_plan(content, "fuzz.txt"), 2.5);
    require(!scene.faces.empty() && !scene.region.empty(), "a gallery has walls and a region");
  });
}

void run_cover(std::string_view content) {
  constexpr std::size_t kMostEntries = 1 << 24;
  const auto read = [&](CoverFormat format) {
    accept_or_refuse([&] { parse_cover(std::string(content), "fuzz", format, kMostEntries); });
  };
  if (content.starts_with("%%")) return read(CoverFormat::kMatrixMarket);
  if (content.starts_with("p ") || content.starts_with("c")) return read(CoverFormat::kHittingSet);
  read(CoverFormat::kScp);
  read(CoverFormat::kRail);
}

/// Small enough to be decided in no time.
bool is_small(const SightQuery& query) {
  constexpr std::size_t kOccluders = 4, kCorners = 6;
  return query.region.size() <= kCorners && query.element.size() <= kCorners &&
         query.occluders.size() <= kOccluders &&
         std::ranges::all_of(query.occluders,
                             [](const auto& polygon) { return polygon.size() <= kCorners; });
}

void run_sees(std::string_view content) {
  accept_or_refuse([&] {
    Json object;
    try {
      refuse_deep_json(content, "query");
      object = Json::parse(content);
    } catch (const Json::exception&) {
      return;
    }
    const ReadQuery read = read_query(object);
    if (!is_small(read.query)) return;
    const SightAnswer answer =
        read.from_viewpoint ? decide_from_point(read.query) : decide_from_region(read.query);
    require(!is_visible(answer.verdict) || answer.witness, "a visible verdict has a witness");
  });
}

constexpr std::array kReaders = {
    Reader{"obj", [](std::string_view content) { run_soup(content, "fuzz.obj"); }},
    Reader{"off", [](std::string_view content) { run_soup(content, "fuzz.off"); }},
    Reader{"ply", [](std::string_view content) { run_soup(content, "fuzz.ply"); }},
    Reader{"stl", [](std::string_view content) { run_soup(content, "fuzz.stl"); }},
    Reader{"gltf", [](std::string_view content) { run_soup(content, "fuzz.gltf"); }},
    Reader{"dae", [](std::string_view content) { run_soup(content, "fuzz.dae"); }},
    Reader{"region", run_region},
    Reader{"plan", run_plan},
    Reader{"cover", run_cover},
    Reader{"sees", run_sees},
};

}  // namespace

std::span<const Reader> readers() { return kReaders; }

const Reader& reader(std::string_view name) {
  const auto found = std::ranges::find(kReaders, name, &Reader::name);
  require(found != kReaders.end(), "a reader of that name");
  return *found;
}

std::vector<std::string> corpus_of(const Reader& reader, const std::string& folder) {
  std::ifstream file(folder + "/" + std::string(reader.name) + ".txt");
  std::vector<std::string> corpus;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line[0] != '#') corpus.push_back(from_line(line));
  }
  return corpus;
}

std::string as_line(std::string_view content) {
  std::string line;
  for (std::size_t i = 0; i < content.size(); ++i) {
    const char c = content[i];
    const bool readable = c >= ' ' && c <= '~' && c != '\\' && !(i == 0 && c == '#');
    if (readable) {
      line += c;
    } else if (const auto known = std::string_view("\n\r\t\\").find(c);
               known != std::string_view::npos) {
      line.append("\\").append(1, "nrt\\"[known]);
    } else {
      constexpr std::string_view kDigits = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(c);
      line.append("\\x").append(1, kDigits[byte >> 4]).append(1, kDigits[byte & 15]);
    }
  }
  return line;
}

std::string from_line(std::string_view line) {
  std::string content;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\' || i + 1 == line.size()) {
      content += line[i];
      continue;
    }
    const char kind = line[++i];
    if (kind == 'x' && i + 2 < line.size()) {
      content += static_cast<char>(std::stoi(std::string(line.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else {
      const auto known = std::string_view("nrt").find(kind);
      content += known == std::string_view::npos ? kind : "\n\r\t"[known];
    }
  }
  return content;
}

}  // namespace viewcover::fuzz
