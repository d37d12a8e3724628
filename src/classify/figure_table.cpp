#include "classify/figure_table.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/number_format.hpp"

namespace moldlight {

namespace {
/// Of the part's own measures: what is less is rounding.
constexpr double k_least_shown_share = 1e-6;

/// What would be written with six digits or more has zeros below the fourth.
double four_digits(double value) {
  constexpr double k_least = 99'999.5;
  if (!(std::abs(value) >= k_least) || !std::isfinite(value)) return value;
  const double last = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3.0);
  return last * std::round(value / last);
}
}  // namespace

void put_figures(const std::vector<FoundFigure>& figures, Json& json) {
  for (const FoundFigure& figure : figures) {
    if (figure.key.empty()) continue;
    Json& place = json[Json::json_pointer("/" + std::string(figure.key))];
    place = nullptr;
    if (!figure.value || !std::isfinite(*figure.value)) continue;
    if (figure.kind == FigureKind::count)
      place = static_cast<std::int64_t>(std::llround(*figure.value));
    else if (figure.kind == FigureKind::flag)
      place = *figure.value != 0.0;
    else
      place = *figure.value;
  }
}

FigureStyle::FigureStyle(const PartModel& model)
    : length_(length_unit(model.part)),
      area_(powered_unit(model.part, 2)),
      volume_(powered_unit(model.part, 3)),
      least_length_(k_least_shown_share * model.frame.diagonal),
      least_area_(k_least_shown_share * model.geometry.total_area),
      least_volume_(k_least_shown_share * std::abs(model.health.volume)) {}

std::string FigureStyle::text(FigureKind kind, double value) const {
  switch (kind) {
    case FigureKind::error:
      return error_text(std::abs(value), least_area_);
    case FigureKind::gap:
      return error_text(std::abs(value), k_least_shown_share);
    case FigureKind::share:
      return fmt::format("{:.1f} %", 100.0 * value);
    case FigureKind::per_cent:
      return fmt::format("{:.2f}", value);
    case FigureKind::count:
      return fmt::format("{:.0f}", value);
    case FigureKind::angle:
      return fmt::format("{:.1f}°", value);
    case FigureKind::area:
    case FigureKind::volume:
      return rounded(four_digits(value), least(kind));
    case FigureKind::length:
    case FigureKind::number:
    case FigureKind::force:
    case FigureKind::actions:
    case FigureKind::flag:
      break;
  }
  return rounded(value, least(kind));
}

std::string FigureStyle::change(FigureKind kind, double value) const {
  if (std::abs(value) <= least(kind)) return "0";
  return (value > 0.0 ? "+" : "") + text(kind, value);
}

double FigureStyle::least(FigureKind kind) const {
  if (kind == FigureKind::area) return least_area_;
  if (kind == FigureKind::length) return least_length_;
  return kind == FigureKind::volume ? least_volume_ : 0.0;
}

bool FigureStyle::is_shown(const FoundFigure& figure, bool details) const {
  if (figure.title.empty() || !figure.value || (figure.shown == FigureShown::details) != details)
    return false;
  return figure.shown == FigureShown::always || std::abs(*figure.value) > least(figure.kind);
}

std::string FigureStyle::text(const FoundFigure& figure) const {
  return figure.value ? text(figure.kind, *figure.value) : "-";
}

std::string FigureStyle::unit(FigureKind kind) const {
  if (kind == FigureKind::area || kind == FigureKind::error) return area_;
  if (kind == FigureKind::length) return length_;
  return kind == FigureKind::volume ? volume_ : std::string();
}

std::string area_with_unit(const PartModel& model, double area) {
  return grouped(rounded_area(four_digits(area), model.geometry.total_area)) + " " +
         powered_unit(model.part, 2);
}

std::string FigureStyle::with_unit(FigureKind kind, double value) const {
  const std::string beside = unit(kind);
  return text(kind, value) + (beside.empty() ? "" : " " + beside);
}

std::string FigureStyle::point(const glm::dvec3& place) const {
  const auto text = [this](double value) {
    return std::abs(value) < least_length_ ? std::string("0") : rounded(value);
  };
  return fmt::format("{}, {}, {}", text(place.x), text(place.y), text(place.z));
}

std::string FigureStyle::heading(std::string_view title, FigureKind kind) const {
  const std::string beside = unit(kind);
  return std::string(title) + (beside.empty() ? "" : " " + beside);
}

}  // namespace moldlight
