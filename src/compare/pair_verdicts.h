#pragma once

#include <filesystem>
#include <vector>

#include "links/verdict.h"
#include "report/run_data.h"

namespace viewcover {

/// How a run knows that a region sees an element, for each pair that it has. A box may have several
/// links to an element, from its faces: the strongest counts.
class PairVerdicts {
 public:
  /// Reads links.csv in the folder of a run: a link says it of all regions and elements below its
  /// two nodes, one of a face of boxes of these boxes.
  ///
  /// Cost: O(file) time, a byte for each pair.
  /// Errors: InputError with file and line for a link that cannot be read or names a verdict of
  /// nothing visible, and for a pair of visibility.mtx without a link.
  PairVerdicts(const std::filesystem::path& folder, const RunData& run);

  /// Requires that the region sees the element.
  Verdict operator()(std::size_t region, std::size_t element) const {
    return static_cast<Verdict>(verdicts_[region * elements_ + element]);
  }

 private:
  std::size_t elements_;
  std::vector<std::uint8_t> verdicts_;
};

}  // namespace viewcover
