#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "links/bit_rows.h"
#include "report/bundle_scene.h"
#include "report/run_record.h"

namespace viewcover {

/// A line of cover.csv: the best set of k regions.
struct CoverRow {
  std::vector<std::size_t> regions;  ///< numbers from 0
  double covered_percent = 0, upper_bound_percent = 0;
  double seconds = 0;
  std::size_t evaluations = 0;
};

/// A line of viewpoints.csv.
struct ViewpointRow {
  Point position = Point::Zero();
  std::size_t region = 0;  ///< number from 0
  double covered_percent = 0, seconds = 0;
};

/// A finished run as pictures and comparisons need it, read from its bundle. All numbers count from
/// 0.
struct RunData {
  Json record;                ///< run.json
  BundleScene bundle;         ///< the scene and its elements
  std::vector<double> areas;  ///< of the elements, scene units squared
  std::vector<RegionShape> regions;
  std::vector<RegionAddress> region_addresses;  ///< ascending
  /// The region that each face of boxes is of, by its part.
  std::map<PartId, std::size_t> face_regions;
  BitRows seen;  ///< #regions x #elements
  std::vector<CoverRow> covers;
  std::vector<ViewpointRow> viewpoints;
  BitRows seen_from_viewpoints;  ///< #viewpoints x #elements

  /// The regions as pictures have them: boxes by a section (RegionShape::picture).
  std::vector<ConvexPolygon> region_pictures() const;
  /// The regions of the last set; none if there is no set.
  std::vector<std::size_t> chosen() const {
    return covers.empty() ? std::vector<std::size_t>() : covers.back().regions;
  }
};

/// Reads the bundle in `folder`; `scene_file` stands in where the scene has moved.
///
/// Errors: InputError as load_bundle_scene, and for files that do not agree in their numbers of
/// regions, elements and viewpoints.
RunData load_run_data(const std::filesystem::path& folder,
                      const std::filesystem::path& scene_file = {});

/// How many of the rows have each column.
std::vector<std::uint32_t> column_counts(const BitRows& bits, std::span<const std::size_t> rows);
std::vector<std::uint32_t> column_counts(const BitRows& bits);

}  // namespace viewcover
