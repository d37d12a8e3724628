#include "parting/pin_bars.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "mesh/edge_collapse.hpp"
#include "mesh/health.hpp"
#include "mesh/union_find.hpp"
#include "mesh/weld.hpp"
#include "parting/halves/bodies.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/halves/tidy_solid.hpp"
#include "parting/mold_files.hpp"
#include "parting/slide_blank.hpp"

namespace moldlight {

namespace {

/// How far around what it forms the pin reaches, and how deep into the wall at its end, in diagonals.
constexpr double k_fit = 3e-5, k_in_wall = 1e-3;
constexpr double k_seat = 0.3;         // of the land, into steel at the far end of a hole
constexpr double k_long = 0.25;        // of the longest line: less of what it forms are skins beside the hole
constexpr double k_beside_rim = 3.0;   // cells off lines that long: one that meets an edge may be missed
constexpr double k_long_step = 0.005;  // likewise where it has steps
constexpr double k_short = 1e-6;       // in diagonals: shorter edges of a half beside it are rounding
constexpr std::size_t k_most_pin_steps = 4;
constexpr std::size_t k_pin_lines = 64, k_most_sides = 256;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Counter-clockwise (Andrew 1979).
std::vector<glm::dvec2> convex_outline(std::vector<glm::dvec2> points) {
  std::ranges::sort(points, [](const glm::dvec2& a, const glm::dvec2& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  });
  std::vector<glm::dvec2> outline;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = outline.size();
    for (const glm::dvec2& point : points) {
      while (outline.size() >= first + 2 &&
             cross(outline.back() - outline[outline.size() - 2], point - outline[outline.size() - 2]) <= 0.0)
        outline.pop_back();
      outline.push_back(point);
    }
    outline.pop_back();
    std::ranges::reverse(points);
  }
  return outline;
}

/// Where normal · x <= offset.
struct HalfPlane {
  glm::dvec2 normal{1.0, 0.0};  // unit
  double offset = 0.0;
};

glm::dvec2 meeting_of(const HalfPlane& a, const HalfPlane& b) {
  return (a.offset * glm::dvec2(b.normal.y, -b.normal.x) - b.offset * glm::dvec2(a.normal.y, -a.normal.x)) /
         cross(a.normal, b.normal);
}

/// The sides of an outline around a convex one, off it by up to `fit`, at corners by up to four times as
/// much: as few as go. Each is off by an amount of its own, so that no edge that runs from a corner of the
/// one meets a corner of the other.
std::vector<HalfPlane> sides_around(const std::vector<glm::dvec2>& outline, double fit) {
  std::vector<HalfPlane> own, sides;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const glm::dvec2 along = glm::normalize(outline[(k + 1) % outline.size()] - outline[k]);
    const glm::dvec2 normal(along.y, -along.x);
    own.push_back({normal, glm::dot(normal, outline[k])});
  }
  const std::size_t step = 1 + own.size() / k_most_sides;
  for (std::size_t k = 0; k < own.size(); k += step)
    sides.push_back({own[k].normal, own[k].offset + 0.5 * fit});
  while (sides.size() > 3) {
    std::size_t least = 0;
    double least_off = INFINITY;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const HalfPlane &before = sides[(k + sides.size() - 1) % sides.size()],
                      &after = sides[(k + 1) % sides.size()];
      if (cross(before.normal, after.normal) < 1e-3) continue;
      const glm::dvec2 corner = meeting_of(before, after);
      double off = 0.0;
      for (const HalfPlane& side : own) off = std::max(off, glm::dot(side.normal, corner) - side.offset);
      if (off >= least_off) continue;
      least_off = off;
      least = k;
    }
    if (least_off > 4.0 * fit) break;
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(least));
  }
  for (std::size_t k = 0; k < sides.size(); ++k)
    sides[k].offset += 0.1 * static_cast<double>(7 * k % 5) * fit;
  return sides;
}

/// Whether each side has a length, the way around them.
bool is_outline(const std::vector<HalfPlane>& sides) {
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const HalfPlane &before = sides[(k + sides.size() - 1) % sides.size()],
                    &after = sides[(k + 1) % sides.size()];
    if (cross(before.normal, sides[k].normal) < 1e-3) return false;
    const glm::dvec2 along(-sides[k].normal.y, sides[k].normal.x);
    if (glm::dot(meeting_of(sides[k], after) - meeting_of(before, sides[k]), along) <= 0.0) return false;
  }
  return sides.size() >= 3;
}

/// How far a point lies inside; below 0 outside.
double inside_by(const std::vector<glm::dvec2>& outline, const glm::dvec2& point) {
  double least = INFINITY;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const glm::dvec2& from = outline[k];
    const glm::dvec2 along = glm::normalize(outline[(k + 1) % outline.size()] - from);
    least = std::min(least, cross(along, point - from));
  }
  return least;
}

class PinRoom {
 public:
  PinRoom(const TriangleMesh& part, const PinWish& wish)
      : part_(part), wish_(wish), frame_(frame_along(wish.way)) {}

  /// One, or with steps one for each, the wide ones first; none where it is no pin.
  std::vector<BarRoom> run() {
    std::vector<BarRoom> rooms;
    for (bool goes_on = true; goes_on;) {
      const std::size_t most = wish_.stepped ? k_most_pin_steps : 1;
      if (rooms.size() == most || !find_outline() || !find_end(goes_on)) return {};
      BarRoom& room = rooms.emplace_back(BarRoom{frame_.way, {}, HalfSpace{-frame_.way, -end_}});
      for (const HalfPlane& side : sides_)
        room.sides.push_back({side.normal.x * frame_.across + side.normal.y * frame_.up, side.offset});
    }
    return rooms;
  }

 private:
  /// What it forms as seen along its way, without skins beside that.
  bool find_outline() {
    glm::dvec2 low(INFINITY), high(-INFINITY);
    double from = INFINITY, to = -INFINITY;
    for (const glm::dvec3& vertex : wish_.formed) {
      const glm::dvec3 at = frame_.of(vertex);
      if (at.z > end_) continue;
      low = glm::min(low, glm::dvec2(at));
      high = glm::max(high, glm::dvec2(at));
      from = std::min(from, at.z);
      to = std::max(to, at.z);
    }
    grid_ = {low, high, k_pin_lines};
    begins_.assign(grid_.lines(), INFINITY);
    ends_.assign(grid_.lines(), -INFINITY);
    std::vector<double> length(grid_.lines(), 0.0);
    for (const TriangleMesh* insert : wish_.inserts) {
      const auto own = depth_columns(*insert, frame_, grid_);
      for (std::size_t line = 0; line < grid_.lines(); ++line) {
        for (Stretch stretch : own[line]) {
          if (wish_.beside) stretch = {std::max(stretch.from, from), std::min(stretch.to, to), 0, 0};
          stretch.to = std::min(stretch.to, end_);
          if (stretch.from >= stretch.to) continue;
          length[line] += stretch.to - stretch.from;
          begins_[line] = std::min(begins_[line], stretch.from);
          ends_[line] = std::max(ends_[line], stretch.to);
        }
      }
    }
    const double least = (wish_.stepped ? k_long_step : k_long) * std::ranges::max(length);
    const glm::dvec2 cell = (high - low) / static_cast<double>(k_pin_lines);
    std::vector<glm::dvec2> points;
    for (const glm::dvec3& vertex : wish_.formed) {
      const glm::dvec2 at(frame_.of(vertex));
      if (frame_.of(vertex).z > end_) continue;
      const auto is_beside = [&](std::size_t line) {
        return length[line] > least &&
               glm::length((grid_.at(line) - at) / glm::max(cell, glm::dvec2(1e-12))) < k_beside_rim;
      };
      for (std::size_t line = 0; line < grid_.lines(); ++line) {
        if (!is_beside(line)) continue;
        points.push_back(at);
        break;
      }
    }
    if (points.size() < 3) return false;
    inner_ = convex_outline(std::move(points));
    if (inner_.size() < 3) return false;
    sides_ = sides_around(inner_, wish_.fit * k_fit);
    return is_outline(sides_);
  }

  /// Within the wall that it ends at, or in the steel behind the hole. With a step within its shoulder, where
  /// a narrower hole goes on.
  bool find_end(bool& goes_on) {
    goes_on = false;
    const double before = end_;
    const auto part = depth_columns(part_, frame_, grid_);
    const double rim = 0.03 * std::min(grid_.high.x - grid_.low.x, grid_.high.y - grid_.low.y);
    const double seat = k_seat * wish_.land;
    double highest = -INFINITY, begin = INFINITY;
    std::size_t looked_at = 0, own = 0;
    std::vector<Stretch> walls;
    for (std::size_t line = 0; line < grid_.lines(); ++line) {
      if (inside_by(inner_, grid_.at(line)) < rim) continue;
      ++looked_at;
      if (begins_[line] < INFINITY) ++own;
      begin = std::min(begin, begins_[line]);
      if (part[line].empty()) continue;
      if (ends_[line] > -INFINITY && part[line].back().to > ends_[line]) return false;
      walls.push_back(part[line].back());
      highest = std::max(highest, part[line].back().to);
    }
    if (looked_at == 0 || 2 * own < looked_at || highest >= before) return false;
    // A hole right through, and no wall, or none before the pin's seat.
    if (highest < begin - seat) {
      end_ = begin - seat;
      return true;
    }
    // The shoulder: what is not far behind where the pin first meets the part.
    double low = -INFINITY, high = INFINITY;
    for (const Stretch& wall : walls) {
      if (wish_.stepped && wall.to < highest - seat) continue;
      low = std::max(low, wall.from);
      high = std::min(high, wall.to);
    }
    end_ = high - std::min(k_in_wall, 0.5 * (high - low));
    goes_on = std::ranges::any_of(walls, [&](const Stretch& wall) { return wall.to < end_; }) ||
              (wish_.stepped && walls.size() < looked_at);
    return low < end_ && end_ < high;
  }

  const TriangleMesh& part_;
  const PinWish& wish_;
  WayFrame frame_;
  LineGrid grid_;
  std::vector<double> begins_, ends_;  // of what it forms, by line
  std::vector<glm::dvec2> inner_;      // outline of what it forms
  std::vector<HalfPlane> sides_;       // of the pin
  double end_ = INFINITY;              // along the way, of what has been found
};

/// The block without the part.
TriangleMesh steel_of(const PlainMold& plain, const MoldHalves& halves) {
  Bounds block;
  for (const MoldBody* half : {&halves.core, &halves.cavity}) {
    for (const glm::dvec3& vertex : plain.as_in_part(half->mesh).vertices) block.add(vertex);
  }
  TriangleMesh steel = plain.part;
  for (auto& facet : steel.facets) std::swap(facet[1], facet[2]);
  const auto first = static_cast<VertexIndex>(steel.vertices.size());
  for (int corner = 0; corner < 8; ++corner)
    steel.vertices.emplace_back((corner & 1) != 0 ? block.max.x : block.min.x,
                                (corner & 2) != 0 ? block.max.y : block.min.y,
                                (corner & 4) != 0 ? block.max.z : block.min.z);
  constexpr VertexIndex k_faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& [a, b, c, d] : k_faces) {
    steel.facets.push_back({first + a, first + b, first + c});
    steel.facets.push_back({first + a, first + c, first + d});
  }
  return steel;
}

class PinPutter {
 public:
  PinPutter(const PlainMold& plain, std::span<const BarRoom> rooms, const Progress& progress)
      : plain_(plain), rooms_(rooms), progress_(progress) {}

  std::string put(std::size_t action, MoldHalves& halves) {
    unit_ = plain_.wish.model.frame.diagonal * halves.scale;
    MoldHalves with = halves;
    TriangleMesh steel = steel_of(plain_, halves), pins;
    for (const BarRoom& room : rooms_) {
      auto pin = cut_by_bar(steel, room, 1.0);
      if (!pin) return "the block does not close around it";
      if (pin->inside.facets.empty()) return "nothing of it is left beside the part";
      if (connected_bodies(pin->inside.vertices.size(), pin->inside.facets).size() != 1)
        return "its pin is not of one piece";
      if (std::string why = cut_bodies(room, with); !why.empty()) return why;
      append(pin->inside, pins);
      steel = std::move(pin->outside);
    }
    if (!left_.empty()) return "it leaves some of what it is to form";
    // Walls that two steps of a pin share are the same facets, seen from either side.
    pins = weld_vertices(pins);
    drop_fins(pins);
    // The pin is exact; the halves have walls set upright.
    const double kept = signed_volume(pins) * std::pow(unit_, 3.0) - taken_;
    if (std::abs(kept) >
        with.upright_volume + halves.specks_volume + k_most_gap_of_pieces * with.block_volume)
      return "pin, halves and part do not fill the block";
    with.part_volume -= kept;
    with.upright_volume = std::max(0.0, with.upright_volume - kept);
    const glm::dvec3& way = rooms_.front().along;
    for (std::size_t k = 0; k < 2 + with.inserts.size(); ++k) {
      const MoldBody& body = k == 0 ? with.core : k == 1 ? with.cavity : with.inserts[k - 2];
      const WayOut out = way_out(pins, plain_.as_in_part(body.mesh), way, INFINITY, k_way_slack);
      if (out.blocked > k_way_slack)
        return plain_.stands_text(k == 0 ? "the core" : k == 1 ? "the cavity" : "another piece", out.place);
    }
    const WayOut out = way_out(pins, plain_.part, way, INFINITY, k_way_slack);
    if (out.blocked > k_way_slack) return plain_.stands_text("the part", out.place);
    MoldBody slide = mold_body(std::move(pins), unit_);
    slide.kind = PieceKind::slide;
    slide.action = action;
    slide.name = fmt::format("slide_{}", with.count(PieceKind::slide) + 1);
    with.insert_volume += slide.volume;
    if (!put_body(with, 2 + with.inserts.size(), std::move(slide), k_needle * unit_, progress_))
      return "facets of it cross each other by rounding";
    with.volume_gap = with.share_left();
    if (std::abs(with.volume_gap) > k_most_gap_of_pieces) return "pin, halves and part do not fill the block";
    if (!with.certified() && halves.certified())
      return "around it the halves would cross themselves by rounding";
    set_in_order(with);
    halves = std::move(with);
    return {};
  }

 private:
  /// What is left of a body; nothing where it cannot be divided, itself where the pin does not meet it.
  [[nodiscard]] std::optional<BarCut> without_pin(const TriangleMesh& body, BarRoom room) const {
    for (HalfSpace& side : room.sides) side.offset *= unit_;
    room.end->offset *= unit_;
    return cut_by_bar(body, room, unit_);
  }

  /// Whether it is too thin for a piece.
  bool leave_to_plastic(const MoldBody& left, MoldHalves& with) const {
    if (!is_speck(left, k_left_to_plastic * unit_)) return false;
    with.specks_volume += left.volume;
    with.insert_volume += left.volume;
    return true;
  }

  std::string cut_bodies(const BarRoom& room, MoldHalves& with) {
    for (const std::size_t half : {0U, 1U}) {
      MoldBody body = half == 0 ? with.core : with.cavity;
      auto cut = without_pin(body.mesh, room);
      if (!cut) return "its half does not close around it";
      if (cut->inside.facets.empty()) continue;
      taken_ += signed_volume(cut->inside);
      // Chips are left to the plastic.
      bool found = false;
      for (const auto& facets : connected_bodies(cut->outside.vertices.size(), cut->outside.facets)) {
        TriangleMesh mesh = body_mesh(cut->outside.vertices, facets);
        collapse_short_edges(mesh, k_short * unit_);
        MoldBody left = mold_body(std::move(mesh));
        if (leave_to_plastic(left, with)) continue;
        if (found) return "its half would fall apart";
        found = true;
        body.mesh = std::move(left.mesh);
        body.volume = left.volume;
      }
      if (!put_body(with, half, std::move(body), k_needle * unit_, progress_))
        return "around it its half would cross itself by rounding";
    }
    // What another of its pins has not taken out yet.
    for (const TriangleMesh& body : std::exchange(left_, {})) {
      const auto cut = without_pin(body, room);
      if (!cut) return "what it forms does not close around it";
      take(*cut, with);
    }
    std::vector<MoldBody> inserts = std::exchange(with.inserts, {});
    std::vector<WrittenBody> written(with.written.bodies.begin() + 2, with.written.bodies.end());
    with.written.bodies.resize(2);
    for (std::size_t k = 0; k < inserts.size(); ++k) {
      const auto cut = without_pin(inserts[k].mesh, room);
      if (!cut) return "what it forms does not close around it";
      if (cut->inside.facets.empty()) {
        with.inserts.push_back(std::move(inserts[k]));
        with.written.bodies.push_back(std::move(written[k]));
        continue;
      }
      if (inserts[k].kind != PieceKind::insert) return "it runs into another piece";
      with.insert_volume -= inserts[k].volume;
      take(*cut, with);
    }
    return {};
  }
  void take(const BarCut& cut, MoldHalves& with) {
    taken_ += signed_volume(cut.inside);
    for (const auto& facets : connected_bodies(cut.outside.vertices.size(), cut.outside.facets)) {
      TriangleMesh mesh = body_mesh(cut.outside.vertices, facets);
      if (!leave_to_plastic(mold_body(mesh), with)) left_.push_back(std::move(mesh));
    }
  }

  const PlainMold& plain_;
  std::span<const BarRoom> rooms_;
  const Progress& progress_;
  double unit_ = 1.0;
  double taken_ = 0.0;              // volume, from halves and inserts
  std::vector<TriangleMesh> left_;  // of inserts, by the pins so far
};

}  // namespace

std::vector<BarRoom> pin_rooms(const TriangleMesh& part, const PinWish& wish) {
  // Holes whose shadows along the way do not meet are apart.
  const WayFrame frame = frame_along(wish.way);
  const auto meet = [](const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
  };
  std::vector<Bounds> shadows;
  UnionFind one(wish.inserts.size());
  for (const TriangleMesh* insert : wish.inserts) {
    Bounds& shadow = shadows.emplace_back();
    for (const glm::dvec3& vertex : insert->vertices)
      shadow.add(glm::dvec3(glm::dvec2(frame.of(vertex)), 0.0));
    const auto last = static_cast<std::uint32_t>(shadows.size() - 1);
    for (std::uint32_t k = 0; k < last; ++k) {
      if (meet(shadows[k], shadow)) one.join(k, last);
    }
  }
  std::vector<BarRoom> rooms;
  for (std::uint32_t first = 0; first < shadows.size(); ++first) {
    if (one.find(first) != first) continue;
    PinWish hole{.inserts = {},
                 .formed = {},
                 .beside = wish.beside,
                 .way = wish.way,
                 .land = wish.land,
                 .fit = wish.fit,
                 .stepped = wish.stepped};
    const auto is_in = [&](const glm::dvec3& vertex) {
      const glm::dvec3 at(glm::dvec2(frame.of(vertex)), 0.0);
      for (std::uint32_t k = 0; k < shadows.size(); ++k) {
        if (one.find(k) == first && meet(shadows[k], {at, at})) return true;
      }
      return false;
    };
    for (std::uint32_t k = 0; k < shadows.size(); ++k) {
      if (one.find(k) == first) hole.inserts.push_back(wish.inserts[k]);
    }
    std::ranges::copy_if(wish.formed, std::back_inserter(hole.formed), is_in);
    std::vector<BarRoom> own = PinRoom(part, hole).run();
    if (own.empty()) return {};
    std::ranges::move(own, std::back_inserter(rooms));
  }
  return rooms;
}

std::string put_pins(const PlainMold& plain, std::size_t action, std::span<const BarRoom> rooms,
                     MoldHalves& halves, const Progress& progress) {
  return PinPutter(plain, rooms, progress).put(action, halves);
}

}  // namespace moldlight
