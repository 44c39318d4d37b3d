#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/address.h"
#include "scene/cluster_tree.h"
#include "scene/convex_polygon.h"
#include "scene/scene.h"

namespace viewcover {

/// A part of an element and how many viewpoints see all of it.
struct ImagedPiece {
  ConvexPolygon
      polygon;  ///< corners off by up to 3 units in the last place; corners within edges occur
  std::uint32_t images = 0;
};

/// How much of an element the images of an audit show.
struct ElementAudit {
  enum class Seen { kNot, kInPart, kWholly };

  double area = 0;                     ///< scene units squared
  double imaged_area = 0;              ///< seen by at least one viewpoint
  std::string imaged_share = "0";      ///< exact share of the area seen, such as "1" or "3/8"
  std::vector<double> area_by_images;  ///< [k]: seen by exactly k viewpoints; the last one is > 0
  Seen seen = Seen::kNot;              ///< exact: wholly iff the share is 1, not iff it is 0
  std::vector<ImagedPiece> pieces;     ///< disjoint, convex; they tile the element

  /// Greatest number of viewpoints that see one part of positive area; exact.
  std::uint32_t images_max() const { return static_cast<std::uint32_t>(area_by_images.size() - 1); }
  /// By area.
  double images_mean() const;
};

/// What a set of viewpoints shows of a scene.
struct Audit {
  std::size_t viewpoints = 0;
  std::vector<ElementAudit> elements;  ///< in the order of the addresses
};

struct AuditOptions {
  bool one_sided = false;                    ///< only the front of a surface is seen
  const std::atomic<bool>* stop = nullptr;   ///< when set, the audit ends with `Interrupted`
  std::atomic<std::size_t>* done = nullptr;  ///< counts elements, for those who watch
};

/// Finds the exactly imaged part of every element (papers/audit.md): all points whose open segment
/// to some viewpoint meets no surface. A surface whose plane holds a viewpoint is not seen from it
/// and hides nothing from it. Coordinates of scene and viewpoints are taken as exact numbers.
///
/// Elements: ascending, none within another, such as those of a VisibilityMatrix.
///
/// Properties, checked by tests/audit:
///  (1) areas, shares and numbers of images do not depend on the order of the viewpoints, and
///      nothing depends on the number of threads
///  (2) a further viewpoint never makes an imaged area smaller
///  (3) the pieces of an element are disjoint and tile it, exactly before rounding
/// The pieces do depend on the order of the viewpoints.
///
/// Cost: about 17 ms a viewpoint for a room of 316 polygons on one thread, and more the more
/// shadows cross (bench/audit.txt). Uses all threads of the current TBB arena. Errors: Interrupted.
Audit audit_images(const Scene& scene, const ClusterTree& clusters,
                   std::span<const ElementAddress> elements, std::span<const Point> viewpoints,
                   const AuditOptions& options = {});

}  // namespace viewcover
