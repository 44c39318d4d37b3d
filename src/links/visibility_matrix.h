#pragma once

#include <vector>

#include "links/bit_rows.h"
#include "links/link_set.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover {

/// Which finest region sees which element (paper, section 2.3): one bit row a region over all
/// elements. A bit is set iff a link joins the region or an ancestor of it to the element or an
/// ancestor of it. A box has the links of all its faces.
///
/// The elements are the leaves of the quadtrees that the links made: the coarsest subdivision of
/// each surface in which every link's element is a node. They tile every surface.
struct VisibilityMatrix {
  std::vector<ElementAddress> elements;  ///< columns, ascending
  std::vector<double> areas;             ///< of the elements, scene units squared
  BitRows bits;                          ///< rows: regions in the order of ViewingRegion::address

  /// How many regions see each element.
  std::vector<std::uint32_t> times_visible() const { return count_in_columns(bits); }
};

/// Cost: O(links x subtree) + O(regions x elements / 64).
VisibilityMatrix make_visibility_matrix(const Scene& scene, const ViewingRegion& region,
                                        const LinkSet& links);

}  // namespace viewcover
