#include "sweep/listing.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace moldlight {

namespace {

constexpr double k_same_direction_deg = 0.1;

enum class Relation : std::uint8_t { apart, hidden, same };

/// What `better` makes of a contender that ranks behind it.
Relation relation(const DirectionRating& rating, const Contender& contender, const Contender& better,
                  const ListingRules& rules) {
  const double angle_deg = line_angle_deg(contender.candidate.direction, better.candidate.direction);
  if (angle_deg > rules.apart_deg) return Relation::apart;
  const double noise =
      rating.value_of_undercut(contender.figures.undercut_uncertainty + better.figures.undercut_uncertainty);
  if (contender.figures.decided != better.figures.decided ||
      contender.figures.value > better.figures.value + noise)
    return Relation::hidden;
  if (rules.tentative) return Relation::apart;
  if (!contender.figures.exact) return Relation::hidden;
  return angle_deg <= k_same_direction_deg ? Relation::same : Relation::apart;
}

void add_sources(const Contender& from, Contender& to) {
  const double angle_deg = line_angle_deg(from.candidate.direction, to.candidate.direction);
  for (const CandidateSource& source : from.candidate.sources) {
    std::vector<CandidateSource>& sources = to.candidate.sources;
    const bool known =
        std::any_of(sources.begin(), sources.end(), [&](const auto& s) { return s.kind == source.kind; });
    if (known) continue;
    sources.push_back(
        {source.kind, fmt::format("{} ({:.2f}° beside)", source.reason, angle_deg), source.share});
  }
}

}  // namespace

void ListingLimit::add(const glm::dvec3& direction, double pessimistic_undercut) {
  if (pessimistic_undercut >= limit_) return;
  const auto place = std::upper_bound(below_.begin(), below_.end(), pessimistic_undercut,
                                      [](double value, const Scored& s) { return value < s.undercut; });
  below_.insert(place, {direction, pessimistic_undercut});
  std::vector<glm::dvec3> counted;
  for (auto scored = below_.begin(); scored != below_.end(); ++scored) {
    const bool apart = std::all_of(counted.begin(), counted.end(), [&](const glm::dvec3& other) {
      return line_angle_deg(other, scored->direction) > 2.0 * apart_deg_;
    });
    if (apart) counted.push_back(scored->direction);
    if (counted.size() < top_) continue;
    limit_ = scored->undercut;
    below_.erase(scored + 1, below_.end());
    return;
  }
}

std::vector<Contender> contenders_to_list(const DirectionRating& rating,
                                          std::span<const Contender> contenders,
                                          std::span<const std::size_t> order, const ListingRules& rules) {
  std::vector<Contender> listed;
  for (const std::size_t i : order) {
    const Contender& contender = contenders[i];
    Relation found = Relation::apart;
    Contender* better = nullptr;
    for (Contender& other : listed) {
      const Relation here = relation(rating, contender, other, rules);
      if (here == Relation::apart) continue;
      found = here;
      better = &other;
      if (here == Relation::hidden) break;
    }
    if (!contender.candidate.from_user() && found == Relation::same) add_sources(contender, *better);
    const bool free = found == Relation::apart && listed.size() < rules.most;
    if (free || contender.candidate.from_user()) listed.push_back(contender);
  }
  return listed;
}

}  // namespace moldlight
