#include "exact/sight_decision.h"

#include <algorithm>
#include <optional>

#include "exact/witness_search.h"

namespace viewcover::exact {
namespace {

/// Random segments tried before the decision: enough for most pairs that see each other, and little
/// beside a decision.
constexpr int kRandomSegments = 96;

/// Ends at the first free cell that holds a real line.
struct FirstSightLine {
  LinePool& pool;
  std::optional<RealLineBracket> bracket{};
  std::optional<LineCell> free_cell{};

  bool holds_anything(const LineCell& cell) {
    bracket = find_real_lines(pool, cell);
    return bracket.has_value();
  }
  bool on_free(const LineCell& cell) {
    free_cell = cell;
    return true;
  }
};

bool any_blocks_anything(LinePool& pool, const ShaftPart& part) {
  return std::any_of(part.roots.begin(), part.roots.end(), [&](const LineCell& root) {
    return std::any_of(part.blockers.begin(), part.blockers.end(), [&](const LineBlocker& blocker) {
      return blocks_anything(pool, root, blocker);
    });
  });
}

}  // namespace

bool blocks_anything(LinePool& pool, LineCell cell, const LineBlocker& blocker) {
  std::vector<std::int8_t> signs;
  for (const Side<6>& side : blocker.sides) {
    bool positive = false, negative = false;
    signs.clear();
    for (const LineVector* ray : cell.rays()) {
      const int sign = pool.sign_of_product(*side.functional, *ray);
      signs.push_back(static_cast<std::int8_t>(sign));
      positive |= sign == side.sign;
      negative |= sign == -side.sign;
    }
    if (!positive) return false;
    if (!negative) continue;
    cell =
        cell.part(side.functional, signs, side.sign, cell.cut_rays(pool, side.functional, signs));
  }
  return find_real_lines(pool, cell).has_value();
}

Verdict decide_by_cells(LinePool& pool, const ShaftPolygons& shaft, const DecisionOptions& options,
                        const OnFreeCell& on_free) {
  bool visible = options.known_visible, blocked = options.known_blocked;
  bool any_part = false, gave_up = false;
  std::optional<std::size_t> covering;  // the occluder that covers all roots so far
  bool one_covers = true;
  visit_shaft_parts(pool, shaft, [&](const ShaftPart& part) {
    any_part = true;
    if (!visible) {
      for (const LineCell& root : part.roots) {
        FirstSightLine rules{pool};
        Subtraction<6, FirstSightLine> subtraction(pool, part.blockers, rules, part.samples,
                                                   options.most_cells);
        const auto outcome = subtraction.run(root);
        if (outcome == SubtractionOutcome::kEnded) {
          visible = true;
          if (!options.may_be_blocked) on_free(part, *rules.free_cell, *rules.bracket);
          break;
        }
        gave_up = outcome == SubtractionOutcome::kGaveUp;
        if (gave_up) return true;
        const auto cover = subtraction.covering_blocker();
        one_covers =
            one_covers && cover && (!covering || *covering == part.occluder_of_blocker[*cover]);
        if (cover) covering = part.occluder_of_blocker[*cover];
      }
      if (!visible) {
        blocked = true;  // all of this part is
        return false;
      }
    }
    if (options.may_be_blocked) return true;
    if (!blocked) blocked = any_blocks_anything(pool, part);
    return blocked;
  });
  if (gave_up || (visible && options.may_be_blocked)) return Verdict::kAssumedVisible;
  if (visible) return blocked ? Verdict::kVisibleWitness : Verdict::kFullyVisible;
  if (!any_part) return Verdict::kHiddenNotFacing;
  return one_covers ? Verdict::kHiddenByOne : Verdict::kHiddenBySet;
}

SightAnswer decide_shaft(const ShaftPolygons& shaft) {
  SightAnswer answer;
  RandomNumbers random(1);
  RandomSegments segments = try_exact_segments(shaft, kRandomSegments, random);
  answer.witness = std::move(segments.witness);
  if (answer.witness && segments.any_blocked) {
    answer.verdict = Verdict::kVisibleWitness;
    return answer;
  }
  LinePool pool(answer.statistics);
  answer.verdict = decide_by_cells(
      pool, shaft,
      {.known_visible = answer.witness.has_value(), .known_blocked = segments.any_blocked},
      [&](const ShaftPart& part, const LineCell& cell, const RealLineBracket& bracket) {
        answer.witness = witness_in_cell(shaft, part, cell, bracket, random, answer.statistics);
      });
  return answer;
}

}  // namespace viewcover::exact
