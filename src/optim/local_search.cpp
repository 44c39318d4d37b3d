#include "optim/local_search.h"

#include <algorithm>

#include "optim/exchange_search.h"
#include "optim/growing_cover.h"
#include "optim/swap_search.h"
#include "optim/whole_cover_search.h"

namespace viewcover {
namespace {

using Index = ScoredCover::Index;

/// Work without success that ends the search for a whole cover, without a time limit: a number of
/// times the entries of the matrix, at most about a second.
constexpr std::uint64_t kPatiencePerOne = 20'000, kMostPatience = 200'000'000;
/// The same for the searches of all k together, and at least for each of them.
constexpr std::uint64_t kMostPatienceForAllK = 300'000'000, kLeastPatienceForK = 200'000;
/// Exchanges of one row, #rows x k, up to which all of them are looked at in each step.
constexpr std::size_t kMostSwaps = 100'000;
/// Part of the time limit for the whole cover when sets of fewer rows are asked for too.
constexpr double kShareOfWholeCover = 0.5;

/// One run of the method.
class LocalRun {
 public:
  LocalRun(const CoverInstance& instance, const CoverOptions& options)
      : instance_(instance),
        options_(options),
        limits_(options),
        random_(options.seed),
        lists_(instance.rows()),
        weights_(instance),
        exchanges_(lists_, weights_, random_),
        swaps_(lists_, weights_, random_) {
    cover_.lower_bound = instance.lower_bound();
  }

  RegionCover result() {
    limits_.expired();
    if (cover_.lower_bound == 0) return cover_;
    const bool one_k = options_.goal == CoverGoal::kOneK;
    if (one_k && options_.k == 0) {
      cover_.whole = false;
      return cover_;
    }
    find_whole_cover();
    if (one_k && options_.k < whole_cover_.size()) {
      find_one_k();
    } else {
      if (options_.goal == CoverGoal::kEveryK) find_smaller_sets();
      if (cover_.steps.empty() || cover_.steps.back().k < whole_cover_.size()) {
        add_step(whole_cover_, seconds_for_whole_cover_, evaluations_for_whole_cover_);
      }
    }
    return cover_;
  }

 private:
  void find_whole_cover() {
    WholeCoverSearch search(lists_, random_);
    const auto report = [&] {
      if (options_.on_better) options_.on_better({sorted(search.best()), limits_.seconds()});
    };
    report();
    const bool only_this = options_.goal == CoverGoal::kWholeCover;
    SearchEffort effort(limits_, only_this ? 1 : kShareOfWholeCover, patience(kMostPatience),
                        search.work());
    // No k rows cover everything if the bound says so: the time belongs to the search for the best.
    const bool excluded = options_.goal == CoverGoal::kOneK && options_.k < cover_.lower_bound;
    if (!excluded) search.run(effort, cover_.lower_bound, report);
    note_limit(effort);
    whole_cover_ = search.best();
    evaluations_for_whole_cover_ = search.evaluations();
    seconds_for_whole_cover_ = limits_.seconds();
  }

  void find_one_k() {
    const std::vector<Index> found =
        best_set(exchanges_.grown({}, options_.k), exchanges_.in_order_of_loss(whole_cover_), 1,
                 patience(kMostPatienceForAllK));
    add_step(found, limits_.seconds(), evaluations_for_whole_cover_ + evaluations());
    cover_.whole = instance_.covers_all(cover_.steps.back().chosen);
  }

  /// Ends before the whole cover, or with a smaller one.
  void find_smaller_sets() {
    const std::vector<Index> order = exchanges_.in_order_of_loss(whole_cover_);
    std::vector<Index> found;
    for (std::size_t k = 1; k < whole_cover_.size(); ++k) {
      const double seconds_before = limits_.seconds();
      const std::uint64_t evaluations_before = evaluations();
      const std::size_t left = whole_cover_.size() - k;
      found = best_set(
          exchanges_.grown(found, k), order, 1 / static_cast<double>(left),
          std::max(kLeastPatienceForK, patience(kMostPatienceForAllK) / (whole_cover_.size() - 1)));
      add_step(found, limits_.seconds() - seconds_before, evaluations() - evaluations_before);
      if (!instance_.covers_all(cover_.steps.back().chosen)) continue;
      whole_cover_ = found;
      if (options_.on_better) options_.on_better({sorted(found), limits_.seconds()});
    }
  }

  /// Starts from the better one of `grown` and as many rows at the end of `order`. Covers at least
  /// as much as `grown`.
  std::vector<Index> best_set(const std::vector<Index>& grown, const std::vector<Index>& order,
                              double share, std::uint64_t most_work) {
    const std::vector<Index> kept(order.end() - static_cast<std::ptrdiff_t>(grown.size()),
                                  order.end());
    const std::vector<Index>& start = covered_percent(kept) > covered_percent(grown) ? kept : grown;
    const std::vector<Index> found = grown.size() * lists_.row_count() <= kMostSwaps
                                         ? improved(swaps_, start, share, most_work)
                                         : improved(exchanges_, start, share, most_work);
    // Weights are rounded in the search.
    return covered_percent(found) < covered_percent(grown) ? grown : found;
  }

  template <class Search>
  std::vector<Index> improved(Search& search, const std::vector<Index>& start, double share,
                              std::uint64_t most_work) {
    SearchEffort effort(limits_, share, most_work, search.work());
    const std::vector<Index> found = search.improved(start, effort);
    note_limit(effort);
    return found;
  }

  std::uint64_t evaluations() const { return exchanges_.evaluations() + swaps_.evaluations(); }

  void add_step(const std::vector<Index>& rows, double seconds, std::uint64_t evaluations) {
    CoverStep step = make_step(instance_, sorted(rows));
    step.seconds = seconds;
    step.evaluations = evaluations;
    cover_.steps.push_back(std::move(step));
    if (options_.on_step) options_.on_step(cover_.steps.back());
  }

  std::uint64_t patience(std::uint64_t most) const {
    return std::min(most, kPatiencePerOne * lists_.ones());
  }

  void note_limit(const SearchEffort& effort) {
    cover_.time_limit_reached = cover_.time_limit_reached || effort.cut_short();
  }

  double covered_percent(const std::vector<Index>& rows) const {
    return instance_.covered_percent(sorted(rows));
  }

  static std::vector<std::size_t> sorted(const std::vector<Index>& rows) {
    std::vector<std::size_t> chosen(rows.begin(), rows.end());
    std::ranges::sort(chosen);
    return chosen;
  }

  const CoverInstance& instance_;
  const CoverOptions& options_;
  SearchLimits limits_;
  RandomNumbers random_;
  Incidence lists_;
  IntegerWeights weights_;
  ExchangeSearch exchanges_;
  SwapSearch swaps_;
  RegionCover cover_;
  std::vector<Index> whole_cover_;
  std::uint64_t evaluations_for_whole_cover_ = 0;
  double seconds_for_whole_cover_ = 0;
};

}  // namespace

RegionCover LocalSearch::solve(const CoverInstance& instance, const CoverOptions& options) const {
  return LocalRun(instance, options).result();
}

}  // namespace viewcover
