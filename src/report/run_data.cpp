#include "report/run_data.h"

#include <numeric>
#include <optional>
#include <utility>

#include "optim/cover_file.h"
#include "report/csv_table.h"
#include "scene/error.h"

namespace viewcover {
namespace {

/// Errors: InputError for a row that names no node, or not one after those of the rows before.
RegionAddress region_address(const CsvTable& table, std::size_t row, const RegionAddress* before) {
  const auto address = RegionAddress::from_file(table.count(row, "part"), table.count(row, "level"),
                                                table.count(row, "path"));
  if (address && (before == nullptr || *before < *address)) return *address;
  throw InputError(table.place(row), "is no region in its place", "give the folder of one run");
}

/// Numbers of a file, which count from 1, as numbers from 0 below `end`.
std::size_t place_of(std::size_t number, std::size_t end, const std::string& place) {
  if (number >= 1 && number <= end) return number - 1;
  throw InputError(place, "there is no region " + std::to_string(number),
                   "give the folder of one run");
}

void require_size(const std::filesystem::path& file, std::string_view what, std::size_t found,
                  std::size_t expected) {
  if (found == expected) return;
  throw InputError(file.string(),
                   "has " + std::to_string(found) + " " + std::string(what) + ", not " +
                       std::to_string(expected),
                   "give the folder of one run");
}

void read_faces(const std::filesystem::path& file, RunData& run) {
  const CsvTable table(file);
  for (std::size_t row = 0; row < table.size(); ++row) {
    const std::size_t region =
        place_of(table.count(row, "region"), run.regions.size(), table.place(row));
    const auto address = RegionAddress::from_file(table.count(row, "part"), 0, 0);
    if (!address || !run.face_regions.emplace(address->owner(), region).second) {
      throw InputError(table.place(row), "is no face of its own", "give the folder of one run");
    }
  }
}

void read_covers(const std::filesystem::path& file, RunData& run) {
  const CsvTable table(file);
  for (std::size_t row = 0; row < table.size(); ++row) {
    CoverRow cover{table.counts(row, "regions"), table.number(row, "covered_area_percent"),
                   table.number(row, "upper_bound_percent"), table.number(row, "seconds"),
                   table.count(row, "evaluations")};
    for (std::size_t& region : cover.regions) {
      region = place_of(region, run.regions.size(), table.place(row));
    }
    run.covers.push_back(std::move(cover));
  }
}

void read_viewpoints(const std::filesystem::path& folder, RunData& run) {
  const CsvTable table(folder / "viewpoints.csv");
  for (std::size_t row = 0; row < table.size(); ++row) {
    run.viewpoints.push_back(
        {Point(table.number(row, "x"), table.number(row, "y"), table.number(row, "z")),
         place_of(table.count(row, "region"), run.regions.size(), table.place(row)),
         table.number(row, "covered_area_percent"), table.number(row, "seconds")});
  }
  const auto matrix = folder / "viewpoints.mtx";
  if (run.viewpoints.empty()) {
    run.seen_from_viewpoints = BitRows(0, run.bundle.elements.size());
    return;
  }
  run.seen_from_viewpoints = read_cover_file(matrix, CoverFormat::kMatrixMarket);
  require_size(matrix, "rows", run.seen_from_viewpoints.rows(), run.viewpoints.size());
  require_size(matrix, "columns", run.seen_from_viewpoints.columns(), run.bundle.elements.size());
}

}  // namespace

RunData load_run_data(const std::filesystem::path& folder,
                      const std::filesystem::path& scene_file) {
  RunData run{.record = read_complete_run(folder),
              .bundle = load_bundle_scene(folder, scene_file),
              .areas = {},
              .regions = {},
              .region_addresses = {},
              .face_regions = {},
              .seen = {},
              .covers = {},
              .viewpoints = {},
              .seen_from_viewpoints = {}};
  const CsvTable elements(folder / "elements.csv");
  for (std::size_t row = 0; row < elements.size(); ++row) {
    run.areas.push_back(elements.number(row, "area"));
  }
  const CsvTable regions(folder / "regions.csv");
  for (std::size_t row = 0; row < regions.size(); ++row) {
    const std::optional<RegionShape> shape = region_in(regions, row);
    if (!shape) throw InputError(regions.place(row), "has fewer than 3 corners or no volume", "");
    run.regions.push_back(*shape);
    run.region_addresses.push_back(
        region_address(regions, row, row == 0 ? nullptr : &run.region_addresses.back()));
  }
  if (regions.has("volume")) read_faces(folder / "faces.csv", run);
  run.seen = read_cover_file(folder / "visibility.mtx", CoverFormat::kMatrixMarket);
  require_size(folder / "visibility.mtx", "rows", run.seen.rows(), run.regions.size());
  require_size(folder / "visibility.mtx", "columns", run.seen.columns(), run.areas.size());
  read_covers(folder / "cover.csv", run);
  read_viewpoints(folder, run);
  return run;
}

std::vector<ConvexPolygon> RunData::region_pictures() const {
  std::vector<ConvexPolygon> pictures;
  for (const RegionShape& region : regions) pictures.push_back(region.picture());
  return pictures;
}

std::vector<std::uint32_t> column_counts(const BitRows& bits, std::span<const std::size_t> rows) {
  std::vector<std::uint32_t> counts(bits.columns(), 0);
  for (const std::size_t row : rows) {
    for_each_bit(bits.row(row), [&](std::size_t column) { ++counts[column]; });
  }
  return counts;
}

std::vector<std::uint32_t> column_counts(const BitRows& bits) {
  std::vector<std::size_t> rows(bits.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return column_counts(bits, rows);
}

}  // namespace viewcover
