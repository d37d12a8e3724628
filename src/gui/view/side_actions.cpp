#include "gui/view/side_actions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "actions/action_body.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/ui.hpp"
#include "gui/view/revision_view.hpp"
#include "pieces/piece_words.hpp"
#include "pieces/pieces_report.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_same_undercut = 0.02;  // of the greater of two undercuts' sizes
constexpr double k_same_cosine = 1.0 - 1e-9;
constexpr double k_least_undercut_reach = 0.2;  // of what is seen around an undercut, unit frame

/// How many pieces are removed one after the other; the halves count as one.
double turns_of(const MoldOfPieces& pieces) {
  if (!pieces.has_solids()) return static_cast<double>(pieces.result->count());
  return static_cast<double>(std::ranges::max(pieces.solids->solids, {}, &PieceSolid::sequence).sequence);
}

/// What is formed lies on the part and moves with its piece, or stays where there are solids, which move.
std::vector<glm::dmat4> places_of_pieces(const AppState& state, const MoldOfPieces& pieces, double open) {
  const auto moved = [&](std::size_t turn) {
    return std::clamp(open * turns_of(pieces) - static_cast<double>(turn), 0.0, 1.0);
  };
  std::vector<glm::dmat4> places;
  const auto& directions = pieces.result->directions;
  for (std::size_t k = 0; k < directions.size(); ++k)
    places.push_back(glm::translate(
        nearer(state.camera),
        pieces.has_solids() ? glm::dvec3(0.0) : 2.0 * k_mold_travel * moved(k) * directions[k].direction));
  for (std::size_t k = 0; pieces.has_solids() && k < pieces.solids->solids.size(); ++k) {
    const std::size_t sequence = pieces.solids->solids[k].sequence;
    const glm::dvec3 way = pulled_by(*state.model, *pieces.solids, k) / state.model->frame.diagonal;
    places.push_back(open > 0.0
                         ? glm::translate(glm::dmat4(1.0), (sequence > 0 ? moved(sequence - 1) : 0.0) * way)
                         : glm::scale(glm::dmat4(1.0), glm::dvec3(0.0)));
  }
  return places;
}

/// Which piece moves, and where to.
std::string moving_text(const MoldOfPieces& pieces, double open) {
  const auto turn = static_cast<std::size_t>(std::ceil(open * turns_of(pieces)));
  if (!pieces.has_solids())
    return fmt::format("piece {}, {}", turn, pull_words(pieces.result->directions[turn - 1].direction));
  const auto& solids = pieces.solids->solids;
  const std::size_t direction = *std::ranges::find(solids, turn, &PieceSolid::sequence)->direction;
  return fmt::format("{}, {}", turn == 1 ? std::string("halves") : fmt::format("piece {}", direction + 1),
                     pull_words(pieces.solids->directions[direction]));
}

/// Whether the mold's steel has what the action moves as a solid.
bool in_steel(const AppState& state, std::size_t action) {
  const auto& solids = state.mold.solids;
  return solids && solids->pieces && std::ranges::any_of(solids->halves().inserts, [&](const MoldBody& body) {
           return body.kind != PieceKind::insert && body.action == action;
         });
}

}  // namespace

std::optional<std::size_t> nearest_undercut(const ActionPlan& plan, const Undercut& undercut) {
  std::optional<std::size_t> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < plan.undercuts.size(); ++k) {
    const Undercut& other = plan.undercuts[k].undercut;
    const double size =
        std::max({other.size_across, other.size_along, undercut.size_across, undercut.size_along});
    const double distance = glm::distance(other.centre, undercut.centre);
    if (distance > k_same_undercut * size || distance >= nearest) continue;
    nearest = distance;
    found = k;
  }
  return found;
}

const SideAction* chosen_action(const AppState& state) {
  const auto& chosen = state.action_choices.chosen;
  return state.actions.plan && chosen ? action_of(*state.actions.plan, *chosen) : nullptr;
}

std::optional<SideArrow> side_arrow(const AppState& state) {
  const ActionChoices& choices = state.action_choices;
  const auto& plan = state.actions.plan;
  if (!state.model || !plan || !choices.chosen) return std::nullopt;
  const UnitFrame& frame = state.model->frame;
  const UndercutReport& found = plan->undercuts[*choices.chosen];
  SideArrow arrow;
  arrow.tail = (found.point - frame.center) / frame.diagonal;
  if (const SideAction* action = chosen_action(state)) {
    if (action->about) return std::nullopt;
    arrow.direction = action->direction;
    if (action->kind != ActionKind::insert) arrow.free = action->interval;
  } else {
    // Outward from the part's middle, as a hand would begin.
    const glm::dvec3& d = state.settings.direction.unit();
    const glm::dvec3 out = found.undercut.centre - frame.center;
    const glm::dvec3 level = out - glm::dot(out, d) * d;
    const glm::dvec3 aside = std::abs(d.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    arrow.direction = glm::length(level) > 1e-6 * frame.diagonal
                          ? glm::normalize(level)
                          : glm::normalize(aside - glm::dot(aside, d) * d);
    arrow.released = false;
  }
  if (choices.wish) arrow.direction = *choices.wish;
  return arrow;
}

void give_side_direction(ActionSettings& settings, const std::optional<glm::dvec3>& former,
                         const glm::dvec3& direction) {
  const auto place = former ? own_direction(settings, *former) : std::nullopt;
  if (place) {
    settings.side_directions[*place] = direction;
  } else {
    settings.side_directions.push_back(direction);
  }
}

bool is_along(const SideAction& action, const glm::dvec3& direction) {
  return !action.about && glm::dot(action.direction, direction) > k_same_cosine;
}

std::optional<std::size_t> own_direction(const ActionSettings& settings, const glm::dvec3& direction) {
  for (std::size_t k = 0; k < settings.side_directions.size(); ++k)
    if (glm::dot(glm::normalize(settings.side_directions[k]), direction) > k_same_cosine) return k;
  return std::nullopt;
}

std::shared_ptr<const std::vector<ViewBody>> shown_bodies(const AppState& state) {
  if (const MoldOfPieces* pieces = shown_pieces(state)) return pieces->bodies;
  const auto& bodies = state.actions.bodies;
  return {bodies, bodies ? &bodies->bodies : nullptr};
}

std::vector<glm::dmat4> body_places(const AppState& state, double open, double share, bool steel) {
  if (const MoldOfPieces* pieces = shown_pieces(state)) return places_of_pieces(state, *pieces, open);
  const auto& plan = state.actions.plan;
  const auto& bodies = state.actions.bodies;
  const SideAction* const chosen = chosen_action(state);
  if (!state.model || !plan || !bodies || (open == 0.0 && chosen == nullptr)) return {};
  const UnitFrame& frame = state.model->frame;
  const OpenedMold opened = opened_mold(plan.get(), open);
  const glm::dmat4 model_from_unit =
      glm::scale(glm::translate(glm::dmat4(1.0), frame.center), glm::dvec3(frame.diagonal));
  const glm::dmat4 unit_from_model = glm::inverse(model_from_unit);
  std::vector<glm::dmat4> places;
  for (const std::size_t k : bodies->actions) {
    const SideAction& action = plan->actions[k];
    const bool first = goes_first(action);
    const double moved = open == 0.0 ? share : first ? opened.slides : opened.lifters;
    const double way = first ? (action.core_side ? 1.0 : -1.0) * opened.halves * k_mold_travel : 0.0;
    const glm::dmat4 place = unit_from_model * action_motion(action, moved) * model_from_unit;
    const bool shown = open > 0.0 ? !(steel && in_steel(state, k)) : &action == chosen;
    places.push_back(shown ? glm::translate(glm::dmat4(1.0), way * state.settings.direction.unit()) * place
                           : glm::scale(glm::dmat4(1.0), glm::dvec3(0.0)));
  }
  return places;
}

std::vector<glm::vec3> points_of_bodies(const AppState& state, double open, bool steel) {
  std::vector<glm::vec3> points;
  const OpenedMold opened = opened_mold(state.actions.plan.get(), open);
  const SteelLook look{.opened = opened.halves, .first = opened.slides, .last = opened.lifters};
  for (std::size_t k = 2; steel && state.mold.solids && k < state.mold.solids->shown.size(); ++k) {
    const ViewSolid& solid = state.mold.solids->shown[k];
    const glm::vec3 shift(solid.motion.shift(look, state.settings.direction.unit()));
    for (const ViewVertex& vertex : solid.body.vertices) points.push_back(vertex.position + shift);
  }
  const std::vector<glm::dmat4> places = body_places(state, open, 1.0, steel);
  const auto bodies = shown_bodies(state);
  for (std::size_t k = 0; k < places.size(); ++k)
    for (const ViewVertex& vertex : (*bodies)[k].vertices)
      points.emplace_back(places[k] * glm::dvec4(vertex.position, 1.0));
  return points;
}

std::vector<glm::vec3> surroundings(const AppState& state, std::size_t undercut) {
  const ActionPlan& plan = *state.actions.plan;
  const UnitFrame& frame = state.model->frame;
  const UndercutReport& found = plan.undercuts[undercut];
  const double size = std::max(found.undercut.size_across, found.undercut.size_along) / frame.diagonal;
  const glm::vec3 centre = frame.to_unit(found.undercut.centre);
  std::vector<glm::vec3> points = points_around(centre, std::max(0.6 * size, k_least_undercut_reach));
  const SideAction* const action = action_of(plan, undercut);
  if (action == nullptr || !state.actions.bodies) return points;
  const ActionBodies& bodies = *state.actions.bodies;
  const auto body = std::ranges::find(bodies.actions, static_cast<std::size_t>(action - plan.actions.data()));
  if (body == bodies.actions.end()) return points;
  const glm::vec3 out(action->about ? glm::dvec3(0.0) : action->travel / frame.diagonal * action->direction);
  for (const ViewVertex& vertex :
       bodies.bodies[static_cast<std::size_t>(body - bodies.actions.begin())].vertices) {
    points.push_back(vertex.position);
    points.push_back(vertex.position + out);
  }
  return points;
}

std::string opening_text(const AppState& state, double open) {
  if (const MoldOfPieces* pieces = shown_pieces(state); pieces != nullptr && open > 0.0)
    return with_minus(moving_text(*pieces, open));
  const double diagonal = state.model->frame.diagonal;
  const ActionPlan* const plan = state.actions.plan.get();
  const OpenedMold opened = opened_mold(plan, open);
  const OpeningWays ways = ways_of(plan);
  const auto text = [&](std::string_view what, double way) {
    return fmt::format("{}{}{} {}", what, what.empty() ? "" : " ", grouped(fmt::format("{:.1f}", way)),
                       length_unit(state.model->part));
  };
  if (open == 0.0 || (ways.first == 0.0 && ways.last == 0.0))
    return text("", opened.halves * k_mold_travel * diagonal);
  if (opened.lifters > 0.0) return text("ejection", opened.lifters * ways.last);
  if (opened.halves > 0.0 || ways.first == 0.0)
    return text("halves", opened.halves * k_mold_travel * diagonal);
  return text("slides", opened.slides * ways.first);
}

}  // namespace moldlight::gui
