#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scene/error.h"
#include "scene/generate/generated_scene.h"
#include "scene/scratch_folder.h"

namespace viewcover {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

// Its own small reader: nothing shared with the scene readers.
GeneratedScene read_obj(const fs::path& file) {
  GeneratedScene scene;
  std::ifstream in(file);
  std::string line;
  std::uint32_t group = 0;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") {
      std::string x, y, z;
      words >> x >> y >> z;
      scene.vertices.emplace_back(std::stod(x), std::stod(y), std::stod(z));
    } else if (key == "g") {
      std::string name;
      words >> name;
      const auto known = std::find(scene.groups.begin(), scene.groups.end(), name);
      group = static_cast<std::uint32_t>(known - scene.groups.begin());
      if (known == scene.groups.end()) scene.groups.push_back(name);
    } else if (key == "f") {
      GeneratedScene::Face face;
      face.group = group;
      std::uint32_t corner = 0;
      while (words >> corner) face.corners.push_back(corner - 1);
      scene.faces.push_back(face);
    }
  }
  return scene;
}

// Files may grow to `bytes` while it lives: the way of a full disk that needs no rights.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(WriteGeneratedScene, ReadsBackEqual) {
  const ScratchFolder folder;
  for (const GeneratedScene& scene :
       {living_room(RoomDetail::kComplex), triangle_soup(500, 3), analytic_scenes()[1].scene}) {
    const fs::path file = folder.path() / "scene.obj";
    write_generated_scene(scene, file);
    const GeneratedScene read = read_obj(file);
    EXPECT_EQ(read.vertices, scene.vertices);
    EXPECT_EQ(read.groups, scene.groups);
    ASSERT_EQ(read.faces.size(), scene.faces.size());
    for (std::size_t i = 0; i < read.faces.size(); ++i) {
      EXPECT_EQ(read.faces[i].corners, scene.faces[i].corners);
      EXPECT_EQ(read.faces[i].group, scene.faces[i].group);
    }
    const auto json = nlohmann::json::parse(content(region_file_beside(file)));
    ASSERT_EQ(json.at("polygons").size(), scene.region.size());
    for (std::size_t part = 0; part < scene.region.size(); ++part) {
      ASSERT_EQ(json["polygons"][part].size(), scene.region[part].size());
      for (std::size_t corner = 0; corner < scene.region[part].size(); ++corner) {
        const auto p = json["polygons"][part][corner].get<std::array<double, 3>>();
        EXPECT_EQ(Point(p[0], p[1], p[2]), scene.region[part][corner]);
      }
    }
  }
  EXPECT_THAT(names_in(folder.path()), ::testing::ElementsAre("scene.obj", "scene.region.json"));
}

TEST(WriteGeneratedScene, SameSceneSameBytesOtherSeedOtherBytes) {
  const ScratchFolder folder;
  const auto bytes = [&](const GeneratedScene& scene) {
    write_generated_scene(scene, folder.path() / "scene.obj");
    return content(folder.path() / "scene.obj") + content(folder.path() / "scene.region.json");
  };
  EXPECT_EQ(bytes(triangle_soup(100, 1)), bytes(triangle_soup(100, 1)));
  EXPECT_NE(bytes(triangle_soup(100, 1)), bytes(triangle_soup(100, 2)));
  EXPECT_EQ(bytes(living_room(RoomDetail::kSimple)), bytes(living_room(RoomDetail::kSimple)));
}

TEST(WriteGeneratedScene, NamesTheRegionFile) {
  EXPECT_EQ(region_file_beside("a/room.obj"), fs::path("a/room.region.json"));
  EXPECT_EQ(region_file_beside("room"), fs::path("room.region.json"));
  EXPECT_EQ(region_file_beside("v1.2/room.v3.obj"), fs::path("v1.2/room.v3.region.json"));
}

TEST(WriteGeneratedScene, SaysWhyAFileCannotBeWritten) {
  const ScratchFolder folder;
  const GeneratedScene scene = triangle_soup(1, 1);
  const auto message = [&](const fs::path& file) -> std::string {
    try {
      write_generated_scene(scene, file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(message(folder.path() / "none" / "a.obj"), HasSubstr("No such file or directory"));
  EXPECT_THAT(message(folder.write("file", "") / "a.obj"), HasSubstr("Not a directory"));
  EXPECT_THAT(message("/dev/full"), HasSubstr("not a regular file"));
  EXPECT_THAT(message(folder.path()), HasSubstr("not a regular file"));
  EXPECT_THAT(names_in(folder.path()), ::testing::ElementsAre("file"));
}

TEST(WriteGeneratedScene, DiskFullLeavesTheOldFiles) {
  const ScratchFolder folder;
  const fs::path file = folder.write("scene.obj", "old");
  folder.write("scene.region.json", "old region");
  // Some 90 kB: more than a stream's buffer. Some 300 bytes: refused only when it is flushed.
  for (const std::size_t triangles : {1000u, 1u}) {
    const FileSizeLimit limit(100);
    try {
      write_generated_scene(triangle_soup(triangles, 1), file);
      FAIL() << "written in spite of the limit";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("File too large"));
      EXPECT_THAT(error.what(), ::testing::StartsWith(file.string()));
    }
  }
  EXPECT_EQ(content(file), "old");
  EXPECT_EQ(content(folder.path() / "scene.region.json"), "old region");
  EXPECT_THAT(names_in(folder.path()), ::testing::ElementsAre("scene.obj", "scene.region.json"));
}

}  // namespace
}  // namespace viewcover
