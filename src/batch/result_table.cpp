#include "batch/result_table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "classify/number_format.hpp"

namespace moldlight::batch {

namespace {

struct RowColumnFacts {
  std::string_view name;
  std::optional<double> (*value)(const PartResult&) = nullptr;  // of figures
};
template <Figure k_figure>
std::optional<double> figure_of(const PartResult& row) {
  return row.figure(k_figure);
}
/// By RowColumn.
constexpr std::array<RowColumnFacts, 9> k_table_columns = {
    {{"part"},
     {"verdict"},
     {"unit"},
     {"undercut", figure_of<Figure::undercut_area>},
     {"share", [](const PartResult& row) { return row.undercut_share(); }},
     {"undercuts", figure_of<Figure::undercuts>},
     {"side actions", figure_of<Figure::side_actions>},
     {"not released", figure_of<Figure::unreleased_area>},
     {"pieces", figure_of<Figure::pieces>}}};

std::optional<double> column_value(const PartResult& row, RowColumn column) {
  const auto value = k_table_columns[static_cast<std::size_t>(column)].value;
  return value != nullptr ? value(row) : std::nullopt;
}

}  // namespace

std::string_view column_name(RowColumn column) {
  return k_table_columns[static_cast<std::size_t>(column)].name;
}

std::string cell_text(const PartResult& row, RowColumn column) {
  if (column == RowColumn::part) return shown_text(row.path);
  if (column == RowColumn::unit) return row.unit;
  if (column == RowColumn::verdict) {
    const std::string state(state_name(row.state));
    return !row.sentence.empty() ? row.sentence : row.reason.empty() ? state : state + ": " + row.reason;
  }
  const auto value = column_value(row, column);
  if (!value) return "";
  const bool area = column == RowColumn::undercut || column == RowColumn::unreleased;
  return column == RowColumn::share ? fmt::format("{:.2f} %", 100.0 * *value)
         : area ? fmt::format("{} {}²", figure(*value), row.unit.empty() ? "unit" : row.unit)
                : figure(*value);
}

std::vector<RowColumn> used_columns(std::span<const PartResult> rows) {
  std::vector<RowColumn> used;
  for (int k = 0; k <= static_cast<int>(RowColumn::pieces); ++k) {
    const auto column = static_cast<RowColumn>(k);
    const auto has = [&](const PartResult& row) {
      return is_text(column) ? !cell_text(row, column).empty() : column_value(row, column).has_value();
    };
    if (std::ranges::any_of(rows, has)) used.push_back(column);
  }
  return used;
}

std::vector<std::size_t> ordered_rows(std::span<const PartResult> results, const RowOrder& order) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const PartResult& row = results[k];
    if (has_words(fmt::format("{} {} {} {} {}", row.path, row.settings, state_name(row.state), row.reason,
                              row.sentence),
                  order.filter))
      rows.push_back(k);
  }
  const RowColumn column = order.column;
  std::ranges::stable_sort(rows, [&](std::size_t a, std::size_t b) {
    const PartResult &first = results[a], &second = results[b];
    if (is_text(column)) {
      const std::string x = cell_text(first, column), y = cell_text(second, column);
      return order.descending ? y < x : x < y;
    }
    const auto x = column_value(first, column), y = column_value(second, column);
    if (!x || !y) return x.has_value() && !y.has_value();
    return order.descending ? *x > *y : *x < *y;
  });
  return rows;
}

}  // namespace moldlight::batch
