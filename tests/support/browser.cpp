#include "support/browser.hpp"

#include <array>
#include <cstdint>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include "support/program_path.hpp"

namespace moldlight::test {

namespace {

using Json = Browser::Json;
using namespace std::string_literals;

constexpr int k_answer_limit_ms = 180'000;

std::string browser() { return program_path({"chromium", "chromium-browser", "google-chrome"}); }

std::string bytes_of_base64(const std::string& text) {
  constexpr std::string_view k_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char letter : text) {
    const std::size_t digit = k_digits.find(letter);
    if (digit == std::string_view::npos) break;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 0xFF);
  }
  return bytes;
}

}  // namespace

bool has_browser() { return !browser().empty(); }

Browser::Browser(const std::vector<std::string>& flags) {
  std::array<int, 2> orders{}, answers{};
  if (::pipe2(orders.data(), O_CLOEXEC) != 0 || ::pipe2(answers.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe");
  std::vector<std::string> words = {browser(),
                                    "--headless",
                                    "--no-sandbox",
                                    "--use-angle=swiftshader",
                                    "--enable-unsafe-swiftshader",
                                    "--disable-background-networking",
                                    "--disable-component-update",
                                    "--no-first-run",
                                    "--log-level=3",
                                    "--remote-debugging-pipe",
                                    "--user-data-dir=" + folder_.file("profile")};
  words.insert(words.end(), flags.begin(), flags.end());
  ProcessSettings settings;
  settings.descriptors = {orders[0], answers[1]};
  process_.emplace(words, settings);
  ::close(orders[0]);
  ::close(answers[1]);
  to_ = orders[1];
  from_ = answers[0];
  const Json target = call("Target.createTarget", {{"url", "about:blank"}});
  const Json attached = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}});
  session_ = attached["sessionId"];
  for (const char* domain : {"Page", "Runtime", "Log", "Network"}) call(domain + ".enable"s, Json::object());
}

Browser::~Browser() {
  process_.reset();
  ::close(to_);
  ::close(from_);
}

Json Browser::read() {
  std::size_t end = 0;
  while ((end = unread_.find('\0')) == std::string::npos) {
    pollfd wait{from_, POLLIN, 0};
    std::array<char, 65536> buffer;
    const ssize_t count =
        ::poll(&wait, 1, k_answer_limit_ms) > 0 ? ::read(from_, buffer.data(), buffer.size()) : 0;
    if (count <= 0) throw std::runtime_error("the browser does not answer");
    unread_.append(buffer.data(), static_cast<std::size_t>(count));
  }
  Json message = Json::parse(unread_.substr(0, end));
  unread_.erase(0, end + 1);
  return message;
}

Json Browser::call(const std::string& method, const Json& parameters) {
  const int number = ++calls_;
  Json order = {{"id", number}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) order["sessionId"] = session_;
  const std::string text = order.dump() + '\0';
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(to_, text.data() + done, text.size() - done);
    if (count <= 0) throw std::runtime_error("the browser has ended");
    done += static_cast<std::size_t>(count);
  }
  while (true) {
    const Json message = read();
    if (message.value("id", 0) != number) {
      note(message);
    } else if (message.contains("error")) {
      throw std::runtime_error(method + ": " + message["error"].dump());
    } else {
      return message["result"];
    }
  }
}

void Browser::note(const Json& event) {
  const std::string method = event.value("method", "");
  if (method == "Page.loadEventFired") {
    loaded_ = true;
  } else if (method == "Network.requestWillBeSent") {
    const std::string address = event["params"]["request"]["url"];
    if (address.starts_with("http") || address.starts_with("ws")) ++requests_;
  } else if (method == "Log.entryAdded" || method == "Runtime.consoleAPICalled" ||
             method == "Runtime.exceptionThrown") {
    const std::string text = event["params"].dump();
    // What the GL says of its speed is not the page's.
    if (text.find("GL Driver Message") == std::string::npos) messages_.push_back(text);
  }
}

void Browser::resize(int width, int height) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

void Browser::load(const std::string& file) {
  loaded_ = false;
  messages_.clear();
  requests_ = 0;
  call("Page.navigate", {{"url", "file://" + file}});
  while (!loaded_) note(read());
}

Json Browser::value(const std::string& expression) {
  const Json answer =
      call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  EXPECT_FALSE(answer.contains("exceptionDetails")) << answer["exceptionDetails"].dump();
  return answer["result"].value("value", Json());
}

Image Browser::picture() {
  const Json answer = call("Page.captureScreenshot", {{"format", "png"}});
  return read_png(folder_.write("page.png", bytes_of_base64(answer["data"])));
}

}  // namespace moldlight::test
