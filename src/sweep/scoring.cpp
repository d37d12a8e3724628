#include "sweep/scoring.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include <tbb/parallel_for.h>

#include "base/threads.hpp"
#include "sweep/arena_threads.hpp"

namespace moldlight {

int ScoringPool::threads(int jobs) { return jobs > 0 ? jobs : usable_cores(); }

ScoringPool::ScoringPool(MakeScorer make_scorer, int jobs)
    : make_scorer_(std::move(make_scorer)),
      scorers_(static_cast<std::size_t>(threads(jobs))),
      arena_(arena_threads(threads(jobs))) {}

std::vector<std::optional<DirectionScore>> ScoringPool::score(std::span<const ScoringTask> tasks,
                                                              const std::function<bool()>& stop,
                                                              const Listener& listener) {
  std::vector<std::optional<DirectionScore>> scores(tasks.size());
  const std::size_t share = (tasks.size() + scorers_.size() - 1) / scorers_.size();
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  const auto score_share = [&](std::unique_ptr<DirectionScorer>& scorer) {
    if (next >= tasks.size()) return;
    if (!scorer) scorer = make_scorer_();
    const std::size_t most = std::clamp<std::size_t>(share, 1, scorer->batch_size());
    for (std::size_t first = next.fetch_add(most); first < tasks.size() && !(stop && stop());
         first = next.fetch_add(most)) {
      const auto batch = tasks.subspan(first, std::min(most, tasks.size() - first));
      const std::vector<DirectionScore> found = scorer->score(batch);
      const std::lock_guard lock(mutex);
      for (std::size_t i = 0; i < found.size(); ++i) {
        scores[first + i] = found[i];
        if (listener) listener(first + i, found[i]);
      }
    }
  };
  arena_.execute([&] {
    tbb::parallel_for(std::size_t{0}, scorers_.size(), [&](std::size_t k) {
      // A thread that waits within a scorer takes no other one.
      tbb::this_task_arena::isolate([&] { score_share(scorers_[k]); });
    });
  });
  return scores;
}

}  // namespace moldlight
