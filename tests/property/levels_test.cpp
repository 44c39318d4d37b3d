// What is decided at one subdivision level follows from what is decided at the next, exactly.
//
// VIEWCOVER_TEST_ALL=1: all levels of both rooms, two minutes on two cores.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "approx/ray_backend.h"
#include "exact/exact_backend.h"
#include "links/refine.h"
#include "links/visibility_matrix.h"
#include "support/generated.h"

namespace viewcover {
namespace {

bool runs_everything() { return std::getenv("VIEWCOVER_TEST_ALL") != nullptr; }

/// A bit of a matrix tells whether a region sees a leaf. Leaves are either cells, the first nodes
/// of a quadtree that are no larger than `element_area`, or larger. A larger one is nowhere linked
/// in part: a region sees all cells below it, or none. So a matrix tells of every region and cell
/// whether they see each other.
struct Level {
  std::size_t regions;
  double element_area;
  VisibilityMatrix matrix;

  bool is_uniform(std::size_t leaf) const { return matrix.areas[leaf] > element_area; }
};

/// Leaves of two matrices that overlap: one contains the other. Calls visit(a, b) for the numbers
/// of all such pairs, ascending.
template <class Visit>
void for_overlaps(const VisibilityMatrix& first, const VisibilityMatrix& second,
                  const Visit& visit) {
  std::size_t a = 0, b = 0;
  while (a < first.elements.size() && b < second.elements.size()) {
    visit(a, b);
    const ElementAddress x = first.elements[a], y = second.elements[b];
    const bool x_is_done = y.contains(x), y_is_done = x.contains(y);
    ASSERT_TRUE(x_is_done || y_is_done);
    if (x_is_done) ++a;
    if (y_is_done) ++b;
    // The larger one is done with when the next one is outside.
    if (!x_is_done && !(b < second.elements.size() && x.contains(second.elements[b]))) ++a;
    if (!y_is_done && !(a < first.elements.size() && y.contains(first.elements[a]))) ++b;
  }
  EXPECT_EQ(a, first.elements.size());
  EXPECT_EQ(b, second.elements.size());
}

struct Checks {
  std::uint64_t checked = 0;
  std::uint64_t only_part_sees = 0;   ///< a part is seen, or sees, but not the whole
  std::uint64_t only_whole_sees = 0;  ///< the whole, but none of its parts
  std::uint64_t not_uniform = 0;  ///< a region sees a part of a leaf that it sees all or none of

  std::uint64_t violations() const { return only_part_sees + only_whole_sees + not_uniform; }
  void add(const Checks& other) {
    checked += other.checked;
    only_part_sees += other.only_part_sees;
    only_whole_sees += other.only_whole_sees;
    not_uniform += other.not_uniform;
  }
};

void PrintTo(const Checks& checks, std::ostream* out) {
  *out << checks.checked << " checks: " << checks.only_part_sees << " times only a part sees, "
       << checks.only_whole_sees << " times only the whole, " << checks.not_uniform
       << " times a leaf is not uniform";
}

std::ostream& operator<<(std::ostream& out, const Checks& checks) {
  PrintTo(checks, &out);
  return out;
}

/// The same elements, four times the regions: a region sees a cell iff one of its quarters does.
Checks compare_regions(const Level& coarse, const Level& fine) {
  Checks checks;
  for_overlaps(coarse.matrix, fine.matrix, [&](std::size_t a, std::size_t b) {
    for (std::size_t row = 0; row < coarse.matrix.bits.rows(); ++row) {
      const bool whole = coarse.matrix.bits.test(row, a);
      bool part = false;
      for (std::size_t digit = 0; digit < 4; ++digit) {
        part |= fine.matrix.bits.test(4 * row + digit, b);
      }
      ++checks.checked;
      checks.only_part_sees += part && !whole;
      checks.only_whole_sees += whole && !part;
    }
  });
  return checks;
}

/// The same regions, smaller cells: a cell is seen iff one of those below it is; of uniform leaves
/// all is seen or none.
Checks compare_elements(const Level& coarse, const Level& fine) {
  Checks checks;
  const std::size_t rows = coarse.matrix.bits.rows();
  std::vector<std::vector<std::size_t>> overlaps(coarse.matrix.elements.size());
  for_overlaps(coarse.matrix, fine.matrix,
               [&](std::size_t a, std::size_t b) { overlaps[a].push_back(b); });
  for (std::size_t a = 0; a < overlaps.size(); ++a) {
    for (std::size_t row = 0; row < rows; ++row) {
      const bool whole = coarse.matrix.bits.test(row, a);
      bool any = false, all = true;
      for (const std::size_t b : overlaps[a]) {
        const bool seen = fine.matrix.bits.test(row, b);
        any |= seen;
        all &= seen;
      }
      ++checks.checked;
      checks.only_part_sees += any && !whole;
      checks.only_whole_sees += whole && !any;
      checks.not_uniform += coarse.is_uniform(a) && any && !all;
    }
  }
  return checks;
}

enum class Backend { kExact, kRays };

/// The levels of a room, solved when first asked for.
class Room {
 public:
  Room(RoomDetail detail, Backend backend) : generated_(living_room(detail)) {
    if (backend == Backend::kExact) {
      backend_ = std::make_unique<ExactBackend>(1);
    } else {
      backend_ = std::make_unique<RayBackend>(RayOptions{.rays = 16, .seed = 1});
    }
  }

  const Level& level(std::size_t regions, double element_area) {
    const auto known = std::ranges::find_if(levels_, [&](const auto& level) {
      return level->regions == regions && level->element_area == element_area;
    });
    if (known != levels_.end()) return **known;
    const testing::LoadedScene loaded = testing::load_generated(generated_, regions);
    EXPECT_EQ(loaded.region.parts.size(), 1u);
    const ClusterTree clusters(loaded.scene);
    const auto begin = std::chrono::steady_clock::now();
    const LinkSet links =
        refine(loaded.scene, clusters, loaded.region, *backend_, {.element_area = element_area});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    levels_.push_back(std::make_unique<Level>(
        Level{regions, element_area, make_visibility_matrix(loaded.scene, loaded.region, links)}));
    const Level& made = *levels_.back();
    std::size_t larger = 0;
    for (std::size_t i = 0; i < made.matrix.elements.size(); ++i) larger += made.is_uniform(i);
    std::cout << "  " << backend_->name() << ", " << regions << " regions, element area "
              << element_area << ": " << links.size() << " links, " << made.matrix.elements.size()
              << " elements, " << larger << " of them larger, " << seconds.count() << " s"
              << std::endl;
    return made;
  }

 private:
  GeneratedScene generated_;
  std::unique_ptr<VisibilityBackend> backend_;
  std::vector<std::unique_ptr<Level>> levels_;
};

struct Grid {
  std::vector<std::size_t> regions;
  std::vector<double> areas;
};
const Grid kWholeGrid = {{16, 64, 256}, {0.4, 0.1, 0.025}};

/// Compares all neighbours in a grid of levels.
Checks compare_neighbours(Room& room, const Grid& grid) {
  Checks by_regions, by_elements;
  for (std::size_t r = 0; r < grid.regions.size(); ++r) {
    for (std::size_t a = 0; a < grid.areas.size(); ++a) {
      const Level& fine = room.level(grid.regions[r], grid.areas[a]);
      if (r > 0)
        by_regions.add(compare_regions(room.level(grid.regions[r - 1], grid.areas[a]), fine));
      if (a > 0)
        by_elements.add(compare_elements(room.level(grid.regions[r], grid.areas[a - 1]), fine));
    }
  }
  std::cout << "  regions: " << by_regions << "\n  elements: " << by_elements << std::endl;
  Checks all = by_regions;
  all.add(by_elements);
  return all;
}

void expect_consistent(RoomDetail detail, const Grid& grid) {
  Room room(detail, Backend::kExact);
  const Checks checks = compare_neighbours(room, runs_everything() ? kWholeGrid : grid);
  EXPECT_GT(checks.checked, 100'000u);
  EXPECT_EQ(checks.violations(), 0u);
}

TEST(Levels, OfTheSimpleRoomAgree) {
  expect_consistent(RoomDetail::kSimple, {{16, 64, 256}, {0.4, 0.1}});
}

TEST(Levels, OfTheComplexRoomAgree) {
  expect_consistent(RoomDetail::kComplex, {{16, 64}, {0.4, 0.1}});
}

/// Random rays miss narrow sights: the checks can fail.
TEST(Levels, OfRandomRaysDisagree) {
  Room room(RoomDetail::kSimple, Backend::kRays);
  const Checks checks = compare_neighbours(room, kWholeGrid);
  EXPECT_GT(checks.only_part_sees, 0u);
  EXPECT_GT(checks.only_whole_sees, 0u);
}

}  // namespace
}  // namespace viewcover
