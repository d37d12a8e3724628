// STEP files that are cut off, too much for the memory, or whose reading is ended from outside: one clear
// line, and no reading program left behind.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"
#include "support/step_text.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_mib = std::size_t{1} << 20;

class HostileStep : public testing::Test {
 protected:
  void SetUp() override {
    if (!MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "built without STEP support";
  }
  test::ScratchFolder folder_;
};

void expect_one_line(const test::ProcessResult& run, const std::string& about) {
  EXPECT_EQ(run.exit_code, 1) << about << ": " << run.err;
  EXPECT_EQ(run.error_lines(), 1u) << about << ": " << run.err;
  EXPECT_TRUE(run.err.starts_with("moldlight: ")) << about << ": " << run.err;
  EXPECT_EQ(run.out, "") << about;
}

/// A box doubled `levels` times by assemblies of assemblies: a small file that takes for ever.
std::string doubled_box(int levels) {
  test::StepText text;
  const std::size_t mm = text.context(test::StepUnit::mm);
  test::StepText::Product inner = text.box_product("box", {1, 2, 3}, mm);
  for (int level = 0; level < levels; ++level) {
    const test::StepText::Product outer = text.assembly("pair", mm);
    text.place(inner, outer, {.origin = {1, 0, 0}});
    text.place(inner, outer, {.origin = {0, 1, 0}});
    inner = outer;
  }
  return text.file();
}

/// The end mark makes the reading program see the cut.
TEST_F(HostileStep, CutAtAHundredPlacesEndsInOneLine) {
  const std::string whole = test::file_bytes(test::data_folder() / "pins_assembly_mm.step");
  constexpr std::size_t k_cuts = 100;
  for (std::size_t i = 0; i < k_cuts; ++i) {
    const std::size_t length = 1 + whole.size() * i / k_cuts + i % 7;
    const std::string name = folder_.write("cut.step", whole.substr(0, length));
    expect_one_line(test::run_moldlight({"info", name}), "cut at " + std::to_string(length));
    const std::string ended =
        folder_.write("cut.step", whole.substr(0, length) + "\nENDSEC;\nEND-ISO-10303-21;\n");
    const auto run = test::run_moldlight({"info", ended});
    const bool warned = run.exit_code == 0 && run.out.find("warning: ") != std::string::npos;
    if (!warned) expect_one_line(run, "ended at " + std::to_string(length));
  }
}

/// OpenCASCADE leaves out the faces for which it gets no memory; the part must be whole or refused.
TEST_F(HostileStep, IsWholeOrRefusedUnderALimitOfMemory) {
  if (test::built_with_sanitizers()) GTEST_SKIP() << "sanitizers need memory of their own";
  // Fine enough for some 100 MiB of memory, in a second.
  const std::vector<std::string> info = {"info", (test::data_folder() / "pins_assembly_mm.step").string(),
                                         "--angular-deflection", "0.3"};
  const auto whole = test::run_moldlight(info);
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  std::size_t refused = 0, read = 0;
  for (const std::size_t mib : {90, 100, 120, 140, 160, 250, 500}) {
    test::ProcessSettings settings;
    settings.address_space_limit = mib * k_mib;
    const auto run = test::run_moldlight(info, settings);
    if (run.exit_code == 0) {
      ++read;
      EXPECT_EQ(run.out, whole.out) << mib << " MiB";
    } else if (run.exit_code != 127) {  // the program itself cannot be loaded
      ++refused;
      expect_one_line(run, std::to_string(mib) + " MiB");
      EXPECT_NE(run.err.find("memory"), std::string::npos) << run.err;
    }
  }
  EXPECT_GT(refused, 0u);
  EXPECT_GT(read, 0u);
}

TEST_F(HostileStep, OnStdinIsReadFromTheFileBehindIt) {
  const std::string part = (test::data_folder() / "pins_assembly_mm.step").string();
  const auto with_stdin = [&](const std::string& shell) {
    return test::Process({"/bin/sh", "-c", shell, "sh", MOLDLIGHT_BINARY, part}, {}).finish();
  };
  const auto file = with_stdin("exec \"$1\" info /dev/stdin <\"$2\"");
  EXPECT_EQ(file.exit_code, 0) << file.err;
  expect_one_line(with_stdin("cat \"$2\" | \"$1\" info /dev/stdin"), "a pipe");
}

/// A reader that a file has taken over hands back without end.
TEST_F(HostileStep, WhatComesBackIsBounded) {
  const fs::path program = folder_.path() / "moldlight";
  fs::copy_file(MOLDLIGHT_BINARY, program);
  const fs::path reader = folder_.write("moldlight-step", "#!/bin/sh\nexec cat /dev/zero >&3\n");
  fs::permissions(reader, fs::perms::owner_all);
  const std::string part = (test::data_folder() / "pins_assembly_mm.step").string();
  test::ProcessSettings settings;
  settings.address_space_limit = 500 * k_mib;
  const auto run = test::Process({program.string(), "info", part, "--max-facets", "1000"}, settings).finish();
  expect_one_line(run, "zeros without end");
  EXPECT_NE(run.err.find("breaks the STEP reader"), std::string::npos) << run.err;
}

pid_t child_of(pid_t parent) {
  std::error_code ignored;
  for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(parent) + "/task", ignored)) {
    std::ifstream children(thread.path() / "children");
    if (pid_t child = 0; children >> child) return child;
  }
  return 0;
}

/// False for a program that has ended, even if nobody has asked how.
bool is_running(pid_t program) {
  return !test::file_bytes("/proc/" + std::to_string(program) + "/cmdline").empty();
}

template <typename Condition>
bool comes_true(const Condition& condition, std::chrono::seconds within) {
  const auto deadline = std::chrono::steady_clock::now() + within;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// moldlight and its reading program in the midst of a file that takes for ever.
class LongStep : public HostileStep {
 protected:
  void SetUp() override {
    HostileStep::SetUp();
    if (IsSkipped()) return;
    const std::string part = folder_.write("doubled.step", doubled_box(24));
    process_ = std::make_unique<test::Process>(std::vector<std::string>{MOLDLIGHT_BINARY, "info", part},
                                               test::ProcessSettings{});
    const auto started = [&] {
      reader_ = child_of(process_->id());
      return test::file_bytes("/proc/" + std::to_string(reader_) + "/comm") == "moldlight-step\n";
    };
    ASSERT_TRUE(comes_true(started, std::chrono::seconds(20)));
  }

  /// Expects that the signal ends both before they have used the processor for two seconds.
  test::ProcessResult end_by(int signal) {
    constexpr double k_most_s = 2.0;
    const double before = test::processor_seconds(process_->id()),
                 read_before = test::processor_seconds(reader_);
    process_->send_signal(signal);
    test::ProcessResult run = process_->finish();
    EXPECT_LT(run.processor_s - before - read_before, k_most_s);
    EXPECT_TRUE(comes_true(
        [&] {
          EXPECT_LT(test::processor_seconds(reader_) - read_before, k_most_s);
          return !is_running(reader_);
        },
        std::chrono::seconds(20)));
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_.path())) ++entries;
    EXPECT_EQ(entries, 1u);
    return run;
  }

  std::unique_ptr<test::Process> process_;
  pid_t reader_ = 0;
};

TEST_F(LongStep, ReadsAnOpenFileBehindAFilter) {
  const std::string folder = "/proc/" + std::to_string(reader_);
  const auto filtered = [&] {
    return test::file_bytes(folder + "/status").find("Seccomp:\t2\n") != std::string::npos;
  };
  EXPECT_TRUE(comes_true(filtered, std::chrono::seconds(20)));
  EXPECT_EQ(fs::read_symlink(folder + "/fd/4").filename(), "doubled.step");
  EXPECT_EQ(test::file_bytes(folder + "/cmdline").find("doubled.step"), std::string::npos);
}

TEST_F(LongStep, EndsWithItsReaderAtAnInterrupt) {
  for (const int signal : {SIGINT, SIGTERM}) {
    if (signal == SIGTERM) SetUp();
    const auto run = end_by(signal);
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_EQ(run.err, "moldlight: interrupted\n");
  }
}

TEST_F(LongStep, EndsItsReaderWhenItIsKilled) { EXPECT_EQ(end_by(SIGKILL).exit_code, 128 + SIGKILL); }

TEST_F(LongStep, SaysWhatEndedItsReader) {
  const std::pair<int, std::string> ends[] = {{SIGKILL, "the system's limits of memory and time (signal 9)"},
                                              {SIGXCPU, "the system's limits of memory and time (signal 24)"},
                                              {SIGSEGV, "breaks the STEP reader OpenCASCADE (signal 11)"}};
  for (const auto& [signal, words] : ends) {
    if (signal != SIGKILL) SetUp();
    ::kill(reader_, signal);
    const auto run = process_->finish();
    expect_one_line(run, words);
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
}

TEST_F(LongStep, IsInterruptedByATermThatOnlyItsReaderHears) {
  ::kill(reader_, SIGTERM);
  const auto run = process_->finish();
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_EQ(run.err, "moldlight: interrupted\n");
}

}  // namespace
}  // namespace moldlight
