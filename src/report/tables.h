#pragma once

#include <filesystem>

#include "report/solution.h"

namespace viewcover {

// The tables of a bundle. Numbers of regions, elements, parts and surfaces are 1-based: a region's
// and an element's number is its row in regions.csv and elements.csv, and its row and column in
// visibility.mtx. A node is named by its polygon, its quadtree level and its path: the base-4
// digits from the root read as one decimal number in [0, 4^level). Coordinates and areas are in
// scene units, as the shortest decimals that read back as the same doubles.
//
// Errors: InputError where a file cannot be written.

/// `region,part,level,path,cx,cy,cz,area,chosen,x0,y0,z0,...`: centre of mass, 1 for chosen regions
/// and as many corners as the polygon with most has; missing ones are empty.
void write_regions(const Solution& solution, const std::filesystem::path& file);

/// `element,surface,group,level,path,cx,cy,cz,area,times_visible,x0,y0,z0,...`
void write_elements(const Solution& solution, const std::filesystem::path& file);

/// `region,element,kind,occluders`: both nodes as `polygon:level:path`, since a link may join inner
/// nodes; the occluders are surface numbers, ascending, separated by spaces.
void write_links(const Solution& solution, const std::filesystem::path& file);

/// Matrix Market, coordinate pattern general, row by row.
void write_visibility(const VisibilityMatrix& matrix, const std::filesystem::path& file);

/// `k,covered_area_percent,upper_bound_percent,seconds,evaluations,regions`: regions are numbers
/// separated by spaces.
void write_cover(const RegionCover& cover, const std::filesystem::path& file);

/// What `verify` and scripts/check-cover-proof check against `visibility.mtx`. Where the method
/// gave no proof there is no file, nor one of an earlier run.
void write_proof(const Solution& solution, const std::filesystem::path& file);

/// `viewpoint,x,y,z,region,covered_area_percent,seconds`.
void write_viewpoints(const std::filesystem::path& file);

}  // namespace viewcover
