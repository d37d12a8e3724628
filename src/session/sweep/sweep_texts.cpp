#include "session/sweep/sweep_texts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

std::string components_text(const glm::dvec3& direction, int decimals) {
  return fmt::format("{}, {}, {}", component_text(direction.x, decimals),
                     component_text(direction.y, decimals), component_text(direction.z, decimals));
}

}  // namespace

std::vector<std::string> tie_marks(const std::vector<SweepCandidate>& candidates) {
  std::vector<std::string> marks;
  std::size_t ties = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto same = [&](const SweepCandidate& other) { return other.tie_group == candidates[i].tie_group; };
    const bool first = i == 0 || !same(candidates[i - 1]);
    if (std::count_if(candidates.begin(), candidates.end(), same) < 2) {
      marks.emplace_back();
    } else {
      if (first) ++ties;
      marks.emplace_back(1, static_cast<char>('a' + (ties - 1) % 26));
    }
  }
  return marks;
}

std::string reasons_text(const Candidate& candidate, std::size_t most) {
  std::vector<const CandidateSource*> told;
  for (const CandidateSource& source : candidate.sources) {
    const bool known =
        std::any_of(told.begin(), told.end(), [&](const auto* s) { return s->kind == source.kind; });
    if (!known) told.push_back(&source);
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(told.size(), most); ++i) text += (i > 0 ? "; " : "") + told[i]->reason;
  if (told.size() > most) text += fmt::format("; {} more", told.size() - most);
  return text;
}

std::string tilt_text(const SweepCandidate& candidate) {
  if (!candidate.tilt) return "-";
  if (candidate.tilt->at_least()) return fmt::format("> {:g}°", candidate.tilt->deg);
  constexpr double k_least_told_deg = 0.01;
  const std::string side = lean_text(candidate.classification.direction, candidate.tilt->toward);
  if (candidate.tilt->deg < k_least_told_deg) return fmt::format("< {:g}° to {}", k_least_told_deg, side);
  return fmt::format("{:.2g}° to {}", candidate.tilt->deg, side);
}

std::string component_text(double value, int decimals) {
  const bool is_zero = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}", is_zero ? 0.0 : value, decimals);
}

std::string direction_text(const glm::dvec3& direction) { return components_text(direction, 5); }

std::string short_direction_text(const glm::dvec3& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) == 1.0)
      return fmt::format("{}{}", direction[axis] > 0.0 ? '+' : '-', "XYZ"[axis]);
  }
  return components_text(direction, 2);
}

double undercut_area(const SweepCandidate& candidate) {
  return candidate.classification.areas[Region::undercut];
}

std::string lean_text(const glm::dvec3& direction, const glm::dvec3& toward) {
  constexpr double k_tan_22_5_deg =
      0.41421356;  // an axis counts when the lean is not nearer to another alone
  const glm::dvec3 aside = toward - glm::dot(toward, direction) * direction;
  const double most = std::max({std::abs(aside.x), std::abs(aside.y), std::abs(aside.z)});
  if (!(most > 0.0)) return "";
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(aside[axis]) < k_tan_22_5_deg * most) continue;
    text += aside[axis] < 0.0 ? '-' : '+';
    text += "xyz"[axis];
  }
  return text;
}

}  // namespace moldlight
