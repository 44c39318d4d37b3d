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
/// and as many corners as the polygon with most has; missing ones are empty. Parts are the polygons
/// of the region, then the faces of boxes, which are no regions, then the boxes. A box has the area
/// of its six faces and eight corners, number k with the greater x, y and z where bits 0, 1 and 2
/// of k are set. Where there are boxes, a last column has their `volume`, empty for polygons.
void write_regions(const Solution& solution, const std::filesystem::path& file);

/// `part,region,x0,y0,z0,...,z3`: the faces of boxes, by which links name them, with the region
/// each is a face of; its front is to that region. No file without boxes, nor one of an earlier
/// run.
void write_faces(const Solution& solution, const std::filesystem::path& file);

/// `element,surface,group,level,path,cx,cy,cz,area,times_visible,x0,y0,z0,...`; with an aperture
/// `times_visible_wide` after `times_visible`: the regions that see it with the gaps closed, too.
void write_elements(const Solution& solution, const std::filesystem::path& file);

/// `region,element,kind,occluders`: both nodes as `polygon:level:path`, since a link may join inner
/// nodes; the occluders are surface numbers, ascending, separated by spaces. With an
/// aperture a last column `narrow`: 1 where no region and element that the link joins see each
/// other with the gaps closed, too.
void write_links(const Solution& solution, const std::filesystem::path& file);

/// Matrix Market, coordinate pattern general, row by row.
void write_visibility(const VisibilityMatrix& matrix, const std::filesystem::path& file);

/// `k,covered_area_percent,upper_bound_percent,seconds,evaluations,regions`: regions are numbers
/// separated by spaces.
void write_cover(const RegionCover& cover, const std::filesystem::path& file);

/// What `verify` and scripts/check-cover-proof check against `visibility.mtx`. Where the method
/// gave no proof there is no file, nor one of an earlier run.
void write_proof(const Solution& solution, const std::filesystem::path& file);

/// What an aperture adds: `gaps.csv`, `gap,surface,other,width,x0,y0,z0,...,z2`, the patches that
/// close the gaps; `visibility-wide.mtx`, what is seen with them, rows and columns as in
/// visibility.mtx; `cover-wide.csv` and `cover-wide.proof`, the cover for that. No files, nor those
/// of an earlier run, without one.
void write_wide(const Solution& solution, const std::filesystem::path& folder);

/// `viewpoint,x,y,z,region,covered_area_percent,seconds`: in the order in which they add most area,
/// with the share of the visible area that is seen so far, and when in the search the viewpoint was
/// first looked from. No lines where none were looked for.
void write_viewpoints(const Solution& solution, const std::filesystem::path& file);

/// What each viewpoint sees, as write_visibility: rows are viewpoints. No file where none were
/// looked for, nor one of an earlier run.
void write_viewpoint_visibility(const Solution& solution, const std::filesystem::path& file);

/// `witness,element,x,y,z`: places that viewpoints of full coverage see, beyond a part of each
/// element (full_coverage/witnesses.h). No file where that was not asked for.
void write_witnesses(const Solution& solution, const std::filesystem::path& file);

/// The certificate of a lower bound that was raised above the region cover's
/// (viewpoints/refined_bound.h): `bound.csv`, `cell,region,part,level,path`; `bound.mtx`, its rows
/// the cells, its columns elements or, for full coverage, witnesses, those not needed empty;
/// `bound.proof`, as write_proof against that matrix. No files, nor those of an earlier run, where
/// it was not raised.
void write_refined_bound(const Solution& solution, const std::filesystem::path& folder);

}  // namespace viewcover
