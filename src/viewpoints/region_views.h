#pragma once

#include <optional>
#include <span>
#include <vector>

#include "links/link_set.h"
#include "links/occluder_set.h"
#include "links/shaft.h"
#include "links/visibility_backend.h"
#include "links/visibility_matrix.h"
#include "scene/cluster_tree.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"
#include "viewpoints/cell_views.h"

namespace viewcover {

/// What viewpoints are looked for in and judged by. Borrowed.
struct ViewedScene {
  const Scene& scene;
  const ClusterTree& clusters;
  const ViewingRegion& region;
  const LinkSet& links;
  const VisibilityMatrix& matrix;
  const VisibilityBackend& backend;
  bool one_sided = false;  ///< as the links were made
};

/// A place on an element, by the element's column.
struct ElementTarget {
  std::size_t column = 0;
  Point place = Point::Zero();
};

/// What is seen from points of the finest regions (paper, figure 5), by the links of the region and
/// its ancestors: elements that a link sees fully need no decision but for the side of their plane;
/// for the others the occluders that the link stored are culled to the cone of the viewpoint, and
/// the backend decides where some are left.
///
/// For a box, the occluders of an element are all that may meet the hull of the two, not those of
/// the links of its faces: a point inside looks out through any of them.
///
/// An element counts as seen if a part of positive area is. From a viewpoint that touches no
/// surface and lies in the region, everything seen is seen by the region: the open cone of the
/// viewpoint lies in the region's shaft, and being free is an open condition, so points of the
/// region's interior near the viewpoint see the same places (papers/viewpoints.md). From inside a
/// box, the sight line leaves it through a face, which sees the same place (papers/volumes.md).
/// Immutable; concurrent calls are allowed.
class RegionViews : public CellViews {
 public:
  /// Cost: O(links + occluder lists + regions x elements / 64); of a box, shaft culling for each
  /// element it sees, in parallel.
  explicit RegionViews(const ViewedScene& viewed);

  std::size_t region_count() const { return viewed_.matrix.bits.rows(); }
  std::size_t column_count() const override { return viewed_.matrix.bits.columns(); }
  const VisibilityMatrix& matrix() const { return viewed_.matrix; }
  const ViewingRegion& region() const override { return viewed_.region; }
  const ViewedScene& viewed() const { return viewed_; }
  const OccluderSet& occluders() const { return occluders_; }

  /// Where viewpoints of a region may be. Positions below are of these.
  const RegionPositions& positions(std::size_t region) const override { return positions_[region]; }
  bool region_sees(std::size_t region, std::size_t column) const override {
    return viewed_.matrix.bits.test(region, column);
  }

  /// True if the position touches no surface. Exact.
  bool is_free(std::size_t region, const Point& position) const;

  /// Sets in `row` the bits of the columns that are seen from a free position of the region; with
  /// `wanted`, of those among them only. Words: as in a row of the matrix. `target`: a place of an
  /// element that is likely to be seen.
  /// Cost: bench/viewpoints.cpp; in proportion to the wanted elements that occluders are left for.
  void look(std::size_t region, const Point& position, std::span<BitRows::Word> row,
            std::span<const BitRows::Word> wanted = {},
            const std::optional<ElementTarget>& target = std::nullopt) const;

  /// Ends of a sight line from the region to an element that it sees; none where the backend finds
  /// none. Cost: a decision of the backend.
  std::optional<SightLine> find_sight_line(std::size_t region, std::size_t column) const;

  /// Does a part of a region see an element? Asks the backend, for a box from each face until one
  /// does, with the occluders that are stored for the region, so the answer of an exact one is a
  /// theorem.
  bool cell_sees(const RegionCell& cell, std::size_t column) const override;

  /// Does a part of the cell that has area, of a box volume, see a place on an element that the
  /// region sees? Requires a place whose difference to any corner is exact, in the plane of no
  /// polygon of the region. Conservative for one-sided elements whose plane cuts the cell.
  bool cell_sees_place(const RegionCell& cell, const ElementTarget& target) const;

  /// Is the position off the plane of an element and, if only fronts count, before it? Exact.
  bool is_facing(std::size_t column, const Point& position) const;

 private:
  /// Columns [first, first + count) of one surface, seen fully.
  struct FullColumns {
    std::uint32_t first, count;
  };
  /// A column, and the occluders stored for it.
  struct PartialColumn {
    std::uint32_t column, occluders_begin, occluders_end;
  };
  struct View {
    std::vector<FullColumns> full;
    std::vector<PartialColumn> partial;  ///< ascending
    std::vector<SurfaceId> touching;     ///< surfaces that may touch positions of the region
  };

  void add_link(std::size_t link);
  void add_boxes();
  /// The occluders of its columns, in the places that its view names.
  std::vector<OccluderId> add_box(std::size_t region);
  /// A polygon, or the faces of a box that look at some of the points: through it only, to their
  /// front (papers/volumes.md).
  std::vector<PlanarPolygon> faces_toward(std::span<const Point> points, RegionAddress address,
                                          const RegionShape& shape) const;
  bool face_sees(const RegionCell& cell, const PlanarPolygon& face, std::size_t column) const;
  bool face_sees_place(const RegionCell& cell, const PlanarPolygon& face,
                       const ElementTarget& target) const;
  bool sees(const PartialColumn& partial, const Point& position,
            const std::optional<ElementTarget>& target) const;
  /// The occluders stored with the link of region and column; none if it is seen fully.
  std::span<const OccluderId> stored_occluders(std::size_t region, std::size_t column) const;
  SmallList<ShaftOccluder, 96> shaft_occluders(std::size_t region, std::size_t column) const;

  ViewedScene viewed_;
  OccluderSet occluders_;
  std::vector<PlanarPolygon> elements_;
  std::vector<RegionPositions> positions_;
  std::vector<View> views_;
  std::vector<OccluderId> stored_;
  std::vector<ClusterNode> leaves_;  ///< of the cluster tree, by occluder
};

}  // namespace viewcover
