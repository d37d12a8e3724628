// A session of the Model Context Protocol (JSON-RPC 2.0): what each message is answered with, and the calls
// of tools, one after another on a thread of their own. What the tools do is not known here.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/progress.hpp"

namespace moldlight::serve {

/// As it comes in: the time that an object takes grows hardly more than its length. Not trusted.
using Message = nlohmann::json;
using Answer = nlohmann::ordered_json;

/// The work of a call; returns the result of `tools/call`, and throws Cancelled.
using ToolWork = std::function<Answer(const Progress&)>;
struct Tool {
  std::string name, title, help;
  Answer schema;  // JSON Schema of the arguments, an object
  /// Throws UsageError for arguments that the tool does not take.
  std::function<ToolWork(const Message& arguments)> ask;
};

struct Server {
  std::string name, version, instructions;
  std::vector<Tool> tools;
};

/// What is wrong with a request, as JSON-RPC has it.
struct RequestFault {
  int code;
  std::string sentence;
};

/// One thread hands messages in; answers go out from that one and from the session's own.
class Session {
 public:
  /// `send` gets a message without its line's end, from either thread.
  Session(Server server, std::function<void(std::string message)> send);
  /// Cancels what runs, and waits for its end.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Answers what can be answered at once; calls wait for their turn.
  void take(std::string_view line);
  /// Answers a message that could not be read at all.
  void refuse_message(const std::string& why);
  /// No call runs or waits.
  [[nodiscard]] bool idle() const;

 private:
  /// The answers of an array of messages, which go out together.
  struct Batch {
    std::size_t open = 0;
    Answer answers = Answer::array();
  };
  using SharedBatch = std::shared_ptr<Batch>;  // null for a message alone
  struct Call;

  void handle(const Message& message, const SharedBatch& batch);
  void notice(const std::string& method, const Message& params);
  /// Null where the answer comes later.
  Answer result_of(const Message& message, const SharedBatch& batch);
  Answer initialize(const Message& params);
  [[nodiscard]] Answer tool_list(const Message& params) const;
  void call_tool(const Message& message, const SharedBatch& batch);
  void report(Call& call, std::string_view stage, double fraction);
  void run_calls();
  /// An answer, or none where it is null.
  void settle(const SharedBatch& batch, Answer answer);
  void send(const Answer& message) const;

  const Server server_;
  const std::function<void(std::string)> send_;
  std::string version_;  // of the protocol; empty before the session has begun
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Call>> waiting_;
  std::shared_ptr<Call> running_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace moldlight::serve
