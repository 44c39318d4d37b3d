#include "optim/cover_proof.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "optim/check_cover_proof.h"
#include "optim/exact_cover.h"
#include "reference_cover.h"
#include "small_instances.h"
#include "support/process.h"

namespace viewcover {
namespace {

using testing::affine_space;
using testing::shuffled;
using testing::small_instance;
using testing::SmallInstance;

std::string proof_of(const BitRows& matrix, double time_limit_seconds = 0) {
  const CoverInstance instance(matrix, std::vector<double>(matrix.columns(), 1.0));
  CoverOptions options;
  options.goal = CoverGoal::kWholeCover;
  options.time_limit_seconds = time_limit_seconds;
  const RegionCover cover = ExactCover().solve(instance, options);
  std::ostringstream out;
  write_cover_proof(out, instance.rows(), *cover.proof);
  return out.str();
}

CoverProofVerdict check(const BitRows& matrix, const std::string& proof) {
  std::istringstream in(proof);
  return check_cover_proof(matrix, in);
}

/// The proof with one of its numbers changed, for each number and several changes.
template <class Visit>
void for_each_change(const std::string& proof, Visit&& visit) {
  for (std::size_t begin = 0; begin < proof.size(); ++begin) {
    const auto is_digit = [&](std::size_t at) {
      return at < proof.size() && std::isdigit(static_cast<unsigned char>(proof[at])) != 0;
    };
    if (!is_digit(begin) || (begin > 0 && is_digit(begin - 1))) continue;
    std::size_t end = begin;
    while (is_digit(end)) ++end;
    const std::string number = proof.substr(begin, end - begin);
    std::vector<std::string> changes = {"0", "1", "18446744073709551616", number + "0"};
    if (number.size() < 10) {
      changes.push_back(std::to_string(std::stoull(number) + 1));
      if (number != "0") changes.push_back(std::to_string(std::stoull(number) - 1));
    }
    for (const std::string& change : changes) {
      if (change == number) continue;
      visit(proof.substr(0, begin) + change + proof.substr(end));
    }
  }
}

TEST(CoverProof, ProvesTheMinimumOfSmallInstances) {
  std::size_t branched = 0, excluded = 0, leaves = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE(seed);
    const SmallInstance instance = small_instance(seed, 18, 60);
    const std::string proof = proof_of(instance.matrix);
    const CoverProofVerdict verdict = check(instance.matrix, proof);
    ASSERT_TRUE(verdict.holds) << "line " << verdict.line << ": " << verdict.reason;
    ASSERT_EQ(verdict.lower_bound, reference::minimum_cover(instance.matrix));
    branched += proof.find("\nbranch") != std::string::npos;
    excluded += proof.find("\nwithout") != std::string::npos;
    leaves += proof.find("\nleaf") != std::string::npos;
  }
  EXPECT_GT(leaves, 100u);
  EXPECT_GT(branched, 0u);
  EXPECT_GT(excluded, 0u);
}

TEST(CoverProof, OneChangedNumberNeverProvesMoreThanTheMinimum) {
  std::size_t refused = 0, still_valid = 0;
  std::vector<BitRows> matrices = {affine_space(2), shuffled(affine_space(2), 2, 7)};
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    matrices.push_back(small_instance(seed, 14, 40).matrix);
  }
  for (const BitRows& matrix : matrices) {
    const std::size_t minimum = reference::minimum_cover(matrix);
    for_each_change(proof_of(matrix), [&](const std::string& changed) {
      const CoverProofVerdict verdict = check(matrix, changed);
      ASSERT_TRUE(!verdict.holds || verdict.lower_bound <= minimum) << changed;
      if (!verdict.holds) {
        ASSERT_GE(verdict.line, 1u);
        ASSERT_THAT(verdict.reason, ::testing::Not(::testing::HasSubstr("\n")));
        ASSERT_FALSE(verdict.reason.empty());
      }
      // Another row or price may do as well; the numbers of the header and of the bounds may not.
      ++(verdict.holds ? still_valid : refused);
      ASSERT_TRUE(!verdict.holds || verdict.lower_bound == minimum) << changed;
    });
  }
  EXPECT_GT(refused, 20 * still_valid / 10);
  EXPECT_GT(refused, 5000u);
}

TEST(CoverProof, OfAnotherMatrixIsRefused) {
  const std::string proof = proof_of(affine_space(2));
  EXPECT_TRUE(check(affine_space(2), proof).holds);
  BitRows other = affine_space(2);
  other.set(0, 11);
  const CoverProofVerdict verdict = check(other, proof);
  EXPECT_FALSE(verdict.holds);
  EXPECT_EQ(verdict.line, 2u);
}

TEST(CoverProof, HoldsForEveryMatrixOfTheCanonicalForm) {
  const BitRows matrix = affine_space(2);
  BitRows with_copies(9, 25);  // an empty column, then all columns twice
  for (std::size_t row = 0; row < 9; ++row) {
    for_each_bit(matrix.row(row), [&](std::size_t column) {
      with_copies.set(row, column + 1);
      with_copies.set(row, column + 13);
    });
  }
  EXPECT_TRUE(check(with_copies, proof_of(matrix)).holds);
}

TEST(CoverProof, MissingAndAddedLinesAreRefused) {
  const BitRows matrix = affine_space(2);
  const std::string proof = proof_of(matrix);
  std::vector<std::string> lines;
  std::istringstream in(proof);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  ASSERT_GT(lines.size(), 8u);
  for (std::size_t changed = 0; changed < lines.size(); ++changed) {
    std::string without, twice;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i != changed) without += lines[i] + "\n";
      twice += lines[i] + "\n";
      if (i == changed) twice += lines[i] + "\n";
    }
    EXPECT_FALSE(check(matrix, without).holds) << "without line " << changed + 1;
    // A dual that is there twice only shifts the numbers of later ones: refused or harmless.
    if (!lines[changed].starts_with("dual")) {
      EXPECT_FALSE(check(matrix, twice).holds) << "twice line " << changed + 1;
    }
  }
}

TEST(CoverProof, IsThereWhenTimeRanOut) {
  const BitRows matrix = affine_space(4);
  const CoverProofVerdict verdict = check(matrix, proof_of(matrix, 0.5));
  EXPECT_TRUE(verdict.holds) << "line " << verdict.line << ": " << verdict.reason;
  EXPECT_GE(verdict.lower_bound, 27u);  // a third of the points, by the linear programme alone
  EXPECT_LE(verdict.lower_bound, 61u);
}

TEST(CoverProof, HashIsThatOfTheCanonicalText) {
  BitRows matrix(2, 3);
  matrix.set(0, 0);
  matrix.set(0, 2);
  matrix.set(1, 1);
  // printf '2 3\n1 3\n2\n' | sha256sum
  EXPECT_EQ(matrix_hash(matrix),
            "e651d6968adb4491aac9ff6cfbb123271fa9e467e0951a0aa4809ec12b94f75a");
}

TEST(CoverProof, ThePythonCheckerAgrees) {
  const ScratchFolder folder;
  const BitRows matrix = affine_space(2);
  const std::filesystem::path matrix_file = folder.path() / "matrix.mtx";
  std::ofstream out(matrix_file);
  out << "%%MatrixMarket matrix coordinate pattern general\n9 12 36\n";
  for (std::size_t row = 0; row < 9; ++row) {
    for_each_bit(matrix.row(row),
                 [&](std::size_t column) { out << row + 1 << ' ' << column + 1 << '\n'; });
  }
  out.close();
  const std::filesystem::path proof_file = folder.path() / "proof";
  const auto python_exit_code = [&](const std::string& proof) {
    std::ofstream(proof_file) << proof;
    testing::Process process({VIEWCOVER_SCRIPTS "/check-cover-proof", matrix_file, proof_file});
    const int code = process.wait();
    const std::string said = code == 0 ? process.out() : process.error();
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    return code;
  };
  const std::string proof = proof_of(matrix);
  EXPECT_EQ(python_exit_code(proof), 0);
  std::size_t number = 0, refused = 0;
  for_each_change(proof, [&](const std::string& changed) {
    if (++number % 64 != 0) return;  // a process takes a while
    const CoverProofVerdict verdict = check(matrix, changed);
    EXPECT_EQ(python_exit_code(changed), verdict.holds ? 0 : 1) << changed;
    refused += !verdict.holds;
  });
  EXPECT_GT(refused, 5u);
}

}  // namespace
}  // namespace viewcover
