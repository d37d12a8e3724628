#include "compare/undercut_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr std::uint32_t k_no_undercut = ~0U;
constexpr double k_same_direction_deg = 2.0, k_same_travel = 0.01;

/// Number of the undercut that each piece is part of.
std::vector<std::uint32_t> undercut_of_piece(const PlannedSide& side) {
  std::vector<std::uint32_t> undercut_of(side.side.count(), k_no_undercut);
  for (std::uint32_t undercut = 0; undercut < side.plan.undercuts.size(); ++undercut)
    for (const std::uint32_t piece : side.plan.undercuts[undercut].undercut.pieces)
      undercut_of[piece] = undercut;
  return undercut_of;
}

/// How well one of each fits the other.
struct Match {
  std::size_t a = 0, b = 0;
  double score = 0.0;
};

/// The best fit first, each once; adds what is matched.
void match_best(std::vector<Match> fits, std::vector<std::optional<std::size_t>>& of_a,
                std::vector<bool>& taken) {
  std::ranges::stable_sort(fits, std::greater(), &Match::score);
  for (const Match& fit : fits) {
    if (of_a[fit.a] || taken[fit.b]) continue;
    of_a[fit.a] = fit.b;
    taken[fit.b] = true;
  }
}

double size_of(const Undercut& undercut) { return std::hypot(undercut.size_across, undercut.size_along); }

/// Undercuts on which surface or regions changed.
struct Touched {
  std::vector<bool> a, b;
};

Touched touched_undercuts(const PlannedSide& a, const PlannedSide& b, const SurfaceChange& surface) {
  const auto of_a = undercut_of_piece(a), of_b = undercut_of_piece(b);
  Touched touched{std::vector<bool>(a.plan.undercuts.size(), false),
                  std::vector<bool>(b.plan.undercuts.size(), false)};
  const auto touch = [](std::vector<bool>& undercuts, std::uint32_t undercut) {
    if (undercut != k_no_undercut) undercuts[undercut] = true;
  };
  for (std::size_t k = 0; k < surface.of_a.left.size(); ++k)
    if (surface.place_of_a[k] != k_no_change) touch(touched.a, of_a[surface.of_a.left[k].piece]);
  for (std::size_t k = 0; k < surface.of_b.left.size(); ++k)
    if (surface.place_of_b[k] != k_no_change) touch(touched.b, of_b[surface.of_b.left[k].piece]);
  for (std::size_t k = 0; k < surface.of_a.regions.size(); ++k) {
    if (surface.change_of_region[k] == k_no_change) continue;
    touch(touched.a, of_a[surface.of_a.regions[k].piece]);
    touch(touched.b, of_b[surface.of_a.regions[k].other]);
  }
  return touched;
}

std::vector<Match> shared_surface(const PlannedSide& a, const PlannedSide& b, const SurfaceChange& surface) {
  const auto of_a = undercut_of_piece(a), of_b = undercut_of_piece(b);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
  for (const PieceShare& share : surface.of_a.shares) {
    const std::uint32_t i = of_a[share.piece], j = of_b[share.other];
    if (i != k_no_undercut && j != k_no_undercut) areas[{i, j}] += share.area;
  }
  std::vector<Match> fits;
  for (const auto& [pair, area] : areas) fits.push_back({pair.first, pair.second, area});
  return fits;
}

std::vector<Match> near_centres(const PlannedSide& a, const PlannedSide& b) {
  std::vector<Match> fits;
  for (std::size_t i = 0; i < a.plan.undercuts.size(); ++i) {
    for (std::size_t j = 0; j < b.plan.undercuts.size(); ++j) {
      const Undercut &one = a.plan.undercuts[i].undercut, &other = b.plan.undercuts[j].undercut;
      const double apart = glm::distance(one.centre, other.centre);
      if (apart <= 0.5 * std::min(size_of(one), size_of(other))) fits.push_back({i, j, -apart});
    }
  }
  return fits;
}

/// The matched ones of A, then what of B is taken by none.
template <typename Kind>
std::vector<MatchedChange> changes_of(const std::vector<std::optional<std::size_t>>& of_a,
                                      const std::vector<bool>& taken, const Kind& kind) {
  std::vector<MatchedChange> changes;
  for (std::size_t i = 0; i < of_a.size(); ++i)
    changes.push_back({of_a[i] ? kind(i, *of_a[i]) : ChangeKind::gone, i, of_a[i]});
  for (std::size_t j = 0; j < taken.size(); ++j)
    if (!taken[j]) changes.push_back({ChangeKind::added, std::nullopt, j});
  return changes;
}

}  // namespace

std::string_view change_name(ChangeKind kind) {
  constexpr std::array<std::string_view, 6> k_names = {"same", "new", "gone", "grown", "shrunk", "changed"};
  return k_names[static_cast<std::size_t>(kind)];
}

std::vector<MatchedChange> match_undercuts(const PlannedSide& a, const PlannedSide& b,
                                           const SurfaceChange& surface) {
  std::vector<std::optional<std::size_t>> of_a(a.plan.undercuts.size());
  std::vector<bool> taken(b.plan.undercuts.size(), false);
  match_best(shared_surface(a, b, surface), of_a, taken);
  match_best(near_centres(a, b), of_a, taken);
  const Touched touched = touched_undercuts(a, b, surface);
  return changes_of(of_a, taken, [&](std::size_t i, std::size_t j) {
    if (!touched.a[i] && !touched.b[j]) return ChangeKind::same;
    const Undercut &one = a.plan.undercuts[i].undercut, &other = b.plan.undercuts[j].undercut;
    // A rim as wide as the tolerance around it.
    const double rim = 2.0 * surface.tolerance.apart * (one.size_across + one.size_along);
    if (std::abs(other.area - one.area) <= rim) return ChangeKind::same;
    return other.area > one.area ? ChangeKind::grown : ChangeKind::shrunk;
  });
}

std::vector<MatchedChange> match_actions(const PlannedSide& a, const PlannedSide& b,
                                         const std::vector<MatchedChange>& undercuts,
                                         const SurfaceChange& surface) {
  std::vector<std::optional<std::size_t>> now(a.plan.undercuts.size());
  for (const MatchedChange& undercut : undercuts)
    if (undercut.a) now[*undercut.a] = undercut.b;
  const auto& actions_a = a.plan.actions;
  const auto& actions_b = b.plan.actions;
  std::vector<Match> fits;
  for (std::size_t i = 0; i < actions_a.size(); ++i) {
    for (std::size_t j = 0; j < actions_b.size(); ++j) {
      double shared = 0.0;
      for (const std::size_t undercut : actions_a[i].undercuts)
        if (now[undercut] && std::ranges::count(actions_b[j].undercuts, *now[undercut]) > 0)
          shared += a.plan.undercuts[undercut].undercut.area;
      if (shared <= 0.0) continue;
      // Of several actions of one undercut those alike belong together.
      const double alike = glm::dot(actions_a[i].direction, actions_b[j].direction) +
                           (actions_a[i].kind == actions_b[j].kind ? 3.0 : 0.0);
      fits.push_back({i, j, shared * (5.0 + alike)});
    }
  }
  std::vector<std::optional<std::size_t>> of_a(actions_a.size());
  std::vector<bool> taken(actions_b.size(), false);
  match_best(std::move(fits), of_a, taken);
  return changes_of(of_a, taken, [&](std::size_t i, std::size_t j) {
    const SideAction &one = actions_a[i], &other = actions_b[j];
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
