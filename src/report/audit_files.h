#pragma once

#include <filesystem>
#include <span>

#include "audit/audit.h"
#include "report/run_record.h"

namespace viewcover {

/// The file of a bundle with its viewpoints.
inline constexpr std::string_view kViewpointsFile = "viewpoints.csv";

/// What is audited. Borrowed.
struct AuditTask {
  const Scene& scene;
  const ClusterTree& clusters;
  std::span<const ElementAddress> elements;
  std::span<const std::uint32_t> times_visible;  ///< regions that see each element
  std::span<const Point> viewpoints;
  bool one_sided = false;
  std::string_view source = kViewpointsFile;  ///< where the viewpoints come from, for audit.json
};

/// Sums over the elements of an audit; areas in scene units squared.
struct AuditSummary {
  std::size_t viewpoints = 0, elements = 0;
  std::size_t seen_wholly = 0, seen_in_part = 0, not_seen = 0;  ///< elements
  double area = 0;                                              ///< of all elements
  double coverable_area = 0;     ///< of the elements that some region sees
  double imaged_area = 0;        ///< of what some viewpoint sees
  double imaged_percent = 100;   ///< of the coverable elements' area
  double missed_area = 0;        ///< of what no viewpoint sees of the coverable elements
  double area_seen_in_part = 0;  ///< of the elements seen in part
};

AuditSummary summary_of(const AuditTask& task, const Audit& audit);
Json to_json(const AuditSummary& summary);

/// Removes what write_audit() left of an earlier run.
void remove_audit(const std::filesystem::path& folder);

/// Audits (audit/audit.h) and writes, in `folder`:
///  - `audit.csv`: `element,surface,area,imaged_area,imaged_percent,images_max,images_mean,seen,
///    imaged_share`; seen is `wholly`, `in_part` or `not`, the share an exact fraction
///  - `audit.vtp`: the disjoint pieces of the elements for ParaView, with `images` (how many
///    viewpoints see the piece), `element` and `surface`
///  - `audit.json`: `source` and `positions` of the viewpoints, and the summary as `audit`
/// The same task, the same bytes, for any number of threads. Errors: Interrupted, before anything
/// is written; InputError where a file cannot be written.
AuditSummary write_audit(const AuditTask& task, const std::filesystem::path& folder,
                         const AuditOptions& options = {});

}  // namespace viewcover
