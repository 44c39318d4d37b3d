#include "report/viewpoint_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "optim/check_cover_proof.h"
#include "optim/cover_file.h"
#include "report/bundle_scene.h"
#include "scene/address.h"
#include "viewpoints/region_positions.h"

namespace viewcover {
namespace {

using Json = nlohmann::ordered_json;

/// Sums in another order, and a text with 17 digits, as shares of 100.
constexpr double kPercentRounding = 1e-4;

/// The first column that `inner` has and `outer` has not.
std::optional<std::size_t> first_missing(std::span<const BitRows::Word> inner,
                                         std::span<const BitRows::Word> outer) {
  for (std::size_t w = 0; w < inner.size(); ++w) {
    const BitRows::Word missing = inner[w] & ~outer[w];
    if (missing != 0) return w * 64 + static_cast<std::size_t>(std::countr_zero(missing));
  }
  return std::nullopt;
}

class ViewpointChecker {
 public:
  ViewpointChecker(const std::filesystem::path& folder, const Json& results,
                   const BitRows& visibility, std::span<const double> areas)
      : folder_(folder),
        results_(results),
        visibility_(visibility),
        areas_(areas),
        viewpoints_(folder / "viewpoints.csv"),
        regions_(folder / "regions.csv"),
        seen_(read_cover_file(folder / "viewpoints.mtx", CoverFormat::kMatrixMarket)) {}

  std::vector<BundleClaim> run() {
    std::string wrong = sizes();
    const bool fits = wrong.empty();
    claims_.push_back({"viewpoints.csv, viewpoints.mtx and run.json agree", std::move(wrong)});
    if (!fits) return std::move(claims_);
    claims_.push_back({"each viewpoint lies in its region", outside()});
    claims_.push_back({"each viewpoint sees no more than its region", beyond_region()});
    claims_.push_back({"viewpoints.csv states what the viewpoints see", percents()});
    check_bound();
    return std::move(claims_);
  }

 private:
  std::string sizes() const {
    const auto stated = results_.value("viewpoints", std::size_t{0});
    if (viewpoints_.size() != stated || seen_.rows() != stated) {
      return fmt::format("{}, {} and {} viewpoints", viewpoints_.size(), seen_.rows(), stated);
    }
    if (seen_.columns() != visibility_.columns() || areas_.size() != visibility_.columns()) {
      return fmt::format("{} columns for {} elements", seen_.columns(), visibility_.columns());
    }
    for (std::size_t i = 0; i < viewpoints_.size(); ++i) {
      const std::size_t region = viewpoints_.count(i, "region");
      if (region < 1 || region > visibility_.rows() || region > regions_.size()) {
        return fmt::format("no region {}", region);
      }
    }
    return {};
  }

  std::size_t region(std::size_t viewpoint) const {
    return viewpoints_.count(viewpoint, "region") - 1;
  }

  std::string outside() const {
    for (std::size_t i = 0; i < viewpoints_.size(); ++i) {
      const Point position(viewpoints_.number(i, "x"), viewpoints_.number(i, "y"),
                           viewpoints_.number(i, "z"));
      const auto shape = region_in(regions_, region(i));
      if (!shape || !shape->contains(position)) {
        return fmt::format("viewpoint {} lies outside region {}", i + 1, region(i) + 1);
      }
    }
    return {};
  }

  std::string beyond_region() const {
    for (std::size_t i = 0; i < viewpoints_.size(); ++i) {
      if (const auto column = first_missing(seen_.row(i), visibility_.row(region(i)))) {
        return fmt::format("viewpoint {} sees element {}, region {} does not", i + 1, *column + 1,
                           region(i) + 1);
      }
    }
    return {};
  }

  std::string percents() const {
    std::vector<BitRows::Word> unseen = visibility_.union_of_all();
    const double total = weight_of(unseen, areas_);
    for (std::size_t i = 0; i < viewpoints_.size(); ++i) {
      for (std::size_t w = 0; w < unseen.size(); ++w) unseen[w] &= ~seen_.row(i)[w];
      const double covered = 100 * (1 - weight_of(unseen, areas_) / total),
                   stated = viewpoints_.number(i, "covered_area_percent");
      if (!(std::fabs(covered - stated) <= kPercentRounding)) {
        return fmt::format("{} % after viewpoint {}, but they see {} %", stated, i + 1, covered);
      }
    }
    const std::size_t missing = count_bits(unseen),
                      admitted = results_.value("elements_from_no_position", std::size_t{0});
    return missing == admitted
               ? ""
               : fmt::format("{} elements are missing, run.json admits {}", missing, admitted);
  }

  void check_bound() {
    const Json stated = results_.value("viewpoints_lower_bound", Json());
    if (!stated.is_number_unsigned()) return;
    const auto bound = stated.get<std::size_t>();
    const auto of_regions = results_.value("regions_lower_bound", std::size_t{0});
    claims_.push_back({"the lower bound is at most the number of viewpoints",
                       bound <= viewpoints_.size()
                           ? ""
                           : fmt::format("{} and {} viewpoints", bound, viewpoints_.size())});
    if (bound <= of_regions) return;
    const BitRows cells = read_cover_file(folder_ / "bound.mtx", CoverFormat::kMatrixMarket);
    claims_.push_back({is_of_witnesses()
                           ? "the cells of the bound tile the regions"
                           : "the cells of the bound tile the regions and see no more than they do",
                       wrong_cell(cells)});
    std::ifstream proof = open_for_check(folder_ / "bound.proof");
    const CoverProofVerdict verdict = check_cover_proof(cells, proof);
    claims_.push_back(
        {fmt::format("bound.proof proves that no {} viewpoints see everything", bound - 1),
         !verdict.holds ? fmt::format("line {}: {}", verdict.line, verdict.reason)
         : verdict.lower_bound != bound
             ? fmt::format("it proves {}, run.json states {}", verdict.lower_bound, bound)
             : ""});
  }

  /// Cells are in quadtree order, so those of a region tile it iff each begins where the one before
  /// it ends, in units of the finest level.
  std::string wrong_cell(const BitRows& seen) const {
    const CsvTable cells(folder_ / "bound.csv");
    if (cells.size() != seen.rows() ||
        (!is_of_witnesses() && seen.columns() != visibility_.columns())) {
      return "bound.csv and bound.mtx do not agree";
    }
    std::size_t region = 0, begin = 0, end = 0;  // what is tiled next, and the region's end
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t owner = cells.count(i, "region") - 1;
      if (owner >= regions_.size()) return fmt::format("cell {} is of no region", i + 1);
      if (i == 0 || owner != region) {
        if (begin != end || owner != (i == 0 ? 0 : region + 1)) {
          return fmt::format("cells of region {} are missing", region + 1);
        }
        region = owner;
        begin = first_leaf(regions_, region);
        end = begin + leaves(regions_, region);
      }
      if (cells.text(i, "part") != regions_.text(region, "part") ||
          cells.count(i, "level") > kMaxSubdivisionLevel || first_leaf(cells, i) != begin) {
        return fmt::format("cell {} is not the next one of region {}", i + 1, region + 1);
      }
      begin += leaves(cells, i);
      if (is_of_witnesses()) continue;
      if (const auto column = first_missing(seen.row(i), visibility_.row(region))) {
        return fmt::format("cell {} sees element {}, region {} does not", i + 1, *column + 1,
                           region + 1);
      }
    }
    return begin == end && region + 1 == regions_.size() ? "" : "the last region is not tiled";
  }

  /// Its columns are witnesses (report/witness_check.h) or elements.
  bool is_of_witnesses() const { return results_.value("bound_columns", "") == "witnesses"; }

  static std::size_t leaves(const CsvTable& nodes, std::size_t row) {
    const auto level = static_cast<int>(nodes.count(row, "level"));
    return std::size_t{1} << (2 * std::max(kMaxSubdivisionLevel - level, 0));
  }
  static std::size_t first_leaf(const CsvTable& nodes, std::size_t row) {
    return nodes.count(row, "path") * leaves(nodes, row);
  }

  std::filesystem::path folder_;
  const Json& results_;
  const BitRows& visibility_;
  std::span<const double> areas_;
  CsvTable viewpoints_, regions_;
  BitRows seen_;
  std::vector<BundleClaim> claims_;
};

}  // namespace

std::vector<BundleClaim> check_viewpoints(const std::filesystem::path& folder, const Json& results,
                                          const BitRows& visibility,
                                          std::span<const double> areas) {
  return ViewpointChecker(folder, results, visibility, areas).run();
}

}  // namespace viewcover
