#include "cli/batch_baseline.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "batch/csv.hpp"
#include "batch/part_result.hpp"
#include "classify/number_format.hpp"

namespace moldlight::cli {

using batch::Figure;

namespace {

/// Of the surface: what two versions or machines may round otherwise.
constexpr double k_same_share = 1e-8;
constexpr std::size_t k_most_listed = 20;

/// A figure of a part as criteria name it.
struct BatchFigure {
  std::string_view name;
  Figure figure = Figure::area;
  bool area = false;
};
constexpr std::array<BatchFigure, batch::k_figure_count> k_figures = {
    {{"undercut", Figure::undercut_area, true},
     {"total", Figure::area, true},
     {"projected-area", Figure::projected_area, true},
     {"undercuts", Figure::undercuts, false},
     {"actions", Figure::side_actions, false},
     {"unreleased", Figure::unreleased_area, true},
     {"pieces", Figure::pieces, false},
     {"least-pieces", Figure::piece_bound, false}}};
constexpr std::string_view k_new = "new-parts", k_gone = "gone-parts", k_changed = "changed-parts",
                           k_failed = "failed-parts";

}  // namespace

std::vector<std::string_view> batch_figure_names() {
  std::vector<std::string_view> names;
  for (const BatchFigure& row : k_figures) names.push_back(row.name);
  names.insert(names.end(), {k_verdict_figure, k_new, k_gone, k_changed, k_failed});
  return names;
}

/// Where the table has what is compared.
struct BatchBaseline::Columns {
  std::size_t path = 0, settings = 0, state = 0, unit = 0, verdict = 0, count = 0;
  std::array<std::size_t, batch::k_figure_count> figures{};

  Columns(const std::vector<std::string>& names, const std::string& file) : count(names.size()) {
    const auto place = [&](std::string_view name, bool needed = true) {
      const auto found = std::ranges::find(names, name);
      if (found == names.end() && needed)
        throw FileError(file, "", "is not a table of moldlight batch merge --csv");
      return static_cast<std::size_t>(found - names.begin());
    };
    path = place("path");
    settings = place("settings");
    state = place("state");
    unit = place("unit");
    verdict = place("verdict");
    // Tables of former versions have no pieces.
    for (std::size_t k = 0; k < figures.size(); ++k)
      figures[k] = place(figure_name(static_cast<Figure>(k)), k < static_cast<std::size_t>(Figure::pieces));
  }
};

BatchBaseline::BatchBaseline(std::string file, const Gate& gate)
    : file_(std::move(file)), gate_(gate), applied_(gate.criteria.size()) {
  if (file_.empty()) {
    require_no_change(gate.criteria);
    return;
  }
  std::ifstream stream(file_, std::ios::binary);
  if (!stream) throw FileError(file_, "", "cannot be read");
  batch::CsvReader reader(stream, file_);
  std::vector<std::string> fields;
  if (!reader.next(fields)) fields.clear();
  const Columns columns(fields, file_);
  while (reader.next(fields)) {
    Row row = row_of(columns, fields, reader.line());
    if (row.state == batch::state_name(batch::ResultState::failed)) ++failed_before_;
    rows_of_path_[row.path].push_back(rows_.size());
    rows_.push_back(std::move(row));
  }
}

BatchBaseline::Row BatchBaseline::row_of(const Columns& columns, const std::vector<std::string>& fields,
                                         std::size_t line) const {
  const auto refuse = [&](std::string_view what) {
    throw FileError(file_, fmt::format("line {}", line), std::string(what));
  };
  if (fields.size() != columns.count) refuse("has not as many fields as the table has columns");
  // Tables of former versions hold text that is not yet as spreadsheet_text() has it.
  Row row{batch::spreadsheet_text(fields[columns.path]),
          batch::spreadsheet_text(fields[columns.settings]),
          fields[columns.state],
          batch::spreadsheet_text(fields[columns.unit]),
          fields[columns.verdict],
          {}};
  for (std::size_t k = 0; k < row.figures.size(); ++k) {
    const std::size_t place = columns.figures[k];
    if (place == fields.size() || fields[place].empty()) continue;
    const std::string& text = fields[place];
    row.figures[k] = number_from<double>(text);
    if (!row.figures[k] || !std::isfinite(*row.figures[k])) refuse("has a figure that is not a number");
  }
  return row;
}

BatchBaseline::Row* BatchBaseline::earlier(const batch::PartResult& result) {
  const auto found = rows_of_path_.find(batch::spreadsheet_text(result.path));
  if (found == rows_of_path_.end()) return nullptr;
  const std::string settings = batch::spreadsheet_text(result.settings);
  for (const std::size_t k : found->second)
    if (!rows_[k].found && rows_[k].settings == settings) return &rows_[k];
  Row& first = rows_[found->second.front()];
  return found->second.size() == 1 && !first.found ? &first : nullptr;
}

void BatchBaseline::add(const batch::PartResult& result) {
  using batch::ResultState;
  Row* before = earlier(result);
  if (before != nullptr) before->found = true;
  if (result.state == ResultState::failed) ++failed_;
  if (result.state == ResultState::missing) return;
  if (before == nullptr) ++fresh_;
  if (before == nullptr || before->state == batch::state_name(ResultState::missing))
    return apply_alone(result);
  compare(result, *before);
}

void BatchBaseline::compare(const batch::PartResult& result, const Row& before) {
  const std::string state(batch::state_name(result.state));
  const std::size_t noted = noted_;
  if (state != before.state) note(result.path, "state", before.state, state);
  const bool same_unit = batch::spreadsheet_text(result.unit) == before.unit;
  const bool comparable = same_unit && state == before.state;
  if (!same_unit && state == before.state)
    note(result.path, "unit", before.unit.empty() ? "none" : before.unit,
         result.unit.empty() ? "none" : result.unit);
  std::vector<ComparedFigure> figures;
  const double area = result.figure(Figure::area).value_or(0.0);
  for (const BatchFigure& row : k_figures) {
    const auto was = before.figures[static_cast<std::size_t>(row.figure)], is = result.figure(row.figure);
    if (!comparable || !was || !is) continue;
    const double error = row.area ? k_same_share * area : 0.0;
    figures.push_back({row.name, *was, *is, error, row.area ? area : 0.0});
    if (std::abs(*is - *was) > error) note(result.path, row.name, figure(*was), figure(*is));
  }
  const auto was = verdict_number(before.verdict), is = verdict_number(result.verdict);
  if (state == before.state && was && is) {
    figures.push_back({k_verdict_figure, *was, *is});
    if (result.verdict != before.verdict) note(result.path, k_verdict_figure, before.verdict, result.verdict);
  }
  (noted_ == noted ? same_ : changed_) += 1;
  apply(result.path, figures);
}

void BatchBaseline::apply_alone(const batch::PartResult& result) {
  std::vector<ComparedFigure> figures;
  const double area = result.figure(Figure::area).value_or(0.0);
  for (const BatchFigure& row : k_figures)
    if (const auto is = result.figure(row.figure))
      figures.push_back({row.name, *is, *is, 0.0, row.area ? area : 0.0});
  if (const auto is = verdict_number(result.verdict)) figures.push_back({k_verdict_figure, *is, *is});
  apply(result.path, figures, false);
}

void BatchBaseline::note(const std::string& path, std::string_view what, const std::string& was,
                         const std::string& is) {
  if (++noted_ > k_most_listed) return;
  changes_ += fmt::format("  {}: {} was {}, is {}\n", one_line(path), what, one_line(was), one_line(is));
}

void BatchBaseline::apply(std::string_view path, std::span<const ComparedFigure> figures, bool has_earlier) {
  for (std::size_t k = 0; k < gate_.criteria.size(); ++k) {
    if (gate_.criteria[k].of_change && !has_earlier) continue;
    if (std::ranges::find(figures, std::string_view(gate_.criteria[k].name), &ComparedFigure::name) ==
        figures.end())
      continue;
    applied_[k] = true;
    const GateCase tried =
        gate_cases(path.empty() ? "all parts" : path, {&gate_.criteria[k], 1}, figures).front();
    if (!gate_.junit.empty()) cases_.push_back(tried);
    if (tried.failure.empty() || ++failure_count_ > k_most_listed) continue;
    failures_.push_back(path.empty() ? tried.failure : one_line(path) + ": " + tried.failure);
  }
}

void BatchBaseline::finish() {
  gone_ = static_cast<std::size_t>(std::ranges::count(rows_, false, &Row::found));
  const auto count = [](std::size_t parts) { return static_cast<double>(parts); };
  const std::array<ComparedFigure, 4> counts = {{{k_failed, count(failed_before_), count(failed_)},
                                                 {k_new, 0.0, count(fresh_)},
                                                 {k_gone, 0.0, count(gone_)},
                                                 {k_changed, 0.0, count(changed_)}}};
  apply({}, std::span(counts).first(file_.empty() ? 1 : counts.size()));
  for (std::size_t k = 0; k < gate_.criteria.size(); ++k) {
    if (!applied_[k])
      throw UsageError(fmt::format(
          "--fail-on: no part has {}{}", gate_.criteria[k].name,
          file_.empty() ? " here; counts of changes need --baseline" : " here and in " + one_line(file_)));
  }
}

std::string BatchBaseline::table() const {
  if (file_.empty()) return {};
  std::string text = fmt::format("against {}: {} new, {} gone, {} changed, {} as before\n", one_line(file_),
                                 plural(fresh_, "part"), gone_, changed_, same_);
  text += changes_;
  if (noted_ > k_most_listed) text += fmt::format("  … {} changes in all\n", noted_);
  return text;
}

}  // namespace moldlight::cli
