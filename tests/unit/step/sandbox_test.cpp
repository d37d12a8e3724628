// What is left to moldlight-step once it has given up its rights.
#include "step/sandbox.hpp"

#include <cerrno>
#include <cstdlib>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/step_result.hpp"
#include "support/process.hpp"

namespace moldlight::step {
namespace {

/// What a call did in a child that has given its rights up: 0, or its errno.
template <typename Call>
int without_rights(const Call& call) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(k_step_result_descriptor);  // what the test was started with
    if (!give_up_rights().empty()) ::_exit(255);
    ::_exit(call() < 0 ? errno : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 254;
}

TEST(Sandbox, LeavesNothingButComputing) {
  if (test::built_with_sanitizers()) GTEST_SKIP() << "sanitizers have threads of their own";
  EXPECT_EQ(without_rights([] { return ::open("/etc/passwd", O_RDONLY); }), EPERM);
  EXPECT_EQ(without_rights([] { return ::open("made", O_CREAT | O_WRONLY, 0600); }), EPERM);
  EXPECT_EQ(without_rights([] { return ::unlink("made"); }), EPERM);
  EXPECT_EQ(without_rights([] { return ::socket(AF_INET, SOCK_STREAM, 0); }), EPERM);
  EXPECT_EQ(without_rights([] { return ::fork(); }), EPERM);
  EXPECT_EQ(without_rights([] { return ::kill(::getppid(), 0); }), EPERM);
  EXPECT_EQ(without_rights([] { return ::execl("/bin/true", "true", nullptr); }), EPERM);
  EXPECT_EQ(without_rights([] { return ::write(STDOUT_FILENO, "no", 2); }), EPERM);
  EXPECT_EQ(without_rights([] { return ::write(k_step_result_descriptor, "", 0); }), EBADF);
  EXPECT_EQ(without_rights([] { return std::malloc(std::size_t{1} << 26) == nullptr ? -1 : 0; }), 0);
}

}  // namespace
}  // namespace moldlight::step
