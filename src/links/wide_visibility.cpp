#include "links/wide_visibility.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "scene/polygon_contact.h"

namespace viewcover {
namespace {

/// A region cannot be split by what blocks its views: cameras are on both sides.
bool is_entered(const NarrowGap& gap, const ViewingRegion& region) {
  const Box around = bounding_box(gap.patch);
  const auto cuts = [&](const ConvexPolygon& part) {
    return bounding_box(part).intersects(around) && cut_each_other(part, gap.patch);
  };
  return std::ranges::any_of(region.parts, cuts) ||
         std::ranges::any_of(region.boxes,
                             [&](const Box& box) { return enters_box(gap.patch, box); });
}

/// The columns [first, second) of the elements in `node`, or the one that `node` is a part of.
std::pair<std::size_t, std::size_t> columns_of(ElementAddress node,
                                               const std::vector<ElementAddress>& elements) {
  const auto begin = std::ranges::lower_bound(elements, node);
  const auto end = std::find_if_not(begin, elements.end(),
                                    [&](ElementAddress element) { return node.contains(element); });
  const auto first = static_cast<std::size_t>(begin - elements.begin()),
             last = static_cast<std::size_t>(end - elements.begin());
  if (first == last && first > 0 && elements[first - 1].contains(node)) return {first - 1, first};
  return {first, last};
}

}  // namespace

WideVisibility find_wide_visibility(const Scene& scene, const ViewingRegion& region,
                                    const VisibilityMatrix& matrix,
                                    const VisibilityBackend& backend, const RefineOptions& options,
                                    double width, RefineProgress* progress) {
  WideVisibility wide{.width = width, .gaps = find_narrow_gaps(scene, width), .bits = matrix.bits};
  wide.gaps_entered =
      std::erase_if(wide.gaps, [&](const NarrowGap& gap) { return is_entered(gap, region); });
  if (wide.gaps.empty()) return wide;
  const Scene closed = with_gaps_closed(scene, wide.gaps);
  const LinkSet links = refine(closed, ClusterTree(closed), region, backend, options, progress);
  BitRows seen(matrix.bits.rows(), matrix.bits.columns());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link link = links[i];
    const auto [first, last] = columns_of(link.element, matrix.elements);
    const std::size_t first_row = region.first_index(link.region);
    for (std::size_t k = 0; k < region.index_count(link.region); ++k) {
      seen.set_range(first_row + k, first, last - first);
    }
  }
  for (std::size_t row = 0; row < seen.rows(); ++row) {
    std::ranges::transform(wide.bits.row(row), seen.row(row), wide.bits.row(row).begin(),
                           std::bit_and<>());
  }
  return wide;
}

bool is_narrow(const Link& link, const ViewingRegion& region, const VisibilityMatrix& matrix,
               const WideVisibility& wide) {
  const auto [first, last] = columns_of(link.element, matrix.elements);
  const std::size_t first_row = region.first_index(link.region);
  for (std::size_t k = 0; k < region.index_count(link.region); ++k) {
    for (std::size_t column = first; column < last; ++column) {
      if (wide.bits.test(first_row + k, column)) return false;
    }
  }
  return true;
}

}  // namespace viewcover
