#include "report/pdf/mark.hpp"

namespace moldlight::report {

namespace {

constexpr double k_stripes_pt = 2.6;
constexpr Ink k_stripe{{255, 255, 255}, 0.55};

}  // namespace

void draw_box(Canvas& canvas, const Mark& mark, const Box& box) {
  if (box.size.x <= 0.0 || box.size.y <= 0.0) return;
  canvas.fill_box(box, {mark.colour});
  if (mark.hatched) canvas.hatch_box(box, k_stripe, 0.0, k_stripes_pt);
}

void draw_mark(Canvas& canvas, const Mark& mark, const glm::dvec2& corner, double size_pt) {
  const Box box{corner, glm::dvec2(size_pt)};
  canvas.fill_box(box, {mark.colour}, 0.15 * size_pt);
  if (mark.hatched) canvas.hatch_box(box, k_stripe, 0.15 * size_pt, k_stripes_pt);
}

}  // namespace moldlight::report
