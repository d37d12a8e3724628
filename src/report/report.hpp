// A report as a value: what it says, without how it looks. Writers make a page, a PDF or a terminal's text of
// the same value.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/image.hpp"
#include "mold/region.hpp"
#include "report/live_view.hpp"
#include "report/model_view.hpp"

namespace moldlight::report {

/// A small sample of a colour.
struct Mark {
  Colour colour = {};
  bool hatched = false;
  std::string_view terminal = {};  // the code that sets it there; none for what a terminal shows without
};

/// A text for people; where it is a figure, also the number and where the JSON report has it (a JSON
/// pointer).
struct Value {
  std::string text = {};
  std::string key = {};  // empty: no figure of the JSON report
  double number = 0.0;
};

struct Figure {
  std::string name;
  Value value;
  std::string unit = {}, note = {}, error = {};  // error without its ±
};
struct FigureGrid {
  std::vector<Figure> figures;
};

/// One bar of the parts of a whole.
struct ShareBar {
  struct Share {
    Mark mark;
    double share = 0.0;  // [0, 1]
    std::string name;
  };
  std::vector<Share> shares;
};

/// Where a column is shown: pages have room for all.
enum class TableColumnRoom : std::uint8_t { any, wide, pages };
struct TableColumn {
  std::string heading;
  bool text = false;  // else figures, which stand at the right
  TableColumnRoom room = TableColumnRoom::any;
};
struct Row {
  std::vector<Value> cells;
  std::optional<Mark> mark = {};
  Image picture = {};  // may be empty
  std::string picture_text = {};
};
struct Table {
  std::vector<TableColumn> columns;
  std::vector<Row> rows;
  std::string rest = {};  // what is said of rows that are left out
  std::string tiny = {};  // the last row, of all that is below a tolerance
};

struct Picture {
  Image light = {}, dark = {};  // by theme; dark may be empty: `light` is transparent, and for both
  std::string text;             // what it shows, for who does not see it
  std::string caption = {};
};
struct Pictures {
  std::vector<Picture> pictures;
};

/// Areas by draft, stacked: of core and of cavity.
struct DraftBars {
  struct Bar {
    double from_deg = 0.0, to_deg = 0.0;
    double core = 0.0, cavity = 0.0;
  };
  std::vector<Bar> bars;  // of equal width, rising
  std::optional<double> required_deg = {};
  Mark core, cavity;
  std::string unit;  // of areas
};

enum class TextLook : std::uint8_t { normal, quiet, notice, command };
struct Text {
  std::string text;
  TextLook look = TextLook::normal;
};

/// Names and values, such as settings.
struct Facts {
  std::vector<std::pair<std::string, std::string>> facts;
};

using Block = std::variant<FigureGrid, ShareBar, Table, Pictures, DraftBars, Text, Facts>;

/// The block that a drawing has in its corner: facts first.
struct TitleBlock {
  Image logo;
  std::vector<Block> blocks;
};

struct Section {
  std::string title;
  std::vector<Block> blocks;
  bool pages_only = false;  // left out of a terminal's text

  void add(Block block) { blocks.push_back(std::move(block)); }
  void add(std::string text, TextLook look = TextLook::normal) {
    blocks.emplace_back(Text{std::move(text), look});
  }
};

/// Who sends the report, and of what; what is empty is not known.
struct TitleFacts {
  std::string revision = {}, material = {}, company = {}, author = {}, date = {}, note = {};
  Image logo = {};
};
enum class Tone : std::uint8_t { good, attention, bad };

struct Report {
  std::string kind;      // "Parting direction", …
  std::string part;      // name of the part's file
  std::string subject;   // "along +Z"
  std::string sentence;  // the verdict
  Tone tone = Tone::good;
  std::vector<std::string> lead;         // sentences below it
  std::optional<TitleBlock> title = {};  // for pages
  Picture still;                         // what stands for the view where there is none
  std::optional<ModelView> view;
  std::optional<LiveView> live;  // of the same part and direction as `view`
  std::string live_notice;       // where it draws a coarser mesh
  std::vector<Section> sections;

  /// The sentences below the verdict as one paragraph.
  [[nodiscard]] std::string paragraph() const {
    std::string text;
    for (const std::string& one : lead) text += (text.empty() ? "" : " ") + one;
    return text;
  }
};

}  // namespace moldlight::report
