#include "cli/report_flags.hpp"

#include <algorithm>

#include "cli/console.hpp"
#include "cli/flags.hpp"
#include "report/html_writer.hpp"

namespace moldlight::cli {

namespace {

/// Whether a shell takes the letter as it is.
bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-+=:,./@%").find(c) != std::string_view::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

void add_report_flags(CLI::App& command, ReportFlags& flags, const Request& request) {
  flags.request = &request;
  add_file_flag(
      command, flags.html,
      {"--html", "FILE.html",
       "Write a report that opens in any browser without a network: verdict, figures, pictures, and "
       "the part to turn, open and cut"});
  CLI::Option* pdf =
      add_file_flag(command, flags.pdf, {"--pdf", "FILE.pdf", "Write the same report as pages for paper"});
  add_text_flag(command, {"--paper", "a4|letter", "Size of the pages of --pdf [default a4]"},
                [&flags](const std::string& text) {
                  if (text != "a4" && text != "letter")
                    throw UsageError(fmt::format("--paper: '{}' is not a4 or letter", one_line(text)));
                  flags.paper = text == "a4" ? report::Paper::a4 : report::Paper::letter;
                })
      ->needs(pdf);
}

report::ReportContext report_context(const ReportFlags& flags, const gl::Context& context,
                                     std::shared_ptr<const PartModel> model, Palette palette,
                                     const Progress& progress) {
  return {.model = std::move(model),
          .progress = progress,
          .gl = &context,
          .palette = palette,
          .version = MOLDLIGHT_VERSION,
          .command = command_text(flags.request->words)};
}

void write_reports(const ReportFlags& flags, const report::Report& report) {
  if (!flags.html.empty()) report::write_html(flags.html, report);
  if (!flags.pdf.empty()) report::write_pdf(flags.pdf, report, flags.paper);
}

std::string command_text(const std::vector<std::string>& words) {
  std::string text = "moldlight";
  for (const std::string& word : words) text += " " + quoted(word);
  return text;
}

}  // namespace moldlight::cli
