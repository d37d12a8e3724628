// Ranks directions as a mold maker does: finds side actions and parting lines, and says which canonical
// direction stands for one found by search.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sweep/contender.hpp"
#include "sweep/sweep_tools.hpp"

namespace moldlight {

/// What is known of a direction that is ranked as molds go, as if the part's shape did not name it; without
/// its depth.
[[nodiscard]] MoldCost mold_cost(const PartModel& model, const Classification& regions,
                                 const DirectionActions& actions, const LineFigures& line);

class MoldRanking {
 public:
  /// The tools must outlive it.
  explicit MoldRanking(SweepTools& tools) : tools_(tools) {}

  /// What is not likely to be the best need have no cost.
  void seek_best_alone() { best_alone_ = true; }

  /// Finds the costs of what is measured, in this order, as far as there is time; those certain to need
  /// heavier side actions than the best so far go without, unless they are followed `to_the_end`.
  void find_costs(std::span<Contender> contenders, bool to_the_end = false);

  /// Whether one found by search comes before all the others, as far as costs are known.
  [[nodiscard]] bool found_leads(std::span<const Contender> named, std::span<const Contender> found) const;

  /// A canonical direction needs no side action, so that nothing found by search comes before it.
  [[nodiscard]] bool is_free() const { return free_; }

  /// Those to list, best first, what has no cost behind what has; with what stands beside them. Found by
  /// search is listed beside a canonical direction only where it is worth it.
  struct Listed {
    std::vector<Contender> contenders;
    std::vector<bool> ties;  // with the one before
    std::vector<std::vector<std::string>> reasons;

    void cut_to(std::size_t most);
    /// Whether there is one at this place whose side actions are known as well as they can be.
    [[nodiscard]] bool is_confirmed(std::size_t place) const;
  };
  [[nodiscard]] Listed listed(std::vector<Contender> contenders) const;

  /// The same once the side actions of the first so many are found again, by what their bodies allow, which
  /// takes longer than all else: so the first may give its place to one that came behind it.
  [[nodiscard]] Listed confirmed(std::vector<Contender> contenders, std::size_t most);

 private:
  /// A canonical direction whose cost is known.
  struct Known {
    glm::dvec3 direction;
    UndercutTotals undercuts;
    bool released = false;  // all of them, but for what ties
  };

  [[nodiscard]] MoldCost cost(const Contender& contender) const;
  /// Where its side actions are not worth looking for, beside what is known.
  [[nodiscard]] ActionLimit limit(const Contender& contender) const;
  void take_down(const Contender& contender);
  /// Of the costs that were taken down: the least effort of those that leave no more than the best, but for
  /// what ties, and the least share that side actions form there.
  [[nodiscard]] std::pair<double, double> least_effort_and_formed() const;
  [[nodiscard]] bool is_worth(const Contender& found, const Contender& canonical) const;
  [[nodiscard]] double most_left(std::span<const Contender> contenders) const;
  [[nodiscard]] BesideDirection beside(const Contender& contender, const Contender& of) const;
  void put(Listed& list, std::vector<Contender>& contenders, std::size_t which) const;
  [[nodiscard]] const Contender* stands_for(const std::vector<Contender>& contenders,
                                            const Contender& found) const;

  SweepTools& tools_;
  std::vector<MoldCost> costs_;                                      // that were taken down
  double least_left_ = std::numeric_limits<double>::infinity();      // by one of them, share of the surface
  double least_undercut_ = std::numeric_limits<double>::infinity();  // area
  std::vector<Known> known_;
  bool free_ = false, best_alone_ = false;
};

}  // namespace moldlight
