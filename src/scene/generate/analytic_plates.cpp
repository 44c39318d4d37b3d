#include <utility>

#include "scene/generate/analytic_parts.h"

namespace viewcover {

namespace {

constexpr Rectangle kUnitSquare{-0.5, 0.5, -0.5, 0.5};
constexpr double kBase = -0.5;  // height of the base below the region
constexpr double kPlate = 1;    // of what may hide the target
constexpr double kTarget = 2;

// The region is the unit square at height 0. A base below it, which nothing hides, keeps the
// region within the bounds of the scene.
SceneBuilder over_a_base(const std::string& name) {
  SceneBuilder scene("viewcover analytic " + name);
  add_region_part(scene, kUnitSquare, 0);
  scene.begin_group("base");
  add_facing_up(scene, kUnitSquare, kBase);
  return scene;
}

AnalyticScene parallel_plates() {
  SceneBuilder scene = over_a_base("parallel-plates");
  const Rectangle square{-1, 1, -1, 1};
  scene.begin_group("plate");
  add_facing_down(scene, square, kPlate);
  scene.begin_group("target");
  add_facing_down(scene, square, kTarget);
  scene.begin_group("beyond");
  add_facing_down(scene, {3, 4, -1, 1}, kTarget);
  add_facing_down(scene, {-4, -3, -1, 1}, kTarget);
  add_facing_down(scene, {-1, 1, 3, 4}, kTarget);
  add_facing_down(scene, {-1, 1, -4, -3}, kTarget);

  AnalyticScene answer;
  answer.name = "parallel-plates";
  answer.derivation =
      "The region is the square |x|, |y| <= 1/2 at z = 0, the plate |x|, |y| <= 1 at z = 1, the "
      "target the same square at z = 2. A sight line crosses z = 1 half way: |x| <= (1/2 + 1) / 2 "
      "= 3/4, within the plate by 1/4, so the target is hidden. A line to a part beyond, at "
      "x >= 3, crosses at x >= (3 - 1/2) / 2 = 5/4, clear of the plate by 1/4, and so on the other "
      "sides: each region sees all that is visible, one suffices.";
  answer.regions = 16;
  answer.optimal_regions = 1;
  answer.hidden_groups = {"target"};
  answer.visible_groups = {"base", "plate", "beyond"};
  answer.scene = std::move(scene).finish();
  return answer;
}

AnalyticScene parallel_plates_exact() {
  SceneBuilder scene = over_a_base("parallel-plates-exact");
  scene.begin_group("plate");
  add_facing_down(scene, kUnitSquare, kPlate);
  scene.begin_group("target");
  add_facing_down(scene, kUnitSquare, kTarget);

  AnalyticScene answer;
  answer.name = "parallel-plates-exact";
  answer.derivation =
      "Region, plate and target are one unit square at z = 0, 1, 2. The point half way between "
      "two points of the square lies in the square, so every sight line to the target meets the "
      "plate and the target is hidden; lines between equal corners only touch the plate. Nothing "
      "hides plate and base, so one region suffices.";
  answer.regions = 16;
  answer.optimal_regions = 1;
  answer.hidden_groups = {"target"};
  answer.visible_groups = {"base", "plate"};
  answer.scene = std::move(scene).finish();
  return answer;
}

// Two half walls at z = 1 that leave |x| < half_width free.
GeneratedScene walls_with_slit(const std::string& name, double half_width) {
  SceneBuilder scene = over_a_base(name);
  scene.begin_group("walls");
  add_facing_down(scene, {-1, -half_width, -1, 1}, kPlate);
  add_facing_down(scene, {half_width, 1, -1, 1}, kPlate);
  scene.begin_group("target");
  add_facing_down(scene, kUnitSquare, kTarget);
  return std::move(scene).finish();
}

AnalyticScene slit() {
  AnalyticScene answer;
  answer.name = "slit";
  answer.derivation =
      "Region and target are one unit square at z = 0 and 2; half walls at z = 1 leave a slit "
      "|x| < 1/8. A line from x = a to x = b passes iff |a + b| < 1/4; in y nothing stops it. 16 "
      "regions and elements of area 1/16 are columns 1 to 4 of width 1/4 from x = -1/2. Region "
      "column c and element column e have sums a + b in an interval of width 1/2 about "
      "(c + e - 5) / 4, which meets |a + b| < 1/4 iff |c + e - 5| <= 1. Column 1 sees 3, 4; "
      "column 2 sees 2, 3, 4; column 3 sees 1, 2, 3; column 4 sees 1, 2. No region sees all four "
      "columns, two do (2 and 3): two regions. At least half of the lines between a pair that sees "
      "each other pass. Walls and base are open to all regions.";
  answer.regions = 16;
  answer.element_area = 1.0 / 16;
  answer.optimal_regions = 2;
  answer.visible_groups = {"base", "walls", "target"};
  answer.scene = walls_with_slit(answer.name, 0.125);
  return answer;
}

AnalyticScene slit_closed() {
  AnalyticScene answer;
  answer.name = "slit-closed";
  answer.derivation =
      "As `slit` with a slit of width 0: the half walls meet at x = 0 and lines through the seam "
      "lie in one plane, so the target is hidden. Walls and base are open to all regions: one "
      "suffices.";
  answer.regions = 16;
  answer.element_area = 1.0 / 16;
  answer.optimal_regions = 1;
  answer.hidden_groups = {"target"};
  answer.visible_groups = {"base", "walls"};
  answer.scene = walls_with_slit(answer.name, 0);
  return answer;
}

}  // namespace

std::vector<AnalyticScene> analytic_plates() {
  return {parallel_plates(), parallel_plates_exact(), slit(), slit_closed()};
}

}  // namespace viewcover
