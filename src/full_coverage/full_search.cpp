#include "full_coverage/full_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "audit/unseen_area.h"
#include "full_coverage/full_coverage.h"
#include "full_coverage/position_search.h"
#include "full_coverage/witness_pool.h"
#include "optim/reductions.h"
#include "viewpoints/column_bits.h"
#include "viewpoints/column_weights.h"
#include "viewpoints/pool_cover.h"
#include "viewpoints/refined_bound.h"

namespace viewcover {
namespace {

/// For covers that are asked for often.
constexpr PoolCoverEffort kEffort{.nodes = 300, .patience = 200'000};
/// Prices come from floating point.
constexpr double kPriceTolerance = 1e-6;
/// New viewpoints after each audit, at most.
constexpr std::size_t kMostAdditions = 12;
/// Regions searched by prices in a round.
constexpr std::size_t kPricedRegions = 48;
/// Parts that are this share of what may be missed are looked at, and become witnesses of the
/// bound.
constexpr double kSmallestPiece = 0.02;
/// Smaller ones count for what a further viewpoint adds, of the best positions.
constexpr double kSmallestPieceOfGain = 2e-4;
constexpr std::size_t kMostPlacesOfGain = 20000, kBestPositions = 32, kMostWitnessesAtOnce = 400;
constexpr std::size_t kMostPlaces = 800, kMostWitnessesOfBound = 64;
constexpr std::size_t kMostCandidates = 1500;
constexpr std::size_t kMostAskedAtOnce = 32;

CoverOptions limits_of(const FullCoverageOptions& options) {
  CoverOptions limits;
  limits.stop = options.stop;
  limits.time_limit_seconds = options.time_limit_seconds;
  return limits;
}

class FullSearch {
 public:
  FullSearch(const RegionViews& views, const ViewpointSet& parts,
             const FullCoverageOptions& options)
      : views_(views),
        scene_(views.viewed().scene),
        options_(options),
        limits_(limits_of(options)),
        witnesses_(views),
        pool_(views, witnesses_),
        search_(views, witnesses_, limits_, options.seed),
        parts_(parts),
        lower_bound_(parts.lower_bound) {
    for_each_bit(std::span<const BitRows::Word>(views.matrix().bits.union_of_all()),
                 [&](std::size_t column) {
                   columns_.push_back(column);
                   elements_.push_back(views.matrix().elements[column]);
                   area_ += views.matrix().areas[column];
                 });
    for (const Viewpoint& viewpoint : parts.viewpoints) pool_.add(viewpoint);
    for (const Viewpoint& viewpoint : parts.tried) pool_.add(viewpoint);
    for (const Viewpoint& viewpoint : search_.special().corners()) pool_.add(viewpoint);
    witnesses_.add(places_in_elements(parts.viewpoints));
    pool_.set_elements(elements_without_witness());
  }

  ViewpointSet run();

 private:
  AuditOptions audit_options() const {
    return {.one_sided = views_.viewed().one_sided, .stop = options_.stop};
  }
  UnseenArea whole_area() const {
    return {scene_, views_.viewed().clusters, elements_, audit_options()};
  }
  std::vector<Point> positions_of(std::span<const Viewpoint> viewpoints) const {
    std::vector<Point> positions;
    for (const Viewpoint& viewpoint : viewpoints) positions.push_back(viewpoint.position);
    return positions;
  }

  bool best_sees(const ElementTarget& place) const {
    return std::ranges::any_of(best_, [&](const Viewpoint& viewpoint) {
      return witnesses_.is_seen(viewpoint.position, place);
    });
  }
  std::vector<ElementTarget> places_in_elements(std::span<const Viewpoint> viewpoints) const;
  std::vector<std::size_t> elements_without_witness() const;
  std::vector<WeightedPlace> unseen_places(std::span<const Viewpoint> viewpoints, double smallest,
                                           std::size_t most);
  std::vector<Viewpoint> cover_witnesses();
  enum class Missed { kTooLittle, kMoreWitnesses, kNoWitness };
  Missed add_what_is_missed(std::span<const Viewpoint> viewpoints);
  void add_by_prices();
  bool raise_bound();
  void trim();
  ViewpointSet result();
  void report() const;

  const RegionViews& views_;
  const Scene& scene_;
  const FullCoverageOptions& options_;
  SearchLimits limits_;
  Witnesses witnesses_;
  WitnessPool pool_;
  PositionSearch search_;
  const ViewpointSet& parts_;
  std::vector<std::size_t> columns_;      // that some region sees
  std::vector<ElementAddress> elements_;  // of these
  double area_ = 0;                       // of these
  std::vector<std::uint32_t> asked_;      // witnesses that the cover is asked for, ascending
  PoolCover cover_;                       // its columns are these, then the pool's elements
  std::vector<Viewpoint> best_;           // sees all witnesses, and misses no more than asked for
  std::size_t lower_bound_;
  std::optional<BoundRefinement> bound_;
  /// What adds most to a set, of so many positions; by places.
  struct Further {
    ValuedViewpoint best;
    std::size_t positions = 0;
  };
  Further further_;          // than the set looked at last
  Further further_to_best_;  // than best_
};

std::vector<ElementTarget> FullSearch::places_in_elements(
    std::span<const Viewpoint> viewpoints) const {
  const Audit audit = audit_images(scene_, views_.viewed().clusters, elements_,
                                   positions_of(viewpoints), audit_options());
  std::vector<ElementTarget> places;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::vector<std::pair<double, const ConvexPolygon*>> seen;
    for (const ImagedPiece& piece : audit.elements[i].pieces) {
      if (piece.images > 0) seen.emplace_back(area(piece.polygon), &piece.polygon);
    }
    std::ranges::sort(seen, std::greater(), [](const auto& piece) { return piece.first; });
    for (const auto& [size, polygon] : seen) {
      if (const auto place = witnesses_.place_in(columns_[i], *polygon)) {
        places.push_back(*place);
        break;
      }
    }
  }
  return places;
}

/// Of which too little is seen for exact positions: they are covered as elements.
std::vector<std::size_t> FullSearch::elements_without_witness() const {
  std::vector<bool> has_witness(views_.column_count(), false);
  for (std::size_t w = 0; w < witnesses_.size(); ++w) has_witness[witnesses_[w].column] = true;
  std::vector<std::size_t> columns = columns_;
  std::erase_if(columns, [&](std::size_t column) { return has_witness[column]; });
  for (const std::size_t column : parts_.missing) std::erase(columns, column);
  return columns;
}

/// Places in what the viewpoints do not image, weighted by area: in each piece, cut up while larger
/// than what may be missed. The `most` largest, largest first; pieces below `smallest` have none.
std::vector<WeightedPlace> FullSearch::unseen_places(std::span<const Viewpoint> viewpoints,
                                                     double smallest, std::size_t most) {
  UnseenArea unseen = whole_area();
  for (const Viewpoint& viewpoint : viewpoints) unseen.subtract(viewpoint.position);
  const double largest = options_.missed_share * area_;
  std::vector<std::pair<std::size_t, ConvexPolygon>> parts;
  for (const UnseenPiece& piece : unseen.pieces()) {
    std::vector<ConvexPolygon> open{piece.polygon};
    while (!open.empty()) {
      const ConvexPolygon part = std::move(open.back());
      open.pop_back();
      const double size = area(part);
      if (size < smallest) continue;
      if (size > largest) {
        for (const ConvexPolygon& quarter : quarters(part)) open.push_back(quarter);
      } else {
        parts.emplace_back(columns_[piece.element], part);
      }
    }
  }
  std::ranges::stable_sort(parts, std::greater(),
                           [](const auto& part) { return area(part.second); });
  if (parts.size() > most) parts.resize(most);
  std::vector<std::optional<ElementTarget>> places(parts.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    const auto place = witnesses_.place_in(parts[i].first, parts[i].second);
    if (place && std::ranges::none_of(viewpoints, [&](const Viewpoint& viewpoint) {
          return witnesses_.is_seen(viewpoint.position, *place);
        })) {
      places[i] = place;
    }
  });
  std::vector<WeightedPlace> weighted;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (places[i]) weighted.push_back({*places[i], area(parts[i].second)});
  }
  return weighted;
}

/// A smallest cover, by asking for few witnesses first and for more of those that it leaves out,
/// until it leaves out none.
std::vector<Viewpoint> FullSearch::cover_witnesses() {
  pool_.look();
  const BitRows rows = pool_.rows();
  if (asked_.empty()) asked_ = columns_without_implied(rows);
  SearchLimits unlimited(CoverOptions{});
  std::vector<Viewpoint> chosen;
  while (true) {
    const std::span<const std::size_t> elements = pool_.elements();
    BitRows asked(rows.rows(), asked_.size() + elements.size());
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      for (std::size_t k = 0; k < asked_.size(); ++k) {
        if (rows.test(i, asked_[k])) asked.set(i, k);
      }
      for (std::size_t k = 0; k < elements.size(); ++k) {
        if (pool_.sees_element(i, elements[k])) asked.set(i, asked_.size() + k);
      }
    }
    cover_ = cover_pool(asked, kEffort, options_.seed, limits_.expired() ? unlimited : limits_);
    const std::vector<BitRows::Word> seen = rows.union_of(cover_.chosen);
    std::vector<std::uint32_t> unseen;
    for (std::uint32_t w = 0; w < rows.columns(); ++w) {
      if (!has_column(seen, w)) unseen.push_back(w);
    }
    if (unseen.empty()) break;
    // Evenly among all: neighbours tell the same.
    const std::size_t step = std::max<std::size_t>(1, unseen.size() / kMostAskedAtOnce);
    for (std::size_t k = 0; k < unseen.size(); k += step) asked_.push_back(unseen[k]);
    std::ranges::sort(asked_);
  }
  for (const std::size_t row : cover_.chosen) chosen.push_back(pool_[row]);
  return chosen;
}

/// Positions and witnesses for what the viewpoints do not image. kTooLittle: nothing was found that
/// adds more than may be missed. Where there is a best set, only what it sees becomes a witness.
FullSearch::Missed FullSearch::add_what_is_missed(std::span<const Viewpoint> viewpoints) {
  const double enough = options_.missed_share * area_;
  std::vector<WeightedPlace> places =
      unseen_places(viewpoints, kSmallestPieceOfGain * enough, kMostPlacesOfGain);
  std::vector<ValuedViewpoint> found = search_.best(
      std::span(places).first(std::min(places.size(), kMostPlaces)), pool_, enough / 2);
  further_ = {{}, found.size()};
  // All pieces count for the best few: small ones add up.
  found.resize(std::min(found.size(), kBestPositions));
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    found[i].value = search_.value_of(found[i].viewpoint, places);
  });
  std::ranges::stable_sort(found, std::greater(), &ValuedViewpoint::value);
  std::vector<ElementTarget> fresh;
  for (std::size_t added = 0; added < kMostAdditions; ++added) {
    const ValuedViewpoint* best = nullptr;
    double most = 0;
    for (const ValuedViewpoint& candidate : found) {
      if (candidate.value <= most) break;  // values only fall
      const double value = search_.value_of(candidate.viewpoint, places);
      if (value > most) {
        most = value;
        best = &candidate;
      }
    }
    if (added == 0 && best != nullptr) further_.best = {best->viewpoint, most};
    if (best == nullptr || most < enough) break;
    pool_.add(best->viewpoint);
    std::erase_if(places, [&](const WeightedPlace& place) {
      const bool is_seen = views_.region_sees(best->viewpoint.region, place.place.column) &&
                           witnesses_.is_seen(best->viewpoint.position, place.place);
      if (is_seen) fresh.push_back(place.place);
      return is_seen;
    });
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 2 * kMostAdditions); ++i) {
    if (!fresh.empty()) pool_.add(found[i].viewpoint);
  }
  if (further_.best.value < enough) return Missed::kTooLittle;
  if (fresh.size() > kMostWitnessesAtOnce) fresh.resize(kMostWitnessesAtOnce);
  if (!best_.empty()) std::erase_if(fresh, [&](const auto& place) { return !best_sees(place); });
  return witnesses_.add(fresh) > 0 ? Missed::kMoreWitnesses : Missed::kNoWitness;
}

/// Column generation: positions whose witnesses cost more than 1 by the prices of the last cover,
/// or may do so together with elements that have no witness, if the region sees these.
void FullSearch::add_by_prices() {
  std::vector<WeightedPlace> places;
  std::vector<double> of_region(views_.region_count(), 0), of_elements(of_region);
  for (std::size_t k = 0; k < asked_.size(); ++k) {
    const double price = cover_.prices[k];
    if (price <= kPriceTolerance) continue;
    const std::uint32_t w = asked_[k];
    places.push_back({witnesses_[w], price});
    for (std::size_t i = 0; i < of_region.size(); ++i) {
      if (witnesses_.region_sees(i, w)) of_region[i] += price;
    }
  }
  for (std::size_t k = 0; k < pool_.elements().size(); ++k) {
    for (std::size_t i = 0; i < of_elements.size(); ++i) {
      if (views_.region_sees(i, pool_.elements()[k])) {
        of_elements[i] += cover_.prices[asked_.size() + k];
      }
    }
  }
  std::vector<std::size_t> regions;
  for (std::size_t i = 0; i < of_region.size(); ++i) {
    if (of_region[i] + of_elements[i] > 1 + kPriceTolerance) regions.push_back(i);
  }
  const std::uint64_t seed = search_.next_seed();
  RandomNumbers random(mixed(seed));
  if (regions.size() > kPricedRegions) {
    for (std::size_t i = 0; i < kPricedRegions; ++i) {
      std::swap(regions[i], regions[i + random.below(regions.size() - i)]);
    }
    regions.resize(kPricedRegions);
  }
  for (const std::vector<ValuedViewpoint>& of_this : search_.anneal(regions, places, seed)) {
    for (std::size_t k = 0; k < std::min<std::size_t>(of_this.size(), 3); ++k) {
      const auto& [viewpoint, value] = of_this[k];
      if (value + of_elements[viewpoint.region] > 1 + kPriceTolerance) pool_.add(viewpoint);
    }
  }
}

/// A round of the bound; true if it rose. The middles of its cells join the pool, and what they
/// leave unseen the witnesses.
bool FullSearch::raise_bound() {
  if (!bound_) {
    bound_.emplace(witnesses_, asked_, limits_, options_.seed, kEffort);
  } else {
    bound_->ask(asked_);
  }
  const std::size_t before = lower_bound_;
  if (!bound_->refine()) return false;
  lower_bound_ = std::max(lower_bound_, bound_->lower_bound());
  std::vector<Viewpoint> middles;
  for (const Look& look : bound_->middles_of_cover()) {
    if (views_.is_free(look.region, look.position)) middles.push_back({look.position, look.region});
  }
  for (const Viewpoint& middle : middles) pool_.add(middle);
  if (lower_bound_ < best_.size() && !middles.empty()) {
    const double smallest = kSmallestPiece * options_.missed_share * area_;
    std::vector<ElementTarget> places;
    for (const WeightedPlace& place : unseen_places(middles, smallest, kMostPlaces)) {
      if (best_sees(place.place)) places.push_back(place.place);
      if (places.size() == kMostWitnessesOfBound) break;
    }
    witnesses_.add(places);
  }
  return lower_bound_ > before;
}

/// Rows with few witnesses that cost something go, once there are too many.
void FullSearch::trim() {
  if (pool_.size() <= kMostCandidates) return;
  pool_.look();
  const BitRows rows = pool_.rows();
  std::vector<double> by_witness(rows.columns(), 0);
  for (std::size_t k = 0; k < asked_.size(); ++k) by_witness[asked_[k]] = cover_.prices[k];
  const ColumnWeights prices(std::move(by_witness));
  std::vector<std::pair<double, std::size_t>> scores;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const bool is_chosen = std::ranges::find(best_, pool_[i]) != best_.end();
    scores.emplace_back(is_chosen ? -1e9 : -prices.of(rows.row(i)), i);
  }
  std::ranges::sort(scores);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < kMostCandidates / 2; ++i) kept.push_back(scores[i].second);
  std::ranges::sort(kept);
  pool_.keep(kept);
}

void FullSearch::report() const {
  if (options_.progress == nullptr) return;
  options_.progress->viewpoints = best_.size();
  options_.progress->lower_bound = std::min(lower_bound_, best_.size());
  options_.progress->positions = search_.looked();
}

ViewpointSet FullSearch::run() {
  int idle = 0;
  while (true) {
    const std::vector<Viewpoint> viewpoints = cover_witnesses();
    if (best_.empty() || viewpoints.size() < best_.size()) {
      const Missed missed = add_what_is_missed(viewpoints);
      if (missed == Missed::kMoreWitnesses && !limits_.expired()) continue;
      if (missed == Missed::kTooLittle || best_.empty()) {
        // Out of time: what was found last is to be seen nevertheless.
        best_ = missed == Missed::kMoreWitnesses ? cover_witnesses() : viewpoints;
        further_to_best_ = further_;
        idle = 0;
      }
    }
    report();
    if (lower_bound_ >= best_.size() || limits_.expired()) break;
    trim();
    add_by_prices();
    idle = raise_bound() ? 0 : idle + 1;
    if (options_.close_gap_seconds > 0 ? limits_.seconds() >= options_.close_gap_seconds
                                       : idle >= options_.patience) {
      break;
    }
  }
  return result();
}

ViewpointSet FullSearch::result() {
  ViewpointSet set;
  set.seen = BitRows(0, views_.column_count());
  FullCoverage full;
  full.missed_share = options_.missed_share;
  // Those first that image most witnesses more.
  std::vector<Viewpoint> left = best_;
  std::vector<WeightedPlace> places;
  for (std::size_t w = 0; w < witnesses_.size(); ++w) places.push_back({witnesses_[w], 1});
  UnseenArea unseen = whole_area();
  while (!left.empty()) {
    std::vector<double> values;
    for (const Viewpoint& viewpoint : left) values.push_back(search_.value_of(viewpoint, places));
    const auto best = std::ranges::max_element(values) - values.begin();
    const Viewpoint viewpoint = left[static_cast<std::size_t>(best)];
    left.erase(left.begin() + best);
    std::erase_if(places, [&](const WeightedPlace& place) {
      return witnesses_.is_seen(viewpoint.position, place.place);
    });
    set.viewpoints.push_back(viewpoint);
    unseen.subtract(viewpoint.position);
    full.imaged_percent.push_back(100 * (1 - unseen.area() / area_));
  }
  set.seen = BitRows(set.viewpoints.size(), views_.column_count());
  std::vector<BitRows::Word> missing = views_.matrix().bits.union_of_all();
  const double visible = weight_of(missing, views_.matrix().areas);
  for (std::size_t i = 0; i < set.viewpoints.size(); ++i) {
    views_.look(set.viewpoints[i].region, set.viewpoints[i].position, set.seen.row(i));
    remove_columns(missing, set.seen.row(i));
    set.covered_percent.push_back(100 * (1 - weight_of(missing, views_.matrix().areas) / visible));
    set.seconds.push_back(limits_.seconds());
  }
  for_each_bit(std::span<const BitRows::Word>(missing),
               [&](std::size_t column) { set.missing.push_back(column); });
  set.lower_bound = std::min(lower_bound_, set.viewpoints.size());
  full.bound_is_of_witnesses = bound_ && bound_->lower_bound() == lower_bound_;
  set.refined_bound = full.bound_is_of_witnesses
                          ? std::make_shared<const RefinedBound>(bound_->bound())
                          : parts_.refined_bound;
  if (further_to_best_.best.value > 0) {
    const double before = unseen.area();
    unseen.subtract(further_to_best_.best.viewpoint.position);
    full.further_gain_percent = 100 * (before - unseen.area()) / (area_ - before);
  }
  full.further_positions = further_to_best_.positions;
  for (std::size_t w = 0; w < witnesses_.size(); ++w) full.witnesses.push_back(witnesses_[w]);
  set.full = std::make_shared<const FullCoverage>(std::move(full));
  set.paper_viewpoints = parts_.paper_viewpoints;
  set.candidates = pool_.size();
  set.positions = search_.looked();
  set.relaxation = cover_.relaxation;
  set.time_limit_reached = limits_.has_expired();
  return set;
}

}  // namespace

ViewpointSet find_full_coverage(const RegionViews& views, const ViewpointSet& parts,
                                const FullCoverageOptions& options) {
  if (parts.viewpoints.empty()) return parts;
  return FullSearch(views, parts, options).run();
}

}  // namespace viewcover
