#include "links/visibility_matrix.h"

#include <algorithm>

namespace viewcover {
namespace {

/// Appends the leaves below `node` of the coarsest quadtree in which each of `wanted` (ascending,
/// all below `node`) is a node.
void append_leaves(ElementAddress node, const ConvexPolygon& polygon,
                   std::span<const ElementAddress> wanted, VisibilityMatrix& matrix) {
  if (wanted.empty() || (wanted.size() == 1 && wanted[0] == node)) {
    matrix.elements.push_back(node);
    matrix.areas.push_back(area(polygon));
    return;
  }
  const auto children = quarters(polygon);
  for (int digit = 0; digit < 4; ++digit) {
    const ElementAddress child = node.child(digit);
    const auto begin = std::lower_bound(wanted.begin(), wanted.end(), child);
    const auto end = std::find_if_not(
        begin, wanted.end(), [&](ElementAddress address) { return child.contains(address); });
    append_leaves(child, children[static_cast<std::size_t>(digit)], {begin, end}, matrix);
  }
}

void make_elements(const Scene& scene, const LinkSet& links, VisibilityMatrix& matrix) {
  std::vector<ElementAddress> linked(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) linked[i] = links[i].element;
  std::sort(linked.begin(), linked.end());
  linked.erase(std::unique(linked.begin(), linked.end()), linked.end());

  auto begin = linked.begin();
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const auto end = std::find_if(
        begin, linked.end(), [&](ElementAddress address) { return address.owner().value != s; });
    append_leaves(ElementAddress(SurfaceId(s)), scene.surfaces[s].polygon, {begin, end}, matrix);
    begin = end;
  }
}

}  // namespace

VisibilityMatrix make_visibility_matrix(const Scene& scene, const ViewingRegion& region,
                                        const LinkSet& links) {
  VisibilityMatrix matrix;
  make_elements(scene, links, matrix);
  matrix.bits = BitRows(region.region_count(), matrix.elements.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link link = links[i];
    const auto begin =
        std::lower_bound(matrix.elements.begin(), matrix.elements.end(), link.element);
    const auto end = std::find_if_not(begin, matrix.elements.end(), [&](ElementAddress address) {
      return link.element.contains(address);
    });
    const std::size_t first_row = region.first_index(link.region);
    for (std::size_t k = 0; k < region.index_count(link.region); ++k) {
      matrix.bits.set_range(first_row + k,
                            static_cast<std::size_t>(begin - matrix.elements.begin()),
                            static_cast<std::size_t>(end - begin));
    }
  }
  return matrix;
}

}  // namespace viewcover
