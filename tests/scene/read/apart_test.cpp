#include "scene/read/apart.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "support/sanitized.h"

namespace viewcover {
namespace {

constexpr std::size_t kBytes = std::size_t{1} << 30;

Apart::End end_of(const std::function<std::string()>& task, unsigned seconds = 10) {
  return run_apart(task, kBytes, seconds).end;
}

TEST(Apart, ReturnsWhatTheTaskReturns) {
  const std::string bytes(1'000'000, '\0');
  const Apart apart = run_apart([&] { return bytes + "x"; }, kBytes, 10);
  EXPECT_EQ(apart.end, Apart::End::kDone);
  EXPECT_EQ(apart.bytes, bytes + "x");
}

TEST(Apart, SurvivesWhateverBecomesOfTheTask) {
  const auto threw = run_apart([]() -> std::string { throw std::runtime_error("why"); }, kBytes, 9);
  EXPECT_EQ(threw.end, Apart::End::kThrew);
  EXPECT_EQ(threw.bytes, "why");
  EXPECT_EQ(end_of([] { return std::raise(SIGSEGV) == 0 ? "" : "x"; }), Apart::End::kCrashed);
  EXPECT_EQ(end_of([]() -> std::string { std::abort(); }), Apart::End::kCrashed);
  EXPECT_EQ(end_of([]() -> std::string { std::_Exit(0); }), Apart::End::kCrashed);
  const auto for_ever = []() -> std::string {
    for (volatile bool forever = true; forever;) {
    }
    return "";
  };
  EXPECT_EQ(end_of(for_ever, 1), Apart::End::kNoTime);
  EXPECT_EQ(end_of([] { return "still here"; }), Apart::End::kDone);
}

TEST(Apart, EndsATaskThatAsksForTooMuch) {
  if (viewcover::testing::sanitized()) GTEST_SKIP() << "sanitizers need more than any limit";
  EXPECT_EQ(end_of([] { return std::string(2 * kBytes, 'x'); }), Apart::End::kNoMemory);
}

}  // namespace
}  // namespace viewcover
