// What is said of a parting line in a sentence.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "classify/figures.hpp"
#include "parting/loops.hpp"
#include "parting/mold_frame.hpp"

namespace moldlight {

namespace {

constexpr double k_planar_share = 1e-4;  // of the diagonal
constexpr double k_steep_deg = 85.0;
/// A line that goes up and down a few times has this many times its climb.
constexpr double k_many_climbs = 4.0;
constexpr double k_small_draft_deg = 5.0;

/// "z = 12.4"; "12.4 along 0.6, 0, 0.8" for a direction that is no axis.
std::string height_text(const glm::dvec3& direction, double height) {
  const int axis = axis_of(direction);
  if (axis < 0) return fmt::format("{} along {}", figure(height), figures(direction, 1.0));
  return fmt::format("{} = {}", "xyz"[axis], figure(height * direction[axis]));
}

std::string plural(std::size_t count, std::string_view word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

/// What the whole numbers say where they are not those of two simple surfaces.
std::string count_text(const EulerCheck& euler) {
  if (euler.loops == euler.expected_loops) return {};
  std::string why;
  if (euler.core_pieces > euler.bodies) why += fmt::format(" the core is in {} pieces,", euler.core_pieces);
  if (euler.cavity_pieces > euler.bodies)
    why += fmt::format(" the cavity is in {} pieces,", euler.cavity_pieces);
  const auto of_actions = euler.borders[static_cast<std::size_t>(MoldSide::action)];
  if (euler.action_pieces > 0)
    why += fmt::format(" side actions form {} of the surface with {},", plural(euler.action_pieces, "piece"),
                       plural(static_cast<std::size_t>(of_actions), "border"));
  if (!why.empty()) why.pop_back();
  return fmt::format(", {} where the part's {} ask for {}{}{}", plural(euler.loops, "loop"),
                     plural(static_cast<std::size_t>(std::max<std::int64_t>(0, euler.genus)), "handle"),
                     euler.expected_loops, why.empty() ? "" : ":", why);
}

}  // namespace

std::string parting_verdict(const Assignment& assignment, const PartingLine& line, double diagonal) {
  std::size_t outer = 0, shut_offs = 0, breaks = 0;
  double steepest = 0.0, steep = 0.0, flatness = 0.0, up_and_down = 0.0, draft = 0.0;
  for (const PartingLoop& loop : line.loops) {
    if (loop.kind == LoopKind::action) continue;
    (loop.kind == LoopKind::outer ? outer : shut_offs) += 1;
    if (loop.kind == LoopKind::outer) {
      flatness = std::max(flatness, loop.flatness);
      up_and_down += loop.up_and_down;
      draft = std::max(draft, loop.steep_draft_deg);
    }
    breaks += loop.breaks;
    steepest = std::max(steepest, loop.steepest_deg);
    steep += loop.steep_length;
  }
  if (outer == 0) return "no parting line: core and cavity do not meet";
  const double climb = line.outer_high - line.outer_low;
  std::string text;
  if (climb <= k_planar_share * diagonal) {
    text =
        "planar parting line at " +
        height_text(assignment.direction, std::abs(line.outer_low) > 1e-6 * diagonal ? line.outer_low : 0.0);
  } else if (flatness <= k_planar_share * diagonal) {
    text = fmt::format("parting line in an inclined plane, climbing {}", figure(climb));
  } else {
    text = fmt::format("parting line that climbs {}", figure(climb));
    if (up_and_down > k_many_climbs * climb) {
      text += fmt::format(", up and down {} in all", figure(up_and_down));
      if (draft <= k_small_draft_deg)
        text += fmt::format(" on facets of at most {:.1f}° of draft", std::ceil(10.0 * draft) / 10.0);
    }
  }
  text += fmt::format(", {}", shut_offs == 0 ? "no shut-off" : plural(shut_offs, "shut-off"));
  if (steepest <= k_steep_deg) {
    text += fmt::format(", no step steeper than {:.0f}°", k_steep_deg);
  } else {
    text += fmt::format(", {} of steep steps, up to {:.0f}°", figure(steep), std::floor(steepest));
  }
  if (line.smoothed_length > 1e-6 * diagonal || line.smoothed_climb > 1e-6 * diagonal)
    text +=
        fmt::format("; smoothing took {} of its length and {} of its climbs",
                    figure(std::max(0.0, line.smoothed_length)), figure(std::max(0.0, line.smoothed_climb)));
  const double action = assignment.area(MoldSide::action);
  if (action > 0.0) {
    text += fmt::format("; side actions form {} of the surface", share_text(action, assignment.total_area));
    if (breaks > 0)
      text += fmt::format(" and break the line {}", breaks == 1 ? "once" : plural(breaks, "time"));
  }
  return text + count_text(line.euler);
}

}  // namespace moldlight
