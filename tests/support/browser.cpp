#include "support/browser.hpp"

#include <iterator>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/process.hpp"
#include "support/program_path.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::test {

namespace {

std::string browser() { return program_path({"chromium", "chromium-browser", "google-chrome"}); }

ProcessResult run_browser(const std::string& page, std::vector<std::string> flags,
                          const ScratchFolder& folder) {
  std::vector<std::string> words = {browser(),
                                    "--headless",
                                    "--no-sandbox",
                                    "--use-angle=swiftshader",
                                    "--enable-unsafe-swiftshader",
                                    "--disable-background-networking",
                                    "--disable-component-update",
                                    "--no-first-run",
                                    "--user-data-dir=" + folder.file("profile"),
                                    "--enable-logging=stderr",
                                    "--virtual-time-budget=10000"};
  words.insert(words.end(), flags.begin(), flags.end());
  words.push_back(page);
  Process process(words, {});
  ProcessResult result = process.finish();
  EXPECT_FALSE(result.timed_out) << result.err;
  return result;
}

}  // namespace

bool has_browser() { return !browser().empty(); }

LoadedPage load_page(const std::string& file, const std::string& fragment,
                     const std::vector<std::string>& flags) {
  const ScratchFolder folder;
  const std::string log = folder.file("net.json");
  std::vector<std::string> all = flags;
  all.insert(all.end(), {"--dump-dom", "--log-net-log=" + log});
  const ProcessResult run = run_browser("file://" + file + "#" + fragment, all, folder);
  LoadedPage page{run.out, {}, 0};
  std::istringstream lines(run.err);
  for (std::string line; std::getline(lines, line);)
    // What the GL says of its speed is not the page's.
    if (line.find("CONSOLE") != std::string::npos && line.find("GL Driver Message") == std::string::npos)
      page.messages.push_back(line);
  const std::string net = file_bytes(log);
  EXPECT_FALSE(net.empty()) << run.err;
  // Requests of the browser itself, such as for updates, are for no page.
  const std::regex request(R"re(\{site=file:[^"]*","url":"(http|ws))re");
  page.requests = static_cast<std::size_t>(
      std::distance(std::sregex_iterator(net.begin(), net.end(), request), std::sregex_iterator()));
  return page;
}

Image picture_of_page(const std::string& file, int width, int height) {
  const ScratchFolder folder;
  const std::string picture = folder.file("page.png");
  static_cast<void>(
      run_browser("file://" + file,
                  {fmt::format("--window-size={},{}", width, height), "--screenshot=" + picture}, folder));
  return read_png(picture);
}

void print_page(const std::string& file, const std::string& pdf) {
  const ScratchFolder folder;
  static_cast<void>(
      run_browser("file://" + file, {"--no-pdf-header-footer", "--print-to-pdf=" + pdf}, folder));
}

}  // namespace moldlight::test
