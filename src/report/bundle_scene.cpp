#include "report/bundle_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "report/run_record.h"
#include "report/sha256.h"
#include "scene/error.h"

namespace viewcover {
namespace {

/// What run.json says about how the scene was loaded.
struct SceneRecord {
  std::string file, sha256;
  SceneOptions options;
};

/// Of six numbers, the least corner first; none for null.
std::optional<Box> box_of(const Json& numbers) {
  if (numbers.is_null()) return std::nullopt;
  const auto n = numbers.get<std::array<double, 6>>();
  return Box(Point(n[0], n[1], n[2]), Point(n[3], n[4], n[5]));
}

SceneRecord scene_record(const std::filesystem::path& folder) {
  const Json record = read_complete_run(folder);
  try {
    const Json &input = record.at("inputs").at("scene"), &options = record.at("options");
    SceneRecord scene{input.at("file"), input.at("sha256"), {}};
    if (!options.at("lattice").is_null()) {
      scene.options.lattice_exponent = options.at("lattice").get<int>();
    }
    scene.options.one_sided = options.at("one_sided");
    scene.options.merge_coplanar = options.at("merge_coplanar");
    scene.options.crop = box_of(options.value("crop", Json()));
    scene.options.heal = options.value("heal", 0.0);
    scene.options.targets = options.value("targets", std::vector<std::string>());
    return scene;
  } catch (const Json::exception& error) {
    throw InputError((folder / "run.json").string(),
                     std::string("does not say how the scene was loaded: ") + error.what(),
                     "give the folder of a finished run");
  }
}

/// The node that a row names, if the scene has it.
std::optional<ElementAddress> address_in(const CsvTable& table, std::size_t row,
                                         const Scene& scene) {
  const auto address = ElementAddress::from_file(
      table.count(row, "surface"), table.count(row, "level"), table.count(row, "path"));
  return address && address->owner().value < scene.surfaces.size() ? address : std::nullopt;
}

/// Ascending, and each surface filled: counted in nodes of the deepest level.
bool tile_surfaces(std::span<const ElementAddress> elements, std::size_t surfaces) {
  constexpr auto kWhole = std::uint64_t{1} << (2 * kMaxSubdivisionLevel);
  std::vector<std::uint64_t> filled(surfaces, 0);
  for (const ElementAddress element : elements) {
    filled[element.owner().value] += kWhole >> (2 * element.level());
  }
  return std::ranges::all_of(filled, [](std::uint64_t count) { return count == kWhole; }) &&
         std::ranges::adjacent_find(elements, [](ElementAddress a, ElementAddress b) {
           return a >= b || a.contains(b);
         }) == elements.end();
}

void read_elements(const std::filesystem::path& file, BundleScene& bundle) {
  const std::string advice = "give the folder and the scene of one run";
  const CsvTable table(file);
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto address = address_in(table, row, bundle.scene);
    if (!address ||
        !std::ranges::equal(corners_in(table, row),
                            subdivided(bundle.scene[address->owner()].polygon, *address))) {
      throw InputError(table.place(row), "is no element of the scene", advice);
    }
    bundle.elements.push_back(*address);
    bundle.times_visible.push_back(static_cast<std::uint32_t>(table.count(row, "times_visible")));
  }
  if (!tile_surfaces(bundle.elements, bundle.scene.surfaces.size())) {
    throw InputError(file.string(), "its elements do not tile the surfaces of the scene", advice);
  }
}

}  // namespace

BundleScene load_bundle_scene(const std::filesystem::path& folder,
                              const std::filesystem::path& scene_file) {
  const SceneRecord record = scene_record(folder);
  const std::filesystem::path file =
      scene_file.empty() ? std::filesystem::path(record.file) : scene_file;
  if (!std::filesystem::exists(file)) {
    throw InputError(file.string(), "the scene of the run is not there",
                     "say where it is with --scene FILE");
  }
  if (sha256_of_file(file) != record.sha256) {
    throw InputError(file.string(), "is not the scene of the run: its SHA-256 differs",
                     "give the file that was solved with --scene FILE");
  }
  BundleScene bundle{load_scene(file, record.options), record.options.one_sided, {}, {}};
  read_elements(folder / "elements.csv", bundle);
  return bundle;
}

ConvexPolygon corners_in(const CsvTable& table, std::size_t row) {
  ConvexPolygon polygon;
  for (std::size_t k = 0; table.has(fmt::format("x{}", k)); ++k) {
    if (table.text(row, fmt::format("x{}", k)).empty()) break;
    polygon.push_back({table.number(row, fmt::format("x{}", k)),
                       table.number(row, fmt::format("y{}", k)),
                       table.number(row, fmt::format("z{}", k))});
  }
  return polygon;
}

std::optional<RegionShape> region_in(const CsvTable& regions, std::size_t row) {
  const ConvexPolygon corners = corners_in(regions, row);
  if (!regions.has("volume") || regions.text(row, "volume").empty()) {
    if (corners.size() < 3) return std::nullopt;
    return RegionShape(corners);
  }
  const Box box = bounding_box(corners);
  if (corners.size() != 8 || !(box.volume() > 0)) return std::nullopt;
  return RegionShape(box);
}

std::optional<RegionShape> region_of_cell(const CsvTable& cells, std::size_t row,
                                          const CsvTable& regions) {
  const std::size_t region = cells.count(row, "region") - 1;
  if (region >= regions.size()) return std::nullopt;
  const std::size_t level = cells.count(row, "level"), top = regions.count(region, "level");
  if (level < top || level > static_cast<std::size_t>(kMaxSubdivisionLevel)) return std::nullopt;
  const std::uint64_t path = cells.count(row, "path");
  const RegionAddress below(PartId(0), static_cast<int>(level - top),
                            path & ((std::uint64_t{1} << (2 * (level - top))) - 1));
  const std::optional<RegionShape> root = region_in(regions, region);
  if (!root) return std::nullopt;
  return subdivided(*root, below);
}

std::vector<Point> read_positions(const std::filesystem::path& file) {
  const CsvTable table(file, "give a CSV file with the columns x, y and z");
  std::vector<Point> positions;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const Point& position = positions.emplace_back(table.number(row, "x"), table.number(row, "y"),
                                                   table.number(row, "z"));
    if (!position.allFinite()) {
      throw InputError(table.place(row), "is no place in space", "give finite numbers");
    }
  }
  return positions;
}

}  // namespace viewcover
