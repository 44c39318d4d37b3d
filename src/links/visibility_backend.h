#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "links/verdict.h"
#include "scene/types.h"

namespace viewcover {

class PointShaft;
class Shaft;

/// The ends of an open segment that no occluder meets, inside region (or at the viewpoint) and
/// element but for rounding.
struct SightLine {
  Point from, to;
};

/// What a backend's verdicts are worth.
enum class Guarantee {
  kVisibleIsCertain,  ///< visible is true; hidden may be wrong
  kExact,             ///< every verdict is a theorem
};

/// Counts by name.
using BackendStatistics = std::vector<std::pair<std::string, std::uint64_t>>;

/// How hard a backend must try.
enum class Effort {
  kCheap,  ///< the shaft is subdivided unless it is hidden or fully visible: a backend may leave
           ///< it open and say kAssumedVisible
  kFull,   ///< at the subdivision limit: the verdict goes into the visibility matrix. Only surfaces
           ///< are left in the shaft, no unopened clusters
};

/// Decides whether any sight line is left between a region, or a viewpoint, and an element when
/// several occluders are in the shaft: the questions that refinement (paper, figure 4) and the
/// search for viewpoints (figure 5) ask.
///
/// Properties, checked by tests/conformance for every backend:
///  (1) decide(s) == decide(s) whatever the thread or the order of calls
///  (2) kHidden... from a backend whose guarantee() is kExact is a theorem
///  (3) a visible verdict is never given for a hidden pair; kAssumedVisible is none
///  (4) kAssumedVisible is never the answer to kFull
///  (5) sees_part(s) is never true where the viewpoint sees nothing, and if guarantee() is kExact,
///      never false where it sees something
/// Thread-safety: concurrent calls on one object are allowed.
class VisibilityBackend {
 public:
  virtual ~VisibilityBackend() = default;

  /// What result files store: "rays" or "exact".
  virtual std::string_view name() const = 0;
  virtual Guarantee guarantee() const = 0;

  /// Requires at least one occluder left in the shaft.
  virtual Verdict decide(const Shaft& shaft, Effort effort) const = 0;

  /// Does the viewpoint see a part of the element that has area? Requires a shaft that is facing.
  virtual bool sees_part(const PointShaft& shaft) const = 0;

  /// Ends of a sight line from the region to the element, as a place to look for viewpoints: known
  /// only up to rounding, so what is seen from there is a question of its own. None where none is
  /// found. Requires a shaft that is facing, with surfaces only left in it.
  virtual std::optional<SightLine> find_sight_line(const Shaft& shaft) const = 0;

  /// Counts that tell how decisions were reached, by name, since the backend was made; the same for
  /// any number of threads.
  virtual BackendStatistics statistics() const { return {}; }

 protected:
  VisibilityBackend() = default;
  VisibilityBackend(const VisibilityBackend&) = default;
  VisibilityBackend& operator=(const VisibilityBackend&) = default;
};

}  // namespace viewcover
