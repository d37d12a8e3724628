#include "sweep/direction_cards.hpp"

#include "mold/direction.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_most_cards = 3;
constexpr double k_same_card_deg = 0.02;

/// "+z", "-y": of axes alone, of which the sign is what one looks for.
std::string card_name(const glm::dvec3& direction) {
  const NearestAxis nearest = nearest_axis(direction);
  return (nearest.is_met() && nearest.name.size() == 1 ? "+" : "") + direction_words(direction);
}

}  // namespace

std::vector<DirectionCard> direction_cards(const PartModel& model, const SweepResult& result,
                                           const glm::dvec3& here, const std::optional<MoldCost>& cost) {
  std::vector<DirectionCard> cards;
  if (!result.recommended) return cards;
  const SweepCandidate& best = result.candidates.front();
  for (const SweepCandidate& each : result.candidates) {
    const bool first = &each == &best;
    const bool other_gain = each.cost && best.cost && mold_trade(*each.cost, *best.cost).worth;
    if (cards.size() == k_most_cards || !(first || other_gain)) continue;
    DirectionCard card{.candidate = static_cast<std::size_t>(&each - result.candidates.data()),
                       .direction = first ? result.recommended->direction : each.candidate.direction,
                       .name = {},
                       .verdict = mold_text(model, each),
                       .here = line_angle_deg(each.candidate.direction, here) <= k_same_card_deg};
    card.name = card_name(card.direction);
    const std::optional<MoldCost>& beside = cost || first ? cost : best.cost;
    if (beside && each.cost && !card.here) card.trade = mold_trade(*each.cost, *beside);
    card.offered = !card.here && (card.trade.worth || !beside);
    if (first || card.here || card.offered) cards.push_back(std::move(card));
  }
  return cards;
}

const DirectionCard* better_direction(std::span<const DirectionCard> cards) {
  return !cards.empty() && cards.front().offered ? &cards.front() : nullptr;
}

}  // namespace moldlight
