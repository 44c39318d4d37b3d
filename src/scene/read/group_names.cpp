#include "scene/read/group_names.h"

namespace viewcover {

GroupId GroupNames::id(std::string_view name) {
  const auto found = ids_.find(name);
  if (found != ids_.end()) return found->second;
  const GroupId id(names_.size());
  names_.emplace_back(name);
  ids_.emplace(name, id);
  return id;
}

std::string group_name(const std::string& object, const std::string& part) {
  if (object.empty() || object == part) return part;
  return part.empty() ? object : object + "/" + part;
}

}  // namespace viewcover
