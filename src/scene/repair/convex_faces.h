#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "scene/convex_polygon.h"
#include "scene/lattice.h"
#include "scene/read/polygon_soup.h"
#include "scene/scene.h"

namespace viewcover {

/// The faces of a soup on a lattice as strictly convex, exactly planar polygons, in the order of
/// the faces, the parts of a face next to each other.
struct ConvexFaces {
  std::vector<ConvexPolygon> polygons;
  std::vector<std::uint32_t> sources;  ///< for each polygon the 0-based face it comes from
  Repairs repairs;                     ///< all but `merged_surfaces`
};

/// Largest magnitude of a coordinate of a vertex that a face uses, scene units.
double largest_coordinate(const PolygonSoup& soup);

/// Rounds the vertices that faces use to the lattice, welds those that meet there, drops faces
/// without area and duplicates (the same corners in the same cyclic order or, unless `one_sided`,
/// in the reverse one), and splits or triangulates the rest where needed.
///
/// Errors: InputError for a face that crosses itself, and for a coordinate of 2^32 lattice steps or
/// more: the vertices of a quadtree of 10 levels, two further bits a level, would not be exact.
ConvexFaces make_convex(const PolygonSoup& soup, const Lattice& lattice, bool one_sided);

/// The faces of a mesh file (scene/read/polygon_soup.h) as convex polygons on a given lattice,
/// treated like those of a two-sided scene.
///
/// Errors: InputError as `read_polygon_soup` and `make_convex`, and for a file without a face that
/// has area.
std::vector<ConvexPolygon> load_convex_polygons(const std::filesystem::path& file,
                                                const Lattice& lattice);

}  // namespace viewcover
