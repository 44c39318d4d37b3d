#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "links/bit_rows.h"
#include "report/bundle_check.h"

namespace viewcover {

/// Recomputes what a bundle claims about viewpoints:
///  - each lies in the polygon or box that regions.csv has for its region, taken exactly;
///  - each row of viewpoints.mtx is a part of the region's row in visibility.mtx;
///  - together they see all that any region sees, but for as many elements as run.json admits, and
///    the percents of viewpoints.csv are theirs;
///  - the lower bound is none above their number, and where it exceeds that of the region cover:
///    the cells of bound.csv tile the regions, no cell sees more than its region by bound.mtx, and
///    bound.proof proves the bound for that matrix.
/// That a viewpoint sees an element is asked again by report/sight_check.h, that a cell sees none
/// is not.
///
/// `results`: of run.json. `visibility`: visibility.mtx. `areas`: of the elements.
/// Errors: InputError for files that cannot be read.
std::vector<BundleClaim> check_viewpoints(const std::filesystem::path& folder,
                                          const nlohmann::ordered_json& results,
                                          const BitRows& visibility, std::span<const double> areas);

}  // namespace viewcover
