#include "compare/undercut_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr std::uint32_t k_no_patch = ~0U;
constexpr double k_same_direction_deg = 2.0, k_same_travel = 0.01;

/// Number of the undercut that each piece is part of.
std::vector<std::uint32_t> patch_of_piece(const PlannedSide& side) {
  std::vector<std::uint32_t> patch_of(side.side.count(), k_no_patch);
  for (std::uint32_t patch = 0; patch < side.plan.patches.size(); ++patch)
    for (const std::uint32_t piece : side.plan.patches[patch].undercut.pieces) patch_of[piece] = patch;
  return patch_of;
}

/// How well one of each fits the other.
struct Match {
  std::size_t former = 0, fresh = 0;
  double score = 0.0;
};

/// The best fit first, each once; adds what is matched.
void match_best(std::vector<Match> fits, std::vector<std::optional<std::size_t>>& of_former,
                std::vector<bool>& taken) {
  std::ranges::stable_sort(fits, std::greater(), &Match::score);
  for (const Match& fit : fits) {
    if (of_former[fit.former] || taken[fit.fresh]) continue;
    of_former[fit.former] = fit.fresh;
    taken[fit.fresh] = true;
  }
}

double size_of(const Undercut& undercut) { return std::hypot(undercut.size_across, undercut.size_along); }

/// Undercuts on which surface or regions changed.
struct Touched {
  std::vector<bool> former, fresh;
};

Touched touched_patches(const PlannedSide& former, const PlannedSide& fresh, const SurfaceChange& surface) {
  const auto of_former = patch_of_piece(former), of_fresh = patch_of_piece(fresh);
  Touched touched{std::vector<bool>(former.plan.patches.size(), false),
                  std::vector<bool>(fresh.plan.patches.size(), false)};
  const auto touch = [](std::vector<bool>& patches, std::uint32_t patch) {
    if (patch != k_no_patch) patches[patch] = true;
  };
  for (std::size_t k = 0; k < surface.of_former.left.size(); ++k)
    if (surface.place_of_former[k] != k_no_change)
      touch(touched.former, of_former[surface.of_former.left[k].piece]);
  for (std::size_t k = 0; k < surface.of_fresh.left.size(); ++k)
    if (surface.place_of_fresh[k] != k_no_change)
      touch(touched.fresh, of_fresh[surface.of_fresh.left[k].piece]);
  for (std::size_t k = 0; k < surface.of_former.regions.size(); ++k) {
    if (surface.change_of_region[k] == k_no_change) continue;
    touch(touched.former, of_former[surface.of_former.regions[k].piece]);
    touch(touched.fresh, of_fresh[surface.of_former.regions[k].other]);
  }
  return touched;
}

std::vector<Match> shared_surface(const PlannedSide& former, const PlannedSide& fresh,
                                  const SurfaceChange& surface) {
  const auto of_former = patch_of_piece(former), of_fresh = patch_of_piece(fresh);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
  for (const PieceShare& share : surface.of_former.shares) {
    const std::uint32_t a = of_former[share.piece], b = of_fresh[share.other];
    if (a != k_no_patch && b != k_no_patch) areas[{a, b}] += share.area;
  }
  std::vector<Match> fits;
  for (const auto& [pair, area] : areas) fits.push_back({pair.first, pair.second, area});
  return fits;
}

std::vector<Match> near_centres(const PlannedSide& former, const PlannedSide& fresh) {
  std::vector<Match> fits;
  for (std::size_t a = 0; a < former.plan.patches.size(); ++a) {
    for (std::size_t b = 0; b < fresh.plan.patches.size(); ++b) {
      const Undercut &one = former.plan.patches[a].undercut, &other = fresh.plan.patches[b].undercut;
      const double apart = glm::distance(one.centre, other.centre);
      if (apart <= 0.5 * std::min(size_of(one), size_of(other))) fits.push_back({a, b, -apart});
    }
  }
  return fits;
}

/// The matched ones of the former part, then what of the new part is taken by none.
template <typename Kind>
std::vector<MatchedChange> changes_of(const std::vector<std::optional<std::size_t>>& of_former,
                                      const std::vector<bool>& taken, const Kind& kind) {
  std::vector<MatchedChange> changes;
  for (std::size_t a = 0; a < of_former.size(); ++a)
    changes.push_back({of_former[a] ? kind(a, *of_former[a]) : ChangeKind::gone, a, of_former[a]});
  for (std::size_t b = 0; b < taken.size(); ++b)
    if (!taken[b]) changes.push_back({ChangeKind::fresh, std::nullopt, b});
  return changes;
}

}  // namespace

std::string_view change_name(ChangeKind kind) {
  constexpr std::array<std::string_view, 6> k_names = {"same", "new", "gone", "grown", "shrunk", "changed"};
  return k_names[static_cast<std::size_t>(kind)];
}

std::vector<MatchedChange> match_undercuts(const PlannedSide& former, const PlannedSide& fresh,
                                           const SurfaceChange& surface) {
  std::vector<std::optional<std::size_t>> of_former(former.plan.patches.size());
  std::vector<bool> taken(fresh.plan.patches.size(), false);
  match_best(shared_surface(former, fresh, surface), of_former, taken);
  match_best(near_centres(former, fresh), of_former, taken);
  const Touched touched = touched_patches(former, fresh, surface);
  return changes_of(of_former, taken, [&](std::size_t a, std::size_t b) {
    if (!touched.former[a] && !touched.fresh[b]) return ChangeKind::same;
    const Undercut &one = former.plan.patches[a].undercut, &other = fresh.plan.patches[b].undercut;
    // A rim as wide as the tolerance around it.
    const double rim = 2.0 * surface.tolerance.apart * (one.size_across + one.size_along);
    if (std::abs(other.area - one.area) <= rim) return ChangeKind::same;
    return other.area > one.area ? ChangeKind::grown : ChangeKind::shrunk;
  });
}

std::vector<MatchedChange> match_actions(const PlannedSide& former, const PlannedSide& fresh,
                                         const std::vector<MatchedChange>& undercuts,
                                         const SurfaceChange& surface) {
  std::vector<std::optional<std::size_t>> now(former.plan.patches.size());
  for (const MatchedChange& undercut : undercuts)
    if (undercut.former) now[*undercut.former] = undercut.fresh;
  const auto& actions_a = former.plan.actions;
  const auto& actions_b = fresh.plan.actions;
  std::vector<Match> fits;
  for (std::size_t a = 0; a < actions_a.size(); ++a) {
    for (std::size_t b = 0; b < actions_b.size(); ++b) {
      double shared = 0.0;
      for (const std::size_t patch : actions_a[a].patches)
        if (now[patch] && std::ranges::count(actions_b[b].patches, *now[patch]) > 0)
          shared += former.plan.patches[patch].undercut.area;
      if (shared <= 0.0) continue;
      // Of several actions of one undercut those alike belong together.
      const double alike = glm::dot(actions_a[a].direction, actions_b[b].direction) +
                           (actions_a[a].kind == actions_b[b].kind ? 3.0 : 0.0);
      fits.push_back({a, b, shared * (5.0 + alike)});
    }
  }
  std::vector<std::optional<std::size_t>> of_former(actions_a.size());
  std::vector<bool> taken(actions_b.size(), false);
  match_best(std::move(fits), of_former, taken);
  return changes_of(of_former, taken, [&](std::size_t a, std::size_t b) {
    const SideAction &one = actions_a[a], &other = actions_b[b];
    const double angle_deg =
        glm::degrees(std::acos(std::clamp(glm::dot(one.direction, other.direction), -1.0, 1.0)));
    const double allowed =
        std::max(2.0 * (surface.tolerance.apart + surface.chords), k_same_travel * std::abs(one.travel));
    const bool same = one.kind == other.kind && angle_deg <= k_same_direction_deg &&
                      std::abs(one.travel - other.travel) <= allowed;
    return same ? ChangeKind::same : ChangeKind::changed;
  });
}

}  // namespace moldlight
