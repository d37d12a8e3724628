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
constexpr double k_hair = 0.02;           // of the diagonal: a line that costs less by no more is no better
constexpr double k_alike = 0.25;          // of the diagonal: of those that cost about the same creases decide

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

/// Of the line's outer loops, the longest first, then those of the part's creases.
std::vector<double> levels_of(const PartModel& model, const MoldLine& found) {
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
  return tried;
}

/// 1 for each facet with free surface that is connected with the outer loops across free surface alone.
std::vector<std::uint8_t> outer_walls(const PartModel& model, const MoldLine& found) {
  const Assignment& assignment = found.assignment;
  std::vector<std::uint8_t> on_loop(assignment.mesh.vertices.size(), 0);
  for (const PartingLoop& loop : found.line.loops) {
    if (loop.kind != LoopKind::outer) continue;
    for (const VertexIndex vertex : loop.vertices) on_loop[vertex] = 1;
  }
  std::vector<std::uint8_t> reached(assignment.mesh.pieces.size(), 0);
  std::vector<PieceIndex> open;
  for (PieceIndex piece = 0; piece < reached.size(); ++piece) {
    const auto is_on_loop = [&](VertexIndex corner) { return on_loop[corner] != 0; };
    if (assignment.free[piece] == 0 ||
        std::ranges::none_of(assignment.mesh.pieces[piece].corners, is_on_loop))
      continue;
    reached[piece] = 1;
    open.push_back(piece);
  }
  while (!open.empty()) {
    const PieceIndex piece = open.back();
    open.pop_back();
    for (std::size_t side = 0; side < 3; ++side) {
      const PieceIndex next = assignment.edges.across(piece, side);
      if (next == k_no_piece || next == piece || assignment.free[next] == 0 || reached[next] != 0) continue;
      reached[next] = 1;
      open.push_back(next);
    }
  }
  std::vector<std::uint8_t> facets(model.part.mesh.facets.size(), 0);
  for (PieceIndex piece = 0; piece < reached.size(); ++piece) {
    if (reached[piece] != 0) facets[assignment.mesh.pieces[piece].facet] = 1;
  }
  return facets;
}

}  // namespace

MoldLine find_mold_line(const PartModel& model, const Query& query, const MoldSettings& settings,
                        const Progress& progress) {
  MoldLine found{assign_sides(model, query, settings, progress), {}};
  found.line = parting_line(found.assignment);
  const double diagonal = model.frame.diagonal, worth = planar_worth(settings, diagonal);
  const auto is_planar = [&](const MoldLine& line) { return line.line.is_planar(diagonal); };
  if (settings.parting_height || is_planar(found)) return found;
  const auto cost_of = [&](const MoldLine& line) {
    return line.assignment.energy - (is_planar(line) ? worth : 0.0);
  };
  DividedWalls walls{.facets = outer_walls(model, found)};
  const double most = found.assignment.energy - k_hair * diagonal;
  std::vector<MoldLine> better;
  for (const double height : levels_of(model, found)) {
    walls.height = height;
    MoldLine tried{with_divided(model, settings, found.assignment, walls, progress), {}};
    if (tried.assignment.energy >= most + worth) continue;
    tried.line = parting_line(tried.assignment);
    if (cost_of(tried) < most && tried.line.loops.size() <= found.line.loops.size() &&
        breaks_of(tried.line) <= breaks_of(found.line))
      better.push_back(std::move(tried));
  }
  if (better.empty()) return found;
  const double least = cost_of(*std::ranges::min_element(better, {}, cost_of));
  std::erase_if(better, [&](const MoldLine& line) { return cost_of(line) > least + k_alike * diagonal; });
  return std::move(
      *std::ranges::max_element(better, {}, [](const MoldLine& line) { return on_creases(line.line); }));
}

}  // namespace moldlight
