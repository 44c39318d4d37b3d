#include "report/file_writer.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "scene/error.h"
#include "scene/scratch_folder.h"
#include "support/process.h"

namespace viewcover {
namespace {

using testing::read_file;

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(FileWriter, AppearsWholeOnCommit) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "table.csv";
  FileWriter out(file);
  out << "a," << 7u << ',' << -3 << ',' << 0.1 << '\n';
  EXPECT_FALSE(std::filesystem::exists(file));
  out.commit();
  EXPECT_EQ(read_file(file), "a,7,-3,0.1\n");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(FileWriter, LeavesTheOldFileWithoutCommit) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.write("table.csv", "old");
  {
    FileWriter out(file);
    out << std::string(1 << 20, 'x');
  }
  EXPECT_EQ(read_file(file), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(FileWriter, KeepsMoreThanABuffer) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "long";
  std::string expected;
  FileWriter out(file);
  for (int i = 0; i < 200'000; ++i) {
    out << i << ' ';
    expected += std::to_string(i) + ' ';
  }
  out.commit();
  EXPECT_EQ(read_file(file), expected);
}

TEST(FileWriter, NumbersReadBackExactly) {
  for (const double number : {0.1, 1.0 / 3, 1e-300, 5e-324, 1.7976931348623157e308, -2.5,
                              std::nextafter(1.0, 2.0), 123456789.125}) {
    EXPECT_EQ(std::strtod(shortest_decimal(number).c_str(), nullptr), number);
  }
  EXPECT_EQ(shortest_decimal(0.3), "0.3");
  EXPECT_EQ(shortest_decimal(2), "2");
}

TEST(FileWriter, SaysWhyItCannotWrite) {
  const ScratchFolder folder;
  const std::filesystem::path regular = folder.write("regular", "");
  try {
    FileWriter out(regular / "below");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith((regular / "below").string()));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("Not a directory"));
  }
}

TEST(FileWriter, NoticesAVanishedFolder) {
  const ScratchFolder folder;
  const std::filesystem::path below = folder.path() / "below";
  std::filesystem::create_directory(below);
  FileWriter out(below / "file");
  out << "text";
  std::filesystem::remove_all(below);
  EXPECT_THROW(out.commit(), InputError);
  EXPECT_FALSE(std::filesystem::exists(below));
}

TEST(CsvField, QuotesWhatNeedsIt) {
  EXPECT_EQ(csv_field("wall north"), "wall north");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("the \"big\" one"), "\"the \"\"big\"\" one\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_field(""), "");
}

}  // namespace
}  // namespace viewcover
