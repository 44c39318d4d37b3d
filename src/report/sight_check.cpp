#include "report/sight_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "audit/seen_elements.h"
#include "optim/cover_file.h"
#include "report/audit_files.h"
#include "report/bundle_scene.h"
#include "report/csv_table.h"
#include "report/run_record.h"
#include "scene/error.h"
#include "scene/random_numbers.h"
#include "scene/repair/narrow_gaps.h"
#include "viewpoints/column_bits.h"
#include "viewpoints/region_positions.h"

namespace viewcover {
namespace {

/// The first pair that `inner` has and `outer` has not, row i of the one against row rows[i] of the
/// other, put into the text.
std::string first_beyond(const BitRows& inner, const BitRows& outer,
                         std::span<const std::size_t> rows, const char* text) {
  for (std::size_t i = 0; i < inner.rows(); ++i) {
    for (std::size_t column = 0; column < inner.columns(); ++column) {
      if (inner.test(i, column) && !outer.test(rows[i], column)) {
        return fmt::format(fmt::runtime(text), rows[i] + 1, column + 1);
      }
    }
  }
  return {};
}

class SightChecker {
 public:
  SightChecker(const std::filesystem::path& folder, const std::filesystem::path& scene_file,
               std::uint64_t seed)
      : folder_(folder), bundle_(load_bundle_scene(folder, scene_file)), random_(seed) {}

  void check_viewpoints(bool is_exact) {
    const std::string claim = "each viewpoint sees the elements that viewpoints.mtx says";
    const std::vector<Point> viewpoints = read_positions(folder_ / kViewpointsFile);
    const BitRows claimed = matrix("viewpoints.mtx");
    if (claimed.rows() != viewpoints.size() || claimed.columns() != bundle_.elements.size()) {
      claims_.push_back({claim, "its size is another"});
      return;
    }
    std::vector<std::size_t> rows(viewpoints.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    const BitRows seen = seen_from(viewpoints, bundle_.scene);
    claims_.push_back(
        {claim, first_beyond(claimed, seen, rows, "viewpoint {} does not see element {}")});
    if (!is_exact) return;
    claims_.push_back(
        {"each viewpoint sees no elements but those that viewpoints.mtx says",
         first_beyond(seen, claimed, rows, "viewpoint {} sees element {}, which it does not say")});
  }

  void check_regions() {
    check_nodes("region", "regions.csv", "visibility.mtx", Asked::kAll, bundle_.scene);
  }
  void check_cells() {
    check_nodes("cell", "bound.csv", "bound.mtx", Asked::kSeenBySome, bundle_.scene);
  }
  void check_regions_with_gaps_closed() {
    const CsvTable table(folder_ / "gaps.csv");
    std::vector<NarrowGap> gaps;
    for (std::size_t row = 0; row < table.size(); ++row) {
      const SurfaceId surface(table.count(row, "surface") - 1);
      if (surface.value >= bundle_.scene.surfaces.size()) {
        throw InputError(table.place(row), "is of a surface that the scene does not have",
                         "give the folder of one run");
      }
      gaps.push_back({.surface = surface, .other = surface, .patch = corners_in(table, row)});
    }
    check_nodes("region", "regions.csv", "visibility-wide.mtx", Asked::kAll,
                with_gaps_closed(bundle_.scene, gaps));
  }

  std::vector<BundleClaim> claims() { return std::move(claims_); }

 private:
  /// What a matrix tells about: all elements, or those in some row of it.
  enum class Asked { kAll, kSeenBySome };

  BitRows matrix(const char* name) const {
    return read_cover_file(folder_ / name, CoverFormat::kMatrixMarket);
  }
  /// Of the scene's targets.
  BitRows seen_from(std::span<const Point> positions, const Scene& scene) const {
    BitRows seen =
        seen_elements(scene, ClusterTree(scene), bundle_.elements, positions, bundle_.one_sided);
    std::vector<BitRows::Word> others(seen.words_per_row());
    for (std::size_t i = 0; i < bundle_.elements.size(); ++i) {
      if (!bundle_.scene[bundle_.elements[i].owner()].is_target) add_column(others, i);
    }
    for (std::size_t i = 0; i < seen.rows(); ++i) remove_columns(seen.row(i), others);
    return seen;
  }

  /// Nodes of the quadtrees over the regions, such as regions and cells of the bound, see all that
  /// random positions in them see in the scene, of what the matrix tells about.
  void check_nodes(const std::string& kind, const char* table, const char* matrix_file, Asked what,
                   const Scene& scene) {
    constexpr std::size_t kPositions = 32;
    const std::string claim =
        fmt::format("random positions see no more than {} says of their {}s", matrix_file, kind);
    const CsvTable nodes(folder_ / table);
    const BitRows claimed = matrix(matrix_file);
    if (claimed.rows() != nodes.size() || claimed.columns() != bundle_.elements.size()) {
      claims_.push_back({claim, "its size is another"});
      return;
    }
    std::vector<std::size_t> rows;
    std::vector<Point> positions;
    for (std::size_t i = 0; i < kPositions && nodes.size() > 0; ++i) {
      const std::size_t row = random_.below(nodes.size());
      const auto shape = region_of_cell(nodes, row, regions_);
      if (!shape) {
        claims_.push_back({claim, fmt::format("{} {} is in no region", kind, row + 1)});
        return;
      }
      const RegionPositions places(*shape, bundle_.scene.bounds, bundle_.scene.lattice.exponent);
      const Point position = places.random(random_);
      if (touches_a_surface(position, scene)) continue;
      rows.push_back(row);
      positions.push_back(position);
    }
    BitRows seen = seen_from(positions, scene);
    if (what == Asked::kSeenBySome) {
      const std::vector<BitRows::Word> asked = claimed.union_of_all();
      for (std::size_t i = 0; i < seen.rows(); ++i) {
        for (std::size_t w = 0; w < asked.size(); ++w) seen.row(i)[w] &= asked[w];
      }
    }
    claims_.push_back(
        {claim, first_beyond(seen, claimed, rows,
                             (kind + " {} sees element {}, which it does not say").c_str())});
  }

  static bool touches_a_surface(const Point& position, const Scene& scene) {
    return std::ranges::any_of(
        scene.surfaces, [&](const Surface& surface) { return lies_in(position, surface.polygon); });
  }

  std::filesystem::path folder_;
  BundleScene bundle_;
  CsvTable regions_{folder_ / "regions.csv"};
  RandomNumbers random_;
  std::vector<BundleClaim> claims_;
};

}  // namespace

std::vector<BundleClaim> check_sights(const std::filesystem::path& folder,
                                      const std::filesystem::path& scene_file, std::uint64_t seed) {
  const Json record = read_complete_run(folder);
  const Json results = record.value("results", Json::object());
  const bool has_viewpoints = results.contains("viewpoints"),
             has_gaps = results.contains("wide") && std::filesystem::exists(folder / "gaps.csv"),
             is_exact = record.value("options", Json::object()).value("backend", "") == "exact";
  if (!has_viewpoints && !(has_gaps && is_exact)) return {};
  SightChecker checker(folder, scene_file, seed);
  if (has_viewpoints) checker.check_viewpoints(is_exact);
  if (is_exact) {
    checker.check_regions();
    if (has_gaps) checker.check_regions_with_gaps_closed();
    // The columns of bound.mtx may be witnesses.
    if (results.value("bound_columns", "elements") == "elements" &&
        std::filesystem::exists(folder / "bound.csv")) {
      checker.check_cells();
    }
  }
  return checker.claims();
}

}  // namespace viewcover
