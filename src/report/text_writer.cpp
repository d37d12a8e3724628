#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "report/writers.hpp"

namespace moldlight::report {

namespace {

constexpr std::size_t k_most_text_rows = 20;
constexpr std::string_view k_gap = "  ", k_no_colour = "\033[0m";

/// Columns of a terminal: bytes that begin a character of UTF-8.
std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// With hyphens for what a page sets as minus and dash: a figure is copied from a terminal into a command.
std::string with_hyphens(std::string text) {
  for (const std::string_view sign : {"−", "–"}) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
      text.replace(at, sign.size(), "-");
  }
  return text;
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string padding(width - std::min(width, columns_of(text)), ' ');
  return left ? text + padding : padding + text;
}

void end_line(std::string& text) {
  text.erase(text.find_last_not_of(' ') + 1);
  text += '\n';
}

class TextWriter {
 public:
  explicit TextWriter(const TerminalStyle& style) : style_(style) {}

  [[nodiscard]] std::string section(const Section& section) const {
    std::string text;
    for (const Block& block : section.blocks)
      text += std::visit([this](const auto& one) { return block_text(one); }, block);
    return text.empty() ? text : "\n" + section.title + "\n" + text;
  }

 private:
  [[nodiscard]] std::string block_text(const FigureGrid& grid) const {
    std::size_t names = 0;
    for (const Figure& figure : grid.figures) names = std::max(names, columns_of(figure.name));
    std::string text;
    for (const Figure& figure : grid.figures) {
      text += padded(figure.name, names, true) + std::string(k_gap) + with_hyphens(figure.value.text);
      if (!figure.unit.empty()) text += (figure.unit == "°" ? "" : " ") + figure.unit;
      if (!figure.error.empty()) text += " ± " + figure.error;
      if (!figure.note.empty()) text += ", " + with_hyphens(figure.note);
      end_line(text);
    }
    return text;
  }

  [[nodiscard]] std::string block_text(const Table& table) const {
    std::vector<std::size_t> shown;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const TableColumnRoom room = table.columns[c].room;
      if (room == TableColumnRoom::any || (room == TableColumnRoom::wide && style_.wide)) shown.push_back(c);
    }
    const std::size_t rows = std::min(table.rows.size(), k_most_text_rows);
    std::vector<std::size_t> widths;
    for (const std::size_t c : shown) {
      std::size_t width = columns_of(table.columns[c].heading);
      for (std::size_t r = 0; r < rows; ++r) width = std::max(width, columns_of(cell(table.rows[r], c)));
      widths.push_back(width);
    }
    std::string text;
    const auto put = [&](std::size_t place, const std::string& words, std::string_view colour) {
      const std::string set = padded(words, widths[place], table.columns[shown[place]].text);
      if (place > 0) text += k_gap;
      text += colour.empty() ? set : fmt::format("{}{}{}", colour, set, k_no_colour);
    };
    for (std::size_t place = 0; place < shown.size(); ++place)
      put(place, table.columns[shown[place]].heading, {});
    end_line(text);
    for (std::size_t r = 0; r < rows; ++r) {
      const Row& row = table.rows[r];
      for (std::size_t place = 0; place < shown.size(); ++place)
        put(place, cell(row, shown[place]),
            style_.colour && place == 0 && row.mark ? row.mark->terminal : "");
      end_line(text);
    }
    if (!table.rest.empty())
      text += table.rest + "\n";
    else if (table.rows.size() > rows)
      text += fmt::format("… {} in all; --json lists them.\n", table.rows.size());
    return table.tiny.empty() ? text : text + table.tiny + "\n";
  }

  [[nodiscard]] std::string block_text(const Text& text) const {
    return text.look == TextLook::command ? std::string() : with_hyphens(text.text) + "\n";
  }

  /// A terminal shows no other.
  template <typename Other>
  [[nodiscard]] std::string block_text(const Other&) const {
    return {};
  }

  [[nodiscard]] static std::string cell(const Row& row, std::size_t column) {
    return column < row.cells.size() ? with_hyphens(row.cells[column].text) : std::string();
  }

  TerminalStyle style_;
};

}  // namespace

std::string to_text(const Report& report, const TerminalStyle& style) {
  std::string text = with_hyphens(report.sentence) + "\n";
  for (const std::string& sentence : report.lead)
    fmt::format_to(std::back_inserter(text), "{}{}\n", k_gap, with_hyphens(sentence));
  fmt::format_to(std::back_inserter(text), "\n{}{}{}\n", report.part, report.subject.empty() ? "" : " ",
                 with_hyphens(report.subject));
  const TextWriter writer(style);
  for (const Section& section : report.sections)
    if (!section.pages_only) text += writer.section(section);
  return text;
}

}  // namespace moldlight::report
