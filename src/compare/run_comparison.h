#pragma once

#include <array>

#include "compare/pair_verdicts.h"
#include "report/run_data.h"

namespace viewcover {

/// Pairs of a region and an element, and the sum of the areas of their elements.
struct PairCount {
  std::size_t count = 0;
  double area = 0;

  void add(double element_area) {
    ++count;
    area += element_area;
  }
};
using PairsByVerdict = std::array<PairCount, kVerdictCount>;

/// How far a run is from another one over the same scene and regions, which judges it. Elements are
/// those of the common refinement of both.
struct RunComparison {
  PairCount judged_pairs, reference_pairs;
  PairCount missed, excess;          ///< in the reference only, in the judged run only
  PairsByVerdict missed_by_verdict;  ///< as the reference knows them
  PairsByVerdict excess_by_verdict;  ///< as the judged run knows them
  std::size_t optimum = 0;           ///< regions in the best set of the judged run
  double claimed_percent = 0;        ///< of what its regions see, by area, its set covers
  double confirmed_percent = 0;      ///< the same, by what the reference says of both
  std::size_t left_out = 0;          ///< elements that some region sees but none of the set

  /// Shares of the reference's pairs that are missed (Q_u), and that the excess amounts to (Q_o),
  /// after Bittner (2002). Not a number if the reference has none.
  double missed_share() const { return share(missed.count, reference_pairs.count); }
  double excess_share() const { return share(excess.count, reference_pairs.count); }
  double missed_area_share() const { return missed.area / reference_pairs.area; }
  double excess_area_share() const { return excess.area / reference_pairs.area; }

 private:
  static double share(std::size_t part, std::size_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// A finished run and how it knows its pairs.
struct ComparedRun {
  const RunData& data;
  const PairVerdicts& verdicts;
};

/// Errors: InputError at `place` if the runs are not of the same scene and regions.
RunComparison compare(const ComparedRun& judged, const ComparedRun& reference,
                      std::string_view place);

}  // namespace viewcover
