// Sessions of the Model Context Protocol with tools that are made up, and the lines that carry them.
#include "serve/session.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.hpp"
#include "serve/lines.hpp"

namespace moldlight::serve {
namespace {

using namespace std::chrono_literals;

/// A session whose tools say what they got, never end, or fail.
class Talk {
 public:
  Talk() {
    say(R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{"protocolVersion":"2025-06-18"}})");
  }

  void say(const std::string& line) { session_.take(line); }
  void call(int id, const std::string& tool, const std::string& meta = "{}") {
    say(R"({"jsonrpc":"2.0","id":)" + std::to_string(id) + R"(,"method":"tools/call","params":{"name":")" +
        tool + R"(","_meta":)" + meta + "}}");
  }
  void cancel(int id) {
    say(R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":)" + std::to_string(id) +
        "}}");
  }
  void wait() const {
    while (!session_.idle()) std::this_thread::sleep_for(1ms);
  }
  [[nodiscard]] std::vector<Message> heard() {
    const std::lock_guard lock(mutex_);
    return heard_;
  }
  [[nodiscard]] std::vector<Message> answers_to(int id) {
    std::vector<Message> answers;
    for (const Message& one : heard())
      if (one.contains("id") && one["id"] == id) answers.push_back(one);
    return answers;
  }
  void wait_for_work() const {
    while (!working_) std::this_thread::sleep_for(1ms);
  }

 private:
  [[nodiscard]] Server server() {
    const auto tool = [](std::string name, ToolWork work) {
      return Tool{name, name, name, {{"type", "object"}}, [work](const Message&) { return work; }};
    };
    return {"test",
            "1",
            "",
            {tool("quick",
                  [](const Progress&) {
                    return Answer{{"content", "done"}};
                  }),
             tool("endless",
                  [this](const Progress& progress) -> Answer {
                    working_ = true;
                    for (int k = 0;; ++k) {
                      progress.report(k % 2 == 0 ? "one" : "other", 0.5);
                      std::this_thread::sleep_for(1ms);
                    }
                  }),
             tool("broken", [](const Progress&) -> Answer { throw Error("it broke"); })}};
  }

  std::atomic<bool> working_ = false;
  std::mutex mutex_;
  std::vector<Message> heard_;
  Session session_{server(), [this](const std::string& message) {
                     const std::lock_guard lock(mutex_);
                     heard_.push_back(Message::parse(message));
                   }};
};

TEST(Session, CallsAreAnsweredInTheirTurn) {
  Talk talk;
  talk.call(1, "quick");
  talk.call(2, "broken");
  talk.call(3, "none");
  talk.wait();
  ASSERT_EQ(talk.answers_to(1).size(), 1u);
  EXPECT_EQ(talk.answers_to(1)[0]["result"]["content"], "done");
  EXPECT_EQ(talk.answers_to(2).at(0)["error"]["code"], -32603);
  EXPECT_EQ(talk.answers_to(3).at(0)["error"]["code"], -32602);
}

TEST(Session, WhatIsCancelledHasNoAnswer) {
  Talk talk;
  talk.call(1, "endless");
  talk.call(2, "quick");
  talk.call(3, "quick");
  talk.wait_for_work();
  talk.cancel(2);
  talk.cancel(1);
  talk.wait();
  EXPECT_TRUE(talk.answers_to(1).empty());
  EXPECT_TRUE(talk.answers_to(2).empty());
  EXPECT_EQ(talk.answers_to(3).size(), 1u);
}

TEST(Session, ProgressRises) {
  Talk talk;
  talk.call(1, "endless", R"({"progressToken":"t"})");
  while (talk.heard().size() < 4) std::this_thread::sleep_for(1ms);
  talk.cancel(1);
  talk.wait();
  double last = -1.0;
  for (const Message& one : talk.heard()) {
    if (!one.contains("method")) continue;
    EXPECT_EQ(one["params"]["progressToken"], "t");
    EXPECT_GT(one["params"]["progress"].get<double>(), last);
    last = one["params"]["progress"].get<double>();
  }
}

TEST(Session, EndsInTheMidstOfACall) {
  Talk talk;
  for (int id = 1; id < 5; ++id) talk.call(id, "endless");
  talk.wait_for_work();
}

TEST(Session, NestingHasABound) {
  Talk talk;
  talk.say(std::string(1'000'000, '['));
  EXPECT_EQ(talk.heard().back()["error"]["code"], -32700);
  talk.say(
      R"({"jsonrpc":"2.0","id":7,"method":"ping","params":{"a":"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\"["}})");
  EXPECT_EQ(talk.answers_to(7).size(), 1u);
}

TEST(Lines, LongOnesArePassedOver) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  LineWriter writer(ends[1], [] { return false; });
  std::thread client([&] {
    for (const std::size_t size : {1, 100, 101, 300'000, 0, 2}) writer.write(std::string(size, 'x'));
    EXPECT_EQ(::write(ends[1], "end", 3), 3);
    ::close(ends[1]);
  });
  LineReader reader(ends[0], 100);
  std::string line, seen;
  for (LineReader::Got got; (got = reader.next(line)) != LineReader::Got::end;) {
    if (got == LineReader::Got::line) seen += std::to_string(line.size()) + " ";
    if (got == LineReader::Got::too_long) seen += "long ";
  }
  client.join();
  ::close(ends[0]);
  EXPECT_EQ(seen, "1 100 long long 0 2 3 ");
}

TEST(Lines, WritingEndsWhereNobodyReads) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  std::atomic<bool> stop = false;
  LineWriter writer(ends[1], [&] { return stop.load(); });
  std::thread later([&] {
    std::this_thread::sleep_for(300ms);
    stop = true;
  });
  EXPECT_TRUE(writer.is_read());
  writer.write(std::string(1'000'000, 'x'));
  EXPECT_TRUE(writer.broken());
  later.join();
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace
}  // namespace moldlight::serve
