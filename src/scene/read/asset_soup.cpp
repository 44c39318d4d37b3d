#include "scene/read/asset_soup.h"

#include <assimp/BaseImporter.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "scene/address.h"
#include "scene/error.h"
#include "scene/read/apart.h"
#include "scene/read/asset_check.h"
#include "scene/read/group_names.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

/// For assimp in a process of its own: bytes and seconds for a small file, and what it may need
/// more for each byte of it (1 s a MiB).
constexpr std::size_t kBytes = std::size_t{1} << 29, kBytesAByte = 64;
constexpr unsigned kSeconds = 5;

/// Files in memory, and no others.
class MemoryFiles : public Assimp::IOSystem {
 public:
  MemoryFiles(std::string_view content, const AssetFiles& files)
      : content_(content), files_(files) {}

  bool Exists(const char* name) const override { return find(name).has_value(); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    const auto found = find(name);
    if (!found || std::string_view(mode).find('w') != std::string_view::npos) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(found->data()),
                                      found->size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::optional<std::string_view> find(std::string_view name) const {
    while (name.starts_with("./") || name.starts_with("/"))
      name.remove_prefix(name[0] == '.' ? 2 : 1);
    if (name == files_.main) return content_;
    const auto buffer = files_.buffers.find(std::string(name));
    if (buffer == files_.buffers.end()) return std::nullopt;
    return buffer->second;
  }

  std::string_view content_;
  const AssetFiles& files_;
};

/// assimp tries all its readers on what it does not know; two are meant here.
void keep_two_readers(Assimp::Importer& importer) {
  constexpr std::array<std::string_view, 2> kKept = {"glTF2 Importer", "Collada Importer"};
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    if (std::ranges::find(kKept, importer.GetImporterInfo(i)->mName) != kKept.end()) continue;
    const std::unique_ptr<Assimp::BaseImporter> reader(importer.GetImporter(i));
    importer.UnregisterLoader(reader.get());
  }
}

Eigen::Affine3d transform_of(const aiNode& node) {
  const aiMatrix4x4& m = node.mTransformation;
  Eigen::Affine3d transform;
  transform.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0,
      0, 0, 1;
  return transform;
}

/// Names that assimp makes up for nodes of COLLADA that have none.
std::string name_of(const aiString& given) {
  const std::string name(given.data, given.length);
  return name.starts_with("$ColladaAutoName$") ? "" : name;
}

class SoupMaker {
 public:
  SoupMaker(const aiScene& scene, std::string file) : scene_(scene) {
    soup_.file = std::move(file);
  }

  PolygonSoup run() {
    add(*scene_.mRootNode, Eigen::Affine3d::Identity());
    if (soup_.faces.empty()) throw InputError(soup_.file, "the file has no face", "");
    soup_.groups = groups_.names();
    return std::move(soup_);
  }

 private:
  // The checks before have seen how deep this goes.
  void add(const aiNode& node, const Eigen::Affine3d& above) {
    const Eigen::Affine3d placed = above * transform_of(node);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] < scene_.mNumMeshes) add(*scene_.mMeshes[node.mMeshes[i]], node, placed);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], placed);
  }

  void add(const aiMesh& mesh, const aiNode& node, const Eigen::Affine3d& placed) {
    const auto polygons =
        std::ranges::count_if(std::span(mesh.mFaces, mesh.mNumFaces),
                              [](const aiFace& face) { return face.mNumIndices > 2; });
    if (polygons == 0) return;
    const std::size_t first = soup_.vertices.size();
    if (soup_.faces.size() + static_cast<std::size_t>(polygons) > ElementAddress::kOwnerLimit ||
        first + mesh.mNumVertices > std::numeric_limits<std::uint32_t>::max()) {
      throw InputError(soup_.file, "more faces, instances counted, than can be numbered",
                       fmt::format("at most {}", ElementAddress::kOwnerLimit));
    }
    const GroupId group = groups_.id(group_name(name_of(node.mName), name_of(mesh.mName)));
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mVertices[i];
      soup_.vertices.push_back(placed * Point(v.x, v.y, v.z));
      if (!soup_.vertices.back().allFinite()) {
        throw InputError(
            soup_.file,
            fmt::format("a coordinate of {} is not finite", in_quotes(mesh.mName.C_Str())), "");
      }
    }
    const bool is_mirrored = placed.linear().determinant() < 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices < 3) continue;
      PolygonSoup::Face corners;
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        if (face.mIndices[k] >= mesh.mNumVertices) {
          throw InputError(soup_.place_of_face(soup_.faces.size()), "a corner is out of range",
                           fmt::format("its mesh has {} vertices", mesh.mNumVertices));
        }
        corners.push_back(static_cast<std::uint32_t>(first + face.mIndices[k]));
      }
      if (is_mirrored) std::reverse(corners.begin() + 1, corners.end());
      soup_.faces.push_back(std::move(corners));
      soup_.face_groups.push_back(group);
    }
  }

  const aiScene& scene_;
  PolygonSoup soup_;
  GroupNames groups_;
};

/// One line, as assimp's messages are not always.
std::string one_line(std::string_view text) {
  constexpr std::size_t kReadable = 160;
  std::string line;
  for (const char c : text.substr(0, kReadable)) line += c >= ' ' && c <= '~' ? c : ' ';
  return line;
}

/// A soup without lines as bytes, for a process that reads it at once.
class SoupWriter {
 public:
  static std::string write(const PolygonSoup& soup) {
    SoupWriter writer;
    writer.add(soup.vertices.size());
    for (const Point& v : soup.vertices) writer.add(std::array{v.x(), v.y(), v.z()});
    writer.add(soup.faces.size());
    for (std::size_t i = 0; i < soup.faces.size(); ++i) {
      writer.add(soup.face_groups[i].value);
      writer.add(soup.faces[i].size());
      for (const std::uint32_t corner : soup.faces[i]) writer.add(corner);
    }
    writer.add(soup.groups.size());
    for (const std::string& group : soup.groups) {
      writer.add(group.size());
      writer.bytes_ += group;
    }
    return std::move(writer.bytes_);
  }

 private:
  template <class T>
  void add(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  std::string bytes_;
};

/// The soup again. assimp may have broken the memory that it comes from: whatever is not as a soup
/// must be is a std::runtime_error.
class SoupReader {
 public:
  explicit SoupReader(std::string_view bytes) : bytes_(bytes) {}

  PolygonSoup read() {
    PolygonSoup soup;
    soup.vertices.resize(size_of(sizeof(std::array<double, 3>)));
    for (Point& v : soup.vertices) {
      const auto coordinates = next<std::array<double, 3>>();
      v = Point(coordinates[0], coordinates[1], coordinates[2]);
      require(v.allFinite());
    }
    soup.faces.resize(size_of(sizeof(std::size_t)));
    for (PolygonSoup::Face& face : soup.faces) {
      soup.face_groups.emplace_back(next<std::uint32_t>());
      face.resize(size_of(sizeof(std::uint32_t)));
      require(face.size() >= 3);
      for (std::uint32_t& corner : face) {
        corner = next<std::uint32_t>();
        require(corner < soup.vertices.size());
      }
    }
    soup.groups.resize(size_of(sizeof(std::size_t)));
    for (std::string& group : soup.groups) group = take(next<std::size_t>());
    for (const GroupId group : soup.face_groups) require(group.value < soup.groups.size());
    require(!soup.faces.empty() && bytes_.empty());
    return soup;
  }

 private:
  static void require(bool holds) {
    if (!holds) throw std::runtime_error("its soup is broken");
  }
  /// How many things of at least so many bytes follow.
  std::size_t size_of(std::size_t bytes_each) {
    const auto size = next<std::size_t>();
    require(size <= bytes_.size() / bytes_each);
    return size;
  }
  std::string_view take(std::size_t size) {
    require(size <= bytes_.size());
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  template <class T>
  T next() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view bytes_;
};

PolygonSoup read_with_assimp(std::string_view content, const AssetFiles& files,
                             const std::string& file) {
  Assimp::Importer importer;
  keep_two_readers(importer);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetIOHandler(new MemoryFiles(content, files));  // which the importer owns
  const aiScene* const scene = importer.ReadFile(files.main, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string_view why = importer.GetErrorString();
    if (why.find("bad_alloc") != std::string_view::npos) throw std::bad_alloc();
    throw InputError(file, "assimp cannot read it: " + one_line(importer.GetErrorString()), "");
  }
  return SoupMaker(*scene, file).run();
}

[[noreturn]] void fail(const std::string& file, const Apart& apart) {
  switch (apart.end) {
    case Apart::End::kThrew: {
      const std::string start = file + ": ";  // of an InputError
      if (apart.bytes.starts_with(start)) {
        throw InputError(file, apart.bytes.substr(start.size()), "");
      }
      throw InputError(file, "assimp cannot read it: " + one_line(apart.bytes), "");
    }
    case Apart::End::kNoMemory:
      throw InputError(file, "assimp needs more memory for it than a file of its size should", "");
    case Apart::End::kNoTime:
      throw InputError(file, "assimp does not come to an end with it", "");
    default:
      throw InputError(file, "assimp breaks on it", "is the file whole?");
  }
}

}  // namespace

PolygonSoup parse_asset(std::string_view content, const std::filesystem::path& file) {
  const std::string name = file.string();
  const bool is_collada = lower_suffix(file) == ".dae";
  const AssetFiles files = is_collada ? check_collada(content, file) : check_gltf(content, file);
  std::size_t bytes = content.size();
  for (const auto& [buffer, held] : files.buffers) bytes += held.size();
  // assimp 5.2 crashes on files that are a little damaged.
  const Apart apart =
      run_apart([&] { return SoupWriter::write(read_with_assimp(content, files, name)); },
                kBytes + kBytesAByte * bytes, kSeconds + static_cast<unsigned>(bytes >> 20));
  if (apart.end != Apart::End::kDone) fail(name, apart);
  try {
    PolygonSoup soup = SoupReader(apart.bytes).read();
    soup.file = name;
    return soup;
  } catch (const std::runtime_error&) {
    fail(name, Apart());
  }
}

}  // namespace viewcover
