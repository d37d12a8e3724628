#include "parting/assignment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "base/error.hpp"
#include "classify/number_format.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/union_find.hpp"
#include "parting/min_cut.hpp"
#include "parting/mold_settings.hpp"
#include "parting/piece_edges.hpp"
#include "parting/seen_through.hpp"
#include "parting/thin_walls.hpp"

namespace moldlight {

namespace {

/// What a wall a diagonal away from the assigned height costs, as a share of the diagonal and its area in
/// diagonals.
constexpr double k_height_weight = 4.0;
/// What a user asks for outweighs lengths of line: a height that is given, and faces that are.
constexpr double k_given_weight = 1e3, k_wish_weight = 1e5;
/// Undercuts of less than this share of the part's area are left to either half.
constexpr double k_undercut_floor = 1e-5;
constexpr std::size_t k_most_heights = 10;
// Of a piece, for as long as sides are sought: free and divided at the height; a hair beyond it.
constexpr std::uint8_t k_divided = 2, k_beyond = 3;
constexpr double k_hair_beyond = 2.0;  // lateral tolerances
constexpr double k_at_height = 1e-6;   // of the diagonal
constexpr double k_level_sine = 0.01;  // a crease that climbs less is level
/// Pieces that are narrower, as a share of the diagonal, are what rounding leans out or hides.
constexpr double k_least_width = 1e-6;

/// The costs of one part's pieces.
struct Costs {
  std::vector<double> line;                  // of each edge, where its pieces differ
  std::vector<std::array<double, 2>> draft;  // of each piece at core and cavity
  std::vector<double> area, middle;          // of each piece; height of its centre
  double per_height = 0.0;                   // cost of an area a length away from the assigned height
  std::vector<double> per_side;              // and of any of a piece's area on its wrong side

  [[nodiscard]] double at_height(PieceIndex piece, int side, double height) const {
    const double above = middle[piece] - height;
    const double wrong = side == 0 ? -above : above;  // the core's side is above
    return wrong > 0.0 ? area[piece] * (per_side[piece] + wrong * per_height) : 0.0;
  }
};

Costs costs_of(const PartModel& model, const Assignment& assignment) {
  const SplitMesh& mesh = assignment.mesh;
  const glm::dvec3& d = assignment.direction;
  Costs costs;
  costs.per_height = k_height_weight / (model.frame.diagonal * model.frame.diagonal);
  for (std::size_t k = 0; k < assignment.edges.edges.size(); ++k) {
    const PieceEdge& edge = assignment.edges.edges[k];
    const glm::dvec3 along = mesh.vertices[edge.to] - mesh.vertices[edge.from];
    costs.line.push_back(line_cost(along, d) * (assignment.crease[k] != 0 ? k_crease_weight : 1.0));
  }
  for (PieceIndex piece = 0; piece < mesh.pieces.size(); ++piece) {
    const auto& corners = mesh.pieces[piece].corners;
    const double area = 0.5 * glm::length(twice_piece_area(mesh, piece));
    const double sine = glm::dot(model.geometry.normals[mesh.pieces[piece].facet], d);
    const double draft = std::abs(sine) < k_least_reverse_sine
                             ? 0.0
                             : k_draft_weight * area * std::abs(sine) / model.frame.diagonal;
    costs.draft.push_back({sine < 0.0 ? draft : 0.0, sine > 0.0 ? draft : 0.0});
    costs.area.push_back(area);
    costs.per_side.push_back(assignment.free[piece] == k_divided ? k_given_weight / model.frame.diagonal
                                                                 : 0.0);
    costs.middle.push_back(
        glm::dot(mesh.vertices[corners[0]] + mesh.vertices[corners[1]] + mesh.vertices[corners[2]], d) / 3.0);
  }
  return costs;
}

double energy_of(const Assignment& assignment, const Costs& costs, double height,
                 const std::vector<MoldSide>& sides) {
  double energy = 0.0;
  for (std::size_t k = 0; k < assignment.edges.edges.size(); ++k) {
    const PieceEdge& edge = assignment.edges.edges[k];
    if (edge.right == k_no_piece) continue;
    const MoldSide left = sides[edge.left], right = sides[edge.right];
    if (left != right && left != MoldSide::action && right != MoldSide::action) energy += costs.line[k];
  }
  for (PieceIndex piece = 0; piece < sides.size(); ++piece) {
    if (assignment.free[piece] == 0) continue;
    const int side = static_cast<int>(sides[piece]);
    energy += costs.draft[piece][static_cast<std::size_t>(side)] + costs.at_height(piece, side, height);
  }
  return energy;
}

/// The sides at one height, and the energy with what moving faces against a wish would cost.
std::vector<MoldSide> cut_sides(const Assignment& assignment, const Costs& costs, double height,
                                const Progress& progress) {
  constexpr std::uint32_t k_fixed = ~0U;
  std::vector<std::uint32_t> node(assignment.sides.size(), k_fixed);
  std::uint32_t nodes = 0;
  for (PieceIndex piece = 0; piece < node.size(); ++piece) {
    if (assignment.free[piece] != 0) node[piece] = nodes++;
  }
  MinCut cut(nodes);
  for (PieceIndex piece = 0; piece < node.size(); ++piece) {
    if (node[piece] == k_fixed) continue;
    for (int side = 0; side < 2; ++side) {
      cut.add_cost(node[piece], side,
                   costs.draft[piece][static_cast<std::size_t>(side)] + costs.at_height(piece, side, height));
    }
  }
  for (std::size_t k = 0; k < assignment.edges.edges.size(); ++k) {
    const PieceEdge& edge = assignment.edges.edges[k];
    if (edge.right == k_no_piece) continue;
    const std::uint32_t left = node[edge.left], right = node[edge.right];
    if (left != k_fixed && right != k_fixed) {
      cut.add_link(left, right, costs.line[k]);
    } else if (left != k_fixed || right != k_fixed) {
      const MoldSide fixed = assignment.sides[left == k_fixed ? edge.left : edge.right];
      if (fixed == MoldSide::action) continue;
      cut.add_cost(left == k_fixed ? right : left, fixed == MoldSide::core ? 1 : 0, costs.line[k]);
    }
  }
  const std::vector<std::uint8_t> found = cut.solve(progress);
  std::vector<MoldSide> sides = assignment.sides;
  for (PieceIndex piece = 0; piece < node.size(); ++piece) {
    if (node[piece] != k_fixed) sides[piece] = found[node[piece]] == 0 ? MoldSide::core : MoldSide::cavity;
  }
  return sides;
}

/// Costs of the faces that a half is to form at the other; a warning for those that it cannot.
void add_wishes(const PartModel& model, const MoldSettings& settings, Assignment& assignment, Costs& costs) {
  const std::vector<FacetWish> assigned = assigned_facets(model, settings);
  double refused = 0.0;
  for (PieceIndex piece = 0; piece < assignment.mesh.pieces.size(); ++piece) {
    const FacetWish wish = assigned[assignment.mesh.pieces[piece].facet];
    if (wish == FacetWish::none) continue;
    if (assignment.free[piece] != 0) {
      costs.draft[piece][wish == FacetWish::core ? 1 : 0] +=
          k_wish_weight * costs.area[piece] / model.frame.diagonal;
    } else if (assignment.sides[piece] != (wish == FacetWish::core ? MoldSide::core : MoldSide::cavity)) {
      refused += costs.area[piece];
    }
  }
  if (refused > 1e-6 * model.geometry.total_area)
    assignment.warnings.push_back(fmt::format(
        "{:.4g} of the area given to a half has reverse draft or is hidden. The other half keeps it.",
        refused));
}

/// 1 for a piece of an undercut that is connected across edges and more than a speck.
std::vector<std::uint8_t> action_pieces(const PartModel& model, const Assignment& assignment,
                                        const ExactQuery& query) {
  const SplitMesh& mesh = assignment.mesh;
  const auto hidden = [&](PieceIndex piece) { return mesh.pieces[piece].region == Region::undercut; };
  UnionFind joined(mesh.pieces.size());
  for (const PieceEdge& edge : assignment.edges.edges) {
    if (edge.right != k_no_piece && hidden(edge.left) && hidden(edge.right))
      joined.join(edge.left, edge.right);
  }
  std::vector<double> areas(mesh.pieces.size(), 0.0);
  for (PieceIndex piece = 0; piece < mesh.pieces.size(); ++piece) {
    if (hidden(piece)) areas[joined.find(piece)] += 0.5 * glm::length(twice_piece_area(mesh, piece));
  }
  const double lateral = query.lateral * model.frame.diagonal;
  const double floor =
      std::max(k_undercut_floor * model.geometry.total_area, std::numbers::pi * lateral * lateral);
  std::vector<std::uint8_t> found(mesh.pieces.size(), 0);
  for (PieceIndex piece = 0; piece < mesh.pieces.size(); ++piece)
    found[piece] = hidden(piece) && areas[joined.find(piece)] > floor ? 1 : 0;
  return found;
}

bool is_needle(const SplitMesh& mesh, PieceIndex piece, double width) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, glm::distance(mesh.corner(piece, k), mesh.corner(piece, (k + 1) % 3)));
  return glm::length(twice_piece_area(mesh, piece)) <= width * longest;
}

/// Connected pieces of a half that no width is left of go to the side that they have the longest border with;
/// those beside an action, narrower than the lateral tolerance (part's unit), likewise.
void join_narrow(const Assignment& assignment, double least_width, double lateral,
                 std::vector<MoldSide>& sides) {
  struct Component {
    double area = 0.0;
    std::array<double, k_side_count> border{};  // by the side across
  };
  UnionFind joined(sides.size());
  for (const PieceEdge& edge : assignment.edges.edges) {
    if (edge.right != k_no_piece && sides[edge.left] == sides[edge.right]) joined.join(edge.left, edge.right);
  }
  std::vector<Component> components(sides.size());
  for (PieceIndex piece = 0; piece < sides.size(); ++piece)
    components[joined.find(piece)].area += 0.5 * glm::length(twice_piece_area(assignment.mesh, piece));
  for (const PieceEdge& edge : assignment.edges.edges) {
    if (edge.right == k_no_piece || sides[edge.left] == sides[edge.right]) continue;
    const double length =
        glm::distance(assignment.mesh.vertices[edge.from], assignment.mesh.vertices[edge.to]);
    components[joined.find(edge.left)].border[static_cast<std::size_t>(sides[edge.right])] += length;
    components[joined.find(edge.right)].border[static_cast<std::size_t>(sides[edge.left])] += length;
  }
  constexpr auto k_action = static_cast<std::size_t>(MoldSide::action);
  std::vector<MoldSide> tidied = sides;
  for (PieceIndex piece = 0; piece < sides.size(); ++piece) {
    if (sides[piece] == MoldSide::action) continue;
    const auto& [area, border] = components[joined.find(piece)];
    const double length = std::accumulate(border.begin(), border.end(), 0.0);
    if (2.0 * area < (border[k_action] > 0.0 ? lateral : least_width) * length)
      tidied[piece] = static_cast<MoldSide>(std::ranges::max_element(border) - border.begin());
  }
  sides = std::move(tidied);
}

/// A slide forms what a half sees only through a hole, across the slide's room.
void give_seen_through(const PartModel& model, const Progress& progress, Assignment& assignment) {
  std::vector<std::uint8_t> former;
  for (const MoldSide side : assignment.sides) former.push_back(static_cast<std::uint8_t>(side));
  assignment.seen_through = seen_through({.model = model,
                                          .mesh = assignment.mesh,
                                          .edges = assignment.edges,
                                          .crease = assignment.crease,
                                          .former = former,
                                          .action = static_cast<std::uint8_t>(MoldSide::action),
                                          .direction = assignment.direction,
                                          .lateral = assignment.lateral / model.frame.diagonal},
                                         progress);
  for (const SeenPatch& patch : assignment.seen_through) {
    for (const PieceIndex piece : patch.pieces) assignment.sides[piece] = MoldSide::action;
  }
}

void sum_areas(const PartModel& model, const Costs& costs, Assignment& assignment) {
  for (PieceIndex piece = 0; piece < assignment.sides.size(); ++piece) {
    const double area = costs.area[piece];
    assignment.total_area += area;
    assignment.areas[static_cast<std::size_t>(assignment.sides[piece])] += area;
    if (assignment.free[piece] == 0) continue;
    assignment.free_area += area;
    const double sine =
        glm::dot(model.geometry.normals[assignment.mesh.pieces[piece].facet], assignment.direction);
    if (assignment.sides[piece] == MoldSide::core ? sine < -k_least_reverse_sine
                                                  : sine > k_least_reverse_sine)
      assignment.reverse_draft_area += area;
  }
}

/// Throws UsageError for a height at which there is no part.
void check_height(const PartModel& model, const glm::dvec3& direction, double height) {
  std::vector<double> reach;
  for (const glm::dvec3& vertex : model.part.mesh.vertices) reach.push_back(glm::dot(vertex, direction));
  auto [low, high] = std::ranges::minmax(reach);
  if (std::abs(low) < 1e-6 * model.frame.diagonal) low = 0.0;  // not "-0"
  if (height < low || height > high)
    throw UsageError(
        fmt::format("--parting-height: {:.6g} is outside of the part, which reaches from {} to {} {} along "
                    "the direction",
                    height, rounded(low), rounded(high), length_unit(model.part)));
}

/// Finds the sides of an assignment that knows its mesh, and what of it is free, at one of the heights that
/// its creases suggest, or at that one.
void find_sides(const PartModel& model, const MoldSettings& settings, std::optional<double> height,
                const Progress& progress, Assignment& result) {
  if (height) {
    cut_at_height(result.mesh, result.free,
                  {.direction = result.direction,
                   .height = *height,
                   .tolerance = k_at_height * model.frame.diagonal,
                   .least = k_divided});
    result.edges = piece_edges(result.mesh);
  }
  progress.report("assigning", 0.5);
  result.crease = crease_edges(result.mesh, result.edges, model.geometry);
  for (PieceIndex piece = 0; piece < result.mesh.pieces.size(); ++piece) {
    const Region region = result.mesh.pieces[piece].region;
    result.sides.push_back(region == Region::core || region == Region::both ? MoldSide::core
                           : region == Region::cavity                       ? MoldSide::cavity
                           : result.free[piece] != 0                        ? MoldSide::core
                                                                            : MoldSide::action);
  }
  progress.report("assigning", 0.6);
  Costs costs = costs_of(model, result);
  add_wishes(model, settings, result, costs);
  progress.report("assigning", 0.7);

  const std::vector<double> heights = height ? std::vector<double>{*height} : level_heights(model, result);
  struct Trial {
    std::vector<MoldSide> sides;
    double energy = 0.0, slots = 0.0;
  };
  std::vector<Trial> trials(heights.size());
  const std::vector<ThinWall> walls =
      heights.size() > 1 ? thin_walls(model, result.mesh, result.free) : std::vector<ThinWall>{};
  tbb::parallel_for(std::size_t{0}, heights.size(), [&](std::size_t k) {
    trials[k].sides = cut_sides(result, costs, heights[k], progress);
    trials[k].energy = energy_of(result, costs, heights[k], trials[k].sides);
    for (const ThinWall& wall : walls)
      trials[k].slots += trials[k].sides[wall.piece] == trials[k].sides[wall.other] ? wall.cost : 0.0;
  });
  progress.report("assigning", 0.8);
  const auto best =
      std::ranges::min_element(trials, {}, [](const Trial& trial) { return trial.energy + trial.slots; });
  result.height = heights[static_cast<std::size_t>(best - trials.begin())];
  const auto all_to = [&](MoldSide side) {
    std::vector<MoldSide> sides = result.sides;
    for (PieceIndex piece = 0; piece < sides.size(); ++piece) {
      if (result.free[piece] != 0) sides[piece] = side;
    }
    return energy_of(result, costs, result.height, sides);
  };
  result.energy_to_core = all_to(MoldSide::core);
  result.energy_to_cavity = all_to(MoldSide::cavity);
  progress.report("assigning", 0.9);
  result.energy = best->energy;
  result.sides = std::move(best->sides);
  join_narrow(result, k_least_width * model.frame.diagonal, result.lateral, result.sides);
  give_seen_through(model, progress, result);
  sum_areas(model, costs, result);
  for (std::uint8_t& free : result.free) free = free != 0 ? 1 : 0;
}

}  // namespace

std::string_view side_name(MoldSide side) {
  switch (side) {
    case MoldSide::core:
      return "core";
    case MoldSide::cavity:
      return "cavity";
    case MoldSide::action:
      break;
  }
  return "action";
}

Assignment assign_sides(const PartModel& model, const Query& query, const MoldSettings& settings,
                        const Progress& progress) {
  Query soft = query;
  soft.method.tau_deg = std::max(query.method.tau_deg, settings.soft_deg);
  const ExactQuery exact = exact_query(model, soft);
  Assignment result;
  result.direction = exact.direction;
  result.lateral = exact.lateral * model.frame.diagonal;
  const ExactPart& part = model.exact(progress);
  ExactSplit split = exact_split(part, exact, progress);
  result.lineless = !split.has_lines(part.effort());
  if (result.lineless) return result;
  result.mesh = std::move(split.mesh);
  if (settings.parting_height) check_height(model, result.direction, *settings.parting_height);
  progress.report("assigning", 0.0);

  result.edges = piece_edges(result.mesh);
  progress.report("assigning", 0.2);
  const double least_width = k_least_width * model.frame.diagonal;
  const double upright = std::sin(glm::radians(query.method.tau_deg));
  const std::vector<std::uint8_t> is_action = action_pieces(model, result, exact);
  progress.report("assigning", 0.4);
  result.free.assign(result.mesh.pieces.size(), 0);
  for (PieceIndex piece = 0; piece < result.mesh.pieces.size(); ++piece) {
    const auto& [corners, facet, region] = result.mesh.pieces[piece];
    if (region == Region::undercut) {
      result.free[piece] = is_action[piece] == 0;  // too small for an action
    } else {
      const bool is_wall = std::abs(glm::dot(model.geometry.normals[facet], result.direction)) <= upright;
      result.free[piece] = region == Region::both || (is_wall && is_needle(result.mesh, piece, least_width));
    }
  }
  if (settings.parting_height) {
    for (std::uint8_t& free : result.free) free = free != 0 ? k_divided : 0;
  }
  find_sides(model, settings, settings.parting_height, progress, result);
  return result;
}

bool is_hair_beyond(const PartModel& model, const Assignment& assignment, PieceIndex piece, double height) {
  const Region region = assignment.mesh.pieces[piece].region;
  if (region != Region::core && region != Region::cavity) return false;
  const double sense = region == Region::core ? 1.0 : -1.0;
  double beyond = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    beyond =
        std::max(beyond, sense * (height - glm::dot(assignment.mesh.corner(piece, k), assignment.direction)));
  const double sine =
      std::abs(glm::dot(model.geometry.normals[assignment.mesh.pieces[piece].facet], assignment.direction));
  return beyond > 0.0 && beyond * sine <= k_hair_beyond * assignment.lateral * std::sqrt(1.0 - sine * sine);
}

namespace {

/// Cuts what is a hair beyond the height there: what of it is beyond becomes free.
void give_hairs(const PartModel& model, double height, Assignment& assignment) {
  cut_at_height(assignment.mesh, assignment.free,
                {.direction = assignment.direction,
                 .height = height,
                 .tolerance = k_at_height * model.frame.diagonal,
                 .least = k_beyond});
  for (PieceIndex piece = 0; piece < assignment.free.size(); ++piece) {
    if (assignment.free[piece] != k_beyond) continue;
    const bool above = glm::dot(assignment.mesh.middle(piece), assignment.direction) > height;
    assignment.free[piece] =
        above == (assignment.mesh.pieces[piece].region == Region::cavity) ? k_divided : 0;
  }
}

}  // namespace

Assignment with_divided(const PartModel& model, const MoldSettings& settings, const Assignment& whole,
                        const DividedWalls& walls, const Progress& progress) {
  progress.report("assigning", 0.0);
  Assignment result;
  result.mesh = whole.mesh;
  result.edges = whole.edges;
  result.free = whole.free;
  result.direction = whole.direction;
  result.lateral = whole.lateral;
  for (PieceIndex piece = 0; piece < result.free.size(); ++piece) {
    if (walls.facets[result.mesh.pieces[piece].facet] == 0) continue;
    if (result.free[piece] != 0) {
      result.free[piece] = k_divided;
    } else if (walls.hairs && is_hair_beyond(model, whole, piece, walls.height)) {
      result.free[piece] = k_beyond;
    }
  }
  if (walls.hairs) give_hairs(model, walls.height, result);
  find_sides(model, settings, walls.height, progress, result);
  return result;
}

LevelLengths::LevelLengths(const glm::dvec3& direction, double diagonal)
    : direction_(direction), step_(1e-4 * diagonal) {}

void LevelLengths::add(const glm::dvec3& from, const glm::dvec3& to) {
  const double length = glm::distance(from, to);
  if (std::abs(glm::dot(to - from, direction_)) > k_level_sine * length) return;
  const double height = 0.5 * glm::dot(from + to, direction_);
  Level& level = levels_[std::llround(height / step_)];
  level.length += length;
  level.moment += length * height;
}

std::vector<double> LevelLengths::heights() const {
  std::vector<Level> found;
  for (const auto& [place, level] : levels_) {
    if (level.length > 0.0) found.push_back(level);
  }
  std::ranges::stable_sort(found, std::greater(), &Level::length);
  std::vector<double> heights;
  for (const Level& level : found) heights.push_back(level.moment / level.length);
  return heights;
}

std::vector<double> level_heights(const PartModel& model, const Assignment& assignment) {
  LevelLengths lengths(assignment.direction, model.frame.diagonal);
  const glm::dvec3& d = assignment.direction;
  double low = INFINITY, high = -INFINITY;
  for (std::size_t k = 0; k < assignment.edges.edges.size(); ++k) {
    const PieceEdge& edge = assignment.edges.edges[k];
    const glm::dvec3 &a = assignment.mesh.vertices[edge.from], &b = assignment.mesh.vertices[edge.to];
    low = std::min({low, glm::dot(a, d), glm::dot(b, d)});
    high = std::max({high, glm::dot(a, d), glm::dot(b, d)});
    const bool may_change =
        assignment.free[edge.left] != 0 || (edge.right != k_no_piece && assignment.free[edge.right] != 0);
    if (may_change && assignment.crease[k] != 0) lengths.add(a, b);
  }
  std::vector<double> heights = lengths.heights();
  if (heights.size() > k_most_heights) heights.resize(k_most_heights);
  if (heights.empty()) heights.push_back(0.5 * (low + high));
  return heights;
}

}  // namespace moldlight
