#pragma once

#include <string>

#include "report/run_record.h"

namespace viewcover {

/// What `solve` prints for people: the columns of the paper's table 1 for this run, of its table 2
/// for each number of regions and of its table 3 for each viewpoint, and how many viewpoints there
/// are at least.
std::string solve_tables(const Solution& solution, Guarantee guarantee, const RunSeconds& seconds);

}  // namespace viewcover
