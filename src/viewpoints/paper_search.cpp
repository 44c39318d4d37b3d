#include "viewpoints/paper_search.h"

#include <algorithm>

#include "viewpoints/sight_line_starts.h"

namespace viewcover {
namespace {

using Words = std::vector<BitRows::Word>;

/// Regions that are tried for an element that the cycle does not find.
constexpr std::size_t kRegionsToHelp = 16;

class PaperSearch {
 public:
  PaperSearch(Looks& looks, const ViewpointOptions& options, CandidatePool& pool)
      : looks_(looks),
        options_(options),
        pool_(pool),
        matrix_(looks.views().matrix()),
        unseen_(matrix_.bits.union_of_all()) {}

  PaperViewpoints run() {
    const auto& regions = options_.chosen_regions;
    std::size_t idle = 0;  // regions in turn that added nothing
    for (std::size_t turn = 0; count_bits(unseen_) > 0; ++turn) {
      const bool helpless = idle >= regions.size();
      const bool added = choose(helpless ? help() : visit(regions[turn % regions.size()], turn));
      if (helpless && !added) give_up_first();
      idle = added || helpless ? 0 : idle + 1;
    }
    return std::move(result_);
  }

 private:
  std::vector<Candidate> visit(std::size_t region, std::size_t turn) {
    const ColumnWeights weights(unseen_, matrix_.areas);
    if (weights.of(matrix_.bits.row(region)) == 0) return {};
    constexpr std::size_t kRunsPerRegion = 4;  // the best counts
    std::vector<AnnealingJob> jobs;
    for (std::size_t run = 0; run < kRunsPerRegion; ++run) {
      jobs.push_back(
          {region, &weights, {.seed = mixed(options_.seed + mixed(turn * kRunsPerRegion + run))}});
    }
    return looks_.anneal(jobs);
  }

  std::size_t first_unseen() const {
    std::size_t first = matrix_.bits.columns();
    for_each_bit(unseen_, [&](std::size_t column) { first = std::min(first, column); });
    return first;
  }

  std::vector<Candidate> help() {
    const auto pairs =
        pairs_of_column(looks_.views(), first_unseen(), options_.chosen_regions, kRegionsToHelp);
    return looks_.from(starts_of_sight_lines(looks_.views(), pairs, options_.seed));
  }

  void give_up_first() {
    const std::size_t column = first_unseen();
    result_.missing.push_back(column);
    unseen_[column / 64] &= ~(BitRows::Word{1} << (column % 64));
  }

  /// Takes the candidate that adds most; false if none adds anything.
  bool choose(std::vector<Candidate> candidates) {
    const ColumnWeights weights(unseen_, matrix_.areas);
    const Candidate* best = nullptr;
    double most = 0;
    for (const Candidate& candidate : candidates) {
      const double adds = weights.of(candidate.seen);
      if (adds > most) {
        best = &candidate;
        most = adds;
      }
    }
    if (best != nullptr) {
      remove_columns(unseen_, best->seen);
      result_.chosen.push_back(*best);
    }
    const bool added = best != nullptr;
    for (Candidate& candidate : candidates) pool_.add(std::move(candidate));
    return added;
  }

  Looks& looks_;
  const ViewpointOptions& options_;
  CandidatePool& pool_;
  const VisibilityMatrix& matrix_;
  Words unseen_;
  PaperViewpoints result_;
};

}  // namespace

PaperViewpoints paper_search(Looks& looks, const ViewpointOptions& options, CandidatePool& pool) {
  return PaperSearch(looks, options, pool).run();
}

}  // namespace viewcover
