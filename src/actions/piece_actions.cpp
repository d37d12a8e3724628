#include "actions/piece_actions.hpp"

#include <algorithm>
#include <cmath>
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

/// Which of an undercut's parts each of its pieces goes with.
class Division {
 public:
  Division(const ChosenContext& context, std::span<const std::size_t> undercut_parts,
           std::span<const std::size_t> nearest, std::span<const std::int32_t> of_atom,
           const std::vector<SideAction>& actions)
      : model_(context.model),
        split_(context.split),
        pulls_(context.pulls),
        undercut_parts_(undercut_parts),
        nearest_(nearest),
        of_atom_(of_atom),
        actions_(actions) {}

  [[nodiscard]] std::size_t part_for(std::uint32_t piece) const {
    constexpr double k_inward = 0.1;
    pulls_.release().end_if_cancelled();
    const auto& corners = split_.pieces[piece].corners;
    const glm::dvec3 middle = split_.middle(piece);
    const glm::dvec3& normal = model_.geometry.normals[split_.pieces[piece].facet];
    const auto frees = [&](std::size_t part) {
      if (of_atom_[part] < 0) return false;
      const SideAction& action = action_of_part(part);
      return is_freed({model_.frame.to_unit(middle), normal, 0.0}, action) &&
             std::ranges::all_of(corners, [&](VertexIndex corner) {
               const glm::dvec3 at = glm::mix(split_.vertices[corner], middle, k_inward);
               return is_freed({model_.frame.to_unit(at), normal, 0.0}, action);
             });
    };
    const std::size_t nearest = nearest_[piece];
    // Facets without area have no normal.
    if (of_atom_[nearest] < 0 || normal == glm::dvec3(0.0)) return nearest;
    if (const auto slide = of_opposite_slides(piece, normal, nearest, frees)) return *slide;
    if (frees(nearest)) return nearest;
    const auto other = std::ranges::find_if(undercut_parts_, frees);
    return other != undercut_parts_.end() ? *other : nearest;
  }

 private:
  [[nodiscard]] const SideAction& action_of_part(std::size_t part) const {
    return actions_[static_cast<std::size_t>(of_atom_[part])];
  }

  /// Of two opposite slides that both free a piece, as near where they meet, the one that it opens towards.
  /// An upright piece that reaches ahead of the part's middle is the first one's: so both halves of a flat
  /// face across the middle are, and the slides' bodies do not overlap there.
  template <typename Frees>
  [[nodiscard]] std::optional<std::size_t> of_opposite_slides(std::uint32_t piece, const glm::dvec3& normal,
                                                              std::size_t nearest, const Frees& frees) const {
    constexpr double k_opposite = -0.999, k_ahead = 1e-6;
    const SideAction& its = action_of_part(nearest);
    if (!is_slide(its.kind)) return std::nullopt;
    const auto found = std::ranges::find_if(undercut_parts_, [&](std::size_t k) {
      if (of_atom_[k] < 0) return false;
      const SideAction& action = action_of_part(k);
      return is_slide(action.kind) && glm::dot(action.direction, its.direction) < k_opposite && frees(k);
    });
    if (found == undercut_parts_.end() || !frees(nearest)) return std::nullopt;
    const bool in_order = of_atom_[nearest] < of_atom_[*found];
    const std::size_t first = in_order ? nearest : *found, second = in_order ? *found : nearest;
    const glm::dvec3& way = action_of_part(first).direction;
    const double draft = glm::dot(normal, way);
    if (std::abs(draft) > k_upright) return draft > 0.0 ? first : second;
    const double middle = pulls_.release().middle(way) * model_.frame.diagonal;
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
  std::span<const std::size_t> undercut_parts_;  // of the undercut
  std::span<const std::size_t> nearest_;
  std::span<const std::int32_t> of_atom_;
  const std::vector<SideAction>& actions_;
};

/// Of how the actions of an undercut's parts move, and which comes first: pieces are divided by that alone.
std::vector<double> division_key(std::size_t undercut, std::span<const std::size_t> undercut_parts,
                                 std::span<const std::int32_t> of_atom,
                                 const std::vector<SideAction>& actions) {
  std::vector<std::int32_t> numbers;
  for (const std::size_t k : undercut_parts) numbers.push_back(of_atom[k]);
  std::ranges::sort(numbers);
  std::vector<double> key = {static_cast<double>(undercut)};
  for (const std::size_t k : undercut_parts) {
    key.push_back(of_atom[k] < 0
                      ? of_atom[k]
                      : static_cast<double>(std::ranges::lower_bound(numbers, of_atom[k]) - numbers.begin()));
    if (of_atom[k] < 0) continue;
    const SideAction& action = actions[static_cast<std::size_t>(of_atom[k])];
    const glm::dvec3& way = action.direction;
    key.insert(key.end(), {static_cast<double>(action.kind), action.about ? 1.0 : 0.0,
                           action.core_side ? 1.0 : 0.0, way.x, way.y, way.z, action.travel});
  }
  return key;
}

}  // namespace

PieceActions::PieceActions(const ChosenContext& context, const std::vector<UndercutPart>& undercut_parts)
    : context_(context),
      parts_(parts_of_undercuts(context.undercuts.counted.size(), undercut_parts)),
      nearest_(context.split.pieces.size(), 0) {
  for (std::size_t undercut = 0; undercut < parts_.size(); ++undercut) {
    if (parts_[undercut].size() < 2) continue;
    const std::vector<std::uint32_t>& pieces = context.undercuts.counted[undercut].pieces;
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t k) {
      context.pulls.release().end_if_cancelled();
      const glm::dvec3 middle = context.split.middle(pieces[k]);
      nearest_[pieces[k]] =
          nearest_part(parts_[undercut], undercut_parts, context.model.frame.to_unit(middle));
    });
  }
}

std::vector<std::int32_t> PieceActions::of(std::span<const std::int32_t> of_atom,
                                           const std::vector<SideAction>& actions) {
  std::vector<std::int32_t> of_piece(context_.split.pieces.size(), k_no_action_of_piece);
  for (std::size_t undercut = 0; undercut < parts_.size(); ++undercut) {
    const std::vector<std::size_t>& parts = parts_[undercut];
    const std::vector<std::uint32_t>& pieces = context_.undercuts.counted[undercut].pieces;
    if (std::ranges::all_of(parts, [&](std::size_t k) { return of_atom[k] == of_atom[parts.front()]; })) {
      for (const std::uint32_t piece : pieces) of_piece[piece] = of_atom[parts.front()];
      continue;
    }
    const auto [known, is_new] = known_.try_emplace(division_key(undercut, parts, of_atom, actions));
    std::vector<std::size_t>& divided = known->second;
    if (is_new) {
      divided.resize(pieces.size());
      const Division division(context_, parts, nearest_, of_atom, actions);
      tbb::parallel_for(std::size_t{0}, pieces.size(),
                        [&](std::size_t k) { divided[k] = division.part_for(pieces[k]); });
    }
    for (std::size_t k = 0; k < pieces.size(); ++k) of_piece[pieces[k]] = of_atom[divided[k]];
  }
  return of_piece;
}

}  // namespace moldlight
