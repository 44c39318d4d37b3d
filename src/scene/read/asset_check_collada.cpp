#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "scene/error.h"
#include "scene/read/asset_check.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

constexpr std::size_t kDeepestElement = 256;
/// More copies of nodes than any scene has.
constexpr std::uint64_t kMostCopies = 1'000'000;

/// The tags of an XML text one after the other.
class TagReader {
 public:
  TagReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// What stands between `<` and `>`; nothing at the end of the text. Comments, CDATA and `<?...?>`
  /// are passed over.
  std::optional<std::string_view> next() {
    for (;;) {
      const std::size_t open = text_.find('<', place_);
      if (open == std::string_view::npos) return std::nullopt;
      move_to(open);
      if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>")) continue;
      const std::size_t close = end_of_tag(open + 1);
      const std::string_view tag = text_.substr(open + 1, close - open - 1);
      tag_line_ = line_;
      move_to(close + 1);
      if (!tag.starts_with("!")) return tag;
    }
  }
  [[noreturn]] void fail(std::string_view wrong, std::string_view right) const {
    throw InputError(InputError::at_line(file_, tag_line_), wrong, right);
  }

 private:
  void move_to(std::size_t place) {
    const std::string_view passed = text_.substr(place_, place - place_);
    line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
    place_ = place;
  }
  bool skip(std::string_view begin, std::string_view end) {
    if (!text_.substr(place_).starts_with(begin)) return false;
    tag_line_ = line_;
    const std::size_t found = text_.find(end, place_ + begin.size());
    if (found == std::string_view::npos) fail("the XML is cut short", "is the file whole?");
    move_to(found + end.size());
    return true;
  }
  /// Not one in quotes.
  std::size_t end_of_tag(std::size_t place) {
    char quote = 0;
    for (; place < text_.size(); ++place) {
      const char c = text_[place];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        return place;
      }
    }
    tag_line_ = line_;
    fail("the XML is cut short", "is the file whole?");
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t place_ = 0, line_ = 1, tag_line_ = 1;
};

std::string_view name_of(std::string_view tag) {
  return tag.substr(0, tag.find_first_of(" \t\r\n/"));
}

/// The value of an attribute; empty if there is none.
std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    const bool is_begin = at > 0 && std::string_view(" \t\r\n").find(tag[at - 1]) != tag.npos;
    const std::size_t open = tag.find_first_not_of(" \t\r\n=", at + name.size());
    if (!is_begin || open == tag.npos || (tag[open] != '"' && tag[open] != '\'')) continue;
    const std::size_t close = tag.find(tag[open], open + 1);
    return tag.substr(open + 1, close - open - 1);
  }
  return {};
}

class ColladaChecker {
 public:
  ColladaChecker(std::string_view content, const std::string& file)
      : tags_(content, file), file_(file) {}

  void run() {
    for (auto tag = tags_.next(); tag; tag = tags_.next()) read(*tag);
    if (!has_root_) throw InputError(file_, "is no COLLADA", "its root is <COLLADA>");
    if (!open_.empty()) {
      throw InputError(file_, fmt::format("{} is not closed", in_quotes(open_.back())),
                       "is the file whole?");
    }
    for (std::size_t node = 0; node < nodes_.size(); ++node) copies_of(node, 0);
  }

 private:
  struct Node {
    std::vector<std::string_view> refers_to;  // ids of nodes
    std::vector<std::size_t> children;
    std::uint64_t copies = 0;  // of nodes that one copy of this one stands for; 0: not known yet
    bool is_open = false;
  };

  void read(std::string_view tag) {
    if (tag.starts_with("/")) {
      const std::string_view name = name_of(tag.substr(1));
      if (open_.empty() || open_.back() != name) {
        tags_.fail(fmt::format("{} closes what is not open", in_quotes(name)), "is the XML whole?");
      }
      open_.pop_back();
      if (name == "node") open_nodes_.pop_back();
      return;
    }
    const std::string_view name = name_of(tag);
    if (open_.empty() && (has_root_ || name != "COLLADA")) {
      tags_.fail(fmt::format("{} is out of place", in_quotes(name)), "the root is <COLLADA>");
    }
    has_root_ = true;
    if (name == "node") add_node(tag);
    if (name == "instance_node" && !open_nodes_.empty()) {
      const std::string_view url = attribute(tag, "url");
      nodes_[open_nodes_.back()].refers_to.push_back(url.substr(url.starts_with("#") ? 1 : 0));
    }
    const bool is_empty = tag.ends_with("/");
    if (is_empty && name == "node") open_nodes_.pop_back();
    if (is_empty) return;
    open_.push_back(name);
    if (open_.size() > kDeepestElement) {
      tags_.fail(fmt::format("elements nested deeper than {}", kDeepestElement), "");
    }
  }

  void add_node(std::string_view tag) {
    if (!open_nodes_.empty()) nodes_[open_nodes_.back()].children.push_back(nodes_.size());
    for (const char* const key : {"id", "name", "sid"}) {
      if (const auto id = attribute(tag, key); !id.empty()) by_id_.try_emplace(id, nodes_.size());
    }
    open_nodes_.push_back(nodes_.size());
    nodes_.emplace_back();
  }

  std::uint64_t copies_of(std::size_t number, std::size_t depth) {
    Node& node = nodes_[number];
    if (node.copies > 0) return node.copies;
    if (node.is_open || depth > kDeepestElement) {
      throw InputError(file_, "a node is an instance of itself or nested too deep",
                       "nodes form a tree");
    }
    node.is_open = true;
    std::uint64_t copies = 1;
    for (const std::size_t child : node.children) copies += copies_of(child, depth + 1);
    for (const std::string_view id : node.refers_to) {
      const auto found = by_id_.find(id);
      if (found != by_id_.end()) copies += copies_of(found->second, depth + 1);
    }
    if (copies > kMostCopies) {
      throw InputError(file_, fmt::format("more than {} instances of nodes", kMostCopies), "");
    }
    node.is_open = false;
    return node.copies = copies;
  }

  TagReader tags_;
  const std::string& file_;
  bool has_root_ = false;
  std::vector<std::string_view> open_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> open_nodes_;
  std::unordered_map<std::string_view, std::size_t> by_id_;
};

}  // namespace

AssetFiles check_collada(std::string_view content, const std::filesystem::path& file) {
  const std::string name = file.string();
  ColladaChecker(content, name).run();
  return {"scene.dae", {}};
}

}  // namespace viewcover
