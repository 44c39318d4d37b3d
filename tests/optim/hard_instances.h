#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "links/bit_rows.h"

namespace viewcover::reference {

/// A set cover instance, every column of weight 1, with what is known of its optimum.
struct HardInstance {
  std::string name;
  BitRows matrix;
  std::size_t best = 0;  ///< rows of the smallest cover known
  bool proved = false;   ///< no smaller one exists
};

/// Rows: points of the affine space AG(n,3); columns: its lines, each of three points. The points
/// that a cover leaves out hold no line: a cap set. Known for n = 2, 3, 4: 9 - 4, 27 - 9, 81 - 20
/// (Pellegrino 1970); as Steiner systems A9, A27, A81 in the set cover literature.
HardInstance affine_lines(int dimension);

/// Rows: edges of the d-cube; columns: its 4-cycles, each of four edges (Grossman and Wool 1997:
/// CYC). Known for d = 6, 7, 8: 60 (Harborth and Nienborg 1994: at most 132 of 192 edges hold no
/// 4-cycle), 144, 342.
HardInstance cube_cycles(int dimension);

/// Rows: 4-subsets of n points; columns: bipartitions of the points into two non-empty parts. A
/// subset covers a bipartition if it lies in one of its parts, so that a cover is a 4-uniform
/// hypergraph that no two colours colour (Grossman and Wool 1997: CLR). Known for n = 10, 11: 25,
/// 23; no such hypergraph on any number of points has fewer than 23 edges (Oestergard 2014).
HardInstance bipartitions(int points);

/// `planted` rows share the columns out among them evenly; `decoys` more rows cover as many columns
/// each, chosen at random. As no row covers more than its share, none can be spared.
HardInstance planted_cover(std::size_t planted, std::size_t share, std::size_t decoys,
                           std::uint64_t seed);

/// `copies` of: two rows that share 2 (2^levels - 1) columns, and rows of 2^levels, ..., 4, 2
/// columns, each half from one of the two and half from the other. Greedy takes all of the latter.
HardInstance greedy_trap(int levels, std::size_t copies);

/// Cameras on the ceiling of an empty room: what the academic instances of the GECCO 2020
/// competition on optimal camera placement are about. Places are a grid of 11 x 11 x 5 with steps
/// of 1, the first 11 x 11 at height 0; over each of these, at `height`, a camera looks in 8
/// directions round, at three angles to the horizontal. It covers the places in its pyramid that
/// are no farther than `range`.
struct CameraRoom {
  double height = 4;
  std::array<double, 3> tilts = {};       ///< degrees, negative: down
  double horizontal = 60, vertical = 45;  ///< whole angles of view, degrees
  double range = 8;
  std::size_t best = 0;  ///< cameras of the smallest placement known
  bool proved = false;   ///< no smaller one exists
};

/// Rows: cameras, 2,904; columns: places, 605.
HardInstance camera_placement(const CameraRoom& room);

/// The ones that methods are measured with.
std::vector<HardInstance> hard_instances();

/// The larger ones of the same kinds, under the names clr, STS and cyc in the OR-Library and among
/// the Steiner triple systems.
std::vector<HardInstance> library_instances();

/// Camera placements of the size and density of that competition's first and tenth instance; the
/// best covers are our own (bench/optim.txt).
std::vector<HardInstance> camera_instances();

}  // namespace viewcover::reference
