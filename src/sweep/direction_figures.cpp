#include "sweep/direction_figures.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/similar_word.hpp"
#include "classify/number_format.hpp"
#include "mold/direction.hpp"
#include "mold/measure.hpp"

namespace moldlight {

namespace {

constexpr double k_least_shown_deg = 0.01;
// What is left of undercuts: beside weights of side actions.
constexpr double k_small_rest = 1e-3;    // of the part's area
constexpr double k_small_penalty = 4.0;  // more than any one action
constexpr double k_penalty = 1e4;        // more than all actions of a part
constexpr double k_area_penalty = 1e3;   // for the part's whole area

using Facts = DirectionFacts;
using Found = std::optional<double>;
using Use = DirectionFigure::Use;

constexpr DirectionFigure k_figures[] = {
    {"undercut", "undercut", FigureKind::area, "Area that no mold half releases.",
     Use{.objective = true, .classified = true, .brief = true},
     [](const Facts& f) -> Found { return f.classification.areas[Region::undercut]; }},
    {"undercut_share", "%", FigureKind::per_cent, "Undercut, per cent of the part's area.",
     Use{.classified = true, .brief = true, .yields = true},
     [](const Facts& f) -> Found {
       return 100.0 * share(f.classification.areas[Region::undercut], f.classification.total_area);
     }},
    {"undercut_uncertainty", "±", FigureKind::error, "Uncertainty of the undercut area, 95 % level.",
     Use{.classified = true, .brief = true, .yields = true},
     [](const Facts& f) -> Found { return f.classification.uncertainty.total(); }},
    {"projected_area", "projected", FigureKind::area, "Projected area, on which the clamp force acts.",
     Use{.objective = true}, [](const Facts& f) -> Found { return f.classification.shadow_area; }},
    {"clamp_force", "clamp force", FigureKind::force, "Projected area times the pressure.", Use{},
     [](const Facts& f) {
       const double force = f.settings.pressure * f.classification.shadow_area;
       return force > 0.0 ? Found(force) : std::nullopt;
     }},
    {"draw_depth", "depth", FigureKind::length, "Draw depth: the part's extent along the direction.",
     Use{.objective = true}, [](const Facts& f) -> Found { return f.draw_depth; }},
    {"near_vertical_area", "near-vertical", FigureKind::area,
     "Area of the facets with less draft than the near-vertical tolerance.",
     Use{.objective = true, .column = false},
     [](const Facts& f) -> Found {
       if (f.measured) return f.classification.near_vertical_area;
       return near_vertical_area(f.model.geometry, f.classification.direction, f.settings.method.tau_deg);
     },
     "undraughted_area"},
    {"reverse_draft", "reverse draft", FigureKind::area,
     "Area of near-vertical walls that one half alone reaches and that lean against it.",
     Use{.objective = true, .column = false},
     [](const Facts& f) { return f.measured ? Found(f.classification.reverse_draft.area) : std::nullopt; }},
    {"undercuts", "undercuts", FigureKind::count,
     "Number of undercuts. Marks within the lateral tolerance do not count.",
     Use{.objective = true, .brief = true, .yields = true},
     [](const Facts& f) {
       if (f.actions != nullptr) return Found(static_cast<double>(f.actions->undercuts.count));
       return f.undercuts ? Found(static_cast<double>(*f.undercuts)) : std::nullopt;
     },
     "patches"},
    {"parting_climb", "climb", FigureKind::length,
     "Climb of the parting line along the direction, with shut-offs.",
     Use{.objective = true, .column = false},
     [](const Facts& f) { return f.parting ? Found(f.parting->climb) : std::nullopt; }},
    {"parting_length", "line", FigureKind::length, "Length of the parting line, with shut-offs.",
     Use{.objective = true, .column = false},
     [](const Facts& f) { return f.parting ? Found(f.parting->length) : std::nullopt; }},
    {"travel", "travel", FigureKind::length, "Longest travel of a side action.",
     Use{.objective = true, .of_actions = true},
     [](const Facts& f) { return f.actions ? Found(f.actions->travel) : std::nullopt; }},
    {"unreleased_area", "unreleased", FigureKind::area, "Undercut area that no side action releases.",
     Use{.brief = true, .of_actions = true},
     [](const Facts& f) { return f.actions ? Found(f.actions->totals.unreleased_area) : std::nullopt; }},
    {"side_actions", "side actions", FigureKind::actions,
     "The cheapest set of side actions, ordered by the sum of their weights.",
     Use{.objective = true, .brief = true, .of_actions = true},
     [](const Facts& f) { return f.actions ? Found(f.actions->weight) : std::nullopt; }},
    {"tilt_margin_deg", "tilt", FigureKind::angle,
     "Tilt margin: how far the direction may tilt before the undercut grows.", Use{},
     [](const Facts& f) { return f.tilt ? Found(f.tilt->deg) : std::nullopt; }},
};

std::string objective_name(std::string_view key) {
  std::string name(key);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// The part's own measure of a kind of figure.
double measure_of(FigureKind kind, const PartModel& model) {
  if (kind == FigureKind::length) return model.frame.diagonal;
  if (kind == FigureKind::area)
    return std::max(model.geometry.total_area, std::numeric_limits<double>::min());
  return 1.0;
}

}  // namespace

std::span<const DirectionFigure> direction_figures() { return k_figures; }

const DirectionFigure& direction_figure(std::string_view key) {
  const auto found = std::find_if(std::begin(k_figures), std::end(k_figures),
                                  [&](const auto& figure) { return figure.key == key; });
  CHECK(found != std::end(k_figures));
  return *found;
}

std::vector<std::optional<double>> find_figures(const DirectionFacts& facts) {
  std::vector<std::optional<double>> values;
  for (const DirectionFigure& figure : k_figures) values.push_back(figure.find(facts));
  return values;
}

std::optional<double> figure_value(const DirectionFigure& row, const SweepCandidate& candidate) {
  const auto place = static_cast<std::size_t>(&row - k_figures);
  return place < candidate.figures.size() ? candidate.figures[place] : std::nullopt;
}

std::string figure_text(const DirectionFigure& row, const PartModel& model, const SweepCandidate& candidate) {
  const auto value = figure_value(row, candidate);
  if (!value) return "-";
  if (row.kind == FigureKind::actions) return candidate.actions ? candidate.actions->text() : "-";
  if (row.kind == FigureKind::angle) {
    if (*value >= k_widest_tilt_deg) return fmt::format("> {:g}°", k_widest_tilt_deg);
    return *value < k_least_shown_deg ? fmt::format("< {:g}°", k_least_shown_deg)
                                      : fmt::format("{:.2g}°", *value);
  }
  return (row.kind == FigureKind::area && !candidate.measured ? "≈ " : "") +
         FigureStyle(model).text(row.kind, *value);
}

std::string figure_aside(const DirectionFigure& row, const SweepCandidate& candidate) {
  const auto& tilt = candidate.tilt;
  if (row.kind != FigureKind::angle || !tilt || tilt->at_least()) return {};
  return " to " + lean_text(candidate.classification.direction, tilt->toward);
}

std::string figure_heading(const DirectionFigure& row, const PartModel& model) {
  return FigureStyle(model).heading(row.label, row.kind);
}

std::vector<const DirectionFigure*> figure_columns(const SweepResult& result) {
  std::vector<const DirectionFigure*> columns;
  for (const DirectionFigure& figure : k_figures) {
    const bool known = std::any_of(result.candidates.begin(), result.candidates.end(),
                                   [&](const auto& c) { return figure_value(figure, c).has_value(); });
    const bool ranked_by = std::ranges::any_of(
        result.settings.objective.terms, [&](const Objective::Term& term) { return term.figure == &figure; });
    if ((figure.use.column || ranked_by) && known) columns.push_back(&figure);
  }
  return columns;
}

void keep_brief(std::vector<const DirectionFigure*>& columns) {
  const bool with_actions = std::ranges::any_of(columns, [](const auto* c) { return c->use.of_actions; });
  std::erase_if(columns, [&](const auto* c) { return !c->use.brief || (with_actions && c->use.yields); });
}

std::vector<std::string_view> objective_names() {
  static const std::vector<std::string> k_names = [] {
    std::vector<std::string> names;
    for (const DirectionFigure& figure : k_figures) {
      if (figure.use.objective) names.push_back(objective_name(figure.key));
    }
    return names;
  }();
  return {k_names.begin(), k_names.end()};
}

Objective parse_objective(std::string_view text) {
  Objective objective{.text = std::string(text), .terms = {}};
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view term = rest.substr(0, comma);
    const std::size_t colon = term.find(':');
    const std::string_view name = term.substr(0, colon);
    const auto found =
        std::find_if(std::begin(k_figures), std::end(k_figures), [&](const DirectionFigure& figure) {
          return figure.use.objective && (objective_name(figure.key) == name ||
                                          (!figure.former.empty() && objective_name(figure.former) == name));
        });
    if (found == std::end(k_figures)) {
      throw UsageError(fmt::format("--objective: '{}' is not one of {}{}", name,
                                   fmt::join(objective_names(), ", "),
                                   did_you_mean(name, objective_names())));
    }
    double weight = 1.0;
    if (colon != std::string_view::npos) {
      const std::string_view number = term.substr(colon + 1);
      weight = number_from<double>(number).value_or(-1.0);
      if (!(weight >= 0.0) || !std::isfinite(weight)) {
        throw UsageError(fmt::format("--objective: the weight '{}' is not a number of at least 0", number));
      }
    }
    if (weight > 0.0) objective.terms.push_back({&*found, weight});
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (objective.terms.empty()) throw UsageError("--objective: all weights are 0");
  return objective;
}

bool needs_actions(const Objective& objective) {
  return std::ranges::any_of(objective.terms,
                             [](const Objective::Term& term) { return term.figure->use.of_actions; });
}

bool seeks_actions(const SweepSettings& settings) {
  return settings.actions || settings.rank == SweepRank::mold || needs_actions(settings.objective);
}

double unreleased_penalty(const DirectionFacts& facts) {
  if (facts.actions == nullptr) return 0.0;
  const double area = facts.actions->totals.unreleased_area;
  if (area <= facts.classification.uncertainty.rounding) return 0.0;
  const double rest = area / measure_of(FigureKind::area, facts.model);
  return (rest <= k_small_rest ? k_small_penalty : k_penalty) + k_area_penalty * rest;
}

double objective_value(const Objective& objective, const DirectionFacts& facts) {
  double value = 0.0;
  for (const Objective::Term& term : objective.terms) {
    const double found = term.figure->find(facts).value_or(0.0);
    const double penalty = term.figure->use.of_actions ? unreleased_penalty(facts) : 0.0;
    value += term.weight * (found / measure_of(term.figure->kind, facts.model) + penalty);
  }
  return value;
}

}  // namespace moldlight
