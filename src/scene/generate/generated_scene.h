#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/types.h"

namespace viewcover {

/// A scene made by rule, ready to be written as OBJ with its viewing region beside it.
struct GeneratedScene {
  struct Face {
    std::vector<std::uint32_t>
        corners;              ///< 0-based into `vertices`, counter-clockwise from the front
    std::uint32_t group = 0;  ///< into `groups`
  };
  std::string title;  ///< first comment line of the file: kind, options, seed
  std::vector<Point> vertices;
  std::vector<Face> faces;
  std::vector<std::string> groups;
  std::vector<std::vector<Point>> region;  ///< polygons of the viewing region
};

/// Writes FILE (OBJ, shortest decimals that read back exactly) and FILE with the suffix
/// `.region.json`. Same scene, same bytes. Errors: InputError where a file cannot be written.
void write_generated_scene(const GeneratedScene& scene, const std::filesystem::path& file);

/// `room.obj` -> `room.region.json`.
std::filesystem::path region_file_beside(const std::filesystem::path& file);

enum class RoomDetail { kSimple, kComplex };

/// A furnished living room in the manner of the paper's figures 6 and 8: exactly 316 (simple) or
/// 1228 (complex) convex planar polygons, z up, metres; the region is a horizontal rectangle at
/// eye height. Every group is one piece of furniture or one wall.
GeneratedScene living_room(RoomDetail detail);

/// Such rooms side by side, open doors between them: room-1/sofa, room-2/sofa, ..., a region in
/// each. What would stand or hang in the way is left out. Requires 1 to 40 rooms: within
/// 256 m all corners, multiples of 2^-15 m, are on a scene's lattice.
GeneratedScene row_of_rooms(std::size_t rooms, RoomDetail detail);

/// `triangles` random triangles in the unit cube, above and below a square region at half height.
/// Their size shrinks like the distance between neighbours, n^(-1/3): near by, all soups look
/// alike; a line across the cube meets about 0.3 n^(1/3) of them. Same seed, same bytes on every
/// platform.
GeneratedScene triangle_soup(std::size_t triangles, std::uint64_t seed);

/// A scene with an answer known in closed form, and the argument for it.
struct AnalyticScene {
  std::string name;
  std::string derivation;              ///< why the answer is what it is, one paragraph
  std::size_t regions = 0;             ///< viewing regions a part to solve with (power of 4)
  std::optional<double> element_area;  ///< to solve with; default if not set
  std::optional<std::size_t>
      optimal_regions;                     ///< fewest viewing regions that see all that is visible
  std::vector<std::string> hidden_groups;  ///< groups that no region sees any part of
  std::vector<std::string>
      visible_groups;  ///< groups of which every element is seen by some region
  GeneratedScene scene;
};

/// All of them, in the order `generate analytic --list` prints.
std::vector<AnalyticScene> analytic_scenes();

}  // namespace viewcover
