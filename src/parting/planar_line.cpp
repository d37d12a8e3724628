#include "parting/planar_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr double k_level_step = 1e-4;     // of the diagonal: heights that are one
constexpr std::size_t k_most_levels = 6;  // that are tried
constexpr double k_nearly_level =
    0.02;                        // of the diagonal: a line that climbs by less may become level by hairs
constexpr double k_hair = 0.02;  // of the diagonal: a line that costs less by no more is no better
constexpr double k_alike_reverse = 2e-3;  // of the surface: reverse draft that differs by less is alike
constexpr double k_alike = 0.25;          // of the diagonal: of those that cost about the same creases decide
constexpr double k_alike_creases = 0.05;  // of the most of them; then the part's middle does

/// Of the outer loops' length.
double on_creases(const PartingLine& line) {
  double sum = 0.0;
  for (const PartingLoop& loop : line.loops)
    sum += loop.kind == LoopKind::outer ? loop.on_crease * loop.length : 0.0;
  return sum;
}

std::size_t breaks_of(const PartingLine& line) {
  std::size_t breaks = 0;
  for (const PartingLoop& loop : line.loops) breaks += loop.breaks;
  return breaks;
}

/// Half-way up the part, or the origin's height where that is no farther off than the lateral tolerance: a
/// part that was drawn about its middle plane is parted there.
double middle_height(const PartModel& model, const glm::dvec3& direction, double lateral) {
  const auto [low, high] = std::ranges::minmax(
      model.part.mesh.vertices, {}, [&](const glm::dvec3& vertex) { return glm::dot(vertex, direction); });
  const double middle = 0.5 * glm::dot(low + high, direction);
  return std::abs(middle) <= lateral ? 0.0 : middle;
}

/// Of the line's outer loops, the longest first, then those of the part's creases, and its middle.
std::vector<double> levels_of(const PartModel& model, const MoldLine& found, double middle) {
  LevelLengths lengths(found.assignment.direction, model.frame.diagonal);
  for (const PartingLoop& loop : found.line.loops) {
    if (loop.kind != LoopKind::outer) continue;
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      lengths.add(loop.points[k], loop.points[(k + 1) % loop.points.size()]);
  }
  std::vector<double> levels = lengths.heights();
  for (const double height : level_heights(model, found.assignment)) levels.push_back(height);
  std::vector<double> tried;
  for (const double height : levels) {
    const auto is_same = [&](double other) {
      return std::abs(other - height) <= k_level_step * model.frame.diagonal;
    };
    if (tried.size() < k_most_levels && std::ranges::none_of(tried, is_same)) tried.push_back(height);
  }
  if (std::ranges::find(tried, middle) == tried.end()) tried.push_back(middle);
  return tried;
}

/// The facets with surface that is free, or if asked for a hair beyond the height, and connected with the
/// outer loops across such surface alone. `hairs` of them says whether there are some.
DividedWalls outer_walls(const PartModel& model, const MoldLine& found, double height, bool hairs) {
  const Assignment& assignment = found.assignment;
  std::vector<std::uint8_t> on_loop(assignment.mesh.vertices.size(), 0);
  for (const PartingLoop& loop : found.line.loops) {
    if (loop.kind != LoopKind::outer) continue;
    for (const VertexIndex vertex : loop.vertices) on_loop[vertex] = 1;
  }
  DividedWalls walls{.height = height, .facets = std::vector<std::uint8_t>(model.part.mesh.facets.size(), 0)};
  const auto may_be_divided = [&](PieceIndex piece) {
    if (assignment.free[piece] != 0) return true;
    const bool is_hair = hairs && is_hair_beyond(model, assignment, piece, height);
    walls.hairs = walls.hairs || is_hair;
    return is_hair;
  };
  std::vector<std::uint8_t> reached(assignment.mesh.pieces.size(), 0);
  std::vector<PieceIndex> open;
  for (PieceIndex piece = 0; piece < reached.size(); ++piece) {
    const auto is_on_loop = [&](VertexIndex corner) { return on_loop[corner] != 0; };
    if (std::ranges::none_of(assignment.mesh.pieces[piece].corners, is_on_loop) || !may_be_divided(piece))
      continue;
    reached[piece] = 1;
    open.push_back(piece);
  }
  while (!open.empty()) {
    const PieceIndex piece = open.back();
    open.pop_back();
    for (std::size_t side = 0; side < 3; ++side) {
      const PieceIndex next = assignment.edges.across(piece, side);
      if (next == k_no_piece || next == piece || reached[next] != 0 || !may_be_divided(next)) continue;
      reached[next] = 1;
      open.push_back(next);
    }
  }
  for (PieceIndex piece = 0; piece < reached.size(); ++piece) {
    if (reached[piece] != 0) walls.facets[assignment.mesh.pieces[piece].facet] = 1;
  }
  return walls;
}

}  // namespace

MoldLine find_mold_line(const PartModel& model, const Query& query, const MoldSettings& settings,
                        const Progress& progress) {
  MoldLine found{assign_sides(model, query, settings, progress), {}};
  if (found.assignment.lineless) return found;
  progress.report("assigning", 1.0);
  found.line = parting_line(found.assignment);
  progress.report("assigning", 1.0);
  const double diagonal = model.frame.diagonal, worth = planar_worth(settings, diagonal);
  const auto is_planar = [&](const MoldLine& line) { return line.line.is_planar(diagonal); };
  if (settings.parting_height || is_planar(found)) return found;
  const auto cost_of = [&](const MoldLine& line) {
    return line.assignment.energy - (is_planar(line) ? worth : 0.0);
  };
  const double most = found.assignment.energy - k_hair * diagonal;
  std::vector<MoldLine> better;
  // How far the line climbs then.
  const auto try_walls = [&](const DividedWalls& walls) -> double {
    MoldLine tried{with_divided(model, settings, found.assignment, walls, progress), {}};
    if (tried.assignment.energy >= most + worth) return INFINITY;
    tried.line = parting_line(tried.assignment);
    const double climb = tried.line.outer_climb();
    // A slide stands well on a plane, though the line is broken there: not on a step.
    if ((is_planar(tried) || (!walls.hairs && breaks_of(tried.line) <= breaks_of(found.line))) &&
        cost_of(tried) < most && tried.line.loops.size() <= found.line.loops.size())
      better.push_back(std::move(tried));
    return climb;
  };
  const double middle = middle_height(model, found.assignment.direction, found.assignment.lateral);
  for (const double height : levels_of(model, found, middle)) {
    const double climb = try_walls(outer_walls(model, found, height, false));
    // Hairs are given away for a plane alone, where it is not far.
    if (climb <= k_planar_share * diagonal || climb > k_nearly_level * diagonal) continue;
    if (const DividedWalls walls = outer_walls(model, found, height, true); walls.hairs) try_walls(walls);
  }
  if (better.empty()) return found;
  const auto keep_about_least = [&](const auto& figure, double more) {
    const double most_of_it = figure(*std::ranges::min_element(better, {}, figure)) + more;
    std::erase_if(better, [&](const MoldLine& line) { return figure(line) > most_of_it; });
  };
  keep_about_least([](const MoldLine& line) { return line.assignment.reverse_draft_area; },
                   k_alike_reverse * model.geometry.total_area);
  keep_about_least(cost_of, k_alike * diagonal);
  if (std::ranges::any_of(better, is_planar))
    std::erase_if(better, [&](const MoldLine& line) { return !is_planar(line); });
  const auto less_on_creases = [](const MoldLine& line) { return -on_creases(line.line); };
  keep_about_least(less_on_creases,
                   k_alike_creases * on_creases(std::ranges::min(better, {}, less_on_creases).line));
  return std::move(*std::ranges::min_element(
      better, {}, [&](const MoldLine& line) { return std::abs(line.assignment.height - middle); }));
}

}  // namespace moldlight
