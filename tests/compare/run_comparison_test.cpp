#include "compare/run_comparison.h"

#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <map>
#include <set>

#include "random_run.h"
#include "scene/error.h"
#include "scene/scratch_folder.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::array<Verdict, 3> kVisible = {Verdict::kFullyVisible, Verdict::kVisibleWitness,
                                             Verdict::kAssumedVisible};

template <class Owner>
std::string node(QuadAddress<Owner> address) {
  return std::to_string(address.owner().value + 1) + ":" + std::to_string(address.level()) + ":" +
         std::to_string(address.path());
}

class RunComparisonTest : public ::testing::Test {
 protected:
  static Verdict verdict_of(std::size_t region, std::size_t element) {
    return kVisible[(region + element) % 3];
  }
  std::string text_of_links(const RunData& run) const {
    std::string text = "region,element,kind,occluders\n";
    for (std::size_t region = 0; region < run.regions.size(); ++region) {
      for_each_bit(run.seen.row(region), [&](std::size_t i) {
        text += node(run.region_addresses[region]) + "," + node(run.bundle.elements[i]) + "," +
                std::string(name(verdict_of(region, i))) + ",1 2\n";
      });
    }
    return text;
  }
  PairVerdicts verdicts(const RunData& run, const std::string& text) const {
    std::ofstream(folder_.path() / "links.csv") << text;
    return {folder_.path(), run};
  }
  PairVerdicts verdicts(const RunData& run) const { return verdicts(run, text_of_links(run)); }

  ScratchFolder folder_;
};

/// The element of a run that holds a smallest cell.
std::size_t holder(const RunData& run, ElementAddress cell) {
  for (std::size_t i = 0; i < run.bundle.elements.size(); ++i) {
    if (run.bundle.elements[i].contains(cell)) return i;
  }
  throw std::logic_error("no element holds the cell");
}

// By the 64 smallest cells of each surface, of area 1: no refinement, no merging of lists.
TEST_F(RunComparisonTest, AgreesWithACountOfSmallestCells) {
  std::size_t differing = 0, incomplete = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    RunData a = random_run(random);
    const RunData b = random_run(random);
    a.covers.back().regions = {seed % 2};
    const RunComparison comparison = compare({a, verdicts(a)}, {b, verdicts(b)}, "B");

    std::map<Verdict, double> missed, excess;
    double pairs_of_a = 0, pairs_of_b = 0, coverable_a = 0, coverable_b = 0, covered_a = 0,
           covered_b = 0;
    std::set<std::pair<std::size_t, std::size_t>> pieces, left_out;
    for (std::size_t surface = 0; surface < 2; ++surface) {
      for (std::uint64_t path = 0; path < 64; ++path) {
        const ElementAddress cell(SurfaceId(surface), 3, path);
        const std::size_t in_a = holder(a, cell), in_b = holder(b, cell);
        for (std::size_t region = 0; region < 2; ++region) {
          const bool seen_a = a.seen.test(region, in_a), seen_b = b.seen.test(region, in_b);
          pairs_of_a += seen_a;
          pairs_of_b += seen_b;
          if (seen_b && !seen_a) missed[verdict_of(region, in_b)] += 1;
          if (seen_a && !seen_b) excess[verdict_of(region, in_a)] += 1;
        }
        const auto any = [](const RunData& run, std::size_t element) {
          return run.seen.test(0, element) || run.seen.test(1, element);
        };
        coverable_a += any(a, in_a);
        coverable_b += any(b, in_b);
        covered_a += a.seen.test(seed % 2, in_a);
        covered_b += b.seen.test(seed % 2, in_b);
        if (any(b, in_b) && !b.seen.test(seed % 2, in_b)) left_out.insert({in_a, in_b});
      }
    }
    if (pairs_of_a * pairs_of_b == 0) continue;
    EXPECT_EQ(comparison.judged_pairs.area, pairs_of_a);
    EXPECT_EQ(comparison.reference_pairs.area, pairs_of_b);
    double all_missed = 0, all_excess = 0;
    for (const Verdict verdict : kVisible) {
      const auto at = static_cast<std::size_t>(verdict);
      EXPECT_EQ(comparison.missed_by_verdict[at].area, missed[verdict]);
      EXPECT_EQ(comparison.excess_by_verdict[at].area, excess[verdict]);
      all_missed += missed[verdict];
      all_excess += excess[verdict];
    }
    EXPECT_EQ(comparison.missed.area, all_missed);
    EXPECT_DOUBLE_EQ(comparison.missed_area_share() * pairs_of_b, all_missed);
    EXPECT_DOUBLE_EQ(comparison.excess_area_share() * pairs_of_b, all_excess);
    EXPECT_EQ(comparison.optimum, 1u);
    EXPECT_DOUBLE_EQ(comparison.claimed_percent, 100 * covered_a / coverable_a);
    EXPECT_DOUBLE_EQ(comparison.confirmed_percent, 100 * covered_b / coverable_b);
    EXPECT_EQ(comparison.left_out, left_out.size());
    differing += all_missed > 0 && all_excess > 0;
    incomplete += comparison.confirmed_percent < 100;
  }
  EXPECT_GT(differing, 80u);
  EXPECT_GT(incomplete, 80u);
}

TEST_F(RunComparisonTest, CountsPiecesOfTheCommonRefinement) {
  RunData a = made_run({level(0, 8, 0, 8, 0)}, {"a"}, {level(1, 2, 1, 2, 3)}, {{0}});
  RunData b = a;
  b.bundle.elements.clear();
  b.areas.assign(4, 16);
  for (int digit = 0; digit < 4; ++digit)
    b.bundle.elements.push_back(a.bundle.elements[0].child(digit));
  b.seen = BitRows(1, 4);
  b.seen.set(0, 2);
  const RunComparison comparison = compare({a, verdicts(a)}, {b, verdicts(b)}, "B");
  EXPECT_EQ(comparison.judged_pairs.count, 4u);
  EXPECT_EQ(comparison.reference_pairs.count, 1u);
  EXPECT_EQ(comparison.missed.count, 0u);
  EXPECT_EQ(comparison.excess_share(), 3.0);
  EXPECT_EQ(comparison.excess_area_share(), 3.0);
  EXPECT_EQ(comparison.missed_share(), 0.0);
}

TEST_F(RunComparisonTest, ALinkSpeaksForAllBelowItsNodes) {
  const ElementAddress whole(SurfaceId(0), 0, 0);
  RunData run = made_run({level(0, 8, 0, 8, 0)}, {"a"},
                         {level(0, 1, 0, 1, 3), level(1, 2, 0, 1, 3)}, {{}, {}});
  run.region_addresses = {RegionAddress(PartId(0), 1, 0), RegionAddress(PartId(0), 1, 1)};
  run.bundle.elements = {whole.child(0), whole.child(1), whole.child(2).child(3)};
  run.seen = BitRows(2, 3);
  for (std::size_t i = 0; i < 3; ++i) run.seen.set(0, i);
  run.seen.set(1, 2);
  const PairVerdicts known = verdicts(run,
                                      "region,element,kind,occluders\n1:1:0,1:0:0,fully_visible,\n"
                                      "1:0:0,1:1:2,visible_witness,4\n");
  EXPECT_EQ(known(0, 0), Verdict::kFullyVisible);
  EXPECT_EQ(known(0, 1), Verdict::kFullyVisible);
  EXPECT_EQ(known(0, 2), Verdict::kVisibleWitness);
  EXPECT_EQ(known(1, 2), Verdict::kVisibleWitness);
}

TEST_F(RunComparisonTest, RefusesLinksThatAreNoneOrTooFew) {
  const RunData run = made_run({level(0, 8, 0, 8, 0)}, {"a"}, {level(0, 1, 0, 1, 3)}, {{0}});
  const std::string titles = "region,element,kind,occluders\n";
  for (const std::string line :
       {"1:0:0,1:0:0,hidden_by_one,", "1:0,1:0:0,fully_visible,", "0:0:0,1:0:0,fully_visible,",
        "1:0:1,1:0:0,fully_visible,", "1:0:0,1:0:0:0,fully_visible,", "a:0:0,1:0:0,fully_visible,",
        ""}) {
    SCOPED_TRACE(line);
    EXPECT_THAT([&] { verdicts(run, titles + line + "\n"); },
                ThrowsMessage<InputError>(HasSubstr("links.csv:2: is no link")));
  }
  EXPECT_THAT([&] { verdicts(run, titles); },
              ThrowsMessage<InputError>(HasSubstr("has no link for region 1 and element 1")));
  EXPECT_EQ(verdicts(run, titles + "1:0:0,1:0:0,fully_visible,")(0, 0), Verdict::kFullyVisible);
}

}  // namespace
}  // namespace viewcover::testing
