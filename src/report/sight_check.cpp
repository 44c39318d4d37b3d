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
#include "scene/random_numbers.h"
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

  /// `cells_too`: the columns of bound.mtx are elements.
  std::vector<BundleClaim> run(bool is_exact, bool cells_too) {
    check_viewpoints(is_exact);
    if (!is_exact) return std::move(claims_);
    check_nodes("region", "regions.csv", "visibility.mtx");
    if (cells_too && std::filesystem::exists(folder_ / "bound.csv")) {
      check_nodes("cell", "bound.csv", "bound.mtx");
    }
    return std::move(claims_);
  }

 private:
  BitRows matrix(const char* name) const {
    return read_cover_file(folder_ / name, CoverFormat::kMatrixMarket);
  }
  /// Of the scene's targets.
  BitRows seen_from(std::span<const Point> positions) const {
    BitRows seen =
        seen_elements(bundle_.scene, clusters_, bundle_.elements, positions, bundle_.one_sided);
    std::vector<BitRows::Word> others(seen.words_per_row());
    for (std::size_t i = 0; i < bundle_.elements.size(); ++i) {
      if (!bundle_.scene[bundle_.elements[i].owner()].is_target) add_column(others, i);
    }
    for (std::size_t i = 0; i < seen.rows(); ++i) remove_columns(seen.row(i), others);
    return seen;
  }

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
    const BitRows seen = seen_from(viewpoints);
    claims_.push_back(
        {claim, first_beyond(claimed, seen, rows, "viewpoint {} does not see element {}")});
    if (!is_exact) return;
    claims_.push_back(
        {"each viewpoint sees no elements but those that viewpoints.mtx says",
         first_beyond(seen, claimed, rows, "viewpoint {} sees element {}, which it does not say")});
  }

  /// Nodes of the quadtrees over the regions, such as regions and cells of the bound, see all that
  /// random positions in them see, of what any node is said to see.
  void check_nodes(const std::string& kind, const char* table, const char* matrix_file) {
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
      if (touches_a_surface(position)) continue;
      rows.push_back(row);
      positions.push_back(position);
    }
    BitRows seen = seen_from(positions);
    const std::vector<BitRows::Word> asked = claimed.union_of_all();
    for (std::size_t i = 0; i < seen.rows(); ++i) {
      for (std::size_t w = 0; w < asked.size(); ++w) seen.row(i)[w] &= asked[w];
    }
    claims_.push_back(
        {claim, first_beyond(seen, claimed, rows,
                             (kind + " {} sees element {}, which it does not say").c_str())});
  }

  bool touches_a_surface(const Point& position) const {
    return std::ranges::any_of(bundle_.scene.surfaces, [&](const Surface& surface) {
      return lies_in(position, surface.polygon);
    });
  }

  std::filesystem::path folder_;
  BundleScene bundle_;
  ClusterTree clusters_{bundle_.scene};
  CsvTable regions_{folder_ / "regions.csv"};
  RandomNumbers random_;
  std::vector<BundleClaim> claims_;
};

}  // namespace

std::vector<BundleClaim> check_sights(const std::filesystem::path& folder,
                                      const std::filesystem::path& scene_file, std::uint64_t seed) {
  const Json record = read_complete_run(folder);
  const Json results = record.value("results", Json::object());
  if (!results.contains("viewpoints")) return {};
  return SightChecker(folder, scene_file, seed)
      .run(record.value("options", Json::object()).value("backend", "") == "exact",
           results.value("bound_columns", "elements") == "elements");
}

}  // namespace viewcover
