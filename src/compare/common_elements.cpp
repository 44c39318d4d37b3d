#include "compare/common_elements.h"

#include <algorithm>
#include <numeric>

#include "scene/error.h"

namespace viewcover {
namespace {

void require_alike(const RunData& first, const RunData& second, std::string_view place) {
  const auto refuse = [&](std::string_view what) {
    throw InputError(place, "the runs have different " + std::string(what),
                     "give two runs of one scene and region");
  };
  const auto polygon = [](const Surface& surface) { return surface.polygon; };
  if (!std::ranges::equal(first.bundle.scene.surfaces, second.bundle.scene.surfaces, {}, polygon,
                          polygon)) {
    refuse("scenes");
  }
  if (first.regions != second.regions) refuse("regions");
}

/// The finer one of each pair of elements that overlap. Both lists tile the same surfaces in
/// ascending order, so of the elements at their heads one holds the other.
void refine_commonly(const std::vector<ElementAddress>& a, const std::vector<ElementAddress>& b,
                     CommonElements& common) {
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const bool a_is_finer = b[j].contains(a[i]);
    const ElementAddress finer = a_is_finer ? a[i] : b[j];
    common.addresses.push_back(finer);
    common.first.push_back(i);
    common.second.push_back(j);
    // An element is done once the next of the other list lies outside it.
    const std::size_t next_i = i + (a_is_finer ? 1 : 0), next_j = j + (a_is_finer ? 0 : 1);
    if (a_is_finer) {
      j += next_i == a.size() || !b[j].contains(a[next_i]);
      i = next_i;
    } else {
      i += next_j == b.size() || !a[i].contains(b[next_j]);
      j = next_j;
    }
  }
}

}  // namespace

CommonElements common_elements(const RunData& run) {
  CommonElements common;
  common.addresses = run.bundle.elements;
  common.first.resize(common.size());
  std::iota(common.first.begin(), common.first.end(), std::size_t{0});
  return common;
}

CommonElements common_elements(const RunData& first, const RunData& second,
                               std::string_view place) {
  require_alike(first, second, place);
  CommonElements common;
  refine_commonly(first.bundle.elements, second.bundle.elements, common);
  common.differences.resize(common.size());
  for (std::size_t region = 0; region < first.regions.size(); ++region) {
    for (std::size_t i = 0; i < common.size(); ++i) {
      const bool a = first.seen.test(region, common.first[i]),
                 b = second.seen.test(region, common.second[i]);
      common.differences[i].missed += a && !b;
      common.differences[i].excess += b && !a;
    }
  }
  return common;
}

}  // namespace viewcover
