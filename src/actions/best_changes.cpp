#include "actions/best_changes.hpp"

#include <algorithm>
#include <utility>

namespace moldlight {

std::vector<SavingChange> best_changes(const ActionPlan& plan, const ActionPrices& prices) {
  constexpr std::size_t k_most = 3;
  std::vector<SavingChange> all;
  for (const SideAction& freed : plan.actions) {
    SavingChange change{.undercuts = freed.undercuts, .actions = {}};
    for (std::size_t k = 0; k < plan.actions.size(); ++k) {
      const SideAction& action = plan.actions[k];
      if (!std::ranges::includes(freed.undercuts, action.undercuts)) continue;
      change.actions.push_back(k);
      change.saves += prices[static_cast<std::size_t>(action.kind)];
    }
    all.push_back(std::move(change));
  }
  std::ranges::stable_sort(all, [](const SavingChange& a, const SavingChange& b) {
    if (a.saves != b.saves) return a.saves > b.saves;
    return a.undercuts.size() < b.undercuts.size();
  });
  std::vector<SavingChange> best;
  for (SavingChange& change : all) {
    // What another one saves already is no saving of its own.
    const bool known = std::ranges::any_of(best, [&](const SavingChange& other) {
      return std::ranges::any_of(change.actions, [&](std::size_t action) {
        return std::ranges::find(other.actions, action) != other.actions.end();
      });
    });
    if (known) continue;
    best.push_back(std::move(change));
    if (best.size() == k_most) break;
  }
  return best;
}

}  // namespace moldlight
