#include "compare/criteria.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "actions/verdict_state.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/shown_text.hpp"
#include "base/similar_word.hpp"
#include "classify/number_format.hpp"

namespace moldlight {

namespace {

constexpr std::string_view k_flag = "--fail-on";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// For an error.
std::string shown(std::string_view text) { return shown_text(text, 60); }

Criterion parse_criterion(std::string_view text, std::span<const std::string_view> names) {
  const std::size_t at = text.find('>');
  if (at == std::string_view::npos)
    throw UsageError(
        fmt::format("{}: “{}” is not a criterion; write FIGURE > VALUE, such as \"undercut > +1%\"", k_flag,
                    shown(text)));
  Criterion criterion{.text = std::string(text), .name = std::string(trimmed(text.substr(0, at)))};
  if (std::ranges::find(names, criterion.name) == names.end())
    throw UsageError(fmt::format("{}: there is no figure “{}”; there are {}{}", k_flag, shown(criterion.name),
                                 fmt::join(names, ", "), did_you_mean(criterion.name, names)));
  std::string_view value = text.substr(at + 1);
  if (value.starts_with('=')) {
    criterion.or_equal = true;
    value.remove_prefix(1);
  }
  value = trimmed(value);
  criterion.of_change = value.starts_with('+') || value.starts_with('-');
  if (value.starts_with('+')) value.remove_prefix(1);
  criterion.per_cent = value.ends_with('%');
  if (criterion.per_cent) value = trimmed(value.substr(0, value.size() - 1));
  const bool of_state = criterion.name == k_verdict_figure;
  const auto number = of_state ? verdict_number(value) : number_from<double>(value);
  if (of_state && !number)
    throw UsageError(fmt::format("{}: “{}” is not a verdict; there are {}", k_flag, shown(value),
                                 fmt::join(k_verdict_states, ", ")));
  if (!number || !std::isfinite(*number))
    throw UsageError(
        fmt::format("{}: “{}” has no value; write a number, with + for a change, with % for a share", k_flag,
                    shown(text)));
  criterion.value = *number;
  return criterion;
}

const ComparedFigure& figure_of(const Criterion& criterion, std::span<const ComparedFigure> figures) {
  const auto found = std::ranges::find(figures, criterion.name, &ComparedFigure::name);
  if (found == figures.end())
    throw UsageError(fmt::format("{}: {} is not defined for these parts", k_flag, criterion.name));
  if (criterion.per_cent && !criterion.of_change && found->whole <= 0.0)
    throw UsageError(
        fmt::format("{}: {} has no share; leave out the % or write + for a change", k_flag, criterion.name));
  return *found;
}

std::string percent_text(const ComparedFigure& figure) {
  if (figure.name == k_verdict_figure) return {};
  const std::string change = change_percent(figure.before, figure.after);
  return change.empty() ? change : fmt::format(" ({})", change);
}

}  // namespace

std::string value_text(const ComparedFigure& compared, double value) {
  return compared.name == k_verdict_figure ? std::string(k_verdict_states[static_cast<std::size_t>(value)])
                                           : figure(value);
}

std::string change_text(const ComparedFigure& compared) {
  const double change = compared.after - compared.before;
  if (!(std::abs(change) > 0.0)) return {};
  if (compared.name == k_verdict_figure) return change > 0.0 ? "worse" : "better";
  return fmt::format("{:+.6g}", change);
}

std::optional<double> verdict_number(std::string_view state) {
  const auto found = std::ranges::find(k_verdict_states, state);
  return found == k_verdict_states.end()
             ? std::nullopt
             : std::optional(static_cast<double>(found - k_verdict_states.begin()));
}

std::string change_percent(double before, double after) {
  const double change = before > 0.0 ? 100.0 * (after - before) / before : 0.0;
  constexpr double k_least_shown = 0.005;
  return std::abs(change) < k_least_shown ? std::string() : fmt::format("{:+.2f} %", change);
}

bool Criterion::is_met_by(const ComparedFigure& figure) const {
  double compared = figure.after;
  if (of_change) {
    compared = figure.after - figure.before;
    if (std::abs(compared) <= figure.error) compared = 0.0;
    if (per_cent) {
      if (figure.before == 0.0 && compared != 0.0) return compared > 0.0;
      compared = compared == 0.0 ? 0.0 : 100.0 * compared / std::abs(figure.before);
    }
  } else if (per_cent) {
    compared = 100.0 * figure.after / figure.whole;
  }
  return or_equal ? compared >= value : compared > value;
}

std::vector<Criterion> parse_criteria(std::string_view text, std::span<const std::string_view> names) {
  std::vector<Criterion> criteria;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    criteria.push_back(parse_criterion(trimmed(text.substr(begin, end - begin)), names));
    begin = end + 1;
  }
  return criteria;
}

std::vector<std::string> met_criteria(std::span<const Criterion> criteria,
                                      std::span<const ComparedFigure> figures) {
  std::vector<std::string> sentences;
  for (const Criterion& criterion : criteria) {
    const ComparedFigure& found = figure_of(criterion, figures);
    if (!criterion.is_met_by(found)) continue;
    const std::string was = found.before == found.after
                                ? std::string()
                                : fmt::format("was {}, ", value_text(found, found.before));
    sentences.push_back(fmt::format("criterion failed: {}: {} {}is {}{}", criterion.text, found.name, was,
                                    value_text(found, found.after), percent_text(found)));
  }
  return sentences;
}

std::string figure_changes_table(std::span<const ComparedFigure> figures) {
  std::string text;
  for (const ComparedFigure& one : figures) {
    const double change = one.after - one.before;
    if (std::abs(change) <= one.error) continue;
    text += fmt::format("{:<20} {:>12} {:>12} {:>12}{}\n", one.name, value_text(one, one.before),
                        value_text(one, one.after), change_text(one), percent_text(one));
  }
  if (text.empty()) return "No figure changed.\n";
  return fmt::format("{:<20} {:>12} {:>12} {:>12}\n", "figure", "was", "is", "change") + text;
}

}  // namespace moldlight
