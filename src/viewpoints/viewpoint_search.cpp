#include "viewpoints/viewpoint_search.h"

#include <algorithm>

#include "optim/reductions.h"
#include "viewpoints/candidate_search.h"
#include "viewpoints/paper_search.h"
#include "viewpoints/refined_bound.h"

namespace viewcover {
namespace {

/// Rounds of the search without success before it ends.
constexpr int kPatience = 6;

CoverOptions limits_of(const ViewpointOptions& options, double time_limit_seconds) {
  CoverOptions limits;
  limits.stop = options.stop;
  limits.time_limit_seconds = time_limit_seconds;
  return limits;
}

/// The candidates in the order in which they add most area, without those that add nothing.
void order_by_area(std::vector<Candidate> candidates, const VisibilityMatrix& matrix,
                   ViewpointSet& set) {
  const double total = weight_of(matrix.bits.union_of_all(), matrix.areas);
  std::vector<BitRows::Word> unseen = matrix.bits.union_of_all();
  std::vector<Candidate> order;
  while (!candidates.empty()) {
    const ColumnWeights weights(unseen, matrix.areas);
    const auto best = std::ranges::max_element(
        candidates, {}, [&](const Candidate& candidate) { return weights.of(candidate.seen); });
    if (weights.of(best->seen) == 0) break;
    remove_columns(unseen, best->seen);
    const double left = weight_of(unseen, matrix.areas);
    set.covered_percent.push_back(left == 0 ? 100 : 100 * (1 - left / total));
    order.push_back(*best);
    candidates.erase(best);
  }
  set.seen = BitRows(order.size(), matrix.bits.columns());
  for (std::size_t i = 0; i < order.size(); ++i) {
    set.viewpoints.push_back(order[i].viewpoint);
    set.seconds.push_back(order[i].seconds);
    std::ranges::copy(order[i].seen, set.seen.row(i).begin());
  }
}

/// Raises the lower bound and looks for fewer viewpoints where the bound points to, in turn.
std::vector<Candidate> close_gap(Looks& looks, const ViewpointOptions& options, CandidatePool& pool,
                                 std::vector<Candidate> best, ViewpointSet& set) {
  constexpr std::size_t kRoundsPerSearch = 4;
  CandidateSearch search(looks, options, pool, std::move(best));
  const std::vector<std::uint32_t> columns = columns_without_implied(pool.rows());
  BoundRefinement refinement(looks.views(), columns, looks.limits(), options.seed);
  for (std::size_t round = 1; search.best().size() > set.lower_bound; ++round) {
    if (options.close_gap_seconds == 0 && round > options.gap_rounds) break;
    if (!refinement.refine()) break;
    set.lower_bound = std::max(set.lower_bound, refinement.lower_bound());
    if (options.progress != nullptr) options.progress->lower_bound = set.lower_bound;
    search.add(looks.from(refinement.middles_of_cover()));
    if (round % kRoundsPerSearch == 0) search.run(set.lower_bound, 1);
  }
  if (refinement.lower_bound() > options.lower_bound) {
    set.refined_bound = std::make_shared<const RefinedBound>(refinement.bound());
  }
  return search.best();
}

}  // namespace

ViewpointSet find_viewpoints(const RegionViews& views, const ViewpointOptions& options) {
  ViewpointSet set;
  set.seen = BitRows(0, views.column_count());
  set.lower_bound = options.lower_bound;
  if (options.progress != nullptr) options.progress->lower_bound = set.lower_bound;
  SearchLimits limits(limits_of(options, options.time_limit_seconds));
  if (count_bits(views.matrix().bits.union_of_all()) == 0) return set;

  // The first whole set is always found, however short the time.
  CandidatePool pool(views.column_count());
  SearchLimits unlimited(limits_of(options, 0));
  Looks first_looks(views, unlimited, options.progress);
  PaperViewpoints paper = paper_search(first_looks, options, pool);
  set.missing = std::move(paper.missing);
  set.paper_viewpoints = paper.chosen.size();

  Looks looks(views, limits, options.progress);
  CandidateSearch search(looks, options, pool, std::move(paper.chosen));
  if (search.best().size() > options.lower_bound && !limits.expired()) {
    search.gather();
    search.run(options.lower_bound, kPatience);
  }
  std::vector<Candidate> best = search.best();
  SearchLimits gap_limits(limits_of(options, options.close_gap_seconds));
  Looks gap_looks(views, options.close_gap_seconds > 0 ? gap_limits : limits, options.progress);
  if (options.close_gap_seconds > 0 || options.gap_rounds > 0) {
    best = close_gap(gap_looks, options, pool, std::move(best), set);
  }
  order_by_area(std::move(best), views.matrix(), set);
  set.candidates = pool.size();
  for (std::size_t i = 0; i < pool.size(); ++i) set.tried.push_back(pool[i].viewpoint);
  set.positions = first_looks.positions() + looks.positions() + gap_looks.positions();
  set.relaxation = search.cover().relaxation;
  set.time_limit_reached = limits.has_expired();
  return set;
}

}  // namespace viewcover
