#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <iterator>
#include <string>
#include <system_error>

#include "scene/error.h"
#include "scene/generate/generated_scene.h"

namespace viewcover {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, int error) {
  throw InputError(file.string(), "cannot be written: " + std::generic_category().message(error),
                   "a place with room that may be written to");
}

// A file under a temporary name beside its own; gone unless it is moved to its own name.
class PendingFile {
 public:
  explicit PendingFile(const fs::path& file) : file_(file), temporary_(file) {
    std::error_code ignored;
    if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) {
      throw InputError(file.string(), "is not a regular file", "the name of a file to write");
    }
    temporary_ += ".partial";
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile() {
    std::error_code ignored;
    if (written_) fs::remove(temporary_, ignored);
  }

  void write(const std::string& text) {
    std::FILE* stream = std::fopen(temporary_.c_str(), "wb");
    if (stream == nullptr) refuse(file_, errno);
    written_ = true;
    // A full disk may show only when the buffer is flushed or the file closed.
    int error = 0;
    if (std::fwrite(text.data(), 1, text.size(), stream) != text.size()) error = errno;
    if (error == 0 && std::fflush(stream) != 0) error = errno;
    if (std::fclose(stream) != 0 && error == 0) error = errno;
    if (error != 0) refuse(file_, error);
  }

  void move_into_place() {
    if (std::rename(temporary_.c_str(), file_.c_str()) != 0) refuse(file_, errno);
    written_ = false;
  }

 private:
  fs::path file_;
  fs::path temporary_;
  bool written_ = false;
};

// fmt writes the shortest decimals that read back as the same double.
std::string obj_text(const GeneratedScene& scene) {
  std::string text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "# {}\n# {} vertices, {} faces, {} groups\n", scene.title,
                 scene.vertices.size(), scene.faces.size(), scene.groups.size());
  for (const Point& v : scene.vertices) {
    fmt::format_to(out, "v {} {} {}\n", v.x(), v.y(), v.z());
  }
  const GeneratedScene::Face* previous = nullptr;
  for (const GeneratedScene::Face& face : scene.faces) {
    if (previous == nullptr || previous->group != face.group) {
      fmt::format_to(out, "g {}\n", scene.groups[face.group]);
    }
    previous = &face;
    text += 'f';
    for (const std::uint32_t corner : face.corners) fmt::format_to(out, " {}", corner + 1);
    text += '\n';
  }
  return text;
}

std::string region_text(const GeneratedScene& scene) {
  std::string text = "{\"polygons\": [";
  auto out = std::back_inserter(text);
  const char* before_polygon = "";
  for (const auto& polygon : scene.region) {
    fmt::format_to(out, "{}\n  [", before_polygon);
    const char* before_corner = "";
    for (const Point& p : polygon) {
      fmt::format_to(out, "{}[{}, {}, {}]", before_corner, p.x(), p.y(), p.z());
      before_corner = ", ";
    }
    text += ']';
    before_polygon = ",";
  }
  return text + "\n]}\n";
}

}  // namespace

fs::path region_file_beside(const fs::path& file) {
  fs::path region = file;
  return region.replace_extension(".region.json");
}

void write_generated_scene(const GeneratedScene& scene, const fs::path& file) {
  PendingFile obj(file);
  PendingFile region(region_file_beside(file));
  obj.write(obj_text(scene));
  region.write(region_text(scene));
  region.move_into_place();
  obj.move_into_place();
}

}  // namespace viewcover
