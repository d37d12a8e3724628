// The subcommands that can be the work of a batch, one row each, and what a table of results takes from their
// reports.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace moldlight::batch {

using Json = nlohmann::ordered_json;

/// Figures of a part that tables of results have, whatever the work; a work that does not show one leaves it
/// empty.
enum class Figure : std::uint8_t {
  area,
  undercut_area,
  projected_area,
  undercuts,     // how many
  side_actions,  // how many
  unreleased_area
};
inline constexpr std::size_t k_figure_count = 6;
[[nodiscard]] std::string_view figure_name(Figure figure);

struct Work {
  std::string_view command;
  std::string_view direction;  // JSON pointer to the direction that a picture is drawn along
  std::array<std::string_view, k_figure_count> figures;  // JSON pointers; of an array its size counts
};

[[nodiscard]] std::span<const Work> works();
/// Null where no such subcommand can be the work.
[[nodiscard]] const Work* work_named(std::string_view command);
/// "classify, sweep, actions or mold"
[[nodiscard]] std::string work_names();

/// Settings of reports that change nothing in them but how long they take: no part of a result's key.
[[nodiscard]] std::span<const std::string_view> settings_without_effect();

/// What a place of the report holds as a number; nothing where it holds none.
[[nodiscard]] std::optional<double> number_at(const Json& report, std::string_view place);
/// Three numbers; nothing where it holds none.
[[nodiscard]] std::optional<std::array<double, 3>> direction_in(const Json& report, const Work& work);

}  // namespace moldlight::batch
