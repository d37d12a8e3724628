// Text and samples of colours in the pages of a document: how they look, and where lines break.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "picture/canvas.hpp"
#include "report/report.hpp"

namespace moldlight::report {

/// Inks of a page, for paper.
inline constexpr Ink k_ink{{20, 23, 27}}, k_soft{{68, 75, 84}}, k_faint{{91, 99, 109}},
    k_line{{208, 213, 219}}, k_field{{241, 243, 245}}, k_good{{33, 122, 60}}, k_attention{{154, 91, 0}},
    k_bad{{180, 35, 35}};
/// The size of text, in points.
inline constexpr double k_body_pt = 9.0, k_small_pt = 8.0;
/// A line's height and how far below its top the letters stand, in sizes of the text.
inline constexpr double k_line_height = 1.38, k_baseline = 1.02;

/// The text in lines of at most `width_pt`, broken at line ends, at spaces, and inside of words that are
/// wider alone. At least one.
[[nodiscard]] std::vector<std::string> lines_of(Canvas& canvas, std::string_view text, const TextStyle& style,
                                                double width_pt);
/// The same for what must fit on a page with other such text: what would be too many lines ends with "…".
[[nodiscard]] std::vector<std::string> few_lines_of(Canvas& canvas, std::string_view text,
                                                    const TextStyle& style, double width_pt);
/// The widest word.
[[nodiscard]] double word_width(Canvas& canvas, std::string_view text, const TextStyle& style);

[[nodiscard]] constexpr double line_pt(const TextStyle& style) { return k_line_height * style.size_px; }

/// Draws lines below each other; `at` is the upper end of the first, at the side that they are aligned to.
void draw_lines(Canvas& canvas, const glm::dvec2& at, const std::vector<std::string>& lines,
                const TextStyle& style);

/// A box in the mark's colour, striped where it is hatched.
void draw_box(Canvas& canvas, const Mark& mark, const Box& box);
/// The same, a square that stands beside text.
void draw_mark(Canvas& canvas, const Mark& mark, const glm::dvec2& corner, double size_pt);

}  // namespace moldlight::report
