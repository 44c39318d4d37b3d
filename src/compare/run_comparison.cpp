#include "compare/run_comparison.h"

#include <algorithm>

#include "compare/common_elements.h"

namespace viewcover {
namespace {

/// What a set of regions covers of the area that any region sees, judged by one run.
struct Covered {
  double percent = 100;
  std::size_t left_out = 0;
};

Covered covered_by(const std::vector<std::size_t>& chosen, const BitRows& seen,
                   const std::vector<std::size_t>& elements, const std::vector<double>& areas) {
  const BitRows::Word one = 1;
  const auto all = seen.union_of_all(), some = seen.union_of(chosen);
  double coverable = 0, covered = 0;
  Covered result;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const BitRows::Word bit = one << (elements[i] % 64);
    if ((all[elements[i] / 64] & bit) == 0) continue;
    coverable += areas[i];
    const bool is_covered = (some[elements[i] / 64] & bit) != 0;
    covered += is_covered ? areas[i] : 0;
    result.left_out += is_covered ? 0 : 1;
  }
  if (result.left_out > 0) result.percent = 100 * covered / coverable;
  return result;
}

}  // namespace

RunComparison compare(const ComparedRun& judged, const ComparedRun& reference,
                      std::string_view place) {
  const RunData &a = judged.data, &b = reference.data;
  const CommonElements common = common_elements(a, b, place);
  std::vector<double> areas(common.size());
  for (std::size_t i = 0; i < common.size(); ++i) {
    const bool is_of_a = a.bundle.elements[common.first[i]] == common.addresses[i];
    areas[i] = is_of_a ? a.areas[common.first[i]] : b.areas[common.second[i]];
  }

  RunComparison comparison;
  for (std::size_t region = 0; region < a.regions.size(); ++region) {
    for (std::size_t i = 0; i < common.size(); ++i) {
      const std::size_t in_a = common.first[i], in_b = common.second[i];
      const bool a_sees = a.seen.test(region, in_a), b_sees = b.seen.test(region, in_b);
      if (a_sees) comparison.judged_pairs.add(areas[i]);
      if (b_sees) comparison.reference_pairs.add(areas[i]);
      if (a_sees == b_sees) continue;
      const Verdict verdict =
          a_sees ? judged.verdicts(region, in_a) : reference.verdicts(region, in_b);
      (a_sees ? comparison.excess : comparison.missed).add(areas[i]);
      (a_sees ? comparison.excess_by_verdict
              : comparison.missed_by_verdict)[static_cast<std::size_t>(verdict)]
          .add(areas[i]);
    }
  }

  const std::vector<std::size_t> chosen = a.chosen();
  const Covered confirmed = covered_by(chosen, b.seen, common.second, areas);
  comparison.optimum = chosen.size();
  comparison.claimed_percent = covered_by(chosen, a.seen, common.first, areas).percent;
  comparison.confirmed_percent = confirmed.percent;
  comparison.left_out = confirmed.left_out;
  return comparison;
}

}  // namespace viewcover
