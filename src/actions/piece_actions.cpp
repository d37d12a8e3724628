#include "actions/piece_actions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

namespace moldlight {

namespace {

/// Numbers of undercut parts, of each undercut.
std::vector<std::vector<std::size_t>> parts_of_undercuts(std::size_t undercuts,
                                                         const std::vector<UndercutPart>& undercut_parts) {
  std::vector<std::vector<std::size_t>> parts(undercuts);
  for (std::size_t k = 0; k < undercut_parts.size(); ++k) parts[undercut_parts[k].undercut].push_back(k);
  return parts;
}

std::size_t nearest_part(std::span<const std::size_t> of_undercut,
                         const std::vector<UndercutPart>& undercut_parts, const glm::vec3& at) {
  std::size_t nearest = of_undercut.front();
  float least = std::numeric_limits<float>::infinity();
  for (const std::size_t k : of_undercut) {
    for (const UndercutSample& sample : undercut_parts[k].samples) {
      const float distance = glm::distance(sample.position, at);
      if (distance >= least) continue;
      least = distance;
      nearest = k;
    }
  }
  return nearest;
}

class PieceActions {
 public:
  PieceActions(const ChosenContext& context, const std::vector<UndercutPart>& undercut_parts,
               std::span<const std::size_t> nearest, std::span<const std::int32_t> of_atom,
               const std::vector<SideAction>& actions)
      : model_(context.model),
        split_(context.split),
        pulls_(context.pulls),
        undercut_parts_(undercut_parts),
        nearest_(nearest),
        of_atom_(of_atom),
        actions_(actions) {
    for (const SideAction& action : actions)
      middles_.push_back(pulls_.release().middle(action.direction) * model_.frame.diagonal);
  }

  std::vector<std::int32_t> of(const std::vector<Undercut>& undercuts) const {
    const auto undercut_parts = parts_of_undercuts(undercuts.size(), undercut_parts_);
    std::vector<std::int32_t> of_piece(split_.pieces.size(), k_no_action_of_piece);
    for (std::size_t undercut = 0; undercut < undercut_parts.size(); ++undercut) {
      const bool alike = std::ranges::all_of(undercut_parts[undercut], [&](std::size_t k) {
        return of_atom_[k] == of_atom_[undercut_parts[undercut].front()];
      });
      const std::vector<std::uint32_t>& pieces = undercuts[undercut].pieces;
      tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t k) {
        of_piece[pieces[k]] = alike ? of_atom_[undercut_parts[undercut].front()]
                                    : action_for(pieces[k], undercut_parts[undercut]);
      });
    }
    return of_piece;
  }

 private:
  [[nodiscard]] std::int32_t action_for(std::uint32_t piece,
                                        const std::vector<std::size_t>& undercut_parts) const {
    constexpr double k_inward = 0.1;
    pulls_.release().end_if_cancelled();
    const auto& corners = split_.pieces[piece].corners;
    const glm::dvec3 middle = split_.middle(piece);
    const glm::dvec3& normal = model_.geometry.normals[split_.pieces[piece].facet];
    const auto frees = [&](std::int32_t number) {
      if (number < 0) return false;
      const SideAction& action = actions_[static_cast<std::size_t>(number)];
      return is_freed({model_.frame.to_unit(middle), normal, 0.0}, action) &&
             std::ranges::all_of(corners, [&](VertexIndex corner) {
               const glm::dvec3 at = glm::mix(split_.vertices[corner], middle, k_inward);
               return is_freed({model_.frame.to_unit(at), normal, 0.0}, action);
             });
    };
    const std::int32_t nearest = of_atom_[nearest_[piece]];
    // Facets without area have no normal.
    if (nearest < 0 || normal == glm::dvec3(0.0)) return nearest;
    if (const auto slide = of_opposite_slides(piece, normal, nearest, undercut_parts, frees)) return *slide;
    if (frees(nearest)) return nearest;
    const auto other =
        std::ranges::find_if(undercut_parts, [&](std::size_t k) { return frees(of_atom_[k]); });
    return other != undercut_parts.end() ? of_atom_[*other] : nearest;
  }

  /// Of two opposite slides that both free a piece, as near where they meet, the one that it opens towards.
  /// An upright piece that reaches ahead of the part's middle is the first one's: so both halves of a flat
  /// face across the middle are, and the slides' bodies do not overlap there.
  [[nodiscard]] std::optional<std::int32_t> of_opposite_slides(
      std::uint32_t piece, const glm::dvec3& normal, std::int32_t nearest,
      const std::vector<std::size_t>& undercut_parts, const std::function<bool(std::int32_t)>& frees) const {
    constexpr double k_opposite = -0.999, k_ahead = 1e-6;
    const SideAction& its = actions_[static_cast<std::size_t>(nearest)];
    if (!is_slide(its.kind)) return std::nullopt;
    const auto found = std::ranges::find_if(undercut_parts, [&](std::size_t k) {
      if (of_atom_[k] < 0) return false;
      const SideAction& action = actions_[static_cast<std::size_t>(of_atom_[k])];
      return is_slide(action.kind) && glm::dot(action.direction, its.direction) < k_opposite &&
             frees(of_atom_[k]);
    });
    if (found == undercut_parts.end() || !frees(nearest)) return std::nullopt;
    const std::int32_t first = std::min(nearest, of_atom_[*found]),
                       second = std::max(nearest, of_atom_[*found]);
    const glm::dvec3& way = actions_[static_cast<std::size_t>(first)].direction;
    const double draft = glm::dot(normal, way);
    if (std::abs(draft) > k_upright) return draft > 0.0 ? first : second;
    const double middle = middles_[static_cast<std::size_t>(first)];
    const auto reaches_ahead = [&](VertexIndex corner) {
      return glm::dot(split_.vertices[corner] - model_.frame.center, way) >
             middle + k_ahead * model_.frame.diagonal;
    };
    return std::ranges::any_of(split_.pieces[piece].corners, reaches_ahead) ? first : second;
  }

  [[nodiscard]] bool is_freed(const UndercutSample& sample, const SideAction& action) const {
    const Release& release = pulls_.release();
    if (action.about) return true;
    if (action.kind == ActionKind::lifter)
      return release.clears(sample,
                            {action.direction, action.core_side ? pulls_.direction() : -pulls_.direction(),
                             action.travel / model_.frame.diagonal});
    if (action.kind == ActionKind::insert && release.covered(sample, action.direction)) return false;
    return release.free_length(sample, action.direction) == std::numeric_limits<double>::infinity();
  }

  const PartModel& model_;
  const SplitMesh& split_;
  const PullFinder& pulls_;
  std::vector<double> middles_;  // of the part, along each action's way
  const std::vector<UndercutPart>& undercut_parts_;
  std::span<const std::size_t> nearest_;
  std::span<const std::int32_t> of_atom_;
  const std::vector<SideAction>& actions_;
};

}  // namespace

std::vector<std::size_t> nearest_parts(const ChosenContext& context,
                                       const std::vector<UndercutPart>& undercut_parts) {
  const std::vector<Undercut>& undercuts = context.undercuts.counted;
  const auto parts = parts_of_undercuts(undercuts.size(), undercut_parts);
  std::vector<std::size_t> nearest(context.split.pieces.size(), 0);
  for (std::size_t undercut = 0; undercut < parts.size(); ++undercut) {
    if (parts[undercut].size() < 2) continue;
    const std::vector<std::uint32_t>& pieces = undercuts[undercut].pieces;
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t k) {
      context.pulls.release().end_if_cancelled();
      const glm::dvec3 middle = context.split.middle(pieces[k]);
      nearest[pieces[k]] = nearest_part(parts[undercut], undercut_parts, context.model.frame.to_unit(middle));
    });
  }
  return nearest;
}

std::vector<std::int32_t> actions_of_pieces(const ChosenContext& context,
                                            const std::vector<UndercutPart>& undercut_parts,
                                            std::span<const std::size_t> nearest,
                                            std::span<const std::int32_t> of_atom,
                                            const std::vector<SideAction>& actions) {
  return PieceActions(context, undercut_parts, nearest, of_atom, actions).of(context.undercuts.counted);
}

}  // namespace moldlight
