#include "show/page.h"

#include <array>
#include <fstream>
#include <iterator>
#include <utility>

#include "report/file_writer.h"
#include "scene/error.h"
#include "show/page_assets.h"

namespace viewcover {
namespace {

std::string read_script(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (text.empty()) {
    throw InputError(file.string(), "cannot be read; the page needs it",
                     "install Debian's libjs-three, or leave the page out with --no-page");
  }
  // What would end or change a script element is escaped; inside of strings it means the same.
  for (const auto& [what, with] :
       {std::pair<std::string, std::string>{"</script", "<\\/script"}, {"<!--", "<\\!--"}}) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
      text.replace(at, what.size(), with);
    }
  }
  return text;
}

}  // namespace

std::filesystem::path three_folder() { return VIEWCOVER_THREE; }

void write_page(const PageContent& content, const std::filesystem::path& file,
                const std::filesystem::path& three) {
  const std::string library = read_script(three / "build" / "three.min.js"),
                    controls = read_script(three / "examples/js/controls/OrbitControls.js"),
                    data = page_data(content);
  const std::array<std::pair<std::string_view, std::string_view>, 5> parts = {
      {{"style", PageAssets::style},
       {"data", data},
       {"three", library},
       {"controls", controls},
       {"script", PageAssets::script}}};
  FileWriter out(file);
  std::string_view left = PageAssets::html;
  for (const auto& [name, text] : parts) {
    const std::string place = "{{" + std::string(name) + "}}";
    const std::size_t at = left.find(place);
    out << left.substr(0, at) << text;
    left.remove_prefix(at + place.size());
  }
  out << left;
  out.commit();
}

}  // namespace viewcover
