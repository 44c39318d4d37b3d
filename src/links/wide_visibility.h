#pragma once

#include <cstddef>
#include <vector>

#include "links/bit_rows.h"
#include "links/refine.h"
#include "links/visibility_matrix.h"
#include "scene/repair/narrow_gaps.h"

namespace viewcover {

/// What a run sees otherwise than through gaps narrower than some width.
struct WideVisibility {
  double width = 0;              ///< of gaps that are closed, scene units
  std::vector<NarrowGap> gaps;   ///< that were closed
  std::size_t gaps_entered = 0;  ///< more, which the region passes through: left open
  /// Which regions see which elements with the gaps closed, too: rows and columns as in the
  /// matrix, whose bits that are missing here are visible through narrow gaps only.
  BitRows bits;
};

/// Closes the gaps narrower than `width` and decides everything anew with `backend`. For an exact
/// backend the bits are theorems about the scene with its patches (scene/repair/narrow_gaps.h);
/// random rays also miss what is wide. `options` as for the matrix. Cost: as refine, unless there
/// is no gap. Errors: as find_narrow_gaps and refine.
WideVisibility find_wide_visibility(const Scene& scene, const ViewingRegion& region,
                                    const VisibilityMatrix& matrix,
                                    const VisibilityBackend& backend, const RefineOptions& options,
                                    double width, RefineProgress* progress = nullptr);

/// Is no region and element that the link joins visible otherwise? `matrix` as above.
bool is_narrow(const Link& link, const ViewingRegion& region, const VisibilityMatrix& matrix,
               const WideVisibility& wide);

}  // namespace viewcover
