// Work in a process of its own that may crash, and what its parent does then.
#include "base/supervisor.hpp"

#include <csignal>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.hpp"

namespace moldlight {
namespace {

/// In the child, which must not go on with the tests: the end of its process.
[[noreturn]] void crash(int signal) {
  ::signal(signal, SIG_DFL);
  ::raise(signal);
  ::_exit(99);
}

TEST(Supervise, TheChildsCodeIsTheParents) {
  WorkRecord record;
  const Supervised supervised = supervise(record);
  if (!supervised.exit_code) ::_exit(supervised.forerunner ? 1 : 42);
  EXPECT_EQ(*supervised.exit_code, 42);
}

TEST(Supervise, TheNextChildIsToldOfACrashAndWhatWasNoted) {
  WorkRecord record;
  const Supervised supervised = supervise(record);
  if (!supervised.exit_code && !supervised.forerunner) {
    record.write("half");
    record.write(std::string("part\0work", 9));
    record.write(std::string(WorkRecord::k_most_bytes + 1, 'x'));
    crash(SIGKILL);
  }
  if (!supervised.exit_code) {
    const bool told = supervised.forerunner->cause.starts_with("killed") &&
                      supervised.forerunner->record == std::string("part\0work", 9);
    ::_exit(told ? 7 : 1);
  }
  EXPECT_EQ(*supervised.exit_code, 7);
}

TEST(Supervise, GivesUpAfterTwoCrashesAtOnce) {
  WorkRecord record;
  try {
    const Supervised supervised = supervise(record);
    if (!supervised.exit_code) crash(SIGABRT);
    FAIL() << "a code " << *supervised.exit_code;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("crashed twice, each time within 10 s of its start (abort)"),
              std::string::npos)
        << error.what();
  }
}

TEST(Supervise, ARequestToEndReachesTheChildAndIsNoCrash) {
  WorkRecord record;
  const Supervised supervised = supervise(record);
  if (!supervised.exit_code) {
    // As where all processes of the program are asked: this one directly, too.
    ::signal(SIGTERM, SIG_IGN);
    ::signal(SIGINT, [](int) { ::_exit(130); });
    ::kill(::getppid(), SIGTERM);
    for (;;) ::pause();
  }
  EXPECT_EQ(*supervised.exit_code, 130);
}

TEST(Supervise, AChildThatIsToldToEndDoesNotComeBack) {
  WorkRecord record;
  const Supervised supervised = supervise(record);
  if (!supervised.exit_code) crash(supervised.forerunner ? SIGKILL : SIGTERM);
  EXPECT_EQ(*supervised.exit_code, 128 + SIGTERM);
}

}  // namespace
}  // namespace moldlight
