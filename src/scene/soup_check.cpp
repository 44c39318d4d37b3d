#include "scene/soup_check.h"

#include <algorithm>

namespace viewcover {

GroupId CheckedSoup::group(std::string_view name) {
  // The last group is asked for most: once a face.
  if (!groups.empty() && groups.back() == name) return GroupId(groups.size() - 1);
  const auto found = std::find(groups.begin(), groups.end(), name);
  if (found != groups.end()) return GroupId(static_cast<std::size_t>(found - groups.begin()));
  groups.emplace_back(name);
  return GroupId(groups.size() - 1);
}

}  // namespace viewcover
