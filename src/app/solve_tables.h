#pragma once

#include <string>

#include "report/run_record.h"

namespace viewcover {

/// What `solve` prints for people: the columns of the paper's table 1 for this run and of its
/// table 2 for each number of regions.
std::string solve_tables(const Solution& solution, const RunSeconds& seconds);

}  // namespace viewcover
