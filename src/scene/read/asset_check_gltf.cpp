#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "scene/error.h"
#include "scene/read/asset_check.h"
#include "scene/read/json_text.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

using nlohmann::json;

constexpr std::size_t kDeepestNode = 256;

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) {
    number = number << 8 | static_cast<unsigned char>(bytes[place + i]);
  }
  return number;
}

/// The JSON in a .glb: a header of 12 bytes, then chunks of a length, a kind and content.
std::string_view json_chunk(std::string_view content, const std::string& file) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  constexpr std::uint32_t kJson = 0x4E4F534A;
  const auto fail = [&](std::string_view wrong) {
    throw InputError(file, wrong, "is the .glb whole?");
  };
  if (content.size() < kHeader + kChunkHeader) fail("the file is cut short");
  if (number_at(content, 4) != 2) fail("a .glb of another version than 2");
  if (number_at(content, 8) != content.size()) {
    fail(fmt::format("the header claims {} bytes, the file has {}", number_at(content, 8),
                     content.size()));
  }
  for (std::size_t place = kHeader; place < content.size();) {
    if (content.size() - place < kChunkHeader ||
        number_at(content, place) > content.size() - place - kChunkHeader) {
      fail("a chunk goes beyond the end of the file");
    }
    if (place == kHeader && number_at(content, place + 4) != kJson) {
      fail("the first chunk is not JSON");
    }
    place += kChunkHeader + number_at(content, place);
  }
  return content.substr(kHeader + kChunkHeader, number_at(content, kHeader));
}

class GltfChecker {
 public:
  GltfChecker(std::string_view content, const std::filesystem::path& file)
      : file_(file), name_(file.string()) {
    const bool is_binary = content.starts_with("glTF");
    files_.main = is_binary ? "scene.glb" : "scene.gltf";
    bytes_ = content.size();
    root_ = parse_json(is_binary ? json_chunk(content, name_) : content, name_);
  }

  AssetFiles run() {
    const json* const asset = member(root_, "asset");
    const json* const version = asset != nullptr ? member(*asset, "version") : nullptr;
    if (version == nullptr || !version->is_string() ||
        !version->get_ref<const std::string&>().starts_with("2.")) {
      fail("is no glTF 2.0", R"(it says {"asset": {"version": "2.0"}})");
    }
    for (const json& buffer : list("buffers")) check_buffer(buffer);
    check_accessors();
    check_nodes();
    return std::move(files_);
  }

 private:
  [[noreturn]] void fail(std::string_view wrong, std::string_view right) const {
    throw InputError(name_, wrong, right);
  }
  static const json* member(const json& object, const char* key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }
  const json& list(const char* key) const {
    static const json kNone = json::array();
    const json* const found = member(root_, key);
    if (found == nullptr) return kNone;
    if (!found->is_array()) fail(fmt::format("\"{}\" is no list", key), "");
    return *found;
  }
  /// A number that says how many.
  std::uint64_t count(const json& object, const char* key) const {
    const json* const found = member(object, key);
    if (found == nullptr) return 0;
    if (!found->is_number_unsigned()) fail(fmt::format("\"{}\" is no count", key), "");
    return found->get<std::uint64_t>();
  }

  void check_buffer(const json& buffer) {
    const json* const uri = member(buffer, "uri");
    if (uri == nullptr) return;
    if (!uri->is_string()) fail("the uri of a buffer is no text", "");
    const std::string& name = uri->get_ref<const std::string&>();
    if (name.starts_with("data:")) return;
    if (name.empty() || name.front() == '.' || name.find_first_of("/\\:%") != std::string::npos) {
      fail(fmt::format("the buffer {} is not read", in_quotes(name)),
           "buffers are in the file or in plain files beside it");
    }
    const std::filesystem::path beside = file_.parent_path() / name;
    std::error_code error;
    if (!std::filesystem::is_regular_file(beside, error)) {
      fail(fmt::format("its buffer {} is not there", in_quotes(name)),
           "it lies in the same folder");
    }
    std::ifstream stream(beside, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) fail(fmt::format("its buffer {} cannot be read", in_quotes(name)), "");
    if (bytes.size() < count(buffer, "byteLength")) {
      fail(fmt::format("its buffer {} is shorter than it says", in_quotes(name)), "is it whole?");
    }
    bytes_ += bytes.size();
    files_.buffers[name] = std::move(bytes);
  }

  void check_accessors() const {
    const json& accessors = list("accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i) {
      if (count(accessors[i], "count") > bytes_) {
        fail(fmt::format("accessor {} claims more elements than the file has bytes", i), "");
      }
      // Rare for positions, and nothing here tests what assimp makes of them.
      if (member(accessors[i], "sparse") != nullptr) {
        fail(fmt::format("accessor {} is sparse, which is not read", i),
             "export it with all its elements");
      }
    }
  }

  /// A node has one parent at most, and the way down to it is not long.
  void check_nodes() const {
    const json& nodes = list("nodes");
    std::vector<std::vector<std::size_t>> children(nodes.size());
    std::vector<char> has_parent(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const json* const below = member(nodes[i], "children");
      if (below == nullptr) continue;
      if (!below->is_array()) fail(fmt::format("the children of node {} are no list", i), "");
      for (const json& child : *below) {
        if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size()) {
          fail(fmt::format("a child of node {} does not exist", i), "");
        }
        const auto number = child.get<std::size_t>();
        if (has_parent[number] != 0) {
          fail(fmt::format("node {} has two parents", number), "nodes form a tree");
        }
        has_parent[number] = 1;
        children[i].push_back(number);
      }
    }
    std::vector<std::size_t> level;
    std::size_t reached = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (has_parent[i] == 0) level.push_back(i);
    }
    for (std::size_t depth = 0; !level.empty(); ++depth) {
      if (depth > kDeepestNode) fail(fmt::format("nodes deeper than {}", kDeepestNode), "");
      reached += level.size();
      std::vector<std::size_t> next;
      for (const std::size_t node : level) {
        next.insert(next.end(), children[node].begin(), children[node].end());
      }
      level = std::move(next);
    }
    if (reached < nodes.size()) fail("nodes are their own children", "nodes form a tree");
  }

  std::filesystem::path file_;
  std::string name_;
  std::size_t bytes_ = 0;  // of the file and its buffers
  AssetFiles files_;
  json root_;
};

}  // namespace

AssetFiles check_gltf(std::string_view content, const std::filesystem::path& file) {
  return GltfChecker(content, file).run();
}

}  // namespace viewcover
