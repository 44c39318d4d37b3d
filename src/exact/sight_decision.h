#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "exact/shaft_parts.h"
#include "exact/sight_query.h"

namespace viewcover::exact {

inline constexpr std::uint64_t kAnyNumberOfCells = std::numeric_limits<std::uint64_t>::max();

/// What is known before cells are looked at, and how many may be.
struct DecisionOptions {
  bool known_visible = false;   ///< a sight line was found; only "fully" is open
  bool known_blocked = false;   ///< an occluder is known to meet the shaft's interior
  bool may_be_blocked = false;  ///< by more than the occluders given: free cells prove nothing
  std::uint64_t most_cells = kAnyNumberOfCells;
};

/// Called with the first free cell: a part of a shaft, a cell that no blocker meets, and a bracket
/// of its real lines.
using OnFreeCell = std::function<void(const ShaftPart&, const LineCell&, const RealLineBracket&)>;

/// Decides by subtracting blocking cones from the root cells of all parts (papers/exact.md). Exact;
/// kAssumedVisible only where the options leave it open.
Verdict decide_by_cells(LinePool& pool, const ShaftPolygons& shaft, const DecisionOptions& options,
                        const OnFreeCell& on_free);

/// Does the blocker block real lines of the cell? Then its occluder meets the shaft's interior.
bool blocks_anything(LinePool& pool, LineCell cell, const LineBlocker& blocker);

/// Is there a sight line through the shaft? Exact; a witness comes with a visible verdict. Random
/// segments first: what they show needs no decision.
SightAnswer decide_shaft(const ShaftPolygons& shaft);

}  // namespace viewcover::exact
