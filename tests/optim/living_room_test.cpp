#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "reference_cover.h"
#include "support/process.h"
#include "support/sanitized.h"

namespace viewcover {
namespace {

using testing::Outcome;
using testing::viewcover_run;

BitRows read_matrix_market(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && line.starts_with('%')) {
  }
  std::size_t rows = 0, columns = 0, entries = 0;
  std::istringstream(line) >> rows >> columns >> entries;
  BitRows matrix(rows, columns);
  std::size_t row = 0, column = 0;
  for (; in >> row >> column; --entries) matrix.set(row - 1, column - 1);
  if (entries != 0) throw std::runtime_error("wrong number of entries");
  return matrix;
}

/// The number of regions that `solve` finds is the minimum for the matrix that it wrote.
void expect_optimum(const std::string& detail, const std::string& regions, int seeds) {
  const ScratchFolder folder;
  const std::string scene = folder.path() / "room.obj", bundle = folder.path() / "bundle";
  ASSERT_EQ(viewcover_run({"generate", "living-room", "--detail", detail, "-o", scene}).exit_code,
            0);
  for (int number = 1; number <= seeds; ++number) {
    const std::string seed = std::to_string(number);
    SCOPED_TRACE("seed " + seed);
    const Outcome outcome = viewcover_run(
        {"solve", scene, "--region", folder.path() / "room.region.json", "--regions", regions,
         "--seed", seed, "--backend", "rays", "--viewpoints", "none", "--quiet", "-o", bundle});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const BitRows matrix = read_matrix_market(folder.path() / "bundle" / "visibility.mtx");
    const std::size_t optimum = reference::minimum_cover(matrix);
    EXPECT_GE(optimum, 5u);
    EXPECT_THAT(outcome.out,
                ::testing::HasSubstr("\"optimal_regions\":" + std::to_string(optimum) + ","));
  }
}

TEST(LivingRoom, OptimumOf64RegionsIsConfirmed) {
  expect_optimum("simple", "64", 3);
  if (!testing::sanitized()) expect_optimum("complex", "64", 3);
}

TEST(LivingRoom, OptimumOf256RegionsIsConfirmed) {
  if (testing::sanitized()) GTEST_SKIP() << "minutes under sanitizers";
  expect_optimum("simple", "256", 2);
  expect_optimum("complex", "256", 1);
}

}  // namespace
}  // namespace viewcover
