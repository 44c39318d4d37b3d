#include "report/witness_check.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "optim/cover_file.h"
#include "report/audit_files.h"
#include "report/bundle_scene.h"
#include "report/run_record.h"
#include "scene/predicates.h"
#include "scene/random_numbers.h"
#include "viewpoints/region_positions.h"

namespace viewcover {
namespace {

struct NamedPlace {
  std::size_t element = 0;
  Point place = Point::Zero();
};

struct Pair {
  std::size_t first = 0, second = 0;
};

class WitnessChecker {
 public:
  WitnessChecker(const std::filesystem::path& folder, const WitnessCheckOptions& options)
      : folder_(folder),
        options_(options),
        bundle_(load_bundle_scene(folder, options.scene_file)),
        viewpoints_(read_positions(folder / kViewpointsFile)) {
    const CsvTable table(folder / "witnesses.csv");
    const std::vector<Point> places = read_positions(folder / "witnesses.csv");
    for (std::size_t i = 0; i < table.size(); ++i) {
      witnesses_.push_back({table.count(i, "element") - 1, places[i]});
    }
  }

  std::vector<BundleClaim> run() {
    std::string wrong = outside();
    const bool fits = wrong.empty();
    std::vector<BundleClaim> claims = {{"each witness lies in its element", std::move(wrong)}};
    if (!fits) return claims;
    claims.push_back({"no witness lies on another surface or in the plane of a region", crossed()});
    claims.push_back({"each witness is seen from a viewpoint", unseen()});
    if (std::filesystem::exists(folder_ / "bound.csv") && bound_is_of_witnesses()) {
      claims.push_back(
          {"cells of the bound do not see what bound.mtx says they do not", seen_after_all()});
    }
    return claims;
  }

 private:
  bool bound_is_of_witnesses() const {
    const Json record = read_complete_run(folder_);
    return record.value("results", Json::object()).value("bound_columns", "") == "witnesses";
  }

  std::string outside() const {
    for (std::size_t i = 0; i < witnesses_.size(); ++i) {
      const auto& [element, place] = witnesses_[i];
      if (element >= bundle_.elements.size()) return fmt::format("there is no element {}", element);
      const ElementAddress address = bundle_.elements[element];
      if (!lies_in(place, subdivided(bundle_.scene[address.owner()].polygon, address))) {
        return fmt::format("witness {} lies outside element {}", i + 1, element + 1);
      }
    }
    return {};
  }

  /// Exact. What the proof of the bound asks for besides: surfaces near a witness are its own, and
  /// it sees no region edge-on.
  std::string crossed() const {
    const CsvTable table(folder_ / "regions.csv");
    std::vector<std::pair<std::size_t, ConvexPolygon>> polygons;  // no box is seen edge-on
    for (std::size_t row = 0; row < table.size(); ++row) {
      const std::optional<RegionShape> shape = region_in(table, row);
      if (shape && !shape->is_box()) polygons.emplace_back(row + 1, shape->polygon());
    }
    const auto contains = [&](const Point& x, std::size_t surface) {
      const ConvexPolygon& polygon = bundle_.scene.surfaces[surface].polygon;
      return bounding_box(polygon).contains(x) && lies_in(x, polygon);
    };
    std::vector<std::string> wrong(witnesses_.size());
    tbb::parallel_for(std::size_t{0}, witnesses_.size(), [&](std::size_t i) {
      const auto& [element, place] = witnesses_[i];
      const std::size_t own = bundle_.elements[element].owner().value;
      for (std::size_t s = 0; s < bundle_.scene.surfaces.size(); ++s) {
        if (s == own || !contains(place, s)) continue;
        wrong[i] = fmt::format("witness {} lies on surface {} too", i + 1, s + 1);
        return;
      }
      for (const auto& [number, region] : polygons) {
        if (orientation(region[0], region[1], region[2], place) != 0) continue;
        wrong[i] = fmt::format("witness {} lies in the plane of region {}", i + 1, number);
        return;
      }
    });
    const auto first = std::ranges::find_if(wrong, [](const auto& text) { return !text.empty(); });
    return first == wrong.end() ? std::string() : *first;
  }

  /// Exact.
  bool is_seen(const Point& from, const NamedPlace& witness) const {
    const SurfaceId own = bundle_.elements[witness.element].owner();
    const auto side = [&](std::span<const Point> polygon, const Point& x) {
      return orientation(polygon[0], polygon[1], polygon[2], x);
    };
    const int facing = side(bundle_.scene[own].polygon, from);
    if (facing == 0 || (bundle_.one_sided && facing < 0)) return false;
    return std::ranges::none_of(bundle_.scene.surfaces, [&](const Surface& surface) {
      const ConvexPolygon& polygon = surface.polygon;
      if (side(polygon, from) * side(polygon, witness.place) >= 0) return false;
      bool left = false, right = false;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const int turn =
            orientation(from, witness.place, polygon[k], polygon[(k + 1) % polygon.size()]);
        left |= turn > 0;
        right |= turn < 0;
      }
      return !(left && right);
    });
  }

  std::string unseen() const {
    std::vector<char> seen(witnesses_.size(), 0);
    tbb::parallel_for(std::size_t{0}, witnesses_.size(), [&](std::size_t i) {
      seen[i] = std::ranges::any_of(
          viewpoints_, [&](const Point& viewpoint) { return is_seen(viewpoint, witnesses_[i]); });
    });
    const auto missing = std::ranges::find(seen, 0);
    return missing == seen.end()
               ? ""
               : fmt::format("no viewpoint sees witness {}", missing - seen.begin() + 1);
  }

  std::string seen_after_all() const {
    const BitRows bits = read_cover_file(folder_ / "bound.mtx", CoverFormat::kMatrixMarket);
    const CsvTable cells(folder_ / "bound.csv");
    if (bits.rows() != cells.size() || bits.columns() > witnesses_.size()) {
      return "bound.csv, bound.mtx and witnesses.csv do not agree";
    }
    const CsvTable regions(folder_ / "regions.csv");
    std::vector<Pair> pairs;
    const std::vector<BitRows::Word> asked = bits.union_of_all();
    for (std::size_t cell = 0; cell < bits.rows(); ++cell) {
      for_each_bit(std::span<const BitRows::Word>(asked), [&](std::size_t w) {
        if (!bits.test(cell, w)) pairs.push_back({cell, w});
      });
    }
    const std::size_t stride = 1 + pairs.size() / options_.most_segments;
    std::vector<char> wrong(pairs.size(), 0);
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
      RandomNumbers random(mixed(options_.seed) + i);
      if (random.below(stride) != 0) return;
      const auto cell = region_of_cell(cells, pairs[i].first, regions);
      if (!cell) {
        wrong[i] = 1;
        return;
      }
      const RegionPositions positions(*cell, bundle_.scene.bounds, bundle_.scene.lattice.exponent);
      wrong[i] = is_seen(positions.random(random), witnesses_[pairs[i].second]);
    });
    const auto first = std::ranges::find(wrong, 1);
    if (first == wrong.end()) return {};
    const Pair& pair = pairs[static_cast<std::size_t>(first - wrong.begin())];
    return fmt::format("cell {} sees witness {}", pair.first + 1, pair.second + 1);
  }

  std::filesystem::path folder_;
  const WitnessCheckOptions& options_;
  BundleScene bundle_;
  std::vector<Point> viewpoints_;
  std::vector<NamedPlace> witnesses_;
};

}  // namespace

std::vector<BundleClaim> check_witnesses(const std::filesystem::path& folder,
                                         const WitnessCheckOptions& options) {
  if (!std::filesystem::exists(folder / "witnesses.csv")) return {};
  return WitnessChecker(folder, options).run();
}

}  // namespace viewcover
