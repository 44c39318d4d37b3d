#pragma once

#include "scene/generate/solids.h"

namespace viewcover {

/// Pieces of furniture in their own frame: x to the right, y from the front (which looks at -y) to
/// the back, z up, metres, the floor at z = 0. Each adds its faces to the current group. Solids
/// are closed and may touch each other; no two faces cross.

/// How much is modelled.
enum class Finish { kPlain, kFine };

/// Sofa, or armchair with one seat, centred on the origin. Plain: base, back, two arms, 24 faces.
/// Fine: also a cushion a seat, and two pillows (armchair: one) leaning on the back, 6 faces each.
void add_sofa(SceneBuilder& scene, const Placement& at, double width, int seats, Finish finish);

/// Rectangular top centred on the origin, on four square legs: 30 faces.
void add_table(SceneBuilder& scene, const Placement& at, const Point& size);

/// Seat centred on the origin. Plain: two side panels and a closed back, 24 faces.
/// Fine: four legs, two posts and three slats for the back, 60 faces.
void add_chair(SceneBuilder& scene, const Placement& at, Finish finish);

/// Floor lamp on a square foot: foot 6, pole 6, open shade 6 (plain) or 8 (fine) faces.
void add_floor_lamp(SceneBuilder& scene, const Placement& at, Finish finish);
/// Lamp on a cord from a ceiling at height `ceiling`: cord 6, open shade 8 faces.
void add_pendant_lamp(SceneBuilder& scene, const Placement& at, double ceiling);
/// Table lamp: foot 10, pole 6, open shade 8 faces.
void add_table_lamp(SceneBuilder& scene, const Placement& at);

/// Pot (hexagon, closed, 8 faces) with `leaves` triangles, at most 8, round the stem; `second_row`
/// adds as many smaller ones above.
void add_plant(SceneBuilder& scene, const Placement& at, int leaves, bool second_row);

/// Books on the floor of a compartment of inner width, depth and height `inner`, from the left:
/// 6 faces each. `first` varies their measures. REQUIRES: they fit (about 3.5 cm each).
void add_books(SceneBuilder& scene, const Placement& at, const Point& inner, int books, int first);

/// Picture on a wall behind (y = 0 is the wall): a plain board (6 faces) or a frame with the
/// picture set back (14 faces), lower left corner at the origin.
void add_picture(SceneBuilder& scene, const Placement& at, double width, double height,
                 Finish finish);

/// Hanging cloth in `folds` folds of two upright quadrilaterals, from the origin along x.
void add_curtain(SceneBuilder& scene, const Placement& at, double width, double low, double high,
                 int folds);
/// Tilted slats, 6 faces each, from height `low` up to `high`, along x.
void add_blinds(SceneBuilder& scene, const Placement& at, double width, double low, double high,
                int slats);
/// Upright ribs between two pipes, 6 faces each, from the origin along x.
void add_radiator(SceneBuilder& scene, const Placement& at, double width, int ribs);

/// Screen on a foot: 18 faces.
void add_television(SceneBuilder& scene, const Placement& at, double width);
/// A plate (10 faces) and a cup without lid (7 faces) beside it.
void add_place_setting(SceneBuilder& scene, const Placement& at);
/// Open bowl: 9 faces.
void add_bowl(SceneBuilder& scene, const Placement& at);

}  // namespace viewcover
