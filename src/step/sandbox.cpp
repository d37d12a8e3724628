#include "step/sandbox.hpp"

#include <cstring>
#include <memory>

#include <seccomp.h>

#include "io/step_result.hpp"

namespace moldlight::step {

/// Memory, time and the end; nothing that names a file, an address or a process.
constexpr int k_allowed[] = {
    SCMP_SYS(brk),         SCMP_SYS(mmap),          SCMP_SYS(mremap),       SCMP_SYS(munmap),
    SCMP_SYS(mprotect),    SCMP_SYS(madvise),       SCMP_SYS(futex),        SCMP_SYS(read),
    SCMP_SYS(readv),       SCMP_SYS(pread64),       SCMP_SYS(lseek),        SCMP_SYS(fstat),
    SCMP_SYS(close),       SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday), SCMP_SYS(getrusage),
    SCMP_SYS(times),       SCMP_SYS(getrandom),     SCMP_SYS(sched_yield),  SCMP_SYS(getpid),
    SCMP_SYS(gettid),      SCMP_SYS(rt_sigaction),  SCMP_SYS(rt_sigreturn), SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(sigaltstack), SCMP_SYS(exit),          SCMP_SYS(exit_group)};

std::string give_up_rights() {
  const auto failed = [](const char* what, int error) {
    return std::string("is not read, since the reading program cannot be shut in (") + what + ": " +
           std::strerror(-error) + "); allow seccomp";
  };
  const std::unique_ptr<void, void (*)(void*)> filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release);
  if (!filter) return failed("seccomp_init", -ENOMEM);
  for (const int call : k_allowed) {
    if (const int error = seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, call, 0); error != 0)
      return failed("seccomp_rule_add", error);
  }
  // The result's descriptor alone may be written to.
  if (const int error = seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(write), 1,
                                         SCMP_A0(SCMP_CMP_EQ, k_step_result_descriptor));
      error != 0)
    return failed("seccomp_rule_add", error);
  // One's own limits may be read, not set.
  if (const int error =
          seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), 1, SCMP_A2(SCMP_CMP_EQ, 0));
      error != 0)
    return failed("seccomp_rule_add", error);
  if (const int error = seccomp_load(filter.get()); error != 0) return failed("seccomp_load", error);
  return {};
}

}  // namespace moldlight::step
