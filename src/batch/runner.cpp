#include "batch/runner.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <random>
#include <semaphore>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "batch/part_work.hpp"
#include "batch/store.hpp"
#include "classify/json.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

/// A row that has something to be done.
struct Job {
  Row row;
  Digest key{};
  bool settled = false;  // its result is there; what is to lie beside it is not
};

std::vector<Beside> besides_of(const RunSettings& settings) {
  std::vector<Beside> besides;
  if (settings.thumbnails) besides.push_back(Beside::picture);
  if (settings.reports || settings.live)
    besides.push_back(settings.live ? Beside::live_report : Beside::report);
  return besides;
}

/// What the slots of a run share.
class Slots {
 public:
  Slots(const Manifest& manifest, const RunSettings& settings, const std::string& parts, RunCounts& counts,
        const RunListener& listener, const Progress& progress)
      : manifest_(manifest),
        settings_(settings),
        parts_(parts),
        counts_(counts),
        listener_(listener),
        progress_(progress),
        stop_(&progress),
        store_(manifest.folder) {
    const int cores = usable_cores();
    processes_ = settings.processes > 0 ? settings.processes : cores;
    free_.release(processes_);
    work_.limits = {.time_s = settings.part_time_s,
                    .memory_bytes = static_cast<std::size_t>(settings.part_memory_mb) << 20,
                    .threads = std::max(1, cores / processes_)};
    work_.retries = settings.retries;
    besides_ = besides_of(settings);
  }

  /// Works through the jobs; ends early where asked to or where nothing can be stored.
  void work_through(std::vector<Job> jobs) {
    jobs_ = std::move(jobs);
    // Runs that begin together are not to do the same parts at the same time.
    std::random_device random;
    first_ = jobs_.empty() ? 0 : random() % jobs_.size();
    // While one thread waits for the disk, another has its process.
    const std::size_t wanted = std::min(2 * static_cast<std::size_t>(processes_), jobs_.size());
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < wanted; ++k) threads.emplace_back([this] { work(); });
    // Whoever waits is shown how far it is.
    while (ended_ < wanted) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      if (progress_.cancelled()) continue;
      const double share = static_cast<double>(next_) / static_cast<double>(jobs_.size());
      try {
        progress_.report("working", std::min(share, 1.0));
      } catch (const Cancelled&) {  // the slots see it, too
      }
    }
  }

  [[nodiscard]] std::size_t unreachable() const { return unreachable_; }
  [[nodiscard]] std::size_t ended_from_outside() const { return ended_from_outside_; }
  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] const std::string& unreachable_example() const { return unreachable_example_; }

 private:
  void work() {
    try {
      for (std::size_t k = next_++; k < jobs_.size() && !stop_.cancelled(); k = next_++)
        do_job(jobs_[(first_ + k) % jobs_.size()]);
    } catch (const Cancelled&) {  // the part in flight stays undone
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex_);
      if (error_.empty()) error_ = error.what();
      stop_.cancel();
    }
    ++ended_;
  }

  /// A process at a time; of them there are no more than `processes_`.
  template <typename Work>
  auto in_turn(const Work& work) {
    free_.acquire();
    const struct Release {
      std::counting_semaphore<>& free;
      ~Release() { free.release(); }
    } release{free_};
    if (stop_.cancelled()) throw Cancelled();
    return work();
  }

  /// Nothing where another run was faster.
  std::optional<WorkOutcome> work_on_part(const Job& job, const std::string& file) {
    const ResultState now = store_.state(job.key);
    if (now == ResultState::done || (now == ResultState::failed && !settings_.retry_failed))
      return std::nullopt;
    return work_on(manifest_, job.row, file, work_, stop_);
  }

  void do_job(const Job& job) {
    const std::string file = (fs::path(parts_) / job.row.path).string();
    if (job.settled) {
      const auto result = store_.read(job.key, ResultState::done);
      if (result) make_besides(job, file, *result);
      return;
    }
    const auto outcome = in_turn([&] { return work_on_part(job, file); });
    if (!outcome) {
      ++counts_.elsewhere;
      return;
    }
    switch (outcome->end) {
      case WorkEnd::done:
        store_.put(job.key, ResultState::done, outcome->result);
        ++counts_.done;
        warn_off_axis(job, outcome->result);
        make_besides(job, file, outcome->result);
        break;
      case WorkEnd::failed: {
        store_.put(job.key, ResultState::failed, outcome->result);
        ++counts_.failed;
        const std::lock_guard lock(mutex_);
        if (listener_.failed) listener_.failed(job.row.path, outcome->reason);
        break;
      }
      case WorkEnd::unreachable: {
        const std::lock_guard lock(mutex_);
        if (unreachable_++ == 0) unreachable_example_ = fmt::format("{}: {}", file, outcome->reason);
        break;
      }
      case WorkEnd::ended:
        ++ended_from_outside_;
        break;
    }
  }

  void warn_off_axis(const Job& job, const Json& result) {
    static const Json::json_pointer k_sentence("/report/best_direction/off_axis");
    if (!result.contains(k_sentence) || !result.at(k_sentence).is_string()) return;
    const std::lock_guard lock(mutex_);
    if (listener_.off_axis) listener_.off_axis(job.row.path, result.at(k_sentence).get<std::string>());
  }

  void make_besides(const Job& job, const std::string& file, const Json& result) {
    const auto report = result.find("report");
    if (report == result.end()) return;
    for (const Beside what : besides_) {
      if (store_.has(job.key, what)) continue;
      const std::string why = in_turn([&] {
        return make_beside(manifest_, job.row, file, *report, what, store_.beside(job.key, what),
                           work_.limits, stop_);
      });
      const std::lock_guard lock(mutex_);
      if (!why.empty() && listener_.warning)
        listener_.warning(
            fmt::format("{}: no {}: {}", job.row.path, what == Beside::picture ? "picture" : "report", why));
    }
  }

  const Manifest& manifest_;
  const RunSettings& settings_;
  const std::string& parts_;
  RunCounts& counts_;
  const RunListener& listener_;
  const Progress& progress_;
  Progress stop_;
  ResultStore store_;
  int processes_ = 1;
  std::counting_semaphore<> free_{0};  // processes that may be started
  WorkSettings work_;
  std::vector<Beside> besides_;
  std::vector<Job> jobs_;
  std::size_t first_ = 0;
  std::atomic<std::size_t> next_ = 0, ended_ = 0, ended_from_outside_ = 0;
  std::size_t unreachable_ = 0;
  std::string unreachable_example_, error_;
  std::mutex mutex_;
};

}  // namespace

std::span<const Option<RunSettings>> run_options() {
  using S = RunSettings;
  static const std::vector<Option<S>> k_options = {
      {"processes", "--jobs", "Jobs", "", "Number of parts at a time. 0: one per core.",
       IntegerKind<S>{&S::processes, 0, 4096}},
      {"part_time_s", "--part-time", "Time limit of a part", "s",
       "A part that takes longer fails. 0: no limit.", RealKind<S>{&S::part_time_s, 0.0, 1e7, 1.0}},
      {"part_memory_mb", "--part-memory", "Memory limit of a part", "MB",
       "A part that takes more resident memory fails. 0: no limit.",
       IntegerKind<S>{&S::part_memory_mb, 0, 1 << 30}},
      {"retries", "--retries", "Retries", "",
       "Number of retries of a part that failed, unless it reached a limit.",
       IntegerKind<S>{&S::retries, 0, 100}},
      {"retry_failed", "--retry-failed", "Retry failures", "",
       "Retry parts with a recorded failure. Otherwise they are skipped.", SwitchKind<S>{&S::retry_failed}},
      {"thumbnails", "--thumbnails", "Pictures", "",
       "Draw a small picture of every part along its direction, also of parts that are done.",
       SwitchKind<S>{&S::thumbnails}},
      {"reports", "--reports", "Reports", "",
       "Write a report for the browser of every part, also of parts that are done.",
       SwitchKind<S>{&S::reports}},
      {"live", "--live", "Live reports", "",
       "Write reports that find the regions of any direction by themselves. For classify and sweep only.",
       SwitchKind<S>{&S::live}},
  };
  return k_options;
}

Run::Run(const Manifest& manifest, const RunSettings& settings, Shard shard, std::string parts)
    : manifest_(manifest), settings_(settings), shard_(shard), parts_(std::move(parts)) {}

RunEnd Run::carry_out(const RunListener& listener, const Progress& progress) {
  const ResultStore store(manifest_.folder);
  store.remove_leftovers(progress);
  progress.report("looking for results", 0.0);
  const ResultIndex there = store.index(progress);
  std::vector<ResultIndex> besides;  // that are wanted: who has them
  for (const Beside what : besides_of(settings_)) besides.push_back(store.those_with(what, progress));
  const KeyMaker key_of(manifest_);
  std::vector<Job> jobs;
  RowReader reader(manifest_);
  for (Row row; reader.next(row);) {
    if (row.number % 4096 == 0) progress.report("reading the plan", 0.0);
    if (!shard_.has(row.number) || row.same_as) continue;
    ++counts_.rows;
    const Digest key = key_of(row);
    const auto found = there.find(key);
    const ResultState state = found == there.end() ? ResultState::missing : found->second;
    const bool settled =
        state == ResultState::done || (state == ResultState::failed && !settings_.retry_failed);
    if (settled) ++counts_.before;
    const bool lacks =
        state == ResultState::done &&
        std::ranges::any_of(besides, [&](const ResultIndex& those) { return !those.contains(key); });
    if (!settled || lacks) jobs.push_back({row, key, settled});
  }

  RunEnd end;
  Slots slots(manifest_, settings_, parts_, counts_, listener, progress);
  slots.work_through(std::move(jobs));
  const std::size_t handled = counts_.before + counts_.done + counts_.failed + counts_.elsewhere;
  end.undone = counts_.rows - std::min<std::size_t>(handled, counts_.rows);
  end.interrupted = progress.cancelled();
  if (!slots.error().empty()) {
    end.try_again = slots.error();
  } else if (slots.unreachable() > 0) {
    end.try_again = fmt::format("{} part{} could not be reached: {}", slots.unreachable(),
                                slots.unreachable() == 1 ? "" : "s", slots.unreachable_example());
  } else if (slots.ended_from_outside() > 0) {
    end.try_again =
        fmt::format("the processes of {} parts were ended from outside", slots.ended_from_outside());
  }
  return end;
}

}  // namespace moldlight::batch
