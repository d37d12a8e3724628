#include "serve/session.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"

namespace moldlight::serve {

namespace {

constexpr int k_parse_error = -32700, k_invalid_request = -32600, k_no_method = -32601,
              k_invalid_params = -32602, k_internal_error = -32603, k_busy = -32000;

/// Newest first.
constexpr std::array<std::string_view, 3> k_versions = {"2025-06-18", "2025-03-26", "2024-11-05"};

constexpr int k_most_depth = 32;
constexpr std::size_t k_most_in_batch = 64, k_most_waiting = 32;
constexpr std::chrono::milliseconds k_report_interval(100);

/// As far as the text is JSON.
bool is_too_deep(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\') ++k;
    if (quoted) continue;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > k_most_depth) return true;
  }
  return false;
}

Message parsed(std::string_view line) {
  // The parser would take it for the end.
  if (line.find('\0') != std::string_view::npos) throw RequestFault{k_parse_error, "not JSON: a byte is 0"};
  // Asked for by a callback, the parser would look at the whole of an array for each of its members.
  if (is_too_deep(line)) throw RequestFault{k_parse_error, "nested too deeply"};
  Message message = Message::parse(line, nullptr, false);
  if (message.is_discarded()) throw RequestFault{k_parse_error, "not JSON in UTF-8"};
  return message;
}

Answer fault_answer(const Message& id, const RequestFault& fault) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", fault.code}, {"message", fault.sentence}}}};
}

/// Of an object; null where it is not there.
const Message& member(const Message& object, const char* key) {
  static const Message k_none;
  const auto found = object.find(key);
  return found == object.end() ? k_none : *found;
}

/// What stands for a request, and for its progress.
bool is_token(const Message& value) { return value.is_string() || value.is_number(); }

bool is_response(const Message& message) {
  return !message.contains("method") && (message.contains("result") || message.contains("error"));
}

void check_request(const Message& message) {
  const auto require = [](bool holds, const char* sentence) {
    if (!holds) throw RequestFault{k_invalid_request, sentence};
  };
  require(member(message, "jsonrpc") == "2.0", "jsonrpc is not \"2.0\"");
  require(!message.contains("id") || is_token(message["id"]), "id is neither text nor a number");
  require(member(message, "method").is_string(), "method is not text");
  require(!message.contains("params") || message["params"].is_structured(), "params is not an object");
}

/// An empty object where there are none.
Message params_of(const Message& message) {
  if (!message.contains("params")) return Message::object();
  if (!message["params"].is_object()) throw RequestFault{k_invalid_params, "params is not an object"};
  return message["params"];
}

}  // namespace

struct Session::Call {
  Call(Session& session, Message asked_id, SharedBatch in_batch, ToolWork asked)
      : id(std::move(asked_id)),
        batch(std::move(in_batch)),
        work(std::move(asked)),
        progress([this, &session](std::string_view now_at, double share) {
          if (!token.is_null()) session.report(*this, now_at, share);
        }) {}

  const Message id;
  const SharedBatch batch;
  const ToolWork work;
  Message token = {};  // of its progress; null: nobody listens
  Progress progress;
  // Of the last report, under the session's lock.
  std::string stage = {};
  double stages = -1.0, reported = -1.0;
  std::chrono::steady_clock::time_point reported_at = {};
};

Session::Session(Server server, std::function<void(std::string)> send)
    : server_(std::move(server)), send_(std::move(send)), thread_([this] { run_calls(); }) {}

Session::~Session() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    waiting_.clear();
    if (running_) running_->progress.cancel();
  }
  changed_.notify_all();
  thread_.join();
}

bool Session::idle() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && !running_;
}

void Session::refuse_message(const std::string& why) { send(fault_answer(nullptr, {k_parse_error, why})); }

void Session::take(std::string_view line) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos) return;
  try {
    const Message message = parsed(line);
    if (!message.is_array()) return handle(message, nullptr);
    if (version_.empty() || version_ == k_versions.front())
      throw RequestFault{k_invalid_request, "this version of the protocol has no arrays of messages"};
    if (message.empty() || message.size() > k_most_in_batch)
      throw RequestFault{k_invalid_request, fmt::format("an array has 1 to {} messages", k_most_in_batch)};
    const auto batch = std::make_shared<Batch>();
    batch->open = message.size();
    for (const Message& one : message) handle(one, batch);
  } catch (const RequestFault& fault) {
    send(fault_answer(nullptr, fault));
  }
}

void Session::handle(const Message& message, const SharedBatch& batch) {
  Message id;
  try {
    if (!message.is_object()) throw RequestFault{k_invalid_request, "a message is an object"};
    if (is_token(member(message, "id"))) id = message["id"];
    // Nothing is asked of the client, so an answer from it is to nothing.
    if (is_response(message)) return settle(batch, {});
    check_request(message);
    if (!message.contains("id")) {
      if (message.contains("params") && message["params"].is_object())
        notice(message["method"], message["params"]);
      return settle(batch, {});
    }
    Answer result = result_of(message, batch);
    if (!result.is_null()) settle(batch, {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
  } catch (const RequestFault& fault) {
    settle(batch, fault_answer(id, fault));
  }
}

void Session::notice(const std::string& method, const Message& params) {
  const Message& id = member(params, "requestId");
  if (method != "notifications/cancelled" || !is_token(id)) return;
  SharedBatch batch;
  {
    const std::lock_guard lock(mutex_);
    if (running_ && running_->id == id) return running_->progress.cancel();
    const auto call = std::ranges::find_if(waiting_, [&](const auto& one) { return one->id == id; });
    if (call == waiting_.end()) return;
    batch = (*call)->batch;
    waiting_.erase(call);
  }
  settle(batch, {});
}

Answer Session::result_of(const Message& message, const SharedBatch& batch) {
  const std::string& method = message["method"].get_ref<const std::string&>();
  if (method == "ping") return Answer::object();
  if (method == "initialize") return initialize(params_of(message));
  if (method != "tools/list" && method != "tools/call")
    throw RequestFault{k_no_method, "there is no such method"};
  if (version_.empty()) throw RequestFault{k_invalid_request, "the session has not begun; send initialize"};
  if (method == "tools/list") return tool_list(params_of(message));
  call_tool(message, batch);
  return {};
}

Answer Session::initialize(const Message& params) {
  const Message& asked = member(params, "protocolVersion");
  if (!asked.is_string()) throw RequestFault{k_invalid_params, "protocolVersion is not text"};
  const auto known = std::ranges::find(k_versions, asked.get_ref<const std::string&>());
  {
    const std::lock_guard lock(mutex_);
    version_ = known == k_versions.end() ? k_versions.front() : *known;
  }
  return {{"protocolVersion", version_},
          {"capabilities", {{"tools", Answer::object()}}},
          {"serverInfo", {{"name", server_.name}, {"version", server_.version}}},
          {"instructions", server_.instructions}};
}

Answer Session::tool_list(const Message& params) const {
  if (params.contains("cursor"))
    throw RequestFault{k_invalid_params, "the list has one page; leave out cursor"};
  Answer tools = Answer::array();
  for (const Tool& tool : server_.tools)
    tools.push_back(
        {{"name", tool.name},
         {"title", tool.title},
         {"description", tool.help},
         {"inputSchema", tool.schema},
         {"annotations", {{"title", tool.title}, {"readOnlyHint", true}, {"openWorldHint", false}}}});
  return {{"tools", std::move(tools)}};
}

void Session::call_tool(const Message& message, const SharedBatch& batch) {
  const Message params = params_of(message);
  const Message& name = member(params, "name");
  const auto tool = std::ranges::find_if(server_.tools, [&](const Tool& one) { return name == one.name; });
  if (tool == server_.tools.end()) throw RequestFault{k_invalid_params, "there is no such tool"};
  const Message arguments = params.contains("arguments") ? params["arguments"] : Message::object();
  if (!arguments.is_object()) throw RequestFault{k_invalid_params, "arguments is not an object"};
  const Message& meta = member(params, "_meta");
  const Message token = meta.is_object() ? member(meta, "progressToken") : Message();
  if (!token.is_null() && !is_token(token))
    throw RequestFault{k_invalid_params, "progressToken is neither text nor a number"};
  std::shared_ptr<Call> call;
  try {
    call = std::make_shared<Call>(*this, message["id"], batch, tool->ask(arguments));
  } catch (const UsageError& error) {
    throw RequestFault{k_invalid_params, error.what()};
  }
  call->token = token;
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= k_most_waiting)
      throw RequestFault{k_busy,
                         fmt::format("{} calls wait; ask again when one is answered", k_most_waiting)};
    waiting_.push_back(std::move(call));
  }
  changed_.notify_all();
}

void Session::report(Call& call, std::string_view stage, double fraction) {
  Answer params;
  {
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (now - call.reported_at < k_report_interval) return;
    if (call.stages < 0.0 || stage != call.stage) ++call.stages;
    call.stage = stage;
    // Always more, as the protocol wants it, though stages may begin again.
    const double progress = call.stages + 0.99 * std::clamp(fraction, 0.0, 1.0);
    if (progress <= call.reported) return;
    call.reported = progress;
    call.reported_at = now;
    params = {{"progressToken", call.token}, {"progress", progress}, {"message", call.stage}};
  }
  send({{"jsonrpc", "2.0"}, {"method", "notifications/progress"}, {"params", std::move(params)}});
}

void Session::run_calls() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
    if (ending_) return;
    running_ = waiting_.front();
    waiting_.pop_front();
    const bool with_structure = version_ == k_versions.front();
    lock.unlock();
    const Call& call = *running_;
    Answer answer;
    try {
      Answer result = call.work(call.progress);
      // Older versions have no place for it but text.
      if (!with_structure && result.contains("structuredContent"))
        result["content"].push_back(
            {{"type", "text"},
             {"text", result["structuredContent"].dump(-1, ' ', false, Answer::error_handler_t::replace)}});
      answer = {{"jsonrpc", "2.0"}, {"id", call.id}, {"result", std::move(result)}};
    } catch (const Cancelled&) {
    } catch (const std::exception& error) {
      answer = fault_answer(call.id, {k_internal_error, error.what()});
    }
    // The protocol has no answer to what was cancelled.
    settle(call.batch, call.progress.cancelled() ? Answer() : std::move(answer));
    lock.lock();
    running_.reset();
  }
}

void Session::settle(const SharedBatch& batch, Answer answer) {
  if (!batch) {
    if (!answer.is_null()) send(answer);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    if (!answer.is_null()) batch->answers.push_back(std::move(answer));
    if (--batch->open > 0 || batch->answers.empty()) return;
  }
  send(batch->answers);
}

void Session::send(const Answer& message) const {
  send_(message.dump(-1, ' ', false, Answer::error_handler_t::replace));
}

}  // namespace moldlight::serve
