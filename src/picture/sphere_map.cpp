#include "picture/sphere_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "mold/map_frame.hpp"
#include "picture/design_space.hpp"

namespace moldlight {

namespace {

constexpr double k_air_px = 2.0;  // between labels
constexpr int k_turns = 16;
constexpr double k_first_gap = 0.2, k_gap_step = 0.5, k_last_gap = 5.0;  // in label heights

bool overlap(const Box& a, const Box& b) {
  return glm::all(glm::lessThan(a.corner, b.far_corner() + k_air_px)) &&
         glm::all(glm::lessThan(b.corner, a.far_corner() + k_air_px));
}

bool within(const Box& inner, const Box& outer) {
  return glm::all(glm::greaterThanEqual(inner.corner, outer.corner)) &&
         glm::all(glm::lessThanEqual(inner.far_corner(), outer.far_corner()));
}

bool covers(const Box& box, const LabelledMark& mark) {
  const glm::dvec2 nearest = glm::clamp(mark.centre, box.corner, box.far_corner());
  return glm::distance(nearest, mark.centre) < mark.radius + 0.5 * k_air_px;
}

/// A box whose edge is `gap` away from the mark, in direction `turn` of k_turns from the right,
/// counter-clockwise.
Box box_beside(const LabelledMark& mark, double gap, int turn) {
  const double angle = glm::two_pi<double>() * turn / k_turns;
  const glm::dvec2 along(std::cos(angle), -std::sin(angle));
  // How far from the centre a box of this size must stand so that its edge is at the mark.
  const glm::dvec2 half = 0.5 * mark.label;
  const glm::dvec2 steep = glm::max(glm::abs(along), glm::dvec2(1e-9));
  const double inside = std::min(half.x / steep.x, half.y / steep.y);
  return {mark.centre + along * (mark.radius + gap + inside) - half, mark.label};
}

constexpr Colour k_dark{24, 16, 20}, k_light{255, 255, 255};
constexpr Colour k_open{255, 196, 64};  // what a proof left open
// Lengths at scale 1.
constexpr double k_best_radius = 9.0, k_listed_radius = 4.0;
constexpr double k_axis_gap = 20.0, k_axis_px = 15.0, k_remark_px = 11.0, k_label_px = 12.0;
constexpr double k_hatch_pitch = 7.0;
/// A circle that is hardly wider than its mark would only blur it.
constexpr double k_least_circle_px = 13.0;
constexpr double k_on_rim = 0.05;  // height above the equator below which a mark has a twin across the map

glm::dvec2 pixel_of(const MapPlace& place, const glm::dvec2& point) {
  return place.centre + place.radius * glm::dvec2(point.x, -point.y);
}

glm::dvec3 upper(const glm::dvec3& direction) { return direction.z < 0.0 ? -direction : direction; }

glm::dvec2 pixel_of(const MapPlace& place, const glm::dvec3& direction) {
  return pixel_of(place, equal_area_point(upper(direction)));
}

struct Shade {
  glm::dvec3 bare, stripe;
};

Shade bare_shade(bool dark) {
  return dark ? Shade{{58, 62, 68}, {74, 79, 86}} : Shade{{222, 225, 229}, {204, 208, 214}};
}

/// The map alone, with a soft edge, `side` pixels wide.
Image map_image(const UndercutField& field, int side, double radius, const LegendStyle& style) {
  Image image = empty_image(side, side);
  const Shade bare = bare_shade(style.dark);
  const double middle = 0.5 * side, pitch = k_hatch_pitch * style.scale;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 at(x + 0.5 - middle, middle - y - 0.5);
      const double inside = std::clamp(radius - glm::length(at) + 0.5, 0.0, 1.0);
      if (inside <= 0.0) continue;
      const glm::dvec2 point = at / radius;
      const glm::dvec2 held = point / std::max(1.0, glm::length(point));
      const DirectionField::Reading reading = field.areas.at(equal_area_direction(held));
      const Colour colour = undercut_scale_colour(undercut_scale(reading.value, field.worst));
      const double along = std::abs(std::fmod(x + y, pitch) - 0.5 * pitch);
      const double stripe = std::clamp(along - 0.25 * pitch + 0.5, 0.0, 1.0);
      const glm::dvec3 unknown = glm::mix(bare.bare, bare.stripe, stripe);
      const glm::dvec3 mixed = glm::mix(unknown, glm::dvec3(colour.r, colour.g, colour.b), reading.cover);
      std::uint8_t* rgba = image.at(x, y);
      for (int k = 0; k < 3; ++k) rgba[k] = static_cast<std::uint8_t>(std::lround(mixed[k]));
      rgba[3] = static_cast<std::uint8_t>(std::lround(255.0 * inside));
    }
  }
  return image;
}

/// Lines of equal angle from +z and of equal azimuth, every 30 degrees.
void draw_graticule(Canvas& canvas, const MapPlace& place, double scale) {
  const Ink light{k_light, 0.22}, dark{k_dark, 0.16};
  const double width = 1.0 * scale;
  for (const double polar_deg : {30.0, 60.0}) {
    const double radius = place.radius * std::sqrt(1.0 - std::cos(glm::radians(polar_deg)));
    canvas.ring(place.centre, radius + 0.5 * width, light, width);
    canvas.ring(place.centre, radius - 0.5 * width, dark, width);
  }
  const double first = std::sqrt(1.0 - std::cos(glm::radians(30.0)));
  for (int k = 0; k < 12; ++k) {
    const double azimuth = glm::radians(30.0 * k);
    const glm::dvec2 along(std::cos(azimuth), std::sin(azimuth)), aside(-along.y, along.x);
    const double from = k % 3 == 0 ? 0.0 : first;
    const glm::dvec2 shift = 0.5 * width / place.radius * aside;
    canvas.line(pixel_of(place, from * along + shift), pixel_of(place, along + shift), light, width);
    canvas.line(pixel_of(place, from * along - shift), pixel_of(place, along - shift), dark, width);
  }
}

/// The directions so far away from a cap's middle.
void draw_circle(Canvas& canvas, const MapPlace& place, const SphereCap& cap, const Ink& line, double scale) {
  constexpr int k_steps = 180;
  const std::vector<glm::dvec3> ring = ring_around(cap.direction, cap.radius_deg, k_steps, 0.0);
  for (const auto& [ink, width] : {std::pair{Ink{k_dark, 0.6}, 3.0}, {line, 1.3}}) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const glm::dvec2 a = pixel_of(place, ring[k]), b = pixel_of(place, ring[(k + 1) % ring.size()]);
      // A step over the equator goes on at the other side of the map.
      if (glm::distance(a, b) < 0.5 * place.radius) canvas.line(a, b, ink, width * scale);
    }
  }
}

void draw_tilt(Canvas& canvas, const MapPlace& place, const SphereMark& mark, double scale) {
  draw_circle(canvas, place, {mark.direction, mark.tilt_deg}, {k_light, 0.95}, scale);
}

void draw_label(Canvas& canvas, const Box& box, const SphereMark& mark, double scale) {
  const Ink card = mark.best ? Ink{k_light, 0.96} : Ink{k_dark, 0.82};
  canvas.fill_box(box, card, 0.5 * box.size.y);
  if (mark.best) canvas.outline_box(box, {k_dark, 0.8}, 0.5 * box.size.y, 1.2 * scale);
  canvas.text(box.corner + 0.5 * box.size + glm::dvec2(0.0, 0.36 * k_label_px * scale), mark.label,
              {.size_px = k_label_px * scale,
               .weight = FontWeight::semibold,
               .ink = {mark.best ? k_dark : k_light},
               .align = Align::centre,
               .tabular = true});
}

void draw_marks(Canvas& canvas, const MapPlace& place, const std::vector<SphereMark>& marks,
                const std::vector<Box>& taken, double scale) {
  std::vector<LabelledMark> labelled;
  for (const SphereMark& mark : marks) {
    const double radius = (mark.best ? k_best_radius : k_listed_radius) * scale;
    glm::dvec2 label(0.0);
    if (!mark.label.empty()) {
      const TextStyle text{.size_px = k_label_px * scale, .weight = FontWeight::semibold, .tabular = true};
      const double height = 18.0 * scale;
      label = {std::max(canvas.text_width(mark.label, text) + 10.0 * scale, height), height};
    }
    labelled.push_back({pixel_of(place, mark.direction), radius, label});
  }
  const Box room{place.centre - place.radius - 30.0 * scale, glm::dvec2(2.0 * place.radius + 60.0 * scale)};
  const auto places = place_labels(labelled, taken, room);
  for (std::size_t k = 0; k < marks.size(); ++k) {
    if (!places[k] || marks[k].label.empty()) continue;
    const glm::dvec2 middle = places[k]->corner + 0.5 * places[k]->size;
    const glm::dvec2& centre = labelled[k].centre;
    const glm::dvec2 nearest = glm::clamp(centre, places[k]->corner, places[k]->far_corner());
    if (glm::distance(nearest, centre) < labelled[k].radius + 6.0 * scale) continue;
    canvas.line(centre, middle, {k_light, 0.7}, 2.4 * scale);
    canvas.line(centre, middle, {k_dark, 0.8}, 1.2 * scale);
  }
  // A mark that a better one would cover has its label alone.
  const auto covered = [&](std::size_t k) {
    return std::any_of(
        labelled.begin(), labelled.begin() + static_cast<std::ptrdiff_t>(k), [&](const auto& better) {
          return glm::distance(better.centre, labelled[k].centre) < better.radius + labelled[k].radius;
        });
  };
  for (std::size_t k = 0; k < marks.size(); ++k) {
    if (covered(k)) continue;
    draw_mark(canvas, labelled[k].centre, marks[k].best, scale);
    const glm::dvec3 direction = upper(marks[k].direction);
    if (direction.z < k_on_rim) {
      canvas.ring(
          pixel_of(place, equal_area_point(glm::normalize(glm::dvec3(-direction.x, -direction.y, 0.0)))),
          0.7 * labelled[k].radius, {k_dark, 0.7}, 1.4 * scale);
    }
  }
  for (std::size_t k = marks.size(); k-- > 0;)
    if (places[k] && !marks[k].label.empty()) draw_label(canvas, *places[k], marks[k], scale);
}

/// Names the axes around the rim and +z in the middle; gives the boxes that this takes.
std::vector<Box> draw_axes(Canvas& canvas, const MapPlace& place, const LegendStyle& style) {
  const PictureInks inks = picture_inks(style.dark);
  const double scale = style.scale;
  const TextStyle name{.size_px = k_axis_px * scale,
                       .weight = FontWeight::semibold,
                       .ink = inks.strong,
                       .align = Align::centre};
  std::vector<Box> taken;
  const std::array<std::pair<glm::dvec2, const char*>, 4> axes = {
      {{{1, 0}, "+x"}, {{0, 1}, "+y"}, {{-1, 0}, "−x"}, {{0, -1}, "−y"}}};
  for (const auto& [along, text] : axes) {
    const glm::dvec2 at = pixel_of(place, along) + k_axis_gap * scale * glm::dvec2(along.x, -along.y);
    canvas.line(pixel_of(place, along), pixel_of(place, along * (1.0 + 6.0 * scale / place.radius)),
                inks.normal, 1.5 * scale);
    canvas.text(at + glm::dvec2(0.0, 0.36 * name.size_px), text, name);
    taken.push_back({at - 11.0 * scale, glm::dvec2(22.0 * scale)});
  }
  return taken;
}

/// How far from +z the circles are, written on them where least is in the way.
void draw_degrees(Canvas& canvas, const MapPlace& place, double scale) {
  const TextStyle small{.size_px = k_remark_px * scale,
                        .weight = FontWeight::medium,
                        .ink = {k_dark, 0.75},
                        .align = Align::centre};
  for (const auto& [polar_deg, text] : {std::pair{30.0, "30°"}, {60.0, "60°"}}) {
    const double radius = std::sqrt(1.0 - std::cos(glm::radians(polar_deg)));
    const double azimuth = glm::radians(255.0);
    const glm::dvec2 at = pixel_of(place, radius * glm::dvec2(std::cos(azimuth), std::sin(azimuth)));
    const glm::dvec2 size(canvas.text_width(text, small) + 8.0 * scale, 15.0 * scale);
    canvas.fill_box({at - 0.5 * size, size}, {k_light, 0.6}, 0.5 * size.y);
    canvas.text(at + glm::dvec2(0.0, 0.36 * small.size_px), text, small);
  }
}

}  // namespace

std::vector<std::optional<Box>> place_labels(std::span<const LabelledMark> marks, std::span<const Box> taken,
                                             const Box& room) {
  std::vector<Box> filled(taken.begin(), taken.end());
  std::vector<std::optional<Box>> places;
  for (const LabelledMark& mark : marks) {
    const auto free = [&](const Box& box) {
      return within(box, room) &&
             std::none_of(filled.begin(), filled.end(),
                          [&](const Box& other) { return overlap(box, other); }) &&
             std::none_of(marks.begin(), marks.end(), [&](const auto& other) { return covers(box, other); });
    };
    std::optional<Box> place;
    for (double gap = k_first_gap; !place && gap <= k_last_gap; gap += k_gap_step) {
      for (int turn = 0; !place && turn < k_turns; ++turn) {
        const Box box = box_beside(mark, gap * mark.label.y, turn);
        if (free(box)) place = box;
      }
    }
    if (place) filled.push_back(*place);
    places.push_back(place);
  }
  return places;
}

void draw_open_caps(Canvas& canvas, const MapPlace& place, const std::vector<SphereCap>& caps, double scale) {
  // Wider than the mark of a listed direction, which often lies in it.
  constexpr double k_least_px = 14.0;
  const double least_deg = glm::degrees(std::acos(1.0 - std::pow(k_least_px * scale / place.radius, 2.0)));
  for (const SphereCap& cap : caps)
    draw_circle(canvas, place, {cap.direction, std::max(cap.radius_deg, least_deg)}, {k_open}, scale);
}

void draw_open_sample(Canvas& canvas, const glm::dvec2& at, double scale) {
  canvas.ring(at, 7.0 * scale, {k_dark, 0.6}, 3.0 * scale);
  canvas.ring(at, 7.0 * scale, {k_open}, 1.3 * scale);
}

void draw_unknown(Canvas& canvas, const Box& box, const LegendStyle& style) {
  const Shade shade = bare_shade(style.dark);
  const auto ink = [](const glm::dvec3& c) {
    return Ink{
        {static_cast<std::uint8_t>(c.x), static_cast<std::uint8_t>(c.y), static_cast<std::uint8_t>(c.z)}};
  };
  canvas.fill_box(box, ink(shade.bare), 3.0 * style.scale);
  canvas.hatch_box(box, ink(shade.stripe), 3.0 * style.scale, 0.7 * k_hatch_pitch * style.scale);
}

void draw_mark(Canvas& canvas, const glm::dvec2& at, bool best, double scale) {
  if (best) {
    canvas.ring(at, (k_best_radius - 1.5) * scale, {k_dark, 0.9}, 4.0 * scale);
    canvas.ring(at, (k_best_radius - 1.5) * scale, {k_light}, 2.0 * scale);
    canvas.disc(at, 1.8 * scale, {k_dark, 0.9});
  } else {
    canvas.disc(at, k_listed_radius * scale, {k_dark, 0.9});
    canvas.disc(at, (k_listed_radius - 1.4) * scale, {k_light});
  }
}

void draw_sphere_map(Canvas& canvas, const MapPlace& place, const UndercutField& field,
                     const std::vector<SphereMark>& marks, const LegendStyle& style) {
  const double scale = style.scale;
  const int side = 2 * static_cast<int>(std::ceil(place.radius)) + 4;
  const glm::dvec2 corner = glm::round(place.centre - 0.5 * side);
  const MapPlace drawn{corner + 0.5 * side, place.radius};
  canvas.picture(map_image(field, side, place.radius, style), {corner, glm::dvec2(side)});
  draw_graticule(canvas, drawn, scale);
  canvas.ring(drawn.centre, drawn.radius, picture_inks(style.dark).normal, 1.5 * scale);
  draw_degrees(canvas, drawn, scale);
  const std::vector<Box> taken = draw_axes(canvas, drawn, style);
  for (const SphereMark& mark : marks) {
    const double circle = drawn.radius * std::sqrt(1.0 - std::cos(glm::radians(mark.tilt_deg)));
    if (circle > k_least_circle_px * scale) draw_tilt(canvas, drawn, mark, scale);
  }
  draw_marks(canvas, drawn, marks, taken, scale);
}

}  // namespace moldlight
