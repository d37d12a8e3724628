#include "batch/work.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace moldlight::batch {

namespace {

constexpr std::array k_works = {
    Work{"classify",
         "/direction",
         {"/part/area", "/areas/undercut", "/projected_area", "/verdict/undercuts", "", ""}},
    Work{"sweep",
         "/candidates/0/direction",
         {"/part/area", "/candidates/0/areas/undercut", "/candidates/0/projected_area",
          "/candidates/0/patches", "", ""}},
    Work{"actions",
         "/direction",
         {"/part/area", "/verdict/undercut_area", "", "/verdict/undercuts", "/actions",
          "/verdict/unreleased_area"}},
    Work{"mold", "/direction", {"/part/area", "/verdict/undercut_area", "", "/verdict/undercuts", "", ""}},
};

constexpr std::array<std::string_view, 2> k_without_effect = {"jobs", "time_limit_s"};

/// Null where the report has nothing there.
const Json* find(const Json& report, std::string_view pointer) {
  const Json::json_pointer place{std::string(pointer)};
  return report.contains(place) ? &report.at(place) : nullptr;
}

}  // namespace

std::string_view figure_name(Figure figure) {
  constexpr std::array<std::string_view, k_figure_count> k_names = {
      "area", "undercut_area", "projected_area", "undercuts", "side_actions", "unreleased_area"};
  return k_names[static_cast<std::size_t>(figure)];
}

std::span<const Work> works() { return k_works; }

const Work* work_named(std::string_view command) {
  const auto found = std::ranges::find(k_works, command, &Work::command);
  return found == k_works.end() ? nullptr : &*found;
}

std::string work_names() {
  std::string text;
  for (std::size_t k = 0; k < k_works.size(); ++k)
    text += std::string(k == 0                   ? ""
                        : k + 1 < k_works.size() ? ", "
                                                 : " or ") +
            std::string(k_works[k].command);
  return text;
}

std::span<const std::string_view> settings_without_effect() { return k_without_effect; }

std::optional<double> number_at(const Json& report, std::string_view place) {
  if (place.empty()) return std::nullopt;
  const Json* value = find(report, place);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) return value->get<double>();
  if (!value->is_array()) return std::nullopt;
  return static_cast<double>(value->size());
}

std::optional<std::array<double, 3>> direction_in(const Json& report, const Work& work) {
  const Json* value = find(report, work.direction);
  if (value == nullptr || !value->is_array() || value->size() != 3) return std::nullopt;
  std::array<double, 3> direction{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(*value)[k].is_number()) return std::nullopt;
    direction[k] = (*value)[k].get<double>();
  }
  return direction;
}

}  // namespace moldlight::batch
