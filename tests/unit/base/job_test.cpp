// A job in the background: what it does, what it leaves out, what becomes of it, how it ends.
#include "base/job.hpp"

#include <atomic>
#include <chrono>
#include <semaphore>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace moldlight {
namespace {

using Job = moldlight::Job<int>;

/// Every piece of work waits until it is let go on; an outcome is reported to `done`.
struct Gate {
  std::counting_semaphore<> started{0}, go{0}, done{0};
};

JobOptions gated(Gate& gate) {
  return {.wake = [&gate] { gate.done.release(); }};
}

Job::Work work(Gate& gate, int request) {
  return [&gate, request](const Progress& progress) {
    gate.started.release();
    gate.go.acquire();
    progress.report("working", 0.5);
    return 10 * request;
  };
}

/// What the job hands over; 0 for nothing.
int taken(Job& job) {
  const auto outcome = job.take();
  return outcome && outcome->result ? *outcome->result : 0;
}

TEST(Job, DoesWhatRunsAndThenTheNewestThatFollows) {
  Gate gate;
  Job job(gated(gate));
  EXPECT_FALSE(job.running());
  job.follow(work(gate, 1));
  gate.started.acquire();
  for (const int request : {2, 3, 4}) job.follow(work(gate, request));
  EXPECT_TRUE(job.running());
  gate.go.release();
  gate.done.acquire();
  EXPECT_EQ(taken(job), 10);
  EXPECT_EQ(taken(job), 0);
  gate.go.release();
  gate.done.acquire();
  EXPECT_EQ(taken(job), 40);
  EXPECT_FALSE(job.running());
}

TEST(Job, StartsInPlaceOfWhatRunsAndWhatWaits) {
  Gate gate;
  Job job(gated(gate));
  job.follow(work(gate, 1));
  gate.started.acquire();
  job.follow(work(gate, 2));
  job.give_up();
  EXPECT_FALSE(job.running());
  gate.go.release(2);
  job.start(work(gate, 3), {"first", 0.25});
  EXPECT_EQ(job.status().stage, "first");
  EXPECT_EQ(job.status().fraction, 0.25);
  gate.done.acquire();
  EXPECT_EQ(taken(job), 30);
  EXPECT_EQ(job.status().stage, "");
}

TEST(Job, OfWhatIsCancelledTheOutcomeCanBeTaken) {
  Gate gate;
  Job job(gated(gate));
  job.start([&gate](const Progress& progress) {
    gate.started.release();
    while (!progress.cancelled()) std::this_thread::yield();
    return 7;
  });
  gate.started.acquire();
  EXPECT_FALSE(job.cancelled());
  job.cancel();
  gate.done.acquire();
  EXPECT_TRUE(job.running());
  EXPECT_EQ(taken(job), 7);
  EXPECT_FALSE(job.running());
}

TEST(Job, SaysWhyThereIsNoResultUnlessItWasCancelled) {
  Gate gate;
  Job job(gated(gate));
  job.start([](const Progress&) -> int { throw std::runtime_error("no such thing"); });
  gate.done.acquire();
  auto outcome = job.take();
  ASSERT_TRUE(outcome.has_value());
  EXPECT_FALSE(outcome->result.has_value());
  EXPECT_EQ(outcome->error, "no such thing");
  job.start(work(gate, 1));
  gate.started.acquire();
  job.cancel();
  gate.go.release();
  gate.done.acquire();
  outcome = job.take();
  ASSERT_TRUE(outcome.has_value());
  EXPECT_FALSE(outcome->result.has_value());
  EXPECT_EQ(outcome->error, "");
}

TEST(Job, EndsWithWorkUnderWayAndCleansUpOnItsThread) {
  Gate gate;
  gate.go.release();
  std::thread::id worked, ended;
  JobOptions options = gated(gate);
  options.at_end = [&ended] { ended = std::this_thread::get_id(); };
  {
    Job job(options);
    job.start([&](const Progress& progress) {
      worked = std::this_thread::get_id();
      return work(gate, 1)(progress);
    });
    gate.started.acquire();
  }
  EXPECT_EQ(ended, worked);
  EXPECT_NE(ended, std::this_thread::get_id());
}

TEST(Job, LeavesTheCoresAloneForAsLongAsItsPauseSays) {
  Gate gate;
  gate.go.release(100);
  JobOptions options = gated(gate);
  std::atomic<int> asked = 0;
  options.pause_s = [&](double took) {
    EXPECT_GE(took, 0.0);
    ++asked;
    return 0.05;
  };
  Job job(std::move(options));
  const auto start = std::chrono::steady_clock::now();
  for (int request = 0; request < 4; ++request) {
    job.follow(work(gate, request));
    gate.done.acquire();
  }
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(3 * 50));
  EXPECT_GE(asked, 3);
}

TEST(Job, GivesWayToThreadsThatDraw) {
  const auto niceness = [] { return getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid))); };
  const int own = niceness();
  std::binary_semaphore done{0};
  Job job({.wake = [&done] { done.release(); }});
  int of_threads_that_it_starts = 0;
  job.start([&](const Progress&) {
    std::thread([&] { of_threads_that_it_starts = niceness(); }).join();
    return niceness();
  });
  done.acquire();
  EXPECT_GT(taken(job), own);
  EXPECT_GT(of_threads_that_it_starts, own);
  EXPECT_EQ(niceness(), own) << "the thread that draws is as it was";
}

}  // namespace
}  // namespace moldlight
