#include "cli/interrupt.hpp"

#include <atomic>
#include <csignal>

#include "base/check.hpp"

namespace moldlight::cli {

namespace {

// A signal handler can reach nothing but what is global.
std::atomic<Progress*> interrupted_progress = nullptr;
static_assert(std::atomic<Progress*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void cancel_progress(int) {
  if (Progress* progress = interrupted_progress.load()) progress->cancel();
}

}  // namespace

InterruptGuard::InterruptGuard(Progress& progress) {
  CHECK(interrupted_progress.exchange(&progress) == nullptr);
  struct sigaction action = {};
  action.sa_handler = cancel_progress;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction former = {};
    // Who started the program may want it to outlive an interrupt (nohup, a background job).
    if (sigaction(signal, nullptr, &former) == 0 && former.sa_handler != SIG_IGN) {
      sigaction(signal, &action, nullptr);
    }
  }
}

InterruptGuard::~InterruptGuard() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction former = {};
    if (sigaction(signal, nullptr, &former) == 0 && former.sa_handler == cancel_progress) {
      std::signal(signal, SIG_DFL);
    }
  }
  interrupted_progress.store(nullptr);
}

}  // namespace moldlight::cli
