#include "gui/draw/icons.hpp"

#include <cmath>
#include <initializer_list>

#include <glm/gtc/constants.hpp>

#include "gui/draw/ui.hpp"

namespace moldlight::gui {

namespace {

/// Strokes in a square from -1 to 1, y down.
class Pen {
 public:
  Pen(ImDrawList& list, const glm::vec2& centre, float size, ImU32 colour)
      : list_(&list),
        centre_(centre),
        half_(0.5F * size),
        width_(std::max(1.0F, size * 0.085F)),
        colour_(colour) {}

  void line(std::initializer_list<glm::vec2> points, bool closed = false) const {
    for (const glm::vec2& point : points) list_->PathLineTo(at(point));
    list_->PathStroke(colour_, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width_);
  }
  void circle(const glm::vec2& at_point, float radius) const {
    list_->AddCircle(at(at_point), radius * half_, colour_, 0, width_);
  }
  void dot(const glm::vec2& at_point, float radius) const {
    list_->AddCircleFilled(at(at_point), radius * half_, colour_);
  }
  /// Degrees, clockwise from the right.
  void arc(const glm::vec2& at_point, float radius, float from_deg, float to_deg) const {
    const float rad = glm::pi<float>() / 180.0F;
    list_->PathArcTo(at(at_point), radius * half_, from_deg * rad, to_deg * rad, 24);
    list_->PathStroke(colour_, ImDrawFlags_None, width_);
  }

 private:
  [[nodiscard]] ImVec2 at(const glm::vec2& point) const { return im(centre_ + point * half_); }

  ImDrawList* list_;
  glm::vec2 centre_;
  float half_, width_;
  ImU32 colour_;
};

void draw_gear(const Pen& pen) {
  pen.circle({0, 0}, 0.30F);
  pen.circle({0, 0}, 0.62F);
  for (int tooth = 0; tooth < 8; ++tooth) {
    const float angle = static_cast<float>(tooth) * glm::pi<float>() / 4.0F;
    const glm::vec2 out(std::cos(angle), std::sin(angle));
    pen.line({out * 0.62F, out * 0.86F});
  }
}

/// An arrow that turns back to the left; mirrored for redo.
void draw_turn(const Pen& pen, float side) {
  pen.line({{side * -0.35F, -0.75F}, {side * -0.75F, -0.35F}, {side * -0.35F, 0.05F}});
  pen.line({{side * -0.75F, -0.35F}, {side * 0.25F, -0.35F}});
  pen.arc({side * 0.25F, 0.15F}, 0.5F, side > 0 ? -90.0F : 90.0F, side > 0 ? 90.0F : 270.0F);
  pen.line({{side * 0.25F, 0.65F}, {side * -0.35F, 0.65F}});
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, const glm::vec2& centre, float size, ImU32 colour) {
  const Pen pen(list, centre, size, colour);
  switch (icon) {
    case Icon::open:
    case Icon::folder:
      pen.line(
          {{-0.8F, 0.65F}, {-0.8F, -0.6F}, {-0.25F, -0.6F}, {-0.05F, -0.35F}, {0.8F, -0.35F}, {0.8F, 0.65F}},
          true);
      break;
    case Icon::file:
      pen.line({{-0.55F, 0.8F}, {-0.55F, -0.8F}, {0.15F, -0.8F}, {0.55F, -0.4F}, {0.55F, 0.8F}}, true);
      pen.line({{0.12F, -0.76F}, {0.12F, -0.36F}, {0.52F, -0.36F}});
      break;
    case Icon::export_file:
      pen.line({{-0.75F, 0.25F}, {-0.75F, 0.75F}, {0.75F, 0.75F}, {0.75F, 0.25F}});
      pen.line({{0, 0.3F}, {0, -0.8F}});
      pen.line({{-0.4F, -0.4F}, {0, -0.8F}, {0.4F, -0.4F}});
      break;
    case Icon::picture:
      pen.line({{-0.85F, -0.45F},
                {-0.4F, -0.45F},
                {-0.22F, -0.7F},
                {0.22F, -0.7F},
                {0.4F, -0.45F},
                {0.85F, -0.45F},
                {0.85F, 0.7F},
                {-0.85F, 0.7F}},
               true);
      pen.circle({0, 0.1F}, 0.34F);
      break;
    case Icon::ruler:
      pen.line({{-0.85F, 0.35F}, {0.35F, -0.85F}, {0.85F, -0.35F}, {-0.35F, 0.85F}}, true);
      for (const float along : {-0.3F, 0.0F, 0.3F})
        pen.line({{along - 0.25F, -along - 0.25F}, {along - 0.02F, -along - 0.02F}});
      break;
    case Icon::undo:
      draw_turn(pen, 1.0F);
      break;
    case Icon::redo:
      draw_turn(pen, -1.0F);
      break;
    case Icon::help:
      pen.arc({0, -0.35F}, 0.42F, 170.0F, 405.0F);
      pen.line({{0.3F, -0.05F}, {0.0F, 0.2F}, {0.0F, 0.36F}});
      pen.dot({0, 0.72F}, 0.13F);
      break;
    case Icon::settings:
      draw_gear(pen);
      break;
    case Icon::flip:
      pen.line({{-0.4F, 0.8F}, {-0.4F, -0.75F}});
      pen.line({{-0.72F, -0.4F}, {-0.4F, -0.75F}, {-0.08F, -0.4F}});
      pen.line({{0.4F, -0.8F}, {0.4F, 0.75F}});
      pen.line({{0.08F, 0.4F}, {0.4F, 0.75F}, {0.72F, 0.4F}});
      break;
    case Icon::bookmark:
      pen.line({{-0.5F, -0.8F}, {0.5F, -0.8F}, {0.5F, 0.8F}, {0, 0.35F}, {-0.5F, 0.8F}}, true);
      break;
    case Icon::chevron_down:
      pen.line({{-0.55F, -0.25F}, {0, 0.3F}, {0.55F, -0.25F}});
      break;
    case Icon::chevron_up:
      pen.line({{-0.55F, 0.3F}, {0, -0.25F}, {0.55F, 0.3F}});
      break;
    case Icon::chevron_left:
      pen.line({{0.25F, -0.55F}, {-0.3F, 0}, {0.25F, 0.55F}});
      break;
    case Icon::chevron_right:
      pen.line({{-0.25F, -0.55F}, {0.3F, 0}, {-0.25F, 0.55F}});
      break;
    case Icon::close:
      pen.line({{-0.55F, -0.55F}, {0.55F, 0.55F}});
      pen.line({{-0.55F, 0.55F}, {0.55F, -0.55F}});
      break;
    case Icon::check:
      pen.line({{-0.65F, 0.05F}, {-0.2F, 0.5F}, {0.65F, -0.5F}});
      break;
    case Icon::alert:
      pen.line({{0, -0.75F}, {0.85F, 0.7F}, {-0.85F, 0.7F}}, true);
      pen.line({{0, -0.2F}, {0, 0.2F}});
      pen.dot({0, 0.45F}, 0.1F);
      break;
    case Icon::up:
      pen.line({{0, 0.75F}, {0, -0.7F}});
      pen.line({{-0.5F, -0.2F}, {0, -0.7F}, {0.5F, -0.2F}});
      break;
    case Icon::revisions:
      pen.line({{-0.85F, -0.6F}, {-0.15F, -0.6F}, {-0.15F, 0.6F}, {-0.85F, 0.6F}}, true);
      pen.line({{0.15F, -0.6F}, {0.85F, -0.6F}, {0.85F, 0.6F}, {0.15F, 0.6F}}, true);
      pen.dot({0.5F, 0.0F}, 0.2F);
      break;
    case Icon::exchange:
      pen.line({{-0.8F, -0.35F}, {0.75F, -0.35F}});
      pen.line({{0.4F, -0.7F}, {0.75F, -0.35F}, {0.4F, 0.0F}});
      pen.line({{0.8F, 0.4F}, {-0.75F, 0.4F}});
      pen.line({{-0.4F, 0.05F}, {-0.75F, 0.4F}, {-0.4F, 0.75F}});
      break;
    case Icon::sphere:
      pen.circle({0, 0}, 0.8F);
      pen.line({{-0.8F, 0}, {-0.55F, 0.19F}, {-0.2F, 0.27F}, {0.2F, 0.27F}, {0.55F, 0.19F}, {0.8F, 0}});
      break;
  }
}

}  // namespace moldlight::gui
