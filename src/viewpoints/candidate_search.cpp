#include "viewpoints/candidate_search.h"

#include <algorithm>
#include <cmath>

#include "viewpoints/sight_line_starts.h"

namespace viewcover {
namespace {

/// Random positions to begin with, in all regions together, and at least in each.
constexpr std::size_t kSamples = 1024, kSamplesPerRegion = 2;
/// Elements seen by fewer candidates are looked at from the starts of sight lines, of so many
/// regions each.
constexpr std::size_t kFewViewers = 6, kRegionsPerElement = 4;
/// The most candidates the cover is computed for.
constexpr std::size_t kMostCandidates = 4000;
constexpr PoolCoverEffort kEffort{.nodes = 200};
/// Annealing runs in a round, and positions in a run.
constexpr std::size_t kRuns = 48, kEvaluations = 40;
/// What counts as a fall of the relaxation.
constexpr double kFall = 0.005;

/// The columns that of some candidates only two see.
std::vector<BitRows::Word> seen_only_by(std::span<const Candidate> candidates, std::size_t a,
                                        std::size_t b) {
  std::vector<BitRows::Word> only(candidates[a].seen.size());
  for (std::size_t w = 0; w < only.size(); ++w) {
    BitRows::Word others = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (c != a && c != b) others |= candidates[c].seen[w];
    }
    only[w] = (candidates[a].seen[w] | candidates[b].seen[w]) & ~others;
  }
  return only;
}

}  // namespace

CandidateSearch::CandidateSearch(Looks& looks, const ViewpointOptions& options, CandidatePool& pool,
                                 std::vector<Candidate> best)
    : looks_(looks), options_(options), pool_(pool), best_(std::move(best)) {
  report();
}

void CandidateSearch::add(std::vector<Candidate> candidates) {
  for (Candidate& candidate : candidates) pool_.add(std::move(candidate));
}

void CandidateSearch::gather() {
  const RegionViews& views = looks_.views();
  RandomNumbers random(mixed(options_.seed));
  std::vector<Look> samples;
  const std::size_t each = std::max(kSamplesPerRegion, kSamples / views.region_count());
  for (std::size_t region = 0; region < views.region_count(); ++region) {
    for (std::size_t i = 0; i < each; ++i) {
      samples.push_back({region, views.positions(region).random(random)});
    }
  }
  add(looks_.from(samples));

  const std::vector<std::size_t> viewers = pool_.viewers();
  std::vector<SeenPair> pairs;
  for (std::size_t column = 0; column < viewers.size(); ++column) {
    if (viewers[column] >= kFewViewers) continue;
    const auto some = pairs_of_column(views, column, options_.chosen_regions, kRegionsPerElement);
    pairs.insert(pairs.end(), some.begin(), some.end());
  }
  if (!looks_.limits().expired()) {
    add(looks_.from(starts_of_sight_lines(views, pairs, options_.seed)));
  }
}

void CandidateSearch::run(std::size_t lower_bound, int patience) {
  double relaxation = INFINITY;
  int idle = 0, without_prices = 0;
  while (idle < patience) {
    const std::size_t size = best_.size();
    cover_candidates();
    if (best_.size() <= lower_bound || looks_.limits().expired()) return;
    const bool better = best_.size() < size || cover_.relaxation < relaxation - kFall;
    relaxation = std::min(relaxation, cover_.relaxation);
    idle = better ? 0 : idle + 1;
    without_prices = look_by_prices() ? 0 : without_prices + 1;
    if (without_prices > 0 || idle > patience / 2) look_for_one_in_place_of_two();
  }
}

void CandidateSearch::cover_candidates() {
  if (pool_.size() > kMostCandidates && !cover_.prices.empty()) {
    const ColumnWeights prices(cover_.prices);
    std::vector<double> scores;
    for (std::size_t i = 0; i < pool_.size(); ++i) scores.push_back(prices.of(pool_[i].seen));
    pool_.keep_best(kMostCandidates / 2, scores);
    add(best_);
  }
  cover_ = cover_pool(pool_.rows(), kEffort, options_.seed, looks_.limits());
  if (cover_.chosen.size() >= best_.size()) return;
  best_.clear();
  for (const std::size_t i : cover_.chosen) best_.push_back(pool_[i]);
  report();
}

/// True if candidates were found that the prices promise a smaller fractional cover by.
bool CandidateSearch::look_by_prices() {
  const RegionViews& views = looks_.views();
  const ColumnWeights prices(cover_.prices);
  std::vector<std::pair<double, std::size_t>> regions;  // by what their viewpoints cost at most
  for (std::size_t region = 0; region < views.region_count(); ++region) {
    const double most = prices.of(views.matrix().bits.row(region));
    if (most > 1 + PoolCover::kPriceTolerance) regions.emplace_back(-most, region);
  }
  std::ranges::sort(regions);
  if (regions.empty()) return false;
  // Half of the runs in the most promising regions, half anywhere.
  RandomNumbers random(mixed(options_.seed + jobs_));
  std::vector<AnnealingJob> jobs;
  for (std::size_t run = 0; run < kRuns; ++run) {
    const std::size_t place =
        run % 2 == 0 ? run / 2 % regions.size() : random.below(regions.size());
    jobs.push_back(job(regions[place].second, prices));
  }
  std::vector<Candidate> found = looks_.anneal(jobs);
  const bool promising = std::ranges::any_of(found, [&](const Candidate& candidate) {
    return prices.of(candidate.seen) > 1 + PoolCover::kPriceTolerance;
  });
  add(std::move(found));
  return promising;
}

/// For every two of the best viewpoints: what only they see, looked at from a single position of
/// each region that sees it all.
void CandidateSearch::look_for_one_in_place_of_two() {
  const BitRows& bits = looks_.views().matrix().bits;
  const std::vector<double> ones(bits.columns(), 1.0);
  std::vector<ColumnWeights> needs;
  std::vector<std::pair<std::size_t, std::size_t>> tasks;  // a region and the number of a need
  for (std::size_t a = 0; a < best_.size(); ++a) {
    for (std::size_t b = a + 1; b < best_.size(); ++b) {
      const std::vector<BitRows::Word> need = seen_only_by(best_, a, b);
      for (std::size_t region = 0; region < bits.rows(); ++region) {
        if (is_subset(need, bits.row(region))) tasks.emplace_back(region, needs.size());
      }
      needs.emplace_back(need, ones);
    }
  }
  // As many runs as fit in two rounds, others next time.
  std::vector<AnnealingJob> jobs;
  RandomNumbers random(mixed(options_.seed + jobs_));
  const std::size_t first = tasks.empty() ? 0 : random.below(tasks.size());
  for (std::size_t run = 0; run < std::min(tasks.size(), 2 * kRuns); ++run) {
    const auto [region, need] = tasks[(first + run) % tasks.size()];
    jobs.push_back(job(region, needs[need]));
  }
  add(looks_.anneal(jobs));
}

/// An annealing run from a random position or, half of the time, from the region's best candidate.
AnnealingJob CandidateSearch::job(std::size_t region, const ColumnWeights& weights) {
  AnnealingJob job{region, &weights, {}};
  job.options.seed = mixed(options_.seed + mixed(++jobs_));
  job.options.evaluations = kEvaluations;
  if (job.options.seed % 2 == 0) return job;
  const Candidate* const best = best_in(region, weights);
  if (best != nullptr) job.options.start = best->viewpoint.position;
  return job;
}

const Candidate* CandidateSearch::best_in(std::size_t region, const ColumnWeights& weights) const {
  const Candidate* best = nullptr;
  double most = -1;
  for (std::size_t i = 0; i < pool_.size(); ++i) {
    if (pool_[i].viewpoint.region != region) continue;
    const double benefit = weights.of(pool_[i].seen);
    if (benefit > most) {
      best = &pool_[i];
      most = benefit;
    }
  }
  return best;
}

void CandidateSearch::report() const {
  if (options_.progress != nullptr) options_.progress->viewpoints = best_.size();
}

}  // namespace viewcover
