#include "report/audit_check.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "report/audit_files.h"
#include "report/audit_sampling.h"
#include "report/bundle_scene.h"
#include "report/csv_table.h"
#include "scene/error.h"
#include "scene/random_numbers.h"

namespace viewcover {
namespace {

/// Probability of calling a true claim wrong: beyond six standard deviations of a normal variable.
constexpr double kLevel = 2e-9;
/// Of sums in another order.
constexpr double kRelativeRounding = 1e-9;

/// n KL(k / n || share): by Chernoff, k or more (or fewer) of n samples fall into a share with at
/// most exp(-surprise) where they are more (fewer) than expected.
double surprise(std::size_t k, std::size_t n, double share) {
  const auto term = [](double count, double expected) {
    if (count == 0) return 0.0;
    return expected > 0 ? count * std::log(count / expected)
                        : std::numeric_limits<double>::infinity();
  };
  const auto all = static_cast<double>(n), in = static_cast<double>(k);
  return term(in, all * share) + term(all - in, all * (1 - share));
}

bool differ(double a, double b) {
  return !(std::fabs(a - b) <= kRelativeRounding * std::max(std::fabs(a), std::fabs(b)));
}

/// A row of audit.csv.
struct Claimed {
  double area = 0, imaged = 0, images_mean = 0;
  std::size_t images_max = 0;
  std::string seen;

  Claimed(const CsvTable& table, std::size_t row)
      : area(table.number(row, "area")),
        imaged(table.number(row, "imaged_area")),
        images_mean(table.number(row, "images_mean")),
        images_max(table.count(row, "images_max")),
        seen(table.text(row, "seen")) {}
  double share() const { return seen == "wholly" ? 1 : seen == "not" ? 0 : imaged / area; }
};

class AuditChecker {
 public:
  AuditChecker(const std::filesystem::path& folder, const AuditCheckOptions& options)
      : folder_(folder), options_(options), bundle_(load_bundle_scene(folder, options.scene_file)) {
    const std::string file = (folder / "audit.json").string();
    std::ifstream stream(file);
    record_ = Json::parse(stream, nullptr, false);
    try {
      for (const Json& p : record_.at("positions")) {
        viewpoints_.emplace_back(p.at(0).get<double>(), p.at(1).get<double>(),
                                 p.at(2).get<double>());
      }
      source_ = record_.at("source");
      record_.at("audit").at("imaged_area").get<double>();
    } catch (const Json::exception& error) {
      throw InputError(file, std::string("is no record of an audit: ") + error.what(),
                       "run viewcover audit on the folder");
    }
    const CsvTable table(folder / "audit.csv");
    for (std::size_t row = 0; row < table.size(); ++row) claimed_.emplace_back(table, row);
  }

  std::vector<BundleClaim> run() {
    claim("audit.csv has the elements of the bundle", contradicted_row());
    claim("audit.json adds up audit.csv", contradicted_sum());
    claim("audit.json has the viewpoints of " + source_, contradicted_viewpoint());
    // What is sampled are the elements; without them there is nothing to compare.
    if (claimed_.size() != bundle_.elements.size()) return std::move(claims_);
    sample();
    claim("audit.csv states how much of each element is imaged", contradicted_element());
    claim("audit.json states how much is imaged", contradicted_total());
    claim("audit.csv states how many images show each element", contradicted_images());
    return std::move(claims_);
  }

 private:
  void claim(std::string what, std::string contradiction) {
    claims_.push_back({std::move(what), std::move(contradiction)});
  }

  ConvexPolygon element(std::size_t i) const {
    const ElementAddress address = bundle_.elements[i];
    return subdivided(bundle_.scene[address.owner()].polygon, address);
  }

  std::string contradicted_row() const {
    if (claimed_.size() != bundle_.elements.size()) {
      return fmt::format("{} rows for {} elements", claimed_.size(), bundle_.elements.size());
    }
    for (std::size_t i = 0; i < claimed_.size(); ++i) {
      const Claimed& row = claimed_[i];
      if (differ(row.area, area(element(i)))) {
        return fmt::format("element {}: area {} instead of {}", i + 1, row.area, area(element(i)));
      }
      const bool wholly = row.seen == "wholly", none = row.seen == "not";
      if ((!wholly && !none && row.seen != "in_part") || !(row.imaged >= 0) ||
          (none != (row.images_max == 0)) || (none && row.imaged != 0) ||
          differ(std::max(row.imaged, row.area), row.area) ||
          (wholly && differ(row.imaged, row.area))) {
        return fmt::format("element {}: \"{}\" with {} of {}", i + 1, row.seen, row.imaged,
                           row.area);
      }
    }
    return "";
  }

  std::string contradicted_sum() const {
    double imaged = 0, missed = 0, whole = 0;
    std::size_t wholly = 0, in_part = 0;
    for (std::size_t i = 0; i < std::min(claimed_.size(), bundle_.elements.size()); ++i) {
      imaged += claimed_[i].imaged;
      whole += claimed_[i].area;
      if (bundle_.times_visible[i] > 0) missed += claimed_[i].area - claimed_[i].imaged;
      wholly += claimed_[i].seen == "wholly";
      in_part += claimed_[i].seen == "in_part";
    }
    const Json& stated = record_.at("audit");
    const std::pair<const char*, double> sums[] = {{"imaged_area", imaged},
                                                   {"missed_area", missed},
                                                   {"seen_wholly", static_cast<double>(wholly)},
                                                   {"seen_in_part", static_cast<double>(in_part)}};
    for (const auto& [name, sum] : sums) {
      const double value = stated.value(name, -1.0);
      if (!(std::fabs(value - sum) <= kRelativeRounding * whole)) {
        return fmt::format("{} is {} instead of {}", name, value, sum);
      }
    }
    return "";
  }

  std::string contradicted_viewpoint() const {
    if (source_ != kViewpointsFile) return "";
    const std::vector<Point> stated = read_positions(folder_ / source_);
    if (stated.size() != viewpoints_.size()) {
      return fmt::format("{} instead of {}", viewpoints_.size(), stated.size());
    }
    for (std::size_t i = 0; i < stated.size(); ++i) {
      if (stated[i] != viewpoints_[i]) return fmt::format("viewpoint {} is another", i + 1);
    }
    return "";
  }

  void sample() {
    constexpr std::size_t kLeast = 4, kMost = 1024;
    const std::size_t pairs = std::max<std::size_t>(1, claimed_.size() * viewpoints_.size());
    const std::size_t samples = std::clamp(options_.most_segments / pairs, kLeast, kMost);
    const ClusterTree clusters(bundle_.scene);
    const SightSampler sampler(bundle_.scene, clusters, viewpoints_, bundle_.one_sided);
    counts_.resize(claimed_.size());
    tbb::parallel_for(std::size_t{0}, counts_.size(), [&](std::size_t i) {
      counts_[i] = sampler.sample(bundle_.elements[i].owner(), element(i), samples,
                                  mixed(options_.seed + mixed(i)));
    });
  }

  std::string contradicted_element() const {
    const double limit = std::log(2 * static_cast<double>(counts_.size()) / kLevel);
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      const SampleCounts& counts = counts_[i];
      if (surprise(counts.imaged, counts.samples, claimed_[i].share()) > limit) {
        return fmt::format("element {}: {} of its area, but {} of {} points are imaged", i + 1,
                           claimed_[i].share(), counts.imaged, counts.samples);
      }
    }
    return "";
  }

  /// Independent terms a X / n with X in [0, 1] of mean s: Bernstein, 2 exp(-t^2 / (2 var + 2 b t /
  /// 3)) with b the largest a / n.
  std::string contradicted_total() const {
    double expected = 0, found = 0, variance = 0, largest = 0, whole = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      const auto n = static_cast<double>(counts_[i].samples);
      const double share = claimed_[i].share(), weight = claimed_[i].area / n;
      expected += claimed_[i].area * share;
      found += weight * static_cast<double>(counts_[i].imaged);
      variance += weight * weight * n * share * (1 - share);
      largest = std::max(largest, weight);
      whole += claimed_[i].area;
    }
    const double limit = std::log(2 / kLevel);
    const double b = largest * limit / 3;
    const double allowed = b + std::sqrt(b * b + 2 * variance * limit) + kRelativeRounding * whole;
    if (std::fabs(found - expected) <= allowed) return "";
    return fmt::format("{:.6g}, but random points say {:.6g}, and chance excuses {:.2g} only",
                       expected, found, allowed);
  }

  /// Hoeffding for the mean number of images, by area: terms a X / n with X in [0, most].
  std::string contradicted_images() const {
    double expected = 0, found = 0, squares = 0, whole = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      const SampleCounts& counts = counts_[i];
      if (counts.most > claimed_[i].images_max) {
        return fmt::format("element {}: at most {}, but a point is in {}", i + 1,
                           claimed_[i].images_max, counts.most);
      }
      const auto n = static_cast<double>(counts.samples);
      const double weight = claimed_[i].area / n;
      expected += claimed_[i].area * claimed_[i].images_mean;
      found += weight * static_cast<double>(counts.images);
      const double range = weight * static_cast<double>(claimed_[i].images_max);
      squares += n * range * range;
      whole += claimed_[i].area;
    }
    const double allowed =
        std::sqrt(squares * std::log(2 / kLevel) / 2) + kRelativeRounding * whole;
    if (std::fabs(found - expected) <= allowed) return "";
    return fmt::format("{:.6g} by area, but random points say {:.6g}", expected / whole,
                       found / whole);
  }

  std::filesystem::path folder_;
  AuditCheckOptions options_;
  BundleScene bundle_;
  Json record_;
  std::string source_;
  std::vector<Point> viewpoints_;
  std::vector<Claimed> claimed_;
  std::vector<SampleCounts> counts_;
  std::vector<BundleClaim> claims_;
};

}  // namespace

std::vector<BundleClaim> check_audit(const std::filesystem::path& folder,
                                     const AuditCheckOptions& options) {
  return AuditChecker(folder, options).run();
}

}  // namespace viewcover
