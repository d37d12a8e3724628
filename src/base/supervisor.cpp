#include "base/supervisor.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <new>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/stopwatch.hpp"

namespace moldlight {

namespace {

/// A child that lives no longer would most likely die again.
constexpr double k_soon_s = 10.0;
constexpr int k_died_within = 2;  // so often before it is given up

const char* name_of(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "segmentation fault";
    case SIGBUS:
      return "bus error";
    case SIGFPE:
      return "arithmetic fault";
    case SIGILL:
      return "illegal instruction";
    case SIGABRT:
      return "abort";
    case SIGKILL:
      return "killed, as where memory runs out";
    default:
      return "a signal";
  }
}

class BlockedSignals {
 public:
  BlockedSignals() {
    sigemptyset(&waited_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&waited_, signal);
    ::sigprocmask(SIG_BLOCK, &waited_, &former_);
  }
  ~BlockedSignals() { ::sigprocmask(SIG_SETMASK, &former_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

  [[nodiscard]] int wait() const {
    int signal = -1;
    while (signal < 0) signal = ::sigwaitinfo(&waited_, nullptr);
    return signal;
  }

 private:
  sigset_t waited_{}, former_{};
};

[[nodiscard]] bool is_ignored(int signal) {
  struct sigaction action = {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// The signal that asks the child for the same. Who asks all processes of this name reaches the child, too:
/// two of one kind would end it at once.
[[nodiscard]] int handed_on(int signal) {
  const int other = signal == SIGINT ? SIGTERM : SIGINT;
  return is_ignored(other) ? signal : other;
}

/// What is the child's alone, right after the fork.
void become_worker(pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::raise(SIGTERM);
  // Where memory runs short, the work goes rather than the one that reports it.
  if (const int score = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0) {
    static_cast<void>(!::write(score, "500", 3));
    ::close(score);
  }
}

/// Hands requests to end on until the child has ended; its status as of waitpid().
int status_at_end(pid_t child, const BlockedSignals& signals, bool& asked) {
  while (true) {
    int status = 0;
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return status;
    if (ended < 0 && errno != EINTR)
      throw Error(fmt::format("waiting for the working process: {}", std::strerror(errno)));
    const int signal = signals.wait();
    if (signal == SIGCHLD || is_ignored(signal)) continue;
    asked = true;
    ::kill(child, handed_on(signal));
  }
}

}  // namespace

/// Two texts, one of which counts: the other may be half written.
struct WorkRecord::Shared {
  std::atomic<std::uint32_t> current;
  std::array<std::uint32_t, 2> sizes;
  std::array<std::array<char, k_most_bytes>, 2> texts;
};

WorkRecord::WorkRecord() {
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
  void* const memory =
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw Error(fmt::format("no shared memory: {}", std::strerror(errno)));
  shared_ = new (memory) Shared{};
}

WorkRecord::~WorkRecord() { ::munmap(shared_, sizeof(Shared)); }

void WorkRecord::write(std::string_view text) {
  if (text.size() > k_most_bytes) return;
  const std::uint32_t next = 1 - shared_->current.load();
  std::memcpy(shared_->texts[next].data(), text.data(), text.size());
  shared_->sizes[next] = static_cast<std::uint32_t>(text.size());
  shared_->current.store(next);
}

std::string WorkRecord::text() const {
  // A process that went wrong may have written here, too.
  const std::uint32_t current = shared_->current.load() & 1U;
  const std::size_t size = std::min<std::size_t>(shared_->sizes[current], k_most_bytes);
  return {shared_->texts[current].data(), size};
}

Supervised supervise(WorkRecord& record) {
  std::optional<WorkerDeath> forerunner;
  int soon = 0;
  while (true) {
    const pid_t parent = ::getpid();
    const Stopwatch life;
    std::optional<BlockedSignals> signals(std::in_place);
    const pid_t child = ::fork();
    if (child < 0) throw Error(fmt::format("no process to work in: {}", std::strerror(errno)));
    if (child == 0) {
      become_worker(parent);
      signals.reset();
      return {.exit_code = std::nullopt, .forerunner = std::move(forerunner)};
    }
    bool asked = false;
    const int status = status_at_end(child, *signals, asked);
    if (WIFEXITED(status)) return {.exit_code = WEXITSTATUS(status), .forerunner = {}};
    const int signal = WTERMSIG(status);
    if (asked || signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
      return {.exit_code = 128 + signal, .forerunner = {}};
    forerunner = {.cause = name_of(signal), .record = record.text()};
    soon = life.elapsed_ms() < 1000.0 * k_soon_s ? soon + 1 : 0;
    if (soon == k_died_within)
      throw Error(fmt::format("the program crashed twice, each time within {:.0f} s of its start ({})",
                              k_soon_s, forerunner->cause));
  }
}

}  // namespace moldlight
