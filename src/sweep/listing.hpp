// Which directions are listed: the best ones that are directions of their own, not the slopes of a better
// one.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sweep/contender.hpp"
#include "sweep/direction_rating.hpp"

namespace moldlight {

/// Undercut area above which a direction is surely not listed, whatever else is scored later.
class ListingLimit {
 public:
  /// `top` directions are listed, `apart_deg` from each other.
  ListingLimit(std::size_t top, double apart_deg) : top_(top), apart_deg_(apart_deg) {}

  void add(const glm::dvec3& direction, double pessimistic_undercut);

  /// Infinity until enough is scored. Directions at twice the listed ones' distance are counted: a better one
  /// that comes later hides one of them at most and takes its place.
  [[nodiscard]] double undercut() const { return limit_; }

 private:
  struct Scored {
    glm::dvec3 direction;
    double undercut;
  };
  std::size_t top_;
  double apart_deg_;
  double limit_ = std::numeric_limits<double>::infinity();
  std::vector<Scored> below_;  // what may still matter, by undercut
};

/// How many contenders are listed, and how near to each other they may be.
struct ListingRules {
  std::size_t most = 1;
  double apart_deg = 3.0;
  /// Nothing that may still prove better is dropped; for scores that are not final.
  bool tentative = false;
};

/// The contenders of `order` (best first) that stand for themselves, as many as the rules allow and those of
/// the user in any case. A contender is hidden by a better one within `apart_deg` that it is surely worse
/// than; unless tentative, also by one that it ties with, if it does not come from a feature of the part or
/// is within 0.1 degrees: then what speaks for it speaks for the better one, which gets its sources.
[[nodiscard]] std::vector<Contender> contenders_to_list(const DirectionRating& rating,
                                                        std::span<const Contender> contenders,
                                                        std::span<const std::size_t> order,
                                                        const ListingRules& rules);

}  // namespace moldlight
