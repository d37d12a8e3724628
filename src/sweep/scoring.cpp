#include "sweep/scoring.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "base/threads.hpp"

namespace moldlight {

/// Threads that live as long as the pool, so that each keeps its scorer (and its GL context).
struct ScoringPool::Workers {
  MakeScorer make_scorer;
  std::mutex mutex;
  std::condition_variable work, done;
  bool quit = false;
  std::uint64_t round = 0;
  int busy = 0;
  std::exception_ptr failure;

  std::span<const ScoringTask> tasks;
  const std::function<bool()>* stop = nullptr;
  const Listener* listener = nullptr;
  std::vector<std::optional<DirectionScore>>* scores = nullptr;
  std::atomic<std::size_t> next{0};

  std::vector<std::jthread> threads;

  ~Workers() {
    {
      const std::lock_guard lock(mutex);
      quit = true;
    }
    work.notify_all();
    threads.clear();
  }

  void score_share(DirectionScorer& scorer) {
    const std::size_t share = (tasks.size() + threads.size() - 1) / threads.size();
    const std::size_t most = std::clamp<std::size_t>(share, 1, scorer.batch_size());
    for (std::size_t first = next.fetch_add(most); first < tasks.size() && !(*stop && (*stop)());
         first = next.fetch_add(most)) {
      const auto batch = tasks.subspan(first, std::min(most, tasks.size() - first));
      const std::vector<DirectionScore> found = scorer.score(batch);
      const std::lock_guard lock(mutex);
      for (std::size_t i = 0; i < found.size(); ++i) {
        (*scores)[first + i] = found[i];
        if (*listener) (*listener)(first + i, found[i]);
      }
    }
  }

  void run() {
    std::unique_ptr<DirectionScorer> scorer;
    std::uint64_t seen = 0;
    while (true) {
      {
        std::unique_lock lock(mutex);
        work.wait(lock, [&] { return quit || round != seen; });
        if (quit) return;
        seen = round;
      }
      try {
        if (!scorer) scorer = make_scorer();
        score_share(*scorer);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = tasks.size();
      }
      const std::lock_guard lock(mutex);
      if (--busy == 0) done.notify_one();
    }
  }
};

int ScoringPool::threads(int jobs) { return jobs > 0 ? jobs : usable_cores(); }

ScoringPool::ScoringPool(MakeScorer make_scorer, int jobs)
    : jobs_(threads(jobs)), workers_(std::make_unique<Workers>()) {
  workers_->make_scorer = std::move(make_scorer);
  try {
    for (int i = 0; i < jobs_; ++i)
      workers_->threads.emplace_back([workers = workers_.get()] { workers->run(); });
  } catch (const std::system_error&) {
    // The result is the same with fewer.
    jobs_ = static_cast<int>(workers_->threads.size());
    if (jobs_ == 0) throw;
  }
}

ScoringPool::~ScoringPool() = default;

std::vector<std::optional<DirectionScore>> ScoringPool::score(std::span<const ScoringTask> tasks,
                                                              const std::function<bool()>& stop,
                                                              const Listener& listener) {
  std::vector<std::optional<DirectionScore>> scores(tasks.size());
  std::unique_lock lock(workers_->mutex);
  workers_->tasks = tasks;
  workers_->stop = &stop;
  workers_->listener = &listener;
  workers_->scores = &scores;
  workers_->next = 0;
  workers_->failure = nullptr;
  workers_->busy = jobs_;
  ++workers_->round;
  workers_->work.notify_all();
  workers_->done.wait(lock, [&] { return workers_->busy == 0; });
  if (workers_->failure) std::rethrow_exception(workers_->failure);
  return scores;
}

}  // namespace moldlight
