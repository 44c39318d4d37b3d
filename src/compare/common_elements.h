#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "report/run_data.h"

namespace viewcover {

/// Where two runs over one scene and region differ about an element: numbers of regions.
struct Difference {
  std::uint32_t missed = 0;  ///< the first sees it, the second does not
  std::uint32_t excess = 0;  ///< the second sees it, the first does not
};

/// The pieces of surfaces to speak of: the elements of one run, or the common refinement of those
/// of two.
struct CommonElements {
  std::vector<ElementAddress> addresses;  ///< ascending, tile every surface
  std::vector<std::size_t> first;         ///< the element of the first run that each lies in
  std::vector<std::size_t> second;        ///< of the second run; empty if there is one only
  std::vector<Difference> differences;    ///< empty if there is one run only

  std::size_t size() const { return addresses.size(); }
};

CommonElements common_elements(const RunData& run);

/// Pairs of a region and an element that the runs differ about, by element.
/// Errors: InputError at `place` if the runs are not of the same scene, loaded alike, and
/// the same regions.
CommonElements common_elements(const RunData& first, const RunData& second, std::string_view place);

}  // namespace viewcover
