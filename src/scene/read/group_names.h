#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/types.h"

namespace viewcover {

/// The group names of a file, numbered in the order in which they are first asked for.
class GroupNames {
 public:
  /// The group of this name, made if there is none yet. Cost: O(1), as long as the name.
  GroupId id(std::string_view name);
  const std::vector<std::string>& names() const { return names_; }

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };

  std::vector<std::string> names_;
  std::unordered_map<std::string, GroupId, Hash, std::equal_to<>> ids_;
};

/// What a part of an object is called: "OBJECT/PART", or the one of the two that is there, or "".
std::string group_name(const std::string& object, const std::string& part);

}  // namespace viewcover
