#include "parting/draft/draft_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "classify/classify_report.hpp"
#include "classify/number_format.hpp"
#include "io/atomic_file.hpp"
#include "mesh/faces.hpp"
#include "mold/draft.hpp"
#include "picture/design_space.hpp"
#include "picture/legend.hpp"

namespace moldlight {

namespace {

constexpr double k_bin_deg = 0.5, k_binned_deg = 10.0;  // bins are wide beyond that
/// Of a wall's area, by which it is not turned.
constexpr double k_sliver_share = 0.01;
/// A wall whose normals differ by more has no straight foot.
constexpr double k_straight_deg = 0.5;

std::vector<DraftBin> empty_bins() {
  std::vector<DraftBin> bins = {{-90.0, -k_binned_deg, {}}};
  const int count = static_cast<int>(2.0 * k_binned_deg / k_bin_deg);
  for (int k = 0; k < count; ++k)
    bins.push_back({-k_binned_deg + k * k_bin_deg, -k_binned_deg + (k + 1) * k_bin_deg, {}});
  bins.push_back({k_binned_deg, 90.0, {}});
  return bins;
}

DraftBin& bin_of(std::vector<DraftBin>& bins, double draft_deg) {
  const double from_first = (draft_deg + k_draft_rounding_deg + k_binned_deg) / k_bin_deg;
  const double last = static_cast<double>(bins.size() - 1);
  return bins[static_cast<std::size_t>(std::clamp(std::floor(from_first) + 1.0, 0.0, last))];
}

/// What one half forms of a face with too little draft, piece by piece.
struct Shallow {
  struct Piece {
    PieceIndex piece;
    double area, draft_deg;
  };
  std::vector<Piece> pieces;
  double area = 0.0;

  /// What all but slivers of it have: those that stitch a round wall to others lean by chance.
  [[nodiscard]] double draft_deg() const {
    std::vector<Piece> rising = pieces;
    std::ranges::sort(rising, {}, &Piece::draft_deg);
    double passed = 0.0;
    const auto first = std::ranges::find_if(
        rising, [&](const Piece& each) { return (passed += each.area) > k_sliver_share * area; });
    return first == rising.end() ? rising.back().draft_deg : first->draft_deg;
  }
};

WallDraft wall_of(const PartModel& model, const Assignment& assignment, const Shallow& shallow, MoldSide side,
                  double required_deg) {
  const glm::dvec3& d = assignment.direction;
  const double outward = side == MoldSide::core ? 1.0 : -1.0;  // along which the half leaves
  WallDraft wall;
  wall.side = side;
  wall.area = shallow.area;
  wall.least_deg = std::ranges::min(shallow.pieces, {}, &Shallow::Piece::draft_deg).draft_deg;
  double low = INFINITY, high = -INFINITY;
  glm::dvec3 sum(0.0);
  for (const Shallow::Piece& each : shallow.pieces) {
    sum += twice_piece_area(assignment.mesh, each.piece);
    for (const VertexIndex corner : assignment.mesh.pieces[each.piece].corners) {
      const double height = outward * glm::dot(assignment.mesh.vertices[corner], d);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  wall.height = high - low;
  wall.foot = outward * low;
  const double draft = shallow.draft_deg();
  wall.turn_deg = required_deg - draft;
  wall.thickness = wall.height * (std::tan(glm::radians(required_deg)) - std::tan(glm::radians(draft)));

  const double cosine = std::cos(glm::radians(k_straight_deg)), size = glm::length(sum);
  const glm::dvec3 normal = size > 0.0 ? sum / size : d, along = glm::cross(d, normal);
  const bool straight =
      glm::length(along) > 0.5 && std::ranges::all_of(shallow.pieces, [&](const Shallow::Piece& each) {
        return glm::dot(model.geometry.normals[assignment.mesh.pieces[each.piece].facet], normal) >= cosine;
      });
  if (!straight) return wall;
  // The line in which the wall's plane meets the level of the foot.
  const glm::dvec3 line = glm::normalize(along), up = outward * glm::cross(normal, line);
  const glm::dvec3& anchor =
      assignment.mesh.vertices[assignment.mesh.pieces[shallow.pieces.front().piece].corners[0]];
  const double climb = glm::dot(up, d) * outward;
  const glm::dvec3 on_foot =
      anchor + up * ((low - outward * glm::dot(anchor, d)) / (std::abs(climb) > 0.5 ? climb : 1.0));
  double first = INFINITY, last = -INFINITY;
  for (const Shallow::Piece& each : shallow.pieces) {
    for (const VertexIndex corner : assignment.mesh.pieces[each.piece].corners) {
      const double place = glm::dot(assignment.mesh.vertices[corner] - on_foot, line);
      first = std::min(first, place);
      last = std::max(last, place);
    }
  }
  wall.foot_line = {on_foot + first * line, on_foot + last * line};
  return wall;
}

std::string short_area(double area, const std::string& unit) { return fmt::format("{:.4g} {}", area, unit); }

Json wall_json(const WallDraft& wall) {
  Json line;
  if (wall.foot_line) line = {point_json((*wall.foot_line)[0]), point_json((*wall.foot_line)[1])};
  return {{"face", wall.face},         {"side", side_name(wall.side)},
          {"area", wall.area},         {"least_deg", wall.least_deg},
          {"height", wall.height},     {"foot", {{"height", wall.foot}, {"line", line}}},
          {"turn_deg", wall.turn_deg}, {"thickness", wall.thickness}};
}

// Lengths at scale 1.
constexpr double k_width = 372.0, k_height = 224.0, k_margin = 24.0, k_padding = 20.0, k_radius = 12.0;
constexpr double k_title_at = 14.0, k_line_at = 34.0;  // baselines
constexpr double k_chart_top = 56.0, k_chart_bottom = 158.0, k_axis_at = 174.0;
constexpr double k_from_deg = -5.0, k_to_deg = 10.0;
constexpr double k_least_scale = 0.5;
constexpr glm::dvec2 k_design(1600.0, 1000.0);

double place_of(double draft_deg) {
  return k_padding + (draft_deg - k_from_deg) / (k_to_deg - k_from_deg) * (k_width - 2.0 * k_padding);
}

void draw_bars(DesignSpace& at, const DraftCheck& check, const LegendStyle& style) {
  double tallest = 0.0;
  const auto is_shown = [](const DraftBin& bin) {
    return bin.from_deg >= k_from_deg && bin.to_deg <= k_to_deg;
  };
  for (const DraftBin& bin : check.histogram) {
    if (is_shown(bin)) tallest = std::max(tallest, bin.area[0] + bin.area[1]);
  }
  for (const DraftBin& bin : check.histogram) {
    if (!is_shown(bin) || tallest <= 0.0) continue;
    double foot = k_padding + k_chart_bottom;
    const double left = place_of(bin.from_deg) + 0.5, width = place_of(bin.to_deg) - left - 0.5;
    for (const Region region : {Region::core, Region::cavity}) {
      const double height =
          (k_chart_bottom - k_chart_top) * bin.area[region == Region::core ? 0 : 1] / tallest;
      foot -= height;
      if (height > 0.0) fill_region(at.canvas(), at.box({left, foot}, {width, height}), region, style);
    }
  }
}

}  // namespace

std::span<const Option<DraftSettings>> draft_options() {
  using S = DraftSettings;
  static const std::vector<Option<S>> k_options = {
      {"required_draft_deg", "--required-draft", "Required draft of each half", "deg",
       "Report the walls with less draft than this, the reverse draft, and the thickness that the missing "
       "draft costs.",
       PositiveKind<S>{[](S& s) -> double& { return s.required_deg; }, k_most_required_deg}},
  };
  return k_options;
}

DraftCheck check_draft(const PartModel& model, const Assignment& assignment, const ReverseDraft& reverse,
                       double required_deg) {
  DraftCheck check;
  check.required_deg = required_deg;
  check.reverse = reverse;
  check.histogram = empty_bins();
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  std::map<std::pair<std::uint32_t, MoldSide>, Shallow> shallow;
  for (PieceIndex k = 0; k < assignment.sides.size(); ++k) {
    const MoldSide side = assignment.sides[k];
    if (side == MoldSide::action) continue;
    const auto half = static_cast<std::size_t>(side);
    const FacetIndex facet = assignment.mesh.pieces[k].facet;
    const double upward = draft_angle_deg(model.geometry.normals[facet], assignment.direction);
    const double draft = side == MoldSide::core ? upward : -upward;
    const double area = 0.5 * glm::length(twice_piece_area(assignment.mesh, k));
    if (area <= 0.0) continue;
    bin_of(check.histogram, draft).area[half] += area;
    if (draft >= required_deg - k_draft_rounding_deg) continue;
    check.below[half] += area;
    Shallow& face = shallow[{faces.of_facet[facet], side}];
    face.pieces.push_back({k, area, draft});
    face.area += area;
  }
  for (const auto& [key, face] : shallow) {
    ++check.faces_below[static_cast<std::size_t>(key.second)];
    check.walls.push_back(wall_of(model, assignment, face, key.second, required_deg));
    check.walls.back().face = key.first;
  }
  std::ranges::stable_sort(check.walls, std::greater(), &WallDraft::thickness);
  return check;
}

Json draft_json(const PartModel& model, const DraftCheck& check) {
  Json below, bins = Json::array(), walls = Json::array();
  glm::dvec3 worst(0.0);
  for (int k = 0; check.reverse.facet && k < 3; ++k) worst += model.part.mesh.corner(*check.reverse.facet, k);
  for (const MoldSide side : {MoldSide::core, MoldSide::cavity}) {
    const auto half = static_cast<std::size_t>(side);
    below[side_name(side)] = {{"area", check.below[half]}, {"faces", check.faces_below[half]}};
  }
  for (const DraftBin& bin : check.histogram)
    bins.push_back(
        {{"from_deg", bin.from_deg}, {"to_deg", bin.to_deg}, {"core", bin.area[0]}, {"cavity", bin.area[1]}});
  for (const WallDraft& wall : check.walls) walls.push_back(wall_json(wall));
  return {{"required_deg", check.required_deg},
          {"rounding_deg", k_draft_rounding_deg},
          {"below", below},
          {"reverse",
           {{"area", check.reverse.area},
            {"worst_deg", check.reverse.worst_deg},
            {"place", check.reverse.facet ? point_json(worst / 3.0) : Json()}}},
          {"histogram", bins},
          {"faces", walls}};
}

std::string suggestion(const PartModel& model, const WallDraft& wall) {
  return fmt::format("turn by {:.2f}° about its foot: {:.3g} {}", wall.turn_deg, wall.thickness,
                     length_unit(model.part));
}

std::string draft_sentence(const PartModel& model, const DraftCheck& check) {
  const std::string unit = powered_unit(model.part, 2);
  std::string text;
  for (const MoldSide side : {MoldSide::core, MoldSide::cavity}) {
    const auto k = static_cast<std::size_t>(side);
    if (check.faces_below[k] == 0) continue;
    text += fmt::format("{}{} {} on {}", text.empty() ? "" : ", ", side_name(side),
                        short_area(check.below[k], unit), plural(check.faces_below[k], "face"));
  }
  text = text.empty() ? fmt::format("every wall has {}° or more", figure(check.required_deg))
                      : fmt::format("below {}°: {}", figure(check.required_deg), text);
  if (check.reverse.facet)
    text += fmt::format(" · reverse draft {}, at worst {:.3g}°", short_area(check.reverse.area, unit),
                        check.reverse.worst_deg);
  return text;
}

void write_draft_csv(const std::string& path, const DraftCheck& check) {
  AtomicFile file(path);
  file.write(
      "face,side,area,least_draft_deg,height,turn_deg,thickness,foot_height,foot_x1,foot_y1,foot_z1,foot_x2,"
      "foot_y2,foot_z2\n");
  for (const WallDraft& wall : check.walls) {
    std::string row = fmt::format("{},{},{},{},{},{},{},{}", wall.face, side_name(wall.side), wall.area,
                                  wall.least_deg, wall.height, wall.turn_deg, wall.thickness, wall.foot);
    for (std::size_t end = 0; end < 2; ++end) {
      if (wall.foot_line) {
        const glm::dvec3& p = (*wall.foot_line)[end];
        fmt::format_to(std::back_inserter(row), ",{},{},{}", p.x, p.y, p.z);
      } else {
        row += ",,,";
      }
    }
    file.write(row += '\n');
  }
  file.commit();
}

Image with_draft_histogram(const Image& picture, const PartModel& model, const DraftCheck& check,
                           const StillSettings& settings) {
  const glm::dvec2 size(picture.width, picture.height);
  const double scale = std::min(size.x / k_design.x, size.y / k_design.y);
  if (!settings.legend || scale < k_least_scale) return picture;
  const LegendStyle style{
      .dark = settings.theme == Theme::dark, .palette = settings.look.palette, .scale = scale};
  const PictureInks inks = picture_inks(style.dark);
  Canvas canvas(picture);
  const Box card{size - scale * glm::dvec2(k_width + k_margin, k_height + k_margin),
                 scale * glm::dvec2(k_width, k_height)};
  canvas.fill_box(card, inks.card, k_radius * scale);
  canvas.outline_box({card.corner + 0.5, card.size - 1.0}, inks.border, k_radius * scale, 1.0);

  DesignSpace at(canvas, card.corner, scale, style.dark);
  const double inner = k_width - 2.0 * k_padding;
  at.elided({k_padding, k_padding + k_title_at}, "Draft by area", at.title(), inner);
  const std::string unit = powered_unit(model.part, 2);
  const FigureColumn areas(check.below[0] + check.below[1]);
  at.elided({k_padding, k_padding + k_line_at},
            fmt::format("below {}°: core {}, cavity {} {}", figure(check.required_deg),
                        areas.text(check.below[0]), areas.text(check.below[1]), unit),
            at.small(Align::left), inner);
  draw_bars(at, check, style);
  at.line({k_padding, k_padding + k_chart_bottom}, {k_width - k_padding, k_padding + k_chart_bottom},
          inks.faint, 1.0);
  if (check.required_deg <= k_to_deg) {
    const double x = place_of(check.required_deg);
    at.line({x, k_padding + k_chart_top - 4.0}, {x, k_padding + k_chart_bottom}, inks.strong, 1.5);
  }
  for (const int degrees : {-5, 0, 5, 10})
    at.text({place_of(degrees), k_padding + k_axis_at}, fmt::format("{}°", degrees), at.small(Align::centre));
  return canvas.image();
}

}  // namespace moldlight
