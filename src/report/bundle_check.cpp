#include "report/bundle_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "optim/check_cover_proof.h"
#include "optim/cover_file.h"
#include "report/csv_table.h"
#include "report/run_record.h"
#include "report/viewpoint_check.h"
#include "scene/error.h"

namespace viewcover {
namespace {

class BundleChecker {
 public:
  explicit BundleChecker(const std::filesystem::path& folder)
      : folder_(folder), record_(read_complete_run(folder)) {
    bits_ = read_cover_file(folder / "visibility.mtx", CoverFormat::kMatrixMarket);
  }

  std::vector<BundleClaim> run() {
    check_elements();
    check_cover(bits_, "");
    check_regions();
    const Json results = record_.value("results", Json::object());
    check_bound(results, bits_, "");
    if (results.contains("wide")) check_wide(results.at("wide"));
    if (results.contains("viewpoints")) {
      std::vector<BundleClaim> more = check_viewpoints(folder_, results, bits_, areas_);
      std::ranges::move(more, std::back_inserter(claims_));
    }
    return std::move(claims_);
  }

 private:
  /// Adds a claim; `contradiction` says what is wrong, or nothing.
  void claim(std::string what, std::string contradiction) {
    claims_.push_back({std::move(what), std::move(contradiction)});
  }

  void check_elements() {
    const CsvTable elements(folder_ / "elements.csv");
    for (std::size_t i = 0; i < elements.size(); ++i) {
      areas_.push_back(elements.number(i, "area"));
    }
    check_counts(bits_, "");
  }

  /// `suffix` of the files that the claim is about.
  void check_counts(const BitRows& bits, const std::string& suffix) {
    const std::string counts = suffix.empty() ? "times_visible" : "times_visible_wide";
    const CsvTable elements(folder_ / "elements.csv");
    std::string wrong;
    if (elements.size() != bits.columns()) {
      wrong = fmt::format("{} elements, but {} columns", elements.size(), bits.columns());
    }
    const std::vector<std::uint32_t> seen = count_in_columns(bits);
    for (std::size_t i = 0; i < elements.size() && wrong.empty(); ++i) {
      const double times = elements.number(i, counts);
      if (times != seen[i]) {
        wrong = fmt::format("element {}: {} times, but {} regions see it", i + 1, times, seen[i]);
      }
    }
    claim("elements.csv counts the regions of visibility" + suffix + ".mtx that see each element",
          wrong);
  }

  /// The cover of what is seen where narrow gaps are closed.
  void check_wide(const Json& results) {
    const BitRows wide =
        read_cover_file(folder_ / "visibility-wide.mtx", CoverFormat::kMatrixMarket);
    std::string wrong;
    if (wide.rows() != bits_.rows() || wide.columns() != bits_.columns()) {
      wrong = "its size differs";
    }
    for (std::size_t row = 0; row < wide.rows() && wrong.empty(); ++row) {
      for_each_bit(wide.row(row), [&](std::size_t column) {
        if (!bits_.test(row, column)) {
          wrong = fmt::format("region {} sees element {} only there", row + 1, column + 1);
        }
      });
    }
    claim("visibility-wide.mtx has nothing that visibility.mtx does not have", wrong);
    check_counts(wide, "-wide");
    check_cover(wide, "-wide");
    check_bound(results, wide, "-wide");
  }

  /// `suffix` of the file names that the claims are about.
  void check_cover(const BitRows& bits, const std::string& suffix) {
    // Sums of up to 10^9 terms in another order, and a text with 17 digits.
    constexpr double kRounding = 1e-6;
    const CsvTable cover(folder_ / ("cover" + suffix + ".csv"));
    std::string wrong;
    if (areas_.size() != bits.columns()) wrong = "not all areas are known";
    for (std::size_t i = 0; i < cover.size() && wrong.empty(); ++i) {
      chosen_ = cover.counts(i, "regions");
      for (std::size_t& region : chosen_) {
        if (region < 1 || region > bits.rows()) wrong = fmt::format("no region {}", region);
        --region;
      }
      if (!wrong.empty()) break;
      const double k = cover.number(i, "k"), percent = cover.number(i, "covered_area_percent"),
                   bound = cover.number(i, "upper_bound_percent"), covered = covered_percent(bits);
      if (k != static_cast<double>(chosen_.size())) {
        wrong = fmt::format("k = {} with {} regions", k, chosen_.size());
      } else if (std::fabs(percent - covered) > kRounding * 100) {
        wrong = fmt::format("k = {}: {} %, but the regions see {} %", k, percent, covered);
      } else if (bound < covered - kRounding * 100) {
        wrong = fmt::format("k = {}: at most {} %, but the regions see {} %", k, bound, covered);
      }
    }
    claim("cover" + suffix + ".csv states what each set of regions sees", wrong);
    const std::size_t missing =
        count_bits(bits.union_of_all()) - count_bits(bits.union_of(chosen_));
    claim("the regions of cover" + suffix + ".csv see all that any region sees",
          missing == 0 ? "" : fmt::format("{} elements are missing", missing));
  }

  double covered_percent(const BitRows& bits) const {
    double covered = 0, coverable = 0;
    for_each_bit(bits.union_of(chosen_), [&](std::size_t column) { covered += areas_[column]; });
    for_each_bit(bits.union_of_all(), [&](std::size_t column) { coverable += areas_[column]; });
    return coverable > 0 ? 100 * covered / coverable : 100;
  }

  void check_regions() {
    const CsvTable regions(folder_ / "regions.csv");
    std::string wrong;
    if (regions.size() != bits_.rows()) {
      wrong = fmt::format("{} regions, but {} rows", regions.size(), bits_.rows());
    }
    for (std::size_t i = 0; i < regions.size() && wrong.empty(); ++i) {
      const bool is_chosen = std::ranges::find(chosen_, i) != chosen_.end();
      if (regions.text(i, "chosen") != (is_chosen ? "1" : "0")) {
        wrong = fmt::format("region {} is{} in the last set", i + 1, is_chosen ? "" : " not");
      }
    }
    claim("regions.csv marks the chosen regions", wrong);
  }

  void check_bound(const Json& results, const BitRows& bits, const std::string& suffix) {
    const auto bound = results.value("regions_lower_bound", std::size_t{0}),
               size = results.value("optimal_regions", std::size_t{0});
    std::string wrong;
    if (size != chosen_.size()) {
      wrong = fmt::format("run.json has {} regions, cover{}.csv {}", size, suffix, chosen_.size());
    } else if (bound > size) {
      wrong = fmt::format("a lower bound of {} with {} regions", bound, size);
    } else if (results.value("proved", false) != (bound == size)) {
      wrong =
          fmt::format("proved or not does not follow from bound {} and {} regions", bound, size);
    }
    claim("run.json agrees with cover" + suffix + ".csv", wrong);
    const std::filesystem::path file = folder_ / ("cover" + suffix + ".proof");
    if (!std::filesystem::exists(file)) return;
    std::ifstream proof = open_for_check(file);
    const CoverProofVerdict verdict = check_cover_proof(bits, proof);
    claim(fmt::format("cover{}.proof proves that no {} regions see everything", suffix,
                      bound - (bound > 0)),
          !verdict.holds ? fmt::format("line {}: {}", verdict.line, verdict.reason)
          : verdict.lower_bound != bound
              ? fmt::format("it proves {}, run.json states {}", verdict.lower_bound, bound)
              : "");
  }

  std::filesystem::path folder_;
  Json record_;
  BitRows bits_;
  std::vector<double> areas_;
  std::vector<std::size_t> chosen_;  // the last set of cover.csv, from 0
  std::vector<BundleClaim> claims_;
};

}  // namespace

std::vector<BundleClaim> check_bundle(const std::filesystem::path& folder) {
  return BundleChecker(folder).run();
}

}  // namespace viewcover
