// How the pool hands directions to scorers.
#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "sweep/scoring.hpp"

namespace moldlight {
namespace {

/// Scores a direction by its x; remembers the largest batch that any of them got.
class BatchingScorer : public DirectionScorer {
 public:
  BatchingScorer(std::size_t batch_size, std::atomic<std::size_t>& largest)
      : batch_size_(batch_size), largest_(&largest) {}

  [[nodiscard]] std::size_t batch_size() const override { return batch_size_; }
  [[nodiscard]] std::vector<DirectionScore> score(std::span<const ScoringTask> tasks) override {
    for (std::size_t seen = *largest_;
         tasks.size() > seen && !largest_->compare_exchange_weak(seen, tasks.size());) {
    }
    std::vector<DirectionScore> scores;
    for (const ScoringTask& task : tasks) {
      DirectionScore& score = scores.emplace_back();
      score.areas[Region::undercut] = task.direction.x;
      score.given_up = task.direction.x > task.give_up_above;
    }
    return scores;
  }

 private:
  std::size_t batch_size_;
  std::atomic<std::size_t>* largest_;
};

std::vector<ScoringTask> numbered_tasks(int count) {
  std::vector<ScoringTask> tasks;
  for (int i = 0; i < count; ++i) tasks.push_back({{i, 0, 0}, i % 2 == 0 ? 0.5 : INFINITY});
  return tasks;
}

TEST(ScoringPool, HandsOutBatchesAndKeepsOrderAndLimits) {
  struct Case {
    std::size_t batch_size;
    int jobs;
    std::size_t largest;
  };
  // No thread takes more than its share.
  for (const Case& c : {Case{1, 2, 1}, Case{7, 2, 7}, Case{64, 2, 12}, Case{64, 1, 23}}) {
    std::atomic<std::size_t> largest = 0;
    ScoringPool pool([&] { return std::make_unique<BatchingScorer>(c.batch_size, largest); }, c.jobs);
    const std::vector<ScoringTask> tasks = numbered_tasks(23);
    std::size_t noted = 0;
    const auto scores = pool.score(
        tasks, [] { return false; }, [&](std::size_t, const DirectionScore&) { ++noted; });
    EXPECT_EQ(noted, tasks.size());
    EXPECT_EQ(largest, c.largest);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      ASSERT_TRUE(scores[i]);
      EXPECT_EQ(scores[i]->undercut(), static_cast<double>(i));
      EXPECT_EQ(scores[i]->given_up, i > 0 && i % 2 == 0) << i;
    }
  }
}

TEST(ScoringPool, StopsBetweenBatches) {
  std::atomic<std::size_t> largest = 0;
  ScoringPool pool([&] { return std::make_unique<BatchingScorer>(4, largest); }, 1);
  int noted = 0;
  const auto scores = pool.score(
      numbered_tasks(20), [&] { return noted >= 8; }, [&](std::size_t, const DirectionScore&) { ++noted; });
  EXPECT_EQ(noted, 8);
  EXPECT_TRUE(scores[7]);
  EXPECT_FALSE(scores[8]);
}

}  // namespace
}  // namespace moldlight
