#include "parting/seen_through.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

constexpr double k_around = 0.5;         // of the patch's border at least is on the action's wall
constexpr double k_off_surface = 1e-5;   // in diagonals
constexpr double k_nearly_there = 0.95;  // cosine
constexpr std::size_t k_most_places = 64;

/// Connected pieces of one former.
struct Patch {
  std::vector<PieceIndex> pieces;
  double area = 0.0, border = 0.0;
  std::map<PieceIndex, double> on_wall;  // length of border on a wall of the action's, by its patch
  std::vector<PieceIndex> around;        // of the action, across that border
};

/// A patch of the action's, as those that it lies around need it.
struct Room {
  std::vector<FacetIndex> facets;  // rising
  /// Across the direction, unit: in or against which the fewest of its walls face, or the most. None where it
  /// has no walls.
  std::optional<std::array<glm::dvec3, 4>> ways;
};

class PatchFinder {
 public:
  explicit PatchFinder(const SeenThrough& wish) : wish_(wish), joined_(wish.mesh.pieces.size()) {}

  std::vector<SeenPatch> run(const Progress& progress) {
    std::vector<SeenPatch> found;
    if (std::ranges::find(wish_.former, wish_.action) == wish_.former.end()) return found;
    find_patches();
    for (const auto& [number, patch] : patches_) {
      if (progress.cancelled()) throw Cancelled();
      if (wish_.former[number] == wish_.action || patch.on_wall.empty()) continue;
      const auto& [room, length] =
          *std::ranges::max_element(patch.on_wall, {}, [](const auto& entry) { return entry.second; });
      const Patch& own = patches_.at(room);
      if (length < k_around * patch.border || patch.area > own.area) continue;
      // Many patches share a room where walls are all holes.
      const auto at = rooms_.find(room);
      const Room& known = at != rooms_.end() ? at->second : rooms_.emplace(room, room_of(own)).first->second;
      if (!is_under(patch, known)) continue;
      if (const auto way = way_out_of(patch, known)) found.push_back({patch.pieces, *way});
    }
    return found;
  }

 private:
  void find_patches() {
    const auto& edges = wish_.edges.edges;
    for (const PieceEdge& edge : edges) {
      if (edge.right != k_no_piece && wish_.former[edge.left] == wish_.former[edge.right])
        joined_.join(edge.left, edge.right);
    }
    for (PieceIndex piece = 0; piece < wish_.mesh.pieces.size(); ++piece) {
      Patch& patch = patches_[joined_.find(piece)];
      patch.pieces.push_back(piece);
      patch.area += 0.5 * twice_area(piece);
    }
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const PieceEdge& edge = edges[k];
      if (edge.right == k_no_piece || wish_.former[edge.left] == wish_.former[edge.right]) continue;
      const double length = glm::distance(wish_.mesh.vertices[edge.from], wish_.mesh.vertices[edge.to]);
      for (const auto& [piece, other] : {std::pair(edge.left, edge.right), {edge.right, edge.left}}) {
        Patch& patch = patches_[joined_.find(piece)];
        patch.border += length;
        if (wish_.former[other] != wish_.action || wish_.crease[k] != 0) continue;
        patch.on_wall[joined_.find(other)] += length;
        patch.around.push_back(other);
      }
    }
  }

  [[nodiscard]] const glm::dvec3& normal(PieceIndex piece) const {
    return wish_.model.geometry.normals[wish_.mesh.pieces[piece].facet];
  }
  [[nodiscard]] double twice_area(PieceIndex piece) const {
    return glm::length(twice_piece_area(wish_.mesh, piece));
  }
  /// What a ray from so far off the middle of a piece, in diagonals, meets.
  [[nodiscard]] std::optional<ExactRays::Hit> met(PieceIndex piece, double off, const glm::dvec3& way) const {
    const UnitFrame& frame = wish_.model.frame;
    const glm::dvec3 from = (wish_.mesh.middle(piece) - frame.center) / frame.diagonal + off * normal(piece);
    return wish_.model.rays().first_hit(glm::vec3(from), glm::vec3(way), false);
  }

  /// Whether most of what is around a patch lies under a roof that the same action forms.
  [[nodiscard]] bool is_under(const Patch& patch, const Room& room) const {
    std::size_t looked_at = 0, under = 0;
    for (const PieceIndex piece : patch.around) {
      const double up = glm::dot(normal(piece), wish_.direction) < 0.0 ? -1.0 : 1.0;
      const auto hit = met(piece, k_off_surface, up * wish_.direction);
      ++looked_at;
      if (hit && std::ranges::binary_search(room.facets, hit->facet)) ++under;
    }
    return 2 * under > looked_at;
  }

  [[nodiscard]] Room room_of(const Patch& patch) const {
    Room room;
    for (const PieceIndex piece : patch.pieces) room.facets.push_back(wish_.mesh.pieces[piece].facet);
    std::ranges::sort(room.facets);
    const glm::dvec3& d = wish_.direction;
    const glm::dvec3 across = glm::normalize(
        glm::cross(d, std::abs(d.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 aside = glm::cross(d, across);
    double xx = 0.0, xy = 0.0, yy = 0.0;  // of the walls' normals, by their areas
    for (const PieceIndex piece : patch.pieces) {
      const double area = twice_area(piece);
      const double x = glm::dot(normal(piece), across), y = glm::dot(normal(piece), aside);
      xx += area * x * x;
      xy += area * x * y;
      yy += area * y * y;
    }
    const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);  // of the way most of them face
    const glm::dvec3 mean = std::cos(turn) * across + std::sin(turn) * aside;
    glm::dvec3 walls(0.0);  // those that face nearly there
    for (const PieceIndex piece : patch.pieces) {
      const double facing = glm::dot(normal(piece), mean);
      if (std::abs(facing) > k_nearly_there)
        walls += (facing < 0.0 ? -1.0 : 1.0) * twice_area(piece) * normal(piece);
    }
    const glm::dvec3 least = glm::cross(d, walls);
    if (least == glm::dvec3(0.0)) return room;
    const glm::dvec3 way = glm::normalize(least), beside = glm::cross(d, way);
    room.ways = {way, -way, beside, -beside};
    return room;
  }

  /// The way of the room's along which the patch and what is around it are free.
  [[nodiscard]] std::optional<glm::dvec3> way_out_of(const Patch& patch, const Room& room) const {
    if (!room.ways) return std::nullopt;
    const auto is_free = [&](const std::vector<PieceIndex>& pieces, const glm::dvec3& along) {
      const std::size_t step = 1 + pieces.size() / k_most_places;
      for (std::size_t k = 0; k < pieces.size(); k += step) {
        if (met(pieces[k], wish_.lateral, along)) return false;
      }
      return true;
    };
    const auto out = std::ranges::find_if(*room.ways, [&](const glm::dvec3& along) {
      return is_free(patch.pieces, along) && is_free(patch.around, along);
    });
    return out != room.ways->end() ? std::optional(*out) : std::nullopt;
  }

  const SeenThrough& wish_;
  UnionFind joined_;
  std::map<PieceIndex, Patch> patches_;  // by the number that joined_ gives
  std::map<PieceIndex, Room> rooms_;     // by the same, of those that were asked for
};

}  // namespace

std::vector<SeenPatch> seen_through(const SeenThrough& wish, const Progress& progress) {
  return PatchFinder(wish).run(progress);
}

}  // namespace moldlight
