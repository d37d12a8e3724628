// A real browser, Chromium without a window, that tests look at pages with; where it is not installed they
// skip. It is spoken to by the DevTools protocol over pipes, so that the policy of a page holds and yet tests
// can ask it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/png.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::test {

[[nodiscard]] bool has_browser();

/// A running browser with one page. Throws std::runtime_error where it does not answer within three minutes.
class Browser {
 public:
  using Json = nlohmann::ordered_json;

  /// `flags` are the browser's, more than the usual ones.
  explicit Browser(const std::vector<std::string>& flags = {});
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// The page's room, px.
  void resize(int width, int height);
  /// Loads a file in place of the page before, until its scripts have run; what they wait for may be to come.
  void load(const std::string& file);
  /// What an expression is in the page, once that is known where it is a promise. A test fails where it
  /// throws.
  [[nodiscard]] Json value(const std::string& expression);
  /// What the page shows.
  [[nodiscard]] Image picture();

  /// Of the page that is loaded: errors, what it says in its console, and what its policy has blocked.
  [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
  /// How many requests it has made over a network.
  [[nodiscard]] std::size_t requests() const { return requests_; }

 private:
  Json call(const std::string& method, const Json& parameters);
  Json read();
  void note(const Json& event);

  ScratchFolder folder_;
  std::optional<Process> process_;
  int to_ = -1, from_ = -1;
  std::string unread_, session_;
  int calls_ = 0;
  bool loaded_ = false;
  std::vector<std::string> messages_;
  std::size_t requests_ = 0;
};

}  // namespace moldlight::test
