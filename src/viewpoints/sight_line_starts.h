#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viewpoints/looks.h"

namespace viewcover {

/// A region and the column of an element that it sees.
struct SeenPair {
  std::size_t region = 0, column = 0;
};

/// Positions near the starts of sight lines between regions and elements, a few for each pair: the
/// nearest position to the start and others around it, each with the end of the sight line as its
/// target. What is seen from them is not known yet. Pairs in turn; nothing where the backend finds
/// no sight line. In parallel.
std::vector<Look> starts_of_sight_lines(const RegionViews& views, std::span<const SeenPair> pairs,
                                        std::uint64_t seed);

/// Up to `most` regions that see a column, spread evenly over all that do; those of `first` come
/// first.
std::vector<SeenPair> pairs_of_column(const RegionViews& views, std::size_t column,
                                      std::span<const std::size_t> first, std::size_t most);

}  // namespace viewcover
