#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>

#include "scene/generate/generated_scene.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover::testing {

/// A generated scene as a user gets it: written to files and read back.
struct LoadedScene {
  Scene scene;
  ViewingRegion region;
};

inline LoadedScene load_generated(const GeneratedScene& generated, std::size_t regions) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("viewcover-generated-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto file = folder / "scene.obj";
  write_generated_scene(generated, file);
  LoadedScene loaded;
  loaded.scene = load_scene(file);
  loaded.region = load_viewing_region(region_file_beside(file), loaded.scene.lattice, regions);
  check_region_is_free(region_file_beside(file), loaded.scene, loaded.region);
  std::filesystem::remove_all(folder);
  return loaded;
}

}  // namespace viewcover::testing
