#include "pieces/pull_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mold/direction.hpp"
#include "sweep/candidates/candidate_sources.hpp"
#include "sweep/candidates/find_candidates.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_even_lines = 250, k_most_of_a_source = 30, k_most_edge_lines = 60;
constexpr int k_round_deg = 15;
/// What is so near to a line that is named is only tried in its place.
constexpr double k_beside_deg = 5.0;
constexpr double k_same_line_deg = 0.02;
/// Edges are put together where their lines agree to a thousandth.
constexpr double k_edge_step = 1e-3;

/// Lines along the edges at which the part bends, the longest in sum first.
std::vector<Candidate> edge_candidates(const PartModel& model) {
  std::map<std::array<long, 3>, std::pair<double, glm::dvec3>> sums;
  for (const auto* edges : {&model.edges.concave, &model.edges.convex}) {
    for (const FacetEdge& edge : *edges) {
      const glm::dvec3 along = model.part.mesh.vertices[edge.b] - model.part.mesh.vertices[edge.a];
      const double length = glm::length(along);
      if (length <= 0.0) continue;
      const glm::dvec3 line = half_sphere(along / length);
      const auto cell = [&](double value) { return std::lround(value / k_edge_step); };
      auto& [sum, mean] = sums[{cell(line.x), cell(line.y), cell(line.z)}];
      sum += length;
      mean += length * line;
    }
  }
  std::vector<std::pair<double, glm::dvec3>> found;
  for (const auto& [cell, one] : sums) found.push_back(one);
  std::ranges::stable_sort(found, std::greater(), [](const auto& one) { return one.first; });
  if (found.size() > k_most_edge_lines) found.resize(k_most_edge_lines);
  std::vector<Candidate> candidates;
  for (const auto& [length, mean] : found) {
    candidates.push_back({.direction = half_sphere(glm::normalize(mean)),
                          .sources = {{CandidateKind::perpendicular, "along straight edges", 0.0}}});
  }
  return candidates;
}

/// Every 15 degrees between two of the canonical lines that are perpendicular to each other, the first ones.
void add_round_lines(std::span<const Candidate> candidates, std::vector<PullLine>& lines) {
  constexpr double k_perpendicular_deg = 0.1;
  std::vector<glm::dvec3> axes;
  for (const Candidate& candidate : candidates) {
    const auto is_across = [&](const glm::dvec3& axis) {
      return line_angle_deg(axis, candidate.direction) > 90.0 - k_perpendicular_deg;
    };
    if (candidate.canonical && std::ranges::all_of(axes, is_across)) axes.push_back(candidate.direction);
  }
  for (std::size_t a = 0; a < axes.size(); ++a) {
    for (std::size_t b = a + 1; b < axes.size(); ++b) {
      for (int deg = k_round_deg; deg < 180; deg += k_round_deg) {
        if (deg == 90) continue;
        const double angle = glm::radians(static_cast<double>(deg));
        const glm::dvec3 line =
            half_sphere(glm::normalize(std::cos(angle) * axes[a] + std::sin(angle) * axes[b]));
        lines.push_back({line, "a round angle", LineLiking::round});
      }
    }
  }
}

std::string name_of(const Candidate& candidate) {
  const NearestAxis axis = nearest_axis(candidate.direction);
  if (axis.is_met()) return axis.name;
  return candidate.canonical ? candidate.canonical->name : candidate.sources.front().reason;
}

}  // namespace

std::vector<PullLine> pull_lines(const PartModel& model, const PiecesSettings& settings,
                                 const Progress& progress) {
  std::vector<PullLine> lines;
  for (const auto* given : {&settings.fixed, &settings.proposed}) {
    for (const glm::dvec3& direction : *given) {
      const glm::dvec3 unit = unit_direction(direction);
      const NearestAxis axis = nearest_axis(unit);
      lines.push_back({unit, axis.is_met() ? axis.name : "given", LineLiking::named});
    }
  }
  CandidateOptions options{.uniform_count = k_even_lines, .most_per_kind = k_most_of_a_source};
  std::vector<Candidate> found = find_candidates(model, options, progress);
  std::vector<Candidate> edges = edge_candidates(model);
  found.insert(found.end(), edges.begin(), edges.end());
  found = merge_candidates(std::move(found), k_same_line_deg);
  add_round_lines(found, lines);
  const auto beside_named = [&](const Candidate& candidate) {
    return std::ranges::any_of(found, [&](const Candidate& other) {
      return other.canonical && line_angle_deg(other.direction, candidate.direction) < k_beside_deg;
    });
  };
  for (const Candidate& candidate : found) {
    const bool feature =
        candidate.kind() == CandidateKind::axis || candidate.kind() == CandidateKind::revolution ||
        candidate.kind() == CandidateKind::plane || candidate.kind() == CandidateKind::perpendicular;
    lines.push_back({candidate.direction, name_of(candidate),
                     candidate.canonical                   ? LineLiking::named
                     : feature && !beside_named(candidate) ? LineLiking::feature
                                                           : LineLiking::other});
  }
  std::ranges::stable_sort(lines.begin() + static_cast<std::ptrdiff_t>(settings.fixed.size()), lines.end(),
                           {}, &PullLine::liking);
  return lines;
}

}  // namespace moldlight
