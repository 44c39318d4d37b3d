#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

/// Exact visibility, saved as often as can be, and regions.
std::vector<std::string> arguments(const RoomFolder& room, const std::string& bundle,
                                   std::vector<std::string> more = {}) {
  std::vector<std::string> all = {
      VIEWCOVER_BINARY, "solve",     room.scene(), "--region",     room.region(), "-o",
      bundle,           "--threads", "2",          "--checkpoint", "0",           "--quiet"};
  if (std::ranges::find(more, "--regions") == more.end()) {
    more.insert(more.end(), {"--regions", "16", "--element-area", "0.5", "--viewpoints", "none"});
  }
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::size_t saved_files(const std::string& bundle) {
  std::size_t count = 0;
  std::error_code none;
  for ([[maybe_unused]] const auto& entry :
       std::filesystem::directory_iterator(bundle + "/checkpoint", none)) {
    ++count;
  }
  return count;
}

/// Kills the process once it has run for so long. False if it had ended.
bool kill_after(Process& process, double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const bool was_running = process.running();
  process.signal(SIGKILL);
  process.wait();
  return was_running;
}

/// Kills the process when it has saved so many times.
void kill_at_save(Process& process, const std::string& bundle, std::size_t saves) {
  while (process.running() && saved_files(bundle) < saves) ::usleep(200);
  ASSERT_TRUE(process.running());
  process.signal(SIGKILL);
  process.wait();
}

TEST(Resume, AfterKillsAtAnyMomentTheBundleIsTheSame) {
  const RoomFolder room;
  const auto start = std::chrono::steady_clock::now();
  Process whole(arguments(room, room.bundle("whole")));
  ASSERT_EQ(whole.wait(), 0) << whole.error();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto expected = comparable_files(room.bundle("whole"));

  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> moment(0, seconds);
  const char* const asked = std::getenv("VIEWCOVER_KILLS");
  const int kills = asked != nullptr ? std::atoi(asked) : 6;
  int killed = 0, continued = 0;
  for (int i = 0; i < kills; ++i) {
    SCOPED_TRACE(i);
    const std::string bundle = room.bundle("killed");
    std::filesystem::remove_all(bundle);
    Process first(arguments(room, bundle));
    killed += kill_after(first, moment(random));
    // Now and then the one that continues is killed as well.
    if (i % 3 == 0) {
      Process second(arguments(room, bundle, {"--resume"}));
      killed += kill_after(second, moment(random));
    }
    continued += saved_files(bundle) > 0;
    Process last(arguments(room, bundle, {"--resume"}));
    EXPECT_EQ(last.wait(), 0) << last.error();
    EXPECT_EQ(comparable_files(bundle), expected);
    EXPECT_EQ(last_line(last.out()).substr(0, 60), last_line(whole.out()).substr(0, 60));
  }
  std::cout << killed << " kills in runs of " << seconds << " s, " << continued
            << " times visibility went on from a checkpoint\n";
  EXPECT_GT(killed, 0);
}

TEST(Resume, AfterAKillDuringTheSearchForViewpointsTheBundleIsTheSame) {
  const RoomFolder room;
  const std::vector<std::string> small = {"--regions", "4", "--element-area", "4"};
  Process whole(arguments(room, room.bundle("whole"), small));
  ASSERT_EQ(whole.wait(), 0) << whole.error();
  const Json seconds = run_json(room.bundle("whole")).at("measured").at("seconds");
  const std::string bundle = room.bundle();
  Process first(arguments(room, bundle, small));
  const double visibility = seconds.at("visibility"), viewpoints = seconds.at("viewpoints");
  ASSERT_TRUE(kill_after(first, visibility + 0.5 * viewpoints));
  EXPECT_GT(saved_files(bundle), 0u);
  std::vector<std::string> resumed = small;
  resumed.emplace_back("--resume");
  Process last(arguments(room, bundle, resumed));
  EXPECT_EQ(last.wait(), 0) << last.error();
  EXPECT_EQ(comparable_files(bundle), comparable_files(room.bundle("whole")));
}

TEST(Resume, GoesOnFromTheLastSaveAndWithWhatIsLeftHalfWritten) {
  const RoomFolder room;
  Process whole(arguments(room, room.bundle("whole")));
  ASSERT_EQ(whole.wait(), 0) << whole.error();
  const std::string bundle = room.bundle();
  Process first(arguments(room, bundle));
  kill_at_save(first, bundle, 5);
  const std::string first_save = read_file(bundle + "/checkpoint/links-000000");
  std::ofstream(bundle + "/.part.links.csv") << "region,elem";
  Process second(arguments(room, bundle, {"--resume"}));
  kill_at_save(second, bundle, 10);
  // The second run added to the first one's.
  EXPECT_EQ(read_file(bundle + "/checkpoint/links-000000"), first_save);
  EXPECT_FALSE(is_complete(bundle));
  Process last(arguments(room, bundle, {"--resume"}));
  EXPECT_EQ(last.wait(), 0) << last.error();
  EXPECT_EQ(comparable_files(bundle), comparable_files(room.bundle("whole")));
}

TEST(Resume, StartsARunWhereThereIsNoneAndLeavesACompleteOne) {
  const RoomFolder room;
  const Outcome started = room.solve("bundle", {"--resume", "--quiet"});
  ASSERT_EQ(started.exit_code, 0) << started.error;
  const std::string record = read_file(room.bundle() + "/run.json");
  const Outcome again = room.solve("bundle", {"--resume"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.error, HasSubstr("complete; nothing is left"));
  EXPECT_EQ(again.out, started.out);
  EXPECT_EQ(read_file(room.bundle() + "/run.json"), record);
}

TEST(Resume, RefusesAnotherRunAndDamage) {
  const RoomFolder room;
  const std::string bundle = room.bundle();
  Process first(arguments(room, bundle));
  kill_at_save(first, bundle, 2);
  const auto refused = [&](std::vector<std::string> more, const std::string& reason) {
    more.emplace_back("--resume");
    std::vector<std::string> all = arguments(room, bundle, more);
    expect_refused(viewcover_run({all.begin() + 1, all.end()}), reason);
    EXPECT_GE(saved_files(bundle), 2u);
  };
  refused({"--seed", "2"}, "differs in seed");
  refused({"--clearance", "0.01"}, "differs in options.clearance");
  refused({"--heal", "1e-9"}, "differs in options.heal");
  const std::string save = bundle + "/checkpoint/links-000001", text = read_file(save);
  std::ofstream(save) << text.substr(0, text.size() - 1);
  refused({}, "links-000001: is damaged");
  std::ofstream(save) << "links";
  refused({}, "links-000001: is damaged");
  std::ofstream(bundle + "/run.json") << "{";
  refused({}, "run.json: is no JSON object");
  // Without --resume it starts anew, whatever is there.
  Process anew(arguments(room, bundle));
  EXPECT_EQ(anew.wait(), 0) << anew.error();
  EXPECT_EQ(saved_files(bundle), 0u);
}

TEST(MemoryLimit, EndsTheRunWithOneLineAndTheRestCanBeDoneLater) {
  const RoomFolder room;
  const std::vector<std::string> large = {"--regions", "4096", "--element-area", "0.001",
                                          "--quiet"};
  std::vector<std::string> limited = large;
  limited.insert(limited.end(), {"--memory-limit", "150M"});
  expect_refused(room.solve("bundle", limited), "--memory-limit: reached");
  EXPECT_FALSE(is_complete(room.bundle()));
  const Outcome roomy = room.solve("small", {"--memory-limit", "8G", "--quiet"});
  EXPECT_EQ(roomy.exit_code, 0) << roomy.error;
  for (const char* size : {"8", "8X", "-1G", "1e300G", "G", "nan"}) {
    SCOPED_TRACE(size);
    expect_refused(room.solve("bundle", {"--memory-limit", size}), "--memory-limit: '");
  }
}

TEST(Solve, ATerminatedRunCanBeContinued) {
  const RoomFolder room;
  Process process(arguments(room, room.bundle()));
  while (process.running() && saved_files(room.bundle()) < 3) ::usleep(200);
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(), 130);
  EXPECT_THAT(process.error(), HasSubstr("--resume continues it"));
  EXPECT_EQ(run_json(room.bundle()).at("measured").at("ended"), "interrupted");
  Process last(arguments(room, room.bundle(), {"--resume"}));
  EXPECT_EQ(last.wait(), 0) << last.error();
}

}  // namespace
}  // namespace viewcover::testing
