#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "support/made_run.h"

namespace viewcover::testing {

using Random = std::mt19937_64;

inline void subdivide(ElementAddress node, Random& random, std::vector<ElementAddress>& leaves) {
  if (node.level() == 3 || random() % 3 == 0) {
    leaves.push_back(node);
    return;
  }
  for (int digit = 0; digit < 4; ++digit) subdivide(node.child(digit), random, leaves);
}

/// Two surfaces, cut at random; regions see elements at random.
inline RunData random_run(Random& random) {
  RunData run = made_run({level(0, 8, 0, 8, 0), upright(0, 8, 0, 8, 8)}, {"a"},
                         {level(1, 2, 1, 2, 3), level(2, 3, 1, 2, 3)}, {{}, {}});
  run.bundle.elements.clear();
  for (std::size_t surface = 0; surface < 2; ++surface) {
    subdivide({SurfaceId(surface), 0, 0}, random, run.bundle.elements);
  }
  run.areas.clear();
  for (const ElementAddress element : run.bundle.elements) {
    run.areas.push_back(std::ldexp(64, -2 * element.level()));
  }
  run.seen = BitRows(2, run.bundle.elements.size());
  for (std::size_t region = 0; region < 2; ++region) {
    for (std::size_t i = 0; i < run.bundle.elements.size(); ++i) {
      if (random() % 2 == 0) run.seen.set(region, i);
    }
  }
  return run;
}

}  // namespace viewcover::testing
