// Tables of figures: a row states once under which key JSON has a figure, what people call it, what it is a
// number of, and how it is found. JSON, pages, the terminal and the window read the same rows.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "classify/json.hpp"
#include "classify/part_model.hpp"

namespace moldlight {

/// What a figure is a number of: this decides its unit and its digits. Error: how far an area may be off.
/// Gap: what rounding leaves of a whole. Share: in [0, 1]. Actions: weights of side actions, shown in words.
/// Flag: yes or no, for JSON.
enum class FigureKind : std::uint8_t {
  area,
  error,
  gap,
  share,
  per_cent,
  length,
  volume,
  count,
  number,
  force,
  angle,
  actions,
  flag
};

/// Where people see a figure: those of `details` stand apart, for who checks the others.
enum class FigureShown : std::uint8_t { always, unless_nothing, details };

template <typename Of>
struct FigureRow {
  std::string_view key;    // in JSON, "a/b" for b of a; empty: for people alone
  std::string_view title;  // heads its column, or stands before it; empty: for programs alone
  FigureKind kind = FigureKind::number;
  std::optional<double> (*find)(const Of& of) = nullptr;  // none where it is not known
  std::string_view help = {};                             // what the title does not say
  FigureShown shown = FigureShown::always;
};

/// How a row finds a figure that is a member, or a member of a member.
template <auto k_member, auto... k_inner, typename Of>
[[nodiscard]] std::optional<double> member(const Of& of) {
  if constexpr (sizeof...(k_inner) > 0)
    return member<k_inner...>(std::invoke(k_member, of));
  else
    return static_cast<double>(std::invoke(k_member, of));
}

/// A row's figure of one thing.
struct FoundFigure {
  std::string_view key, title, help;
  FigureKind kind = FigureKind::number;
  std::optional<double> value;
  FigureShown shown = FigureShown::always;
};

template <typename Of>
[[nodiscard]] std::vector<FoundFigure> found_figures(std::span<const FigureRow<Of>> rows, const Of& of) {
  std::vector<FoundFigure> found;
  for (const FigureRow<Of>& row : rows)
    found.push_back({row.key, row.title, row.help, row.kind, row.find(of), row.shown});
  return found;
}

/// Sets what has a key, with all digits; null what is not known.
void put_figures(const std::vector<FoundFigure>& figures, Json& json);

/// "982.2 mm²", of the part's surface.
[[nodiscard]] std::string area_with_unit(const PartModel& model, double area);

/// Digits and units for people: four digits, none below what rounding leaves of the part's own measures.
class FigureStyle {
 public:
  explicit FigureStyle(const PartModel& model);

  /// Without its unit, but for "%" and "°".
  [[nodiscard]] std::string text(FigureKind kind, double value) const;
  /// A difference, with its sign; "0" where rounding leaves none.
  [[nodiscard]] std::string change(FigureKind kind, double value) const;
  /// Whether people see it, among the details or not among them.
  [[nodiscard]] bool is_shown(const FoundFigure& figure, bool details = false) const;
  /// "-" where it is not known.
  [[nodiscard]] std::string text(const FoundFigure& figure) const;
  /// "mm²"; empty for what has none, or shows it with the figure.
  [[nodiscard]] std::string unit(FigureKind kind) const;
  /// "12.3 mm²".
  [[nodiscard]] std::string with_unit(FigureKind kind, double value) const;
  /// "12.3, 0, -4".
  [[nodiscard]] std::string point(const glm::dvec3& place) const;
  /// "area mm²": over a column.
  [[nodiscard]] std::string heading(std::string_view title, FigureKind kind) const;

 private:
  [[nodiscard]] double least(FigureKind kind) const;

  std::string length_, area_, volume_;
  double least_length_ = 0.0, least_area_ = 0.0, least_volume_ = 0.0;
};

}  // namespace moldlight
