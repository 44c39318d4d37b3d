#include "show/page.h"

#include <gmock/gmock.h>

#include "scene/error.h"
#include "scene/scratch_folder.h"
#include "show/shading.h"
#include "support/made_run.h"
#include "support/process.h"

namespace viewcover::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

const std::vector<std::string> kHostile = {"</script><script>alert(1)</script>",
                                           "<!--<script>",
                                           "say \"it's\", \\ & so on",
                                           "Wände ✓ \u2028",
                                           "no UTF-8: \xff\xfe",
                                           ""};

RunData hostile_run() {
  std::vector<ConvexPolygon> surfaces;
  for (int i = 0; i < 6; ++i) surfaces.push_back(level(i, i + 1, 0, 1, 0));
  return made_run(surfaces, kHostile, {level(0, 1, 0, 1, 1), level(1, 2, 0, 1, 1)},
                  {{0, 1, 5}, {1, 2}});
}

PageContent content_of(const RunData& run, const CommonElements& shown) {
  return {run, shown, nullptr, kHostile[0], {}, 2, {}};
}

/// Three.js in two lines.
std::filesystem::path made_three(const ScratchFolder& folder) {
  std::filesystem::create_directories(folder.path() / "build");
  std::filesystem::create_directories(folder.path() / "examples/js/controls");
  folder.write("build/three.min.js", "var THREE = '</script><!--';");
  folder.write("examples/js/controls/OrbitControls.js", "THREE;");
  return folder.path();
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t number = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++number;
  return number;
}

TEST(PageData, HoldsNoMarkupAndGivesNamesBack) {
  const RunData run = hostile_run();
  const std::string data = page_data(content_of(run, common_elements(run)));
  EXPECT_THAT(data, Not(HasSubstr("<")));
  EXPECT_TRUE(std::ranges::all_of(data, [](char c) { return c >= ' ' && c <= '~'; }));
  const Json json = Json::parse(data);
  for (const std::size_t i : {0, 1, 2, 3, 5}) EXPECT_EQ(json.at("groups").at(i), kHostile[i]);
  EXPECT_EQ(json.at("groups").at(4), "no UTF-8: \ufffd\ufffd");
  EXPECT_EQ(json.at("name_of_run"), kHostile[0]);
}

TEST(PageData, EncodesNumbersAndBitRows) {
  const RunData run = hostile_run();
  const Json json = Json::parse(page_data(content_of(run, common_elements(run))));
  // 0b100011 and 0b000110; 1, 2, 1, 0, 0, 1 as 32 bits each.
  EXPECT_EQ(json.at("seen").at("bits"), "IwY=");
  EXPECT_EQ(json.at("times_visible"), "AQAAAAIAAAABAAAAAAAAAAAAAAABAAAA");
  EXPECT_EQ(json.at("pieces").at("counts"), "BAQEBAQE");
}

TEST(Page, HasNoMoreScriptsThanItsOwn) {
  const ScratchFolder folder;
  const RunData run = hostile_run();
  write_page(content_of(run, common_elements(run)), folder.path() / "report.html",
             made_three(folder));
  const std::string page = read_file(folder.path() / "report.html");
  EXPECT_EQ(occurrences(page, "<script"), 4u);
  EXPECT_EQ(occurrences(page, "</script"), 4u);
  EXPECT_EQ(occurrences(page, "<!--"), 0u);
  EXPECT_EQ(occurrences(page, "{{"), 0u);
  EXPECT_THAT(page, HasSubstr("var THREE = '<\\/script><\\!--';"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(Page, SaysWhatToInstall) {
  const ScratchFolder folder;
  const RunData run = hostile_run();
  EXPECT_THAT(
      [&] {
        write_page(content_of(run, common_elements(run)), folder.path() / "report.html",
                   folder.path());
      },
      ThrowsMessage<InputError>(HasSubstr("libjs-three")));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "report.html"));
}

TEST(Shading, BlackIsForNeverAndLightnessGrowsWithTheCount) {
  const RunData run = hostile_run();
  const Shading shading = shade(run, common_elements(run), ColourBy::kTimesVisible);
  EXPECT_THAT(shading.colours,
              ElementsAre(ramp(0), ramp(1), ramp(0), kNeverSeen, kNeverSeen, ramp(0)));
  const auto lightness = [](Colour c) {
    return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue;
  };
  EXPECT_GT(lightness(ramp(0)), 40);
  for (int i = 0; i < 100; ++i) {
    EXPECT_GT(lightness(ramp((i + 1) / 100.0)), lightness(ramp(i / 100.0)));
  }
}

TEST(Shading, RefusesWhatTheRunHasNot) {
  const RunData run = hostile_run();
  EXPECT_THAT([&] { shade(run, common_elements(run), ColourBy::kDifference); },
              ThrowsMessage<InputError>(HasSubstr("--against")));
  EXPECT_THAT([&] { shade(run, common_elements(run), ColourBy::kViewpoints); },
              ThrowsMessage<InputError>(HasSubstr("has none")));
}

}  // namespace
}  // namespace viewcover::testing
