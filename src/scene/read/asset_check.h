#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace viewcover {

/// What assimp reads in place of the files that an asset names: nothing else is opened.
struct AssetFiles {
  std::string main;                            ///< the name that assimp is given
  std::map<std::string, std::string> buffers;  ///< content of the other files, by name
};

// assimp 5.2 follows what a file claims: it allocates for elements that are not there, copies a
// node once for each way to it, and goes as deep into the stack as nodes and JSON are nested. The
// checks below read the structure first and refuse what would end badly, or only in a vague
// message. Errors: InputError. Cost: linear.

/// glTF 2.0: `.gltf` (JSON) or `.glb`, told by the first bytes. Reads the buffers beside the file:
/// plain names in its folder only.
AssetFiles check_gltf(std::string_view content, const std::filesystem::path& file);

/// COLLADA.
AssetFiles check_collada(std::string_view content, const std::filesystem::path& file);

}  // namespace viewcover
