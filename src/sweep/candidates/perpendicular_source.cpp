// Directions perpendicular to much facet area. For parts with vertical walls these are single points of the
// sphere, so the votes are counted coarsely and each peak is then refined by least squares over an ever
// narrower band.
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/symmetric_eigen.hpp"
#include "sweep/candidates/candidate_sources.hpp"

namespace moldlight {
namespace {

constexpr std::size_t k_most_voters = 4000;  // normals; the rest of a smooth surface adds little
constexpr std::size_t k_ballots = 15'000;    // directions voted for, 1.2 degrees apart
constexpr double k_vote_width_deg = 1.5;
constexpr double k_peak_distance_deg = 3.0;
constexpr double k_bands_deg[] = {4.0, 4.0, 2.0, 2.0, 1.0, 1.0, 0.5, 0.25, 0.12, 0.06};  // twice: to settle
constexpr double k_same_normal_deg = 0.01;
constexpr double k_least_share = 0.03;  // of the surface, perpendicular to the direction
constexpr double k_least_second_moment =
    0.015;                             // of the surface; else one plane's normals, which fix no direction
constexpr double k_least_kept = 0.3;   // of a band's area in the next narrower one, to go on
constexpr double k_mostly_kept = 0.9;  // … and for the wider one not to be a candidate of its own

struct Perpendicular {
  glm::dvec3 direction{0, 0, 1};
  double area = 0.0;
  double band_deg = 0.0;
};

double votes_for(const glm::dvec3& direction, std::span<const NormalCell> voters) {
  const double per_sine = 1.0 / std::sin(glm::radians(k_vote_width_deg));
  double votes = 0.0;
  for (const NormalCell& voter : voters) {
    votes += voter.area * std::max(0.0, 1.0 - per_sine * std::abs(glm::dot(voter.normal, direction)));
  }
  return votes;
}

/// Least-squares perpendicular of the normals within each band around the last estimate, from wide to narrow.
/// Where a narrower band loses much of the area, both are results: walls drafted all round are no closer than
/// their draft, but other walls may be.
std::vector<Perpendicular> refined(const glm::dvec3& start, const std::vector<NormalCell>& cells,
                                   double total_area) {
  std::vector<Perpendicular> results;
  Perpendicular best{start, 0.0, 0.0};
  for (const double band_deg : k_bands_deg) {
    const double sine = std::sin(glm::radians(band_deg));
    glm::dmat3 moments(0.0);
    double area = 0.0;
    for (const NormalCell& cell : cells) {
      if (std::abs(glm::dot(cell.normal, best.direction)) > sine) continue;
      moments += cell.area * glm::outerProduct(cell.normal, cell.normal);
      area += cell.area;
    }
    if (area <= 0.0 || area < k_least_kept * best.area) break;
    const SymmetricEigen<3> eigen = symmetric_eigen<3>(moments);
    if (eigen.values[1] < k_least_second_moment * total_area) break;
    if (area < k_mostly_kept * best.area) results.push_back(best);
    best = {half_sphere(eigen.vectors[0]), area, band_deg};
  }
  if (best.area > 0.0) results.push_back(best);
  return results;
}

/// Where the coarse votes peak, and where the great circles of the largest planes cross.
std::vector<glm::dvec3> starts(std::span<const NormalCell> voters, std::size_t most) {
  struct Ballot {
    glm::dvec3 direction;
    double votes;
  };
  std::vector<Ballot> ballots;
  for (const glm::dvec3& direction : fibonacci_half_sphere(k_ballots)) {
    ballots.push_back({direction, votes_for(direction, voters)});
  }
  std::ranges::stable_sort(ballots, std::greater{}, &Ballot::votes);

  std::vector<glm::dvec3> found;
  const double peak_cosine = std::cos(glm::radians(k_peak_distance_deg));
  for (const Ballot& ballot : ballots) {
    if (found.size() == 2 * most || ballot.votes <= 0.0) break;
    const bool near_peak = std::any_of(found.begin(), found.end(), [&](const glm::dvec3& peak) {
      return std::abs(glm::dot(peak, ballot.direction)) > peak_cosine;
    });
    if (!near_peak) found.push_back(ballot.direction);
  }
  const std::size_t planes = std::min<std::size_t>(voters.size(), 10);
  for (std::size_t i = 0; i < planes; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec3 crossing = glm::cross(voters[i].normal, voters[j].normal);
      if (glm::length(crossing) > 0.1) found.push_back(glm::normalize(crossing));
    }
  }
  return found;
}

}  // namespace

std::vector<Candidate> perpendicular_candidates(const std::vector<NormalCell>& cells, double total_area,
                                                std::size_t most) {
  const std::span<const NormalCell> voters(cells.data(), std::min(cells.size(), k_most_voters));
  std::vector<Perpendicular> found;
  for (const glm::dvec3& start : starts(voters, most)) {
    for (const Perpendicular& candidate : refined(start, cells, total_area)) {
      if (candidate.area < k_least_share * total_area) continue;
      const bool known = std::any_of(found.begin(), found.end(), [&](const Perpendicular& other) {
        return line_angle_deg(other.direction, candidate.direction) < k_same_normal_deg;
      });
      if (!known) found.push_back(candidate);
    }
  }
  std::ranges::stable_sort(found, std::greater{}, &Perpendicular::area);
  if (found.size() > most) found.resize(most);

  std::vector<Candidate> candidates;
  for (const Perpendicular& perpendicular : found) {
    const double share = perpendicular.area / total_area;
    candidates.push_back({perpendicular.direction,
                          {{CandidateKind::perpendicular,
                            fmt::format("perpendicular to {:.1f} % of the surface within {:g} degrees",
                                        100.0 * share, perpendicular.band_deg),
                            share}}});
  }
  return candidates;
}

}  // namespace moldlight
