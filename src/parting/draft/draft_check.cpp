#include "parting/draft/draft_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "classify/classify_report.hpp"
#include "classify/figure_table.hpp"
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
  wall.required_deg = required_deg;
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

/// Which of the finishes each face has.
class FinishesOfFaces {
 public:
  FinishesOfFaces(const DraftDemand& demand, std::size_t faces) : number_(faces, k_none) {
    for (const FaceFinish& one : demand.finishes)
      if (std::ranges::find(all_, one.finish, &FinishDraft::finish) == all_.end())
        all_.push_back({.finish = one.finish});
    std::ranges::stable_sort(all_, std::greater(),
                             [](const FinishDraft& one) { return one.finish.required_deg; });
    for (const FaceFinish& one : demand.finishes) {
      const auto found = std::ranges::find(all_, one.finish, &FinishDraft::finish);
      number_[one.face] = static_cast<std::uint32_t>(found - all_.begin());
      ++found->faces;
    }
  }
  [[nodiscard]] const std::vector<FinishDraft>& all() const { return all_; }
  /// Null for a face that has none.
  [[nodiscard]] FinishDraft* of(std::uint32_t face, std::vector<FinishDraft>& all) const {
    return number_[face] == k_none ? nullptr : &all[number_[face]];
  }

 private:
  static constexpr std::uint32_t k_none = ~0U;
  std::vector<FinishDraft> all_;
  std::vector<std::uint32_t> number_;  // of each face
};

/// Of faces of which a half forms a part that leans against it, what leans as much and is an undercut.
double undercut_that_leans_back(const PartModel& model, const Assignment& assignment, const Faces& faces) {
  const auto upward_deg = [&](PieceIndex piece) {
    return draft_angle_deg(model.geometry.normals[assignment.mesh.pieces[piece].facet], assignment.direction);
  };
  std::map<std::uint32_t, double> sense_of;  // of faces that lean back: that of the half
  for (PieceIndex k = 0; k < assignment.sides.size(); ++k) {
    const MoldSide side = assignment.sides[k];
    const double sense = side == MoldSide::core ? 1.0 : side == MoldSide::cavity ? -1.0 : 0.0;
    if (sense * upward_deg(k) < -k_draft_rounding_deg)
      sense_of[faces.of_facet[assignment.mesh.pieces[k].facet]] = sense;
  }
  double area = 0.0;
  for (PieceIndex k = 0; k < assignment.sides.size(); ++k) {
    if (assignment.sides[k] != MoldSide::action) continue;
    const auto found = sense_of.find(faces.of_facet[assignment.mesh.pieces[k].facet]);
    if (found != sense_of.end() && found->second * upward_deg(k) < -k_draft_rounding_deg)
      area += 0.5 * glm::length(twice_piece_area(assignment.mesh, k));
  }
  return area;
}

/// "below 1.5°", or below what each finish asks for.
std::string below_text(const DraftCheck& check) {
  return check.finishes.empty() ? fmt::format("below {}°", figure(check.required_deg))
                                : std::string("below the draft of its finish");
}

std::string short_area(double area, const std::string& unit) { return rounded(area) + " " + unit; }

Json wall_json(const WallDraft& wall) {
  Json line;
  if (wall.foot_line) line = {point_json((*wall.foot_line)[0]), point_json((*wall.foot_line)[1])};
  return {{"face", wall.face},
          {"side", side_name(wall.side)},
          {"finish", wall.finish.empty() ? Json() : Json(wall.finish)},
          {"required_deg", wall.required_deg},
          {"area", wall.area},
          {"least_deg", wall.least_deg},
          {"height", wall.height},
          {"foot", {{"height", wall.foot}, {"line", line}}},
          {"turn_deg", wall.turn_deg},
          {"thickness", wall.thickness}};
}

// Lengths at scale 1.
constexpr double k_width = 372.0, k_height = 224.0, k_margin = 24.0, k_padding = 20.0, k_radius = 12.0;
constexpr double k_title_at = 14.0, k_line_at = 34.0;  // baselines
constexpr double k_chart_top = 56.0, k_chart_bottom = 158.0, k_axis_at = 174.0;
constexpr double k_from_deg = -5.0, k_to_deg = 10.0;
constexpr double k_least_wall_share = 1e-6;  // of the part's surface: a smaller wall is a sliver
constexpr double k_least_scale = 0.5;
constexpr glm::dvec2 k_design(1600.0, 1000.0);

double place_of(double draft_deg) {
  return k_padding + (draft_deg - k_from_deg) / (k_to_deg - k_from_deg) * (k_width - 2.0 * k_padding);
}

void draw_bars(DesignSpace& at, const DraftCheck& check, const LegendStyle& style) {
  const double tallest = tallest_bin(check, k_from_deg, k_to_deg);
  for (const DraftBin& bin : check.histogram) {
    if (!bin.within(k_from_deg, k_to_deg) || tallest <= 0.0) continue;
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

double tallest_bin(const DraftCheck& check, double from_deg, double to_deg) {
  double tallest = 0.0;
  for (const DraftBin& bin : check.histogram)
    if (bin.within(from_deg, to_deg)) tallest = std::max(tallest, bin.area[0] + bin.area[1]);
  return tallest;
}

DraftCheck check_draft(const PartModel& model, const Assignment& assignment, const ReverseDraft& reverse,
                       const DraftDemand& demand) {
  DraftCheck check;
  check.required_deg = demand.required_deg;
  check.reverse = reverse;
  check.histogram = empty_bins();
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  const FinishesOfFaces finish_of(demand, faces.count());
  check.finishes = finish_of.all();
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
    const std::uint32_t number = faces.of_facet[facet];
    FinishDraft* const finish = finish_of.of(number, check.finishes);
    const double required_deg = finish != nullptr ? finish->finish.required_deg : demand.required_deg;
    const bool is_below = required_deg > 0.0 && draft < required_deg - k_draft_rounding_deg;
    if (finish != nullptr) {
      finish->area += area;
      finish->least_deg = std::min(finish->least_deg.value_or(draft), draft);
      if (is_below) finish->below += area;
    }
    if (!is_below) continue;
    check.below[half] += area;
    Shallow& face = shallow[{number, side}];
    face.pieces.push_back({k, area, draft});
    face.area += area;
  }
  check.reverse_undercut = undercut_that_leans_back(model, assignment, faces);
  for (const auto& [key, face] : shallow) {
    ++check.faces_below[static_cast<std::size_t>(key.second)];
    FinishDraft* const finish = finish_of.of(key.first, check.finishes);
    const double required_deg = finish != nullptr ? finish->finish.required_deg : demand.required_deg;
    WallDraft& wall = check.walls.emplace_back(wall_of(model, assignment, face, key.second, required_deg));
    wall.face = key.first;
    if (finish == nullptr) continue;
    ++finish->faces_below;
    wall.finish = finish->finish.name;
  }
  // Slivers of the tessellation have angles of their own: nobody looks for them.
  const double least = k_least_wall_share * model.geometry.total_area;
  std::ranges::stable_sort(check.walls, [&](const WallDraft& a, const WallDraft& b) {
    return std::pair(a.area < least, -a.thickness) < std::pair(b.area < least, -b.thickness);
  });
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
  Json finishes = Json::array();
  for (const FinishDraft& one : check.finishes)
    finishes.push_back({{"finish", one.finish.name},
                        {"required_deg", one.finish.required_deg},
                        {"faces", one.faces},
                        {"area", one.area},
                        {"least_deg", one.least_deg ? Json(*one.least_deg) : Json()},
                        {"below", {{"area", one.below}, {"faces", one.faces_below}}}});
  return {{"required_deg", check.required_deg},
          {"rounding_deg", k_draft_rounding_deg},
          {"below", below},
          {"reverse",
           {{"area", check.reverse.area},
            {"worst_deg", check.reverse.worst_deg},
            {"undercut_area", check.reverse_undercut},
            {"place", check.reverse.facet ? point_json(worst / 3.0) : Json()}}},
          {"histogram", bins},
          {"finishes", finishes},
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
  if (!text.empty())
    text = fmt::format("{}: {}", below_text(check), text);
  else
    text = check.finishes.empty() ? fmt::format("every wall has {}° or more", figure(check.required_deg))
                                  : std::string("every wall has the draft of its finish");
  if (check.reverse.facet)
    text += fmt::format(" · reverse draft {}, at worst {:.3g}°{}", short_area(check.reverse.area, unit),
                        check.reverse.worst_deg,
                        check.reverse_undercut > 0.0 ? fmt::format("; {} more of these walls is undercut",
                                                                   short_area(check.reverse_undercut, unit))
                                                     : std::string());
  return text;
}

void write_draft_csv(const std::string& path, const DraftCheck& check) {
  AtomicFile file(path);
  file.write(
      "face,side,area,least_draft_deg,height,turn_deg,thickness,foot_height,foot_x1,foot_y1,foot_z1,foot_x2,"
      "foot_y2,foot_z2,required_draft_deg,finish\n");
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
    fmt::format_to(std::back_inserter(row), ",{},{}\n", wall.required_deg, wall.finish);
    file.write(row);
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
  const FigureStyle figures(model);
  at.elided(
      {k_padding, k_padding + k_line_at},
      fmt::format("{}: core {}, cavity {}", below_text(check), figures.text(FigureKind::area, check.below[0]),
                  figures.with_unit(FigureKind::area, check.below[1])),
      at.small(Align::left), inner);
  draw_bars(at, check, style);
  at.line({k_padding, k_padding + k_chart_bottom}, {k_width - k_padding, k_padding + k_chart_bottom},
          inks.faint, 1.0);
  if (check.required_deg > 0.0 && check.required_deg <= k_to_deg) {
    const double x = place_of(check.required_deg);
    at.line({x, k_padding + k_chart_top - 4.0}, {x, k_padding + k_chart_bottom}, inks.strong, 1.5);
  }
  for (const int degrees : {-5, 0, 5, 10})
    at.text({place_of(degrees), k_padding + k_axis_at}, fmt::format("{}°", degrees), at.small(Align::centre));
  return canvas.image();
}

}  // namespace moldlight
