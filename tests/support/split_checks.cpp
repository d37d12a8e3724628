#include "support/split_checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "support/parallel_rays.hpp"
#include "support/random.hpp"

namespace moldlight::test {
namespace {

constexpr double k_bound = 1e-10;
constexpr double k_least_height = 1e-7;  // of a piece that is no sliver, of the diagonal
constexpr std::size_t k_most_sentences = 4;

using Sides = std::vector<std::pair<VertexIndex, VertexIndex>>;

template <typename Triangle>
Sides sides_of(const std::vector<Triangle>& triangles) {
  Sides sides;
  for (const Triangle& triangle : triangles) {
    const auto& corners = [&]() -> const std::array<VertexIndex, 3>& {
      if constexpr (requires { triangle.corners; }) {
        return triangle.corners;
      } else {
        return triangle;
      }
    }();
    for (std::size_t side = 0; side < 3; ++side) {
      if (corners[side] != corners[(side + 1) % 3])
        sides.emplace_back(corners[side], corners[(side + 1) % 3]);
    }
  }
  return sides;
}

/// Number and length of the directed edges that have none left to run the other way.
std::pair<std::size_t, double> unmatched(Sides sides, const std::vector<glm::dvec3>& vertices) {
  Sides reversed;
  for (const auto& [a, b] : sides) reversed.emplace_back(b, a);
  std::sort(sides.begin(), sides.end());
  std::sort(reversed.begin(), reversed.end());
  Sides left;
  std::set_difference(sides.begin(), sides.end(), reversed.begin(), reversed.end(), std::back_inserter(left));
  double length = 0.0;
  for (const auto& [a, b] : left) length += glm::distance(vertices[a], vertices[b]);
  return {left.size(), length};
}

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 ab = b - a;
  const double square = glm::dot(ab, ab);
  const double t = square > 0.0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * ab);
}

double distance_to_facet(const glm::dvec3& p, const std::array<glm::dvec3, 3>& facet,
                         const glm::dvec3& normal) {
  double beside = std::numeric_limits<double>::infinity();
  bool inside = normal != glm::dvec3(0.0);
  for (std::size_t side = 0; side < 3; ++side) {
    const glm::dvec3 &a = facet[side], &b = facet[(side + 1) % 3];
    beside = std::min(beside, distance_to_segment(p, a, b));
    inside = inside && glm::dot(glm::cross(b - a, p - a), normal) >= 0.0;
  }
  const double above = std::abs(glm::dot(p - facet[0], normal));
  return inside ? above : std::max(beside, above);
}

double longest_side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
}

}  // namespace

SplitFaults split_faults(const ExactModel& model, const ExactSplit& split) {
  const TriangleMesh& mesh = model.mesh();
  const FacetGeometry& geometry = model.geometry();
  const std::vector<glm::dvec3>& vertices = split.mesh.vertices;
  const std::vector<SplitPiece>& pieces = split.mesh.pieces;
  SplitFaults faults;
  const auto say = [&](const std::string& sentence) {
    if (faults.sentences.size() < k_most_sentences) faults.sentences.push_back(sentence);
  };

  if (vertices.size() < mesh.vertices.size() ||
      !std::equal(mesh.vertices.begin(), mesh.vertices.end(), vertices.begin()))
    say("the part's vertices do not come first");
  std::vector<char> used(vertices.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].facet >= mesh.facets.size()) {
      say(fmt::format("piece {} of no facet", i));
      return faults;
    }
    if (i > 0 && pieces[i].facet < pieces[i - 1].facet) say(fmt::format("piece {} out of order", i));
    for (const VertexIndex corner : pieces[i].corners) {
      if (corner >= vertices.size()) {
        say(fmt::format("piece {} has no such corner", i));
        return faults;
      }
      used[corner] = 1;
    }
  }
  for (std::size_t i = mesh.vertices.size(); i < used.size(); ++i) {
    if (used[i] == 0) say(fmt::format("vertex {} in no piece", i));
  }

  std::vector<std::pair<FacetIndex, std::array<VertexIndex, 3>>> sorted;
  for (const SplitPiece& piece : pieces) {
    sorted.emplace_back(piece.facet, piece.corners);
    std::ranges::sort(sorted.back().second);
  }
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end()) say("two pieces of a facet have the same corners");

  const auto [edges, length] = unmatched(sides_of(pieces), vertices);
  const auto [part_edges, part_length] = unmatched(sides_of(mesh.facets), mesh.vertices);
  faults.unmatched_edges = part_edges == 0 ? edges : 0;
  faults.unmatched_length = std::abs(length - part_length) / model.diagonal();

  const double diagonal = model.diagonal(), total = std::max(geometry.total_area, 1e-300);
  const glm::dvec3 center = bounds(mesh).center();
  const auto volume_of = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a - center, glm::cross(b - center, c - center)) / 6.0;
  };
  double area = 0.0, volume = 0.0, part_volume = 0.0;
  RegionValues regions;
  std::size_t next = 0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const std::array<glm::dvec3, 3> corners = {mesh.corner(facet, 0), mesh.corner(facet, 1),
                                               mesh.corner(facet, 2)};
    part_volume += volume_of(corners[0], corners[1], corners[2]);
    const std::size_t first = next;
    double wound = 0.0;
    RegionValues shares;
    for (; next < pieces.size() && pieces[next].facet == facet; ++next) {
      const SplitPiece& piece = pieces[next];
      const glm::dvec3 &a = vertices[piece.corners[0]], &b = vertices[piece.corners[1]],
                       &c = vertices[piece.corners[2]];
      const glm::dvec3 cross = 0.5 * glm::cross(b - a, c - a);
      const double signed_area = glm::dot(cross, geometry.normals[facet]);
      area += glm::length(cross);
      volume += volume_of(a, b, c);
      wound += signed_area;
      shares[piece.region] += glm::length(cross);
      regions[piece.region] += glm::length(cross);
      for (const glm::dvec3& corner : {a, b, c}) {
        faults.outside =
            std::max(faults.outside, distance_to_facet(corner, corners, geometry.normals[facet]) / diagonal);
      }
      const double longest = longest_side(a, b, c);
      if (longest > 0.0) faults.turned = std::max(faults.turned, -2.0 * signed_area / longest / diagonal);
    }
    if (next == first && geometry.areas[facet] > 0.0) say(fmt::format("facet {} has no piece", facet));
    faults.facet_area = std::max(faults.facet_area, std::abs(wound - geometry.areas[facet]) / total);
    for (const Region region : k_regions) {
      const double fraction = split.areas.facet_fractions[facet][static_cast<std::size_t>(region)];
      faults.fractions =
          std::max(faults.fractions, std::abs(shares[region] - fraction * geometry.areas[facet]) / total);
    }
  }
  faults.area = std::abs(area - geometry.total_area) / total;
  // An open part's volume says nothing: its scale is that of the box.
  const double scale =
      part_edges == 0 && part_volume != 0.0 ? std::abs(part_volume) : std::max(total * diagonal, 1e-300);
  faults.volume = std::abs(volume - part_volume) / scale;
  faults.region_area = largest_difference(regions, split.areas.areas) / total;
  return faults;
}

void expect_sound_split(const ExactModel& model, const ExactSplit& split, const std::string& name) {
  const SplitFaults faults = split_faults(model, split);
  for (const std::string& sentence : faults.sentences) ADD_FAILURE() << name << ": " << sentence;
  EXPECT_EQ(faults.unmatched_edges, 0U) << name;
  EXPECT_LE(faults.unmatched_length, k_bound) << name;
  EXPECT_LE(faults.area, k_bound) << name;
  EXPECT_LE(faults.volume, k_bound) << name;
  EXPECT_LE(faults.facet_area, k_bound) << name;
  EXPECT_LE(faults.region_area, k_bound) << name;
  EXPECT_LE(faults.fractions, k_bound) << name;
  EXPECT_LE(faults.outside, k_bound) << name;
  EXPECT_LE(faults.turned, k_bound) << name;
}

void expect_whole_borders(const SplitMesh& mesh, const std::string& name) {
  // Pieces on the sides of every edge: those that run through it from the lower vertex, and the others.
  struct Users {
    std::vector<Region> forward, backward;
  };
  std::map<std::pair<VertexIndex, VertexIndex>, Users> edges;
  for (const SplitPiece& piece : mesh.pieces) {
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexIndex a = piece.corners[side], b = piece.corners[(side + 1) % 3];
      if (a == b) continue;
      Users& users = edges[std::minmax(a, b)];
      (a < b ? users.forward : users.backward).push_back(piece.region);
    }
  }
  struct Border {
    bool from_low = true;  // the walk with the lesser region on its left
    Region left = Region::core, right = Region::core;
    int seen = 0;
  };
  std::map<std::pair<VertexIndex, VertexIndex>, Border> expected;
  std::map<VertexIndex, int> lines_at;      // border edges that end there
  std::map<VertexIndex, bool> odd_edge_at;  // an edge without two pieces, one on each side
  for (const auto& [edge, users] : edges) {
    if (users.forward.size() != 1 || users.backward.size() != 1) {
      odd_edge_at[edge.first] = odd_edge_at[edge.second] = true;
      continue;
    }
    const Region forward = users.forward[0], backward = users.backward[0];
    if (forward == backward) continue;
    expected[edge] = {forward < backward, std::min(forward, backward), std::max(forward, backward), 0};
    ++lines_at[edge.first];
    ++lines_at[edge.second];
  }

  std::size_t wrong = 0;
  const auto fail = [&](const std::string& sentence) {
    if (++wrong <= k_most_sentences) ADD_FAILURE() << name << ": " << sentence;
  };
  for (const RegionBorder& border : region_borders(mesh)) {
    if (border.vertices.size() < 2) {
      fail("a border without an edge");
      continue;
    }
    if (!(border.left < border.right)) fail("the lesser region is not on the left");
    for (std::size_t i = 0; i + 1 < border.vertices.size(); ++i) {
      const VertexIndex a = border.vertices[i], b = border.vertices[i + 1];
      const auto edge = edges.find(std::minmax(a, b));
      if (edge == edges.end()) {
        fail(fmt::format("{} to {} is no edge", a, b));
        continue;
      }
      const auto place = expected.find(edge->first);
      if (place == expected.end()) {
        if (edge->second.forward.size() == 1 && edge->second.backward.size() == 1)
          fail(fmt::format("{} to {} has one region on both sides", a, b));
        continue;
      }
      Border& found = place->second;
      if (found.left != border.left || found.right != border.right || found.from_low != (a < b))
        fail(fmt::format("{} to {} has other regions on its sides", a, b));
      ++found.seen;
    }
    if (border.closed()) continue;
    for (const VertexIndex end : {border.vertices.front(), border.vertices.back()}) {
      if (lines_at[end] == 2 && !odd_edge_at[end])
        fail(fmt::format("a border ends at {}, where it could go on", end));
    }
  }
  for (const auto& [edge, border] : expected) {
    if (border.seen != 1)
      fail(fmt::format("{} to {} is in {} borders", edge.first, edge.second, border.seen));
  }
  EXPECT_EQ(wrong, 0U) << name;
}

RayVerdicts ray_verdicts(const ExactModel& model, const SplitMesh& mesh, const glm::dvec3& direction,
                         const ShapeSettings& settings, std::size_t pieces, std::uint32_t seed) {
  RayVerdicts verdicts;
  Random random(seed);
  std::vector<std::size_t> sound;  // no slivers
  std::vector<double> area_up_to;
  for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
    const glm::dvec3 &a = mesh.vertices[mesh.pieces[i].corners[0]],
                     &b = mesh.vertices[mesh.pieces[i].corners[1]],
                     &c = mesh.vertices[mesh.pieces[i].corners[2]];
    const double twice_area = glm::length(glm::cross(b - a, c - a));
    if (twice_area <= k_least_height * model.diagonal() * longest_side(a, b, c)) continue;
    sound.push_back(i);
    area_up_to.push_back((area_up_to.empty() ? 0.0 : area_up_to.back()) + twice_area);
  }
  if (sound.empty()) return verdicts;
  const bool closed = health_report(model.mesh(), model.geometry()).closed;
  const ParallelRays rays(model.mesh(), model.geometry(), direction, closed);
  for (std::size_t i = 0; i < pieces; ++i) {
    std::size_t chosen = random.below(sound.size());
    if (i % 2 == 0) {
      const auto place =
          std::upper_bound(area_up_to.begin(), area_up_to.end(), random.between(0.0, area_up_to.back()));
      chosen = std::min<std::size_t>(static_cast<std::size_t>(place - area_up_to.begin()), sound.size() - 1);
    }
    const SplitPiece& piece = mesh.pieces[sound[chosen]];
    glm::dvec3 point(0.0);
    double sum = 0.0;
    for (const VertexIndex corner : piece.corners) {
      const double weight = random.between(0.05, 1.0);
      point += weight * mesh.vertices[corner];
      sum += weight;
    }
    const std::optional<Region> region = rays.region(point / sum, piece.facet, settings);
    ++verdicts.pieces;
    verdicts.unclear += region ? 0 : 1;
    if (!region || *region == piece.region) continue;
    const glm::dvec3 at = point / sum;
    verdicts.wrong.push_back(fmt::format("piece {} of facet {}: {} instead of {} at ({:.6g}, {:.6g}, {:.6g})",
                                         sound[chosen], piece.facet, region_name(piece.region),
                                         region_name(*region), at.x, at.y, at.z));
  }
  return verdicts;
}

}  // namespace moldlight::test
