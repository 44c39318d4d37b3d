#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace viewcover {

/// One claim of a bundle, recomputed.
struct BundleClaim {
  std::string claim;
  std::string contradiction;  ///< empty if the claim holds

  bool holds() const { return contradiction.empty(); }
};

/// Recomputes what a bundle claims from its own files: from `visibility.mtx` how often each element
/// is seen, what each set of `cover.csv` covers, that the last one covers all that can be seen;
/// that `cover.proof`, where there is one, proves the lower bound that `run.json` states; that each
/// viewpoint lies in its region and sees nothing that the region does not, that together they see
/// what they say, and the certificate of their lower bound (report/viewpoint_check.h); that the
/// files agree with each other. Shares with what made the bundle the reader of matrices and the
/// checker of proofs only, which makes nothing.
///
/// Errors: InputError for a folder that is no complete bundle, or files that cannot be read.
std::vector<BundleClaim> check_bundle(const std::filesystem::path& folder);

}  // namespace viewcover
