// Batches that are stopped, killed, run twice at once, or find no room on the disk: what is done stays,
// nothing is done by halves, and the same command goes on.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/small_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using test::SmallParts;

std::vector<std::string> run_arguments(const SmallParts& parts) {
  return {MOLDLIGHT_BINARY, "batch", "run", parts.path("night")};
}

std::size_t result_count(const SmallParts& parts) {
  std::size_t count = 0;
  if (!fs::exists(parts.path("night/results"))) return 0;
  for (const auto& entry : fs::recursive_directory_iterator(parts.path("night/results")))
    if (entry.path().extension() == ".json") ++count;
  return count;
}

void wait_for_results(const SmallParts& parts, std::size_t count) {
  for (int k = 0; k < 3000 && result_count(parts) < count; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

/// Leftovers of killed runs are temporary files alone.
std::size_t temporary_files(const SmallParts& parts) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(parts.path("night")))
    if (entry.path().filename().string().starts_with(".moldlight-")) ++count;
  return count;
}

class BatchSignal : public testing::TestWithParam<int> {};

TEST_P(BatchSignal, LosesThePartInFlightAlone) {
  const SmallParts parts(200);
  ASSERT_EQ(parts.plan().exit_code, 0);
  test::Process process(run_arguments(parts), {});
  wait_for_results(parts, 5);
  process.send_signal(GetParam());
  const auto result = process.finish();
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_NE(result.err.find("interrupted; the same command continues"), std::string::npos) << result.err;
  const auto kept = parts.results();
  EXPECT_GE(kept.size(), 5u);
  EXPECT_LT(kept.size(), 200u);
  for (const auto& [name, part] : kept) EXPECT_EQ(part["outcome"], "done") << name;
  EXPECT_EQ(temporary_files(parts), 0u);
  EXPECT_EQ(parts.batch("run").exit_code, 0);
  EXPECT_EQ(parts.results().size(), 200u);
}

INSTANTIATE_TEST_SUITE_P(Signals, BatchSignal, testing::Values(SIGINT, SIGTERM),
                         [](const auto& signal) { return signal.param == SIGINT ? "Int" : "Term"; });

TEST(BatchKilled, ManyTimesEveryPartIsThereOnceAndAsUndisturbed) {
  const SmallParts parts(300);
  parts.add("junk.stl", "junk");
  ASSERT_EQ(parts.plan().exit_code, 0);
  ASSERT_EQ(parts.plan("parts", "calm").exit_code, 0);
  ASSERT_EQ(parts.batch("run", {}, "calm").exit_code, 0);
  const auto undisturbed = parts.results("calm");
  ASSERT_EQ(undisturbed.size(), 301u);
  std::mt19937 random(1);
  int killed = 0;
  for (int round = 0; round < 20; ++round) {
    test::Process process(run_arguments(parts), {});
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 150));
    process.send_signal(SIGKILL);
    if (process.finish().exit_code == 128 + SIGKILL) ++killed;
  }
  EXPECT_GE(killed, 3);
  EXPECT_EQ(parts.batch("run").exit_code, 0);
  EXPECT_EQ(parts.results(), undisturbed);
  // No lock is left behind: what is left are temporary files, and few.
  EXPECT_LE(temporary_files(parts), static_cast<std::size_t>(killed) * std::thread::hardware_concurrency());
}

TEST(BatchTwice, TwoRunsAtOnceShareTheWork) {
  const SmallParts parts(150);
  ASSERT_EQ(parts.plan().exit_code, 0);
  test::Process first(run_arguments(parts), {}), second(run_arguments(parts), {});
  const auto one = first.finish(), two = second.finish();
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(two.exit_code, 0) << two.err;
  EXPECT_EQ(parts.results().size(), 150u);
  EXPECT_EQ(parts.status()["done"], 150);
  EXPECT_EQ(temporary_files(parts), 0u);
}

TEST(BatchChild, ThatIsKilledFromOutsideIsTriedAgain) {
  const SmallParts parts(0);
  const test::SmallPart cup;
  parts.add("cup.obj", test::file_bytes(cup.file()));
  ASSERT_EQ(parts
                .plan("parts", "night",
                      {"classify", "--direction", "z", "--readout", "samples", "--samples", "3000000"})
                .exit_code,
            0);
  test::Process process(run_arguments(parts), {});
  const std::string children = "/proc/" + std::to_string(process.id()) + "/task";
  pid_t child = 0;
  for (int k = 0; k < 1000 && child == 0; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::error_code ignored;
    for (const auto& task : fs::directory_iterator(children, ignored)) {
      const std::string list = test::file_bytes(task.path() / "children");
      if (!list.empty()) child = std::stoi(list);
    }
  }
  if (child == 0) GTEST_SKIP() << "this kernel does not list the children of a process";
  ASSERT_EQ(::kill(child, SIGKILL), 0);
  const auto run = process.finish();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto results = parts.results();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results.begin()->second["outcome"], "done");
  EXPECT_EQ(results.begin()->second["tries"], 2);
}

TEST(BatchDisk, ThatTakesNoMoreEndsTheRunWithTryAgain) {
  const SmallParts parts(20);
  ASSERT_EQ(parts.plan().exit_code, 0);
  test::ProcessSettings small;
  small.file_size_limit = 200;  // bytes, less than a result
  const auto run = parts.batch("run", {}, "night", small);
  EXPECT_EQ(run.exit_code, 75) << run.err;
  EXPECT_NE(run.err.find("cannot be written"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("try again"), std::string::npos) << run.err;
  EXPECT_TRUE(parts.results().empty());
  EXPECT_EQ(temporary_files(parts), 0u);
  EXPECT_EQ(parts.batch("run").exit_code, 0);
  EXPECT_EQ(parts.results().size(), 20u);
}

}  // namespace
}  // namespace moldlight
