#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "links/bit_rows.h"

namespace viewcover::reference {

/// The fewest rows that cover every coverable column: branch and bound on the column with the
/// fewest rows, after removal of implied columns and dominated rows. Shares nothing with
/// src/optim but the bits. Exponential in the worst case; meant for optima up to about 12.
std::size_t minimum_cover(const BitRows& matrix);

/// The largest covered weight of k rows, by trying all sets. Requires at most 16 rows.
double maximum_coverage(const BitRows& matrix, std::span<const double> weights, std::size_t k);

/// What a planar room with furniture looks like from `side` x `side` places: rows are places,
/// numbered along a quadtree, columns wall and furniture elements that face a place at an angle of
/// their own and are not behind one of the round `pieces` of furniture. `weights` are skewed like
/// areas of elements.
struct Room {
  BitRows matrix;
  std::vector<double> weights;
};
Room furnished_room(std::size_t side, std::size_t elements, int pieces, std::uint64_t seed);

}  // namespace viewcover::reference
