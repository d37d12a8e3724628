#include "python/work.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <pthread.h>

#include "base/error.hpp"

namespace moldlight::python {

namespace {

/// A twentieth of the second within which an interrupt is to end the work.
constexpr std::chrono::milliseconds k_look_interval(50);

/// What the working thread passes to the one that waits.
class Watched {
 public:
  void report(std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    fraction_ = fraction;
    reported_ = true;
  }
  void end(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    failure_ = std::move(failure);
    ended_ = true;
    changed_.notify_all();
  }
  /// True once the work has ended, at the latest after the interval.
  [[nodiscard]] bool wait() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, k_look_interval, [this] { return ended_; });
  }
  void wait_for_end() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ended_; });
  }
  /// The newest report, once.
  [[nodiscard]] std::optional<std::pair<std::string, double>> take() {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(reported_, false)) return std::nullopt;
    return std::pair(stage_, fraction_);
  }
  [[nodiscard]] std::exception_ptr failure() const { return failure_; }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string stage_;
  double fraction_ = 0.0;
  bool reported_ = false, ended_ = false;
  std::exception_ptr failure_;
};

/// A thread that does one job after another, and waits without end for the next: TBB keeps memory for every
/// thread that computes with it, and gives little of it back when one ends.
class Worker {
 public:
  /// The job throws nothing.
  void start(std::function<void()> job) {
    const std::lock_guard lock(mutex_);
    job_ = std::move(job);
    changed_.notify_all();
  }
  /// Throws std::system_error where there can be no thread.
  [[nodiscard]] static Worker* make() {
    auto worker = std::make_unique<Worker>();
    std::thread([worker = worker.get()] { worker->run(); }).detach();
    return worker.release();
  }

 private:
  [[noreturn]] void run() {
    while (true) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return job_ != nullptr; });
      const std::function<void()> job = std::exchange(job_, nullptr);
      lock.unlock();
      job();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> job_;
};

/// The workers that have no job. A forked process has none of its parent's threads, so it begins with none.
/// They last as long as the process.
class IdleWorkers {
 public:
  static IdleWorkers& instance() {
    static std::once_flag once;
    std::call_once(once, [] {
      current = new IdleWorkers;
      ::pthread_atfork(nullptr, nullptr, [] { current = new IdleWorkers; });
    });
    return *current;
  }
  [[nodiscard]] Worker* take() {
    const std::lock_guard lock(mutex_);
    if (workers_.empty()) return Worker::make();
    Worker* worker = workers_.back();
    workers_.pop_back();
    return worker;
  }
  void give_back(Worker* worker) {
    const std::lock_guard lock(mutex_);
    workers_.push_back(worker);
  }

 private:
  static inline IdleWorkers* current = nullptr;
  std::mutex mutex_;
  std::vector<Worker*> workers_;
};

/// Calls the listener; false where it asks for an end. Throws what it or a signal's handler raises.
bool go_on(const py::object& listener, Watched& watched) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (listener.is_none()) return true;
  const auto report = watched.take();
  if (!report) return true;
  return listener(report->first, report->second).ptr() != Py_False;
}

}  // namespace

void check_listener(const py::object& listener) {
  if (!listener.is_none() && PyCallable_Check(listener.ptr()) == 0)
    throw UsageError("progress: not a function of a stage and the share that is done");
}

void watch(const py::object& listener, const std::function<void(const Progress&)>& work) {
  check_listener(listener);
  Watched watched;
  Progress progress([&watched](std::string_view stage, double fraction) { watched.report(stage, fraction); });
  std::exception_ptr raised;
  {
    const py::gil_scoped_release unlocked;
    Worker* worker = IdleWorkers::instance().take();
    worker->start([&] {
      std::exception_ptr failure;
      try {
        work(progress);
      } catch (...) {
        failure = std::current_exception();
      }
      watched.end(std::move(failure));
    });
    while (!watched.wait()) {
      const py::gil_scoped_acquire locked;
      try {
        if (!go_on(listener, watched)) progress.cancel();
      } catch (...) {
        raised = std::current_exception();
        progress.cancel();
        break;
      }
    }
    watched.wait_for_end();
    IdleWorkers::instance().give_back(worker);
  }
  if (raised) std::rethrow_exception(raised);
  if (watched.failure()) std::rethrow_exception(watched.failure());
}

}  // namespace moldlight::python
