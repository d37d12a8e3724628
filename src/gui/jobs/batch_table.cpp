#include "gui/jobs/batch_table.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/shown_text.hpp"
#include "classify/json.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "classify/option_json.hpp"

namespace moldlight::gui {

namespace {

using batch::Figure;
using batch::PartResult;
struct ColumnFacts {
  std::string_view name;
  std::optional<double> (*value)(const PartResult&) = nullptr;  // of figures
};
template <Figure k_figure>
std::optional<double> figure_of(const PartResult& row) {
  return row.figure(k_figure);
}
/// By BatchColumn.
constexpr std::array<ColumnFacts, 8> k_batch_columns = {
    {{"part"},
     {"state"},
     {"undercut", figure_of<Figure::undercut_area>},
     {"share", [](const PartResult& row) { return row.undercut_share(); }},
     {"undercuts", figure_of<Figure::undercuts>},
     {"side actions", figure_of<Figure::side_actions>},
     {"not released", figure_of<Figure::unreleased_area>},
     {"pieces", figure_of<Figure::pieces>}}};

std::optional<double> value_of(const PartResult& row, BatchColumn column) {
  const auto value = k_batch_columns[static_cast<std::size_t>(column)].value;
  return value != nullptr ? value(row) : std::nullopt;
}

/// The settings among these that a table of options has.
template <typename S>
void take_settings(std::span<const Option<S>> options, S& settings, const Json& effective) {
  Json known = Json::object();
  for (const Option<S>& option : options) {
    const std::string key(option.key);
    if (effective.contains(key)) known[key] = effective[key];
  }
  set_options(options, settings, known);
}

}  // namespace

BatchTable load_batch_table(const std::string& path, const Progress& progress) {
  BatchTable table;
  table.manifest = batch::read_manifest(path);
  table.rows.reserve(table.manifest.rows);
  table.counts = batch::for_each_result(table.manifest, progress,
                                        [&](const PartResult& row) { table.rows.push_back(row); });
  return table;
}

std::string_view batch_column_name(BatchColumn column) {
  return k_batch_columns[static_cast<std::size_t>(column)].name;
}

std::string batch_cell(const PartResult& row, BatchColumn column) {
  if (column == BatchColumn::part) return shown_text(row.path);
  if (column == BatchColumn::state) return std::string(batch::state_name(row.state));
  const auto value = value_of(row, column);
  if (!value) return "";
  return column == BatchColumn::share ? fmt::format("{:.2f} %", 100.0 * *value) : figure(*value);
}

std::vector<BatchColumn> used_columns(const BatchTable& table) {
  std::vector<BatchColumn> used;
  for (int k = 0; k <= static_cast<int>(BatchColumn::pieces); ++k) {
    const auto column = static_cast<BatchColumn>(k);
    const auto has = [&](const PartResult& row) { return value_of(row, column).has_value(); };
    if (is_text(column) || std::ranges::any_of(table.rows, has)) used.push_back(column);
  }
  return used;
}

std::vector<std::size_t> ordered_rows(const BatchTable& table, const BatchOrder& order) {
  std::vector<std::string> words;
  std::istringstream text(lower_letters(order.filter));
  for (std::string word; text >> word;) words.push_back(word);
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const PartResult& row = table.rows[k];
    const std::string all = lower_letters(
        fmt::format("{} {} {} {}", row.path, row.settings, batch::state_name(row.state), row.reason));
    const auto is_in = [&](const std::string& word) { return all.find(word) != std::string::npos; };
    if (std::ranges::all_of(words, is_in)) rows.push_back(k);
  }
  const BatchColumn column = order.column;
  std::ranges::stable_sort(rows, [&](std::size_t a, std::size_t b) {
    const PartResult &first = table.rows[a], &second = table.rows[b];
    if (is_text(column)) {
      const std::string x = batch_cell(first, column), y = batch_cell(second, column);
      return order.descending ? y < x : x < y;
    }
    const auto x = value_of(first, column), y = value_of(second, column);
    if (!x || !y) return x.has_value() && !y.has_value();
    return order.descending ? *x > *y : *x < *y;
  });
  return rows;
}

BatchPart batch_part(const BatchTable& table, std::size_t number) {
  const PartResult& row = table.rows[number];
  const Json& effective = table.manifest.settings[row.settings_number].effective;
  BatchPart part;
  part.path = (std::filesystem::path(table.manifest.parts_folder()) / row.path).lexically_normal().string();
  take_settings(reading_options(), part.reading, effective);
  take_settings(method_options(), part.notes.settings.method, effective);
  part.notes.unit = part.reading.unit;
  if (row.direction) {
    const auto& d = *row.direction;
    part.notes.settings.direction = glm::dvec3(d[0], d[1], d[2]);
  } else if (const auto d = effective.find("direction"); d != effective.end() && d->is_array()) {
    part.notes.settings.direction =
        glm::dvec3((*d)[0].get<double>(), (*d)[1].get<double>(), (*d)[2].get<double>());
  }
  return part;
}

}  // namespace moldlight::gui
