#include "report/sight_check.h"

#include <fmt/format.h>

#include "audit/seen_elements.h"
#include "optim/cover_file.h"
#include "report/audit_files.h"
#include "report/bundle_scene.h"
#include "report/run_record.h"

namespace viewcover {
namespace {

/// The first pair that `inner` has and `outer` has not.
std::string first_beyond(const BitRows& inner, const BitRows& outer, const char* text) {
  for (std::size_t i = 0; i < inner.rows(); ++i) {
    for (std::size_t column = 0; column < inner.columns(); ++column) {
      if (inner.test(i, column) && !outer.test(i, column)) {
        return fmt::format(fmt::runtime(text), i + 1, column + 1);
      }
    }
  }
  return {};
}

}  // namespace

std::vector<BundleClaim> check_sights(const std::filesystem::path& folder,
                                      const std::filesystem::path& scene_file) {
  const Json record = read_complete_run(folder);
  if (!record.value("results", Json::object()).contains("viewpoints")) return {};
  const BundleScene bundle = load_bundle_scene(folder, scene_file);
  const std::vector<Point> viewpoints = read_positions(folder / kViewpointsFile);
  const BitRows claimed = read_cover_file(folder / "viewpoints.mtx", CoverFormat::kMatrixMarket);
  const std::string claim = "each viewpoint sees the elements that viewpoints.mtx says";
  if (claimed.rows() != viewpoints.size() || claimed.columns() != bundle.elements.size()) {
    return {{claim, "its size is another"}};
  }
  const ClusterTree clusters(bundle.scene);
  const BitRows seen =
      seen_elements(bundle.scene, clusters, bundle.elements, viewpoints, bundle.one_sided);
  std::vector<BundleClaim> claims = {
      {claim, first_beyond(claimed, seen, "viewpoint {} does not see element {}")}};
  if (record.value("options", Json::object()).value("backend", "") == "exact") {
    claims.push_back(
        {"each viewpoint sees no elements but those that viewpoints.mtx says",
         first_beyond(seen, claimed, "viewpoint {} sees element {}, which it does not say")});
  }
  return claims;
}

}  // namespace viewcover
