#include "classify/cad_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"
#include "classify/map_comparison.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/union_find.hpp"
#include "mold/draft.hpp"

namespace moldlight {

namespace {

constexpr double k_border_share = 0.1;  // of the width, by which borders may be simplified

/// A side that two pieces of one CAD face share.
struct InnerSide {
  std::array<std::uint32_t, 2> pieces{};  // which runs from the lower vertex to the higher one, the other
  VertexIndex low = 0, high = 0;
  double length = 0.0;
};

std::vector<InnerSide> inner_sides(const SplitMesh& split, std::span<const std::uint32_t> face_of_piece) {
  struct Side {
    VertexIndex low, high;
    std::uint32_t face, falls, piece;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  for (std::uint32_t piece = 0; piece < split.pieces.size(); ++piece) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex from = split.pieces[piece].corners[k], to = split.pieces[piece].corners[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), face_of_piece[piece], from > to, piece});
    }
  }
  std::ranges::sort(sides);
  std::vector<InnerSide> inner;
  const auto same = [](const Side& a, const Side& b) {
    return a.low == b.low && a.high == b.high && a.face == b.face;
  };
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && same(sides[end], sides[begin])) ++end;
    if (end - begin != 2 || sides[begin].falls == sides[begin + 1].falls) continue;
    const Side& side = sides[begin];
    inner.push_back({{side.piece, sides[begin + 1].piece},
                     side.low,
                     side.high,
                     glm::distance(split.vertices[side.low], split.vertices[side.high])});
  }
  return inner;
}

/// Pieces of a face that hang together under one label.
struct Patch {
  double area = 0.0, outline = 0.0;
  std::map<std::uint32_t, double> beside;  // length of the border with each other patch of the face
};

/// Gives specks the label of the patch that they share most of their border with, the smallest first; returns
/// their area.
double give_away_specks(const SplitMesh& split, std::span<const InnerSide> sides, double width,
                        std::vector<std::uint32_t>& of_piece) {
  UnionFind groups(of_piece.size());
  for (const InnerSide& side : sides)
    if (of_piece[side.pieces[0]] == of_piece[side.pieces[1]]) groups.join(side.pieces[0], side.pieces[1]);
  std::map<std::uint32_t, Patch> patches;
  for (std::uint32_t piece = 0; piece < of_piece.size(); ++piece) {
    Patch& patch = patches[groups.find(piece)];
    patch.area += piece_area(split, split.pieces[piece]);
    for (std::size_t k = 0; k < 3; ++k)
      patch.outline += glm::distance(split.corner(piece, k), split.corner(piece, (k + 1) % 3));
  }
  for (const InnerSide& side : sides) {
    const std::uint32_t a = groups.find(side.pieces[0]), b = groups.find(side.pieces[1]);
    if (a == b) {
      patches[a].outline -= 2.0 * side.length;
    } else {
      patches[a].beside[b] += side.length;
      patches[b].beside[a] += side.length;
    }
  }
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const auto& [root, patch] : patches)
    if (!patch.beside.empty()) order.push_back({patch.area, root});
  std::ranges::sort(order);
  std::map<std::uint32_t, std::uint32_t> into;  // a patch that was given away, to which
  double moved = 0.0;
  for (const auto& [was, root] : order) {
    if (into.contains(root)) continue;
    const Patch patch = patches[root];
    if (patch.beside.empty() || (2.0 * patch.area >= width * patch.outline && patch.area >= width * width))
      continue;
    const std::uint32_t taker =
        std::ranges::max_element(patch.beside, {}, [](const auto& beside) { return beside.second; })->first;
    moved += patch.area;
    into[root] = taker;
    Patch& larger = patches[taker];
    larger.area += patch.area;
    larger.outline += patch.outline - 2.0 * patch.beside.at(taker);
    larger.beside.erase(root);
    for (const auto& [other, length] : patch.beside) {
      if (other == taker) continue;
      patches[other].beside.erase(root);
      patches[other].beside[taker] += length;
      larger.beside[other] += length;
    }
    patches.erase(root);
  }
  const std::vector<std::uint32_t> before = of_piece;
  for (std::uint32_t piece = 0; piece < of_piece.size(); ++piece) {
    std::uint32_t root = groups.find(piece);
    for (auto to = into.find(root); to != into.end(); to = into.find(root)) root = to->second;
    of_piece[piece] = before[root];
  }
  return moved;
}

/// n . d at the border between two facets, where the surface that they follow turns from one class to the
/// other.
double contour_between(const glm::dvec3& a, const glm::dvec3& b, const CadLabelSettings& settings) {
  const double sine = std::sin(glm::radians(settings.tau_deg));
  const FacetClass first = facet_class(glm::dot(a, settings.direction), sine),
                   second = facet_class(glm::dot(b, settings.direction), sine);
  if (first == second) return StepBorder::k_no_contour;
  if (first != FacetClass::near_vertical && second != FacetClass::near_vertical) return 0.0;
  return first == FacetClass::up || second == FacetClass::up ? sine : -sine;
}

}  // namespace

CadLabels cad_labels(const PartModel& model, const SplitMesh& split, std::span<const MeshGroup> groups,
                     std::vector<std::uint32_t> of_piece, const CadLabelSettings& settings) {
  const Part& part = model.part;
  const double width = settings.speck_width;
  CHECK(part.has_cad_faces && of_piece.size() == split.pieces.size());
  CadLabels found;
  StepLabels& labels = found.labels;
  for (const MeshGroup& group : groups) {
    labels.names.push_back(group.name);
    std::ranges::replace(labels.names.back(), '_', ' ');
    labels.colours.push_back(
        static_cast<std::uint32_t>(group.colour.r << 16 | group.colour.g << 8 | group.colour.b));
  }
  std::vector<std::uint32_t> face_of_piece;
  std::uint32_t faces = 0;
  for (const SplitPiece& piece : split.pieces) {
    face_of_piece.push_back(part.facet_source[piece.facet]);
    if (face_of_piece.back() != k_no_facet) faces = std::max(faces, face_of_piece.back() + 1);
  }
  const std::vector<InnerSide> sides = inner_sides(split, face_of_piece);
  found.moved_area = give_away_specks(split, sides, width, of_piece);

  labels.of_face.assign(faces, StepLabels::k_none);
  found.areas.assign(groups.size(), 0.0);
  std::vector<std::map<std::uint32_t, double>> areas(faces);
  for (std::size_t piece = 0; piece < of_piece.size(); ++piece) {
    if (face_of_piece[piece] == k_no_facet) continue;
    const double area = piece_area(split, split.pieces[piece]);
    areas[face_of_piece[piece]][of_piece[piece]] += area;
    found.areas[of_piece[piece]] += area;
  }
  for (std::uint32_t face = 0; face < faces; ++face) {
    found.other_areas.push_back(0.0);
    if (areas[face].empty()) continue;
    const auto most = std::ranges::max_element(areas[face], {}, [](const auto& area) { return area.second; });
    labels.of_face[face] = most->first;
    for (const auto& [label, area] : areas[face])
      if (label != most->first) found.other_areas.back() += area;
  }

  labels.direction = {settings.direction.x, settings.direction.y, settings.direction.z};
  const double mm = part.unit.empty() ? 1.0 : parse_length_unit(part.unit).mm;
  labels.tolerance = k_border_share * width * mm;
  const auto file_facet_of = [&](FacetIndex facet) {
    return part.file_facets.empty() ? facet : part.file_facets[facet];
  };
  const auto in_mm = [&](VertexIndex vertex) {
    const glm::dvec3 point = mm * split.vertices[vertex];
    return std::array<double, 3>{point.x, point.y, point.z};
  };
  for (const InnerSide& side : sides) {
    const std::uint32_t rising = of_piece[side.pieces[0]], falling = of_piece[side.pieces[1]];
    if (rising == falling || face_of_piece[side.pieces[0]] == k_no_facet) continue;
    StepBorder border{.from = in_mm(side.low),
                      .to = in_mm(side.high),
                      .vertices = {side.low, side.high},
                      .left = rising,
                      .right = falling};
    const FacetIndex facet = split.pieces[side.pieces[0]].facet;
    border.facet = file_facet_of(facet);
    border.contour = contour_between(model.geometry.normals[facet],
                                     model.geometry.normals[split.pieces[side.pieces[1]].facet], settings);
    if (falling < rising) {
      std::swap(border.from, border.to);
      std::swap(border.vertices[0], border.vertices[1]);
      std::swap(border.left, border.right);
    }
    labels.borders.push_back(border);
    labels.split_faces.push_back(face_of_piece[side.pieces[0]]);
  }
  std::ranges::sort(labels.borders, {},
                    [](const StepBorder& border) { return std::tuple(border.facet, border.vertices); });
  std::ranges::sort(labels.split_faces);
  labels.split_faces.erase(std::unique(labels.split_faces.begin(), labels.split_faces.end()),
                           labels.split_faces.end());
  return found;
}

}  // namespace moldlight
