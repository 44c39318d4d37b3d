#include "optim/cover_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/error.h"
#include "scene/scratch_folder.h"

namespace viewcover {
namespace {

using ::testing::HasSubstr;

std::string picture(const BitRows& matrix) {
  std::string text;
  for (std::size_t row = 0; row < matrix.rows(); ++row) {
    for (std::size_t column = 0; column < matrix.columns(); ++column) {
      text += matrix.test(row, column) ? '1' : '.';
    }
    text += '\n';
  }
  return text;
}

class CoverFile : public ::testing::Test {
 protected:
  BitRows read(const std::string& text, CoverFormat format) {
    return read_cover_file(folder_.write("problem", text), format);
  }
  /// What the refusal says, without the folder.
  std::string refusal(const std::string& text, CoverFormat format) {
    try {
      read(text, format);
    } catch (const InputError& error) {
      const std::string line = error.what();
      return line.substr(line.find("problem"));
    }
    return "accepted";
  }

  ScratchFolder folder_;
};

// The same problem four times: 2 choices, 3 things to cover.
constexpr const char* kMatrix = "11.\n.11\n";

TEST_F(CoverFile, ReadsMatrixMarket) {
  EXPECT_EQ(picture(read("%%MatrixMarket matrix coordinate pattern general\n% rows: choices\n"
                         "2 3 4\n1 1\n1 2\n2 2\n2 3\n",
                         CoverFormat::kMatrixMarket)),
            kMatrix);
  EXPECT_EQ(picture(read("%%MatrixMarket matrix coordinate pattern general\r\n\r\n%\r\n"
                         "2 3 4\r\n2 3 2 2\r\n1 1\r\n1 2",
                         CoverFormat::kMatrixMarket)),
            kMatrix);
}

TEST_F(CoverFile, OrLibraryChoosesColumns) {
  EXPECT_EQ(picture(read("3 2\n7 5\n1\n1\n2\n1 2\n1 2\n", CoverFormat::kScp)), kMatrix);
  EXPECT_EQ(picture(read(" 3 2\n 1 2 1 2\n 1.5 2 2 3\n", CoverFormat::kRail)), kMatrix);
}

TEST_F(CoverFile, HittingSetsChooseElements) {
  EXPECT_EQ(
      picture(read("c a comment\np hs 2 3\n1\nc another\n1 2\n2\n", CoverFormat::kHittingSet)),
      kMatrix);
}

TEST_F(CoverFile, EmptyProblems) {
  EXPECT_EQ(read("0 0\n", CoverFormat::kScp).rows(), 0u);
  EXPECT_EQ(read("p hs 3 0", CoverFormat::kHittingSet).rows(), 3u);
  const BitRows no_choice = read("2 0\n0 0\n", CoverFormat::kScp);
  EXPECT_EQ(no_choice.columns(), 2u);
}

TEST_F(CoverFile, IsFoundByItsFirstCharacters) {
  EXPECT_EQ(detect_cover_format(folder_.write("a", "%%MatrixMarket matrix ...")),
            CoverFormat::kMatrixMarket);
  EXPECT_EQ(detect_cover_format(folder_.write("b", "p hs 2 3\n")), CoverFormat::kHittingSet);
  EXPECT_THROW(detect_cover_format(folder_.write("c", "3 2\n7 5\n")), InputError);
}

TEST_F(CoverFile, RefusesWhatIsWrongInOneLine) {
  const auto mtx = [](const std::string& rest) {
    return "%%MatrixMarket matrix coordinate pattern general\n" + rest;
  };
  const auto kMtx = CoverFormat::kMatrixMarket;
  EXPECT_THAT(refusal("%%MatrixMarket matrix array real general\n", kMtx),
              HasSubstr("problem:1: no pattern matrix"));
  EXPECT_THAT(refusal(mtx("2 3 2\n1 1\n3 1\n"), kMtx),
              HasSubstr("problem:4: 3 is not a row; give a number from 1 to 2"));
  EXPECT_THAT(refusal(mtx("2 3 2\n1 1\n1 x\n"), kMtx), HasSubstr("problem:4: 'x' is not a column"));
  EXPECT_THAT(refusal(mtx("2 3 2\n1 1\n"), kMtx), HasSubstr("the file ends before a row"));
  EXPECT_THAT(refusal(mtx("2 3 1\n1 1\n1 2\n"), kMtx),
              HasSubstr("problem:4: there is more than the header announces"));
  EXPECT_THAT(refusal(mtx("100000000000 3 1\n1 1\n"), kMtx), HasSubstr("too large"));
  EXPECT_THAT(refusal(mtx("1000000000 1000000000 1\n1 1\n"), kMtx), HasSubstr("too large"));
  EXPECT_THAT(refusal(mtx("-1 3 1\n1 1\n"), kMtx), HasSubstr("problem:2: '-1' is not a number"));
  EXPECT_THAT(refusal("3 2\n7 5\n9\n1\n", CoverFormat::kScp), HasSubstr("the file ends before"));
  EXPECT_THAT(refusal("3 2\n7 5\n1\n0\n", CoverFormat::kScp),
              HasSubstr("problem:4: 0 is not a column"));
  EXPECT_THAT(refusal("p ds 2 3\n", CoverFormat::kHittingSet), HasSubstr("no header"));
  EXPECT_THAT(refusal("p hs 2 3\n1\n2\n", CoverFormat::kHittingSet),
              HasSubstr("the file ends after 2 of 3 sets"));
  EXPECT_THAT(refusal("p hs 2 1\n1\n2\n", CoverFormat::kHittingSet),
              HasSubstr("problem:3: there is more than the header announces"));
  EXPECT_THAT(refusal("", CoverFormat::kRail), HasSubstr("the file ends before a number of rows"));
}

TEST_F(CoverFile, WeightsAreOneAColumn) {
  EXPECT_EQ(read_weights(folder_.write("w", "1 0\n2.5\n"), 3), (std::vector<double>{1, 0, 2.5}));
  for (const char* bad : {"1 2", "1 2 3 4", "1 -2 3", "1 nan 3", "1 1e308 1e308", "1 x 3"}) {
    EXPECT_THROW(read_weights(folder_.write("w", bad), 3), InputError) << bad;
  }
}

}  // namespace
}  // namespace viewcover
