#pragma once

#include <vector>

#include "viewpoints/region_views.h"

namespace viewcover {

/// What a set of viewpoints shows that was found to image all but a share.
struct FullCoverage {
  std::vector<ElementTarget> witnesses;  ///< columns of the bound; the viewpoints see all of them
  /// Area imaged by the first i + 1 viewpoints, of the elements that some region sees, percent.
  std::vector<double> imaged_percent;
  bool bound_is_of_witnesses = false;  ///< or of elements, as without full coverage
  double missed_share = 0;             ///< as asked for
  /// The most area that a further position was found to add, of the area imaged, percent.
  double further_gain_percent = 0;
  std::size_t further_positions = 0;  ///< looked from for that
};

}  // namespace viewcover
