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
    check_cover();
    check_regions();
    check_bound();
    const Json results = record_.value("results", Json::object());
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
    std::string wrong;
    if (elements.size() != bits_.columns()) {
      wrong = fmt::format("{} elements, but {} columns", elements.size(), bits_.columns());
    }
    std::vector<std::size_t> seen(bits_.columns(), 0);
    for (std::size_t row = 0; row < bits_.rows(); ++row) {
      for_each_bit(bits_.row(row), [&](std::size_t column) { ++seen[column]; });
    }
    for (std::size_t i = 0; i < elements.size() && wrong.empty(); ++i) {
      areas_.push_back(elements.number(i, "area"));
      coverable_area_ += seen[i] > 0 ? areas_.back() : 0;
      const double times = elements.number(i, "times_visible");
      if (times != static_cast<double>(seen[i])) {
        wrong = fmt::format("element {}: {} times, but {} regions see it", i + 1, times, seen[i]);
      }
    }
    claim("elements.csv counts the regions that see each element", wrong);
  }

  void check_cover() {
    // Sums of up to 10^9 terms in another order, and a text with 17 digits.
    constexpr double kRounding = 1e-6;
    const CsvTable cover(folder_ / "cover.csv");
    std::string wrong;
    if (areas_.size() != bits_.columns()) wrong = "not all areas are known";
    for (std::size_t i = 0; i < cover.size() && wrong.empty(); ++i) {
      chosen_ = cover.counts(i, "regions");
      for (std::size_t& region : chosen_) {
        if (region < 1 || region > bits_.rows()) wrong = fmt::format("no region {}", region);
        --region;
      }
      if (!wrong.empty()) break;
      const double k = cover.number(i, "k"), percent = cover.number(i, "covered_area_percent"),
                   bound = cover.number(i, "upper_bound_percent"), covered = covered_percent();
      if (k != static_cast<double>(chosen_.size())) {
        wrong = fmt::format("k = {} with {} regions", k, chosen_.size());
      } else if (std::fabs(percent - covered) > kRounding * 100) {
        wrong = fmt::format("k = {}: {} %, but the regions see {} %", k, percent, covered);
      } else if (bound < covered - kRounding * 100) {
        wrong = fmt::format("k = {}: at most {} %, but the regions see {} %", k, bound, covered);
      }
    }
    claim("cover.csv states what each set of regions sees", wrong);
    const std::size_t missing =
        count_bits(bits_.union_of_all()) - count_bits(bits_.union_of(chosen_));
    claim("the chosen regions see all that any region sees",
          missing == 0 ? "" : fmt::format("{} elements are missing", missing));
  }

  double covered_percent() const {
    double covered = 0;
    for_each_bit(bits_.union_of(chosen_), [&](std::size_t column) { covered += areas_[column]; });
    return coverable_area_ > 0 ? 100 * covered / coverable_area_ : 100;
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

  void check_bound() {
    const Json results = record_.value("results", Json::object());
    const auto bound = results.value("regions_lower_bound", std::size_t{0}),
               size = results.value("optimal_regions", std::size_t{0});
    std::string wrong;
    if (size != chosen_.size()) {
      wrong = fmt::format("run.json has {} regions, cover.csv {}", size, chosen_.size());
    } else if (bound > size) {
      wrong = fmt::format("a lower bound of {} with {} regions", bound, size);
    } else if (results.value("proved", false) != (bound == size)) {
      wrong =
          fmt::format("proved or not does not follow from bound {} and {} regions", bound, size);
    }
    claim("run.json agrees with cover.csv", wrong);
    const std::filesystem::path file = folder_ / "cover.proof";
    if (!std::filesystem::exists(file)) return;
    std::ifstream proof = open_for_check(file);
    const CoverProofVerdict verdict = check_cover_proof(bits_, proof);
    claim(fmt::format("cover.proof proves that no {} regions see everything", bound - (bound > 0)),
          !verdict.holds ? fmt::format("line {}: {}", verdict.line, verdict.reason)
          : verdict.lower_bound != bound
              ? fmt::format("it proves {}, run.json states {}", verdict.lower_bound, bound)
              : "");
  }

  std::filesystem::path folder_;
  Json record_;
  BitRows bits_;
  std::vector<double> areas_;
  double coverable_area_ = 0;
  std::vector<std::size_t> chosen_;  // the last set of cover.csv, from 0
  std::vector<BundleClaim> claims_;
};

}  // namespace

std::vector<BundleClaim> check_bundle(const std::filesystem::path& folder) {
  return BundleChecker(folder).run();
}

}  // namespace viewcover
