// A job for the newest request: what it does, what it leaves out, how it ends.
#include "base/latest_job.hpp"

#include <atomic>
#include <semaphore>
#include <vector>

#include <gtest/gtest.h>

namespace moldlight {
namespace {

using Job = LatestJob<int, int>;

/// Every piece of work waits until it is let go on; an outcome is reported to `done`.
struct Gate {
  std::counting_semaphore<> started{0}, go{0}, done{0};
};

Job::Options gated(Gate& gate) {
  return {.work =
              [&gate](int request, const Progress& progress) {
                gate.started.release();
                gate.go.acquire();
                progress.report("", 0.0);
                return 10 * request;
              },
          .wake = [&gate] { gate.done.release(); }};
}

TEST(LatestJob, DoesWhatRunsAndThenTheNewestRequest) {
  Gate gate;
  Job job(gated(gate));
  EXPECT_FALSE(job.busy());
  job.request(1);
  gate.started.acquire();
  for (const int request : {2, 3, 4}) job.request(request);
  EXPECT_TRUE(job.busy());
  gate.go.release();
  gate.done.acquire();
  EXPECT_EQ(job.take(), 10);
  EXPECT_EQ(job.take(), std::nullopt);
  gate.go.release();
  gate.done.acquire();
  EXPECT_EQ(job.take(), 40);
  EXPECT_FALSE(job.busy());
}

TEST(LatestJob, GivesUpWhatRunsAndWhatWaits) {
  Gate gate;
  Job job(gated(gate));
  job.request(1);
  gate.started.acquire();
  job.request(2);
  job.cancel();
  EXPECT_FALSE(job.busy());
  gate.go.release(2);
  job.request(3);
  gate.done.acquire();
  EXPECT_EQ(job.take(), 30);
}

TEST(LatestJob, EndsWithWorkUnderWay) {
  Gate gate;
  gate.go.release();
  Job job(gated(gate));
  job.request(1);
  gate.started.acquire();
}

TEST(LatestJob, LeavesTheCoresAloneForAsLongAsItsPauseSays) {
  Gate gate;
  gate.go.release(100);
  Job::Options options = gated(gate);
  std::atomic<int> asked = 0;
  options.pause_s = [&](double took) {
    EXPECT_GE(took, 0.0);
    ++asked;
    return 0.05;
  };
  Job job(std::move(options));
  const auto start = std::chrono::steady_clock::now();
  for (int request = 0; request < 4; ++request) {
    job.request(request);
    gate.done.acquire();
  }
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(3 * 50));
  EXPECT_GE(asked, 3);
}

}  // namespace
}  // namespace moldlight
