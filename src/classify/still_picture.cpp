#include "classify/still_picture.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "gl/objects.hpp"
#include "mold/direction.hpp"
#include "mold/exact/exact_regions.hpp"
#include "picture/callouts.hpp"
#include "picture/legend.hpp"
#include "render/view_geometry.hpp"

namespace moldlight {

namespace {

/// A picture of this size has everything at scale 1; one of another shape at least by its smaller side.
constexpr glm::dvec2 k_full_scale_px(1280.0, 800.0);
constexpr double k_full_scale_side_px = 1150.0;
constexpr double k_least_scale = 0.72;  // below this text is not read
constexpr double k_most_share = 0.2;    // of the picture's area, that a legend may take
constexpr double k_margin = 28.0;       // around it at scale 1
constexpr double k_fill = 0.86;
constexpr int k_reduction = 8;  // of the pictures that show what the part covers

/// What a picture must find room for, seen from where the camera looks. Points are in the unit frame.
struct Composition {
  Camera camera;
  glm::ivec2 size{0};
  std::optional<Box> legend;
  std::span<const glm::vec3> extremes;  // the part's outermost points
  std::span<const glm::vec3> beyond;    // points off the part that are to be seen too
};

/// A camera that fits the points into a box of the picture.
Camera framed(Camera camera, std::span<const glm::vec3> points, const Box& box, const glm::ivec2& size) {
  const glm::ivec2 room = glm::max(glm::ivec2(box.size), glm::ivec2(1));
  camera = fitted(camera, points, room, k_fill);
  camera.height *= static_cast<double>(size.y) / room.y;
  return panned(camera, box.corner + 0.5 * box.size - 0.5 * glm::dvec2(size), size);
}

/// Boxes for the part, from the whole picture to what the legend leaves free for certain.
std::vector<Box> scene_boxes(const Composition& composition) {
  const glm::dvec2 room(composition.size);
  std::vector<Box> boxes = {{glm::dvec2(0.0), room}};
  if (!composition.legend) return boxes;
  const bool beside = room.x > 1.15 * room.y;
  const double left = composition.legend->far_corner().x, below = room.y - composition.legend->corner.y;
  for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    boxes.push_back(beside ? Box{{share * left, 0.0}, {room.x - share * left, room.y}}
                           : Box{{0.0, 0.0}, {room.x, room.y - share * below}});
  }
  return boxes;
}

/// The legend with some air around it.
Box forbidden_box(const Box& legend) {
  const double air = legend.corner.x;
  return {legend.corner - air, legend.size + 2.0 * air};
}

bool holds(const Box& box, const glm::dvec2& point) {
  return glm::all(glm::greaterThanEqual(point, box.corner)) &&
         glm::all(glm::lessThanEqual(point, box.far_corner()));
}

/// True if the part runs into a box of the picture, of which `view` has drawn a small one.
bool part_covers(const PartView& view, const glm::ivec2& small_size, const Box& box) {
  const std::vector<std::uint32_t> facets = view.read_facets();
  for (int y = 0; y < small_size.y; ++y) {
    for (int x = 0; x < small_size.x; ++x) {
      const auto row = static_cast<std::size_t>(small_size.y - 1 - y);
      if (facets[row * static_cast<std::size_t>(small_size.x) + static_cast<std::size_t>(x)] == 0) continue;
      if (holds(box, static_cast<double>(k_reduction) * (glm::dvec2(x, y) + 0.5))) return true;
    }
  }
  return false;
}

/// Where the legend stands in a still picture.
struct StillLayout {
  double scale = 1.0;         // of text, lines and hatches
  std::optional<Box> legend;  // none where there is no content or no room for it
};
/// `content` may be null.
StillLayout still_layout(const glm::ivec2& size, const LegendContent* content) {
  const glm::dvec2 room(size);
  StillLayout layout;
  layout.scale = std::max(std::min(room.x / k_full_scale_px.x, room.y / k_full_scale_px.y),
                          std::min(room.x, room.y) / k_full_scale_side_px);
  if (content == nullptr) return layout;
  layout.scale = std::max(layout.scale, k_least_scale);
  const glm::dvec2 legend = legend_size(*content, {.scale = layout.scale});
  const double margin = k_margin * layout.scale;
  if (legend.x + 2.0 * margin <= room.x && legend.x * legend.y <= k_most_share * room.x * room.y) {
    layout.legend = Box{{margin, room.y - margin - legend.y}, legend};
  }
  return layout;
}

/// The camera moved and zoomed so that the part is as large as it can be without running into the legend.
/// Draws small pictures with `view` to find out.
Camera composed(const gl::Functions& gl, PartView& view, const PartBuffers& part,
                const Composition& composition) {
  std::vector<glm::vec3> points(composition.extremes.begin(), composition.extremes.end());
  points.insert(points.end(), composition.beyond.begin(), composition.beyond.end());
  const std::vector<Box> boxes = scene_boxes(composition);
  const glm::ivec2 small_size = glm::max(composition.size / k_reduction, glm::ivec2(1));
  const gl::ColourTarget small(gl, small_size);
  ViewSettings plain;
  plain.colour_mode = ColourMode::plain;
  plain.ambient_occlusion = plain.feature_edges = plain.arrows = false;
  plain.samples = 1;
  for (const Box& box : boxes) {
    const Camera candidate = framed(composition.camera, points, box, composition.size);
    if (&box == &boxes.back()) return candidate;
    const Box forbidden = forbidden_box(*composition.legend);
    bool collides = false;
    for (const glm::vec3& point : composition.beyond) {
      const auto pixel = project(candidate, composition.size, glm::dvec3(point));
      collides = collides || (pixel && holds(forbidden, *pixel));
    }
    if (collides) continue;
    view.draw_final({small.framebuffer(), small_size}, {.part = part}, {candidate, plain});
    if (!part_covers(view, small_size, forbidden)) return candidate;
  }
  return composition.camera;
}

constexpr int k_samples = 32;

glm::dquat orientation(const PartModel& model, const std::shared_ptr<const SplitMesh>& split,
                       const glm::dvec3& direction, const StillSettings& settings) {
  if (settings.view == PictureView::automatic) {
    return settings.seen_from ? *settings.seen_from
                              : revealing_orientation(model, std::span(&split, 1), direction);
  }
  constexpr std::array k_views = {StandardView::isometric, StandardView::front, StandardView::back,
                                  StandardView::left,      StandardView::right, StandardView::top,
                                  StandardView::bottom};
  return standard_orientation(k_views[static_cast<std::size_t>(settings.view) - 1]);
}

std::shared_ptr<const SplitMesh> exact_regions(const PartModel& model, const Classification& result,
                                               const Progress& progress) {
  if (result.split) return result.split;
  const ExactQuery query = exact_query(model, result.query());
  return std::make_shared<const SplitMesh>(exact_split(model.exact(progress), query, progress).mesh);
}

LegendContent legend_content(const PartModel& model, const Classification& result) {
  LegendContent content;
  content.title = part_name(model.part);
  // A line each: the card is no wider than its table.
  content.lines = {
      "parting direction " + direction_words(result.direction),
      fmt::format("near-vertical below {}°", figure(result.settings.tau_deg)),
      fmt::format("lateral tolerance {:.3g} {}", result.lateral_tolerance, length_unit(model.part))};
  const FigureStyle style(model);
  for (const Region region : k_regions) {
    const auto index = static_cast<std::size_t>(region);
    content.shares[index] = share(result.areas[region], result.total_area);
    content.percents[index] = fmt::format("{:.2f}", 100.0 * content.shares[index]);
    content.areas[index] = style.text(FigureKind::area, result.areas[region]);
  }
  content.unit = powered_unit(model.part, 2);
  content.note = fmt::format("undercut ± {}  ·  two checks {}",
                             style.with_unit(FigureKind::error, result.uncertainty.total()),
                             result.identity.agrees() ? "agree" : "disagree");
  return content;
}

/// The part as it is drawn now.
struct DrawnPart {
  const PartView& view;
  const Camera& camera;
  glm::ivec2 size;
};

/// Bodies as a picture takes them.
struct ShownBodies {
  ShownBodies(std::span<const StillBody> stills, const UnitFrame& frame) {
    const glm::dmat4 to_part =
        glm::scale(glm::translate(glm::dmat4(1.0), frame.center), glm::dvec3(frame.diagonal));
    for (const StillBody& still : stills) {
      bodies.push_back(view_body(still.mesh, frame, still.colour));
      motions.push_back(glm::inverse(to_part) * still.motion * to_part);
      Bounds box;
      std::vector<glm::vec3> moved;
      for (const ViewVertex& vertex : bodies.back().vertices) {
        moved.emplace_back(motions.back() * glm::dvec4(glm::dvec3(vertex.position), 1.0));
        box.add(glm::dvec3(moved.back()));
      }
      middles.push_back(box.center());
      for (const auto& [a, b, c] : bodies.back().facets) {
        add_edge(moved[a], moved[b]);
        add_edge(moved[b], moved[c]);
        add_edge(moved[c], moved[a]);
      }
    }
  }

  std::vector<ViewBody> bodies;
  std::vector<glm::dmat4> motions;  // unit frame
  std::vector<glm::dvec3> middles;  // of each, where it is shown, in the unit frame
  std::vector<glm::vec3> outline;   // points of their edges, likewise

 private:
  /// Its end, and so many between that no long edge passes by unseen.
  void add_edge(const glm::vec3& from, const glm::vec3& to) {
    constexpr float k_step = 0.05F, k_most_steps = 64.0F;
    const float steps = std::ceil(std::clamp(glm::distance(from, to) / k_step, 1.0F, k_most_steps));
    for (float k = 1.0F; k <= steps; ++k) outline.push_back(glm::mix(from, to, k / steps));
  }
};

/// Says which half comes off along which arrow, where its tip is not behind the part.
void label_arrows(Canvas& canvas, const DrawnPart& part, const std::array<ViewArrow, 2>& arrows,
                  const LegendStyle& style) {
  for (const auto& [arrow, label] : {std::pair(arrows[0], "core"), std::pair(arrows[1], "cavity")}) {
    const auto tip = project(part.camera, part.size, arrow.tip);
    const auto tail = project(part.camera, part.size, arrow.tail);
    if (!tip || !tail) continue;
    const auto seen = part.view.pick(glm::ivec2(*tip));
    if (seen && glm::dot(glm::dvec3(seen->position) - arrow.tip, part.camera.toward_viewer()) > 0.0) continue;
    const glm::dvec2 along =
        glm::distance(*tip, *tail) > 1.0 ? glm::normalize(*tip - *tail) : glm::dvec2(0, -1);
    const glm::dvec2 room = tag_size(canvas, label, style);
    draw_tag(canvas, *tip + along * (6.0 * style.scale + 0.5 * glm::dot(glm::abs(along), room)), label,
             style);
  }
}

/// Of a place that is this much behind the surface there, the surface is not what is seen; unit frame.
constexpr double k_seen_within = 0.004;

/// Numbers where their places are in the picture.
std::vector<Callout> placed(const DrawnPart& part, std::span<const StillCallout> callouts,
                            const UnitFrame& frame) {
  std::vector<Callout> found;
  for (const StillCallout& callout : callouts) {
    std::optional<Callout> first;
    for (const glm::dvec3& place : callout.places) {
      const glm::dvec3 point(frame.to_unit(place));
      const auto pixel = project(part.camera, part.size, point);
      if (!pixel || !holds({glm::dvec2(0.0), glm::dvec2(part.size)}, *pixel)) continue;
      const auto seen = part.view.pick(glm::ivec2(*pixel));
      const double before =
          seen ? glm::dot(glm::dvec3(seen->position) - point, part.camera.toward_viewer()) : 0.0;
      if (!first || before < k_seen_within) first = Callout{*pixel, callout.text, before >= k_seen_within};
      if (!first->hidden) break;
    }
    if (first) found.push_back(*first);
  }
  return found;
}

}  // namespace

void validate(const StillSettings& settings) {
  for (const int side : {settings.size.x, settings.size.y}) {
    if (side < k_least_picture_px || side > k_most_picture_px) {
      throw UsageError(fmt::format("--size: {}x{} is out of range, {} to {} pixels a side", settings.size.x,
                                   settings.size.y, k_least_picture_px, k_most_picture_px));
    }
  }
}

StillPainter::StillPainter(const gl::Context& context, std::shared_ptr<const PartModel> model)
    : context_(&context),
      model_(std::move(model)),
      geometry_(view_geometry(model_->part.mesh, model_->geometry, model_->adjacency, model_->frame)),
      maps_(context, model_),
      view_(context.functions(), geometry_) {}

glm::dquat StillPainter::seen_best(std::span<const Classification> results) const {
  std::vector<std::shared_ptr<const SplitMesh>> splits;
  for (const Classification& result : results) splits.push_back(result.split);
  return revealing_orientation(*model_, splits, results.front().direction);
}

Image StillPainter::draw(const Classification& result, const StillSettings& settings,
                         const Progress& progress, std::span<const StillBody> bodies) {
  validate(settings);
  const glm::ivec2& size = settings.size;
  const LookSettings& look = settings.look;
  const auto split = exact_regions(*model_, result, progress);
  // What the GL draws in software takes seconds on a busy machine: between two passes it can be given up.
  const auto drawing = [&progress](double done) { progress.report("drawing the picture", done); };
  drawing(0.0);
  if (look.regions_by == RegionsBy::maps || look.mark_difference) maps_.draw_resting(result.query());
  maps_.take_split(*split, geometry_, result.query());

  const LegendContent content = legend_content(*model_, result);
  const StillLayout places = still_layout(size, settings.legend ? &content : nullptr);
  const std::array<ViewArrow, 2> arrows = {parting_arrow(geometry_.extremes, result.direction, 0.0),
                                           parting_arrow(geometry_.extremes, -result.direction, 0.0)};
  Camera camera;
  camera.orientation = orientation(*model_, split, result.direction, settings);
  camera.projection = settings.view == PictureView::automatic || settings.view == PictureView::isometric
                          ? Projection::perspective
                          : Projection::orthographic;
  camera.fov_deg = 22.0;

  ViewSettings view_settings{look};
  view_settings.theme = settings.theme;
  view_settings.backdrop = settings.backdrop;
  view_settings.pixel_scale = std::max(1.0, 1.15 * places.scale);
  view_settings.samples = k_samples;
  drawing(0.2);
  std::vector<glm::vec3> beyond;
  if (look.arrows && settings.focus.empty()) beyond = {glm::vec3(arrows[0].tip), glm::vec3(arrows[1].tip)};
  const ShownBodies shown(bodies, model_->frame);
  view_.set_bodies(shown.bodies);
  view_.set_tube(settings.line, settings.lit_line);
  beyond.insert(beyond.end(), shown.outline.begin(), shown.outline.end());
  camera = composed(
      context_->functions(), view_, maps_.buffers(),
      {camera, size, places.legend,
       settings.focus.empty() ? std::span<const glm::vec3>(geometry_.extremes) : settings.focus, beyond});
  drawing(0.4);
  const gl::ColourTarget picture(context_->functions(), size);
  for (int samples = 1;
       view_.draw({picture.framebuffer(), size}, maps_.subject(), {camera, view_settings, {}, shown.motions});
       ++samples)
    drawing(0.4 + 0.5 * samples / k_samples);

  Canvas canvas({size.x, size.y, picture.read()});
  drawing(0.9);
  const LegendStyle style{
      .dark = settings.theme == Theme::dark, .palette = look.palette, .scale = places.scale};
  if (look.arrows && places.legend) label_arrows(canvas, {view_, camera, size}, arrows, style);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (const auto pixel = project(camera, size, shown.middles[k]))
      draw_tag(canvas, *pixel, bodies[k].label, style);
  }
  if (const auto middle = project(camera, size, glm::dvec3(0.0)))
    draw_callouts(canvas, placed({view_, camera, size}, settings.callouts, model_->frame), *middle, style);
  if (settings.scale_bar)
    draw_scale_bar(canvas, model_->frame.diagonal * pixel_length(camera, size), length_unit(model_->part),
                   style);
  if (places.legend) draw_legend(canvas, places.legend->corner, content, style);
  return canvas.image();
}

std::span<const Option<StillSettings>> still_options() {
  using S = StillSettings;
  static const std::vector<Option<S>> k_options = {
      {"view", "--view", "View", "",
       "Point of view. Auto shows the undercuts best, with the parting direction upward.",
       choice<&S::view>({"auto", "iso", "front", "back", "left", "right", "top", "bottom"})},
      {"theme", "--theme", "Theme", "", "Background of the picture.", choice<&S::theme>({"dark", "light"})},
  };
  return k_options;
}

glm::ivec2 parse_picture_size(std::string_view text, std::string_view what, const glm::ivec2& least) {
  const std::size_t cross = std::min(text.find('x'), text.size());
  const auto width = number_from<int>(text.substr(0, cross));
  const auto height = number_from<int>(text.substr(std::min(cross + 1, text.size())));
  if (!width || !height)
    throw UsageError(fmt::format("{}: '{}' is not WIDTHxHEIGHT, such as 1280x720", what, text));
  const glm::ivec2 size(*width, *height);
  if (glm::any(glm::lessThan(size, least)) ||
      glm::any(glm::greaterThan(size, glm::ivec2(k_most_picture_px)))) {
    throw UsageError(fmt::format("{}: '{}' is out of range, {}x{} to {}x{} pixels", what, text, least.x,
                                 least.y, k_most_picture_px, k_most_picture_px));
  }
  return size;
}

}  // namespace moldlight
