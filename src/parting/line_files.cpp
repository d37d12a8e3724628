#include "parting/line_files.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "classify/number_format.hpp"
#include "io/atomic_file.hpp"
#include "io/part_formats.hpp"
#include "io/step_text.hpp"
#include "mesh/length_unit.hpp"
#include "parting/mold_halves.hpp"

namespace moldlight {

namespace {

using Out = std::back_insert_iterator<std::string>;

std::string layer_of(std::string_view kind) {
  return kind == "outer"      ? "OUTER"
         : kind == "shut-off" ? "SHUT_OFF"
         : kind == "seam"     ? "SEAM"
                              : "UNDERCUT_RIM";
}

void write_dxf(const std::string& path, const WrittenLines& lines) {
  std::string text;
  const Out out(text);
  fmt::format_to(out, "999\nmoldlight {} of {}\n", lines.title, StepText::plain(lines.name));
  fmt::format_to(out, "999\nunit: {}\n",
                 lines.unit.empty() ? "that of the part's file" : StepText::plain(lines.unit));
  text += "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n";
  text += "0\nTABLE\n2\nLAYER\n70\n";
  const bool has_seams =
      std::ranges::any_of(lines.loops, [](const auto& loop) { return loop.kind == "seam"; });
  std::vector<std::pair<std::string_view, int>> layers = {{"outer", 1}, {"shut-off", 5}, {"action", 6}};
  if (has_seams) layers = {{"seam", 1}};
  fmt::format_to(out, "{}\n", layers.size());
  for (const auto& [kind, colour] : layers)
    fmt::format_to(out, "0\nLAYER\n2\n{}\n70\n0\n62\n{}\n6\nCONTINUOUS\n", layer_of(kind), colour);
  text += "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (const WrittenLoop& loop : lines.loops) {
    const std::string layer = layer_of(loop.kind);
    fmt::format_to(out, "0\nPOLYLINE\n8\n{}\n66\n1\n10\n0\n20\n0\n30\n0\n70\n{}\n", layer, loop.open ? 8 : 9);
    for (const glm::dvec3& p : loop.points)
      fmt::format_to(out, "0\nVERTEX\n8\n{}\n10\n{}\n20\n{}\n30\n{}\n70\n32\n", layer, p.x, p.y, p.z);
    fmt::format_to(out, "0\nSEQEND\n8\n{}\n", layer);
  }
  write_file(path, text += "0\nENDSEC\n0\nEOF\n");
}

void write_svg(const std::string& path, const WrittenLines& lines) {
  const MoldFrame frame = mold_frame(lines.direction);
  const double scale = mm_per_unit(lines.unit);
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for (const WrittenLoop& loop : lines.loops) {
    for (const glm::dvec3& point : loop.points) {
      const glm::dvec3 p = scale * frame.to_mold(point);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  if (lines.loops.empty()) low = high = glm::dvec3(0.0);
  const glm::dvec3 size = high - low;
  const double border = 0.03 * std::max({size.x, size.y, 1e-9}), width = size.x + 2 * border,
               height = size.y + 2 * border, stroke = 0.003 * std::max({size.x, size.y, 1e-9});
  std::string text;
  const Out out(text);
  fmt::format_to(
      out,
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n<title>Parting line seen along the "
      "direction; blue is low, red is high</title>\n",
      width, height);
  for (const WrittenLoop& loop : lines.loops) {
    fmt::format_to(
        out, "<g id=\"loop{}\" class=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" fill=\"none\">\n",
        &loop - lines.loops.data() + 1, loop.kind, stroke);
    for (std::size_t k = 0; k + (loop.open ? 1 : 0) < loop.points.size(); ++k) {
      const glm::dvec3 a = scale * frame.to_mold(loop.points[k]),
                       b = scale * frame.to_mold(loop.points[(k + 1) % loop.points.size()]);
      const double share = size.z > 1e-9 * glm::length(size) ? (0.5 * (a.z + b.z) - low.z) / size.z : 0.5;
      const auto red = static_cast<int>(220.0 * share), blue = static_cast<int>(220.0 * (1.0 - share));
      fmt::format_to(out, "<path d=\"M{} {}L{} {}\" stroke=\"#{:02x}30{:02x}\"/>\n", a.x - low.x + border,
                     high.y - a.y + border, b.x - low.x + border, high.y - b.y + border, red, blue);
    }
    text += "</g>\n";
  }
  write_file(path, text += "</svg>\n");
}

void write_obj(const std::string& path, const WrittenLines& lines) {
  std::string text = fmt::format("# moldlight {}\n", lines.title);
  const Out out(text);
  std::size_t number = 0;
  std::string_view group;
  for (const WrittenLoop& loop : lines.loops) {
    for (const glm::dvec3& p : loop.points) fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
    if (loop.kind != group) fmt::format_to(out, "g {}\n", loop.kind);
    group = loop.kind;
    text += "l";
    for (std::size_t k = 0; k < loop.points.size(); ++k) fmt::format_to(out, " {}", number + k + 1);
    text += loop.open ? "\n" : fmt::format(" {}\n", number + 1);
    number += loop.points.size();
  }
  write_file(path, text);
}

void write_csv(const std::string& path, const WrittenLines& lines) {
  std::string text = "loop,kind,x,y,z\n";
  const Out out(text);
  for (std::size_t k = 0; k < lines.loops.size(); ++k) {
    for (const glm::dvec3& p : lines.loops[k].points)
      fmt::format_to(out, "{},{},{},{},{}\n", k + 1, lines.loops[k].kind, p.x, p.y, p.z);
  }
  write_file(path, text);
}

void write_step(const std::string& path, const WrittenLines& lines) {
  StepText text(fmt::format("moldlight {}", lines.title), lines.name);
  const double mm = mm_per_unit(lines.unit);  // every file is in millimetres
  std::string curves;
  for (const WrittenLoop& loop : lines.loops) {
    StepText::Number first = 0;
    for (const glm::dvec3& p : loop.points) {
      const StepText::Number added = text.point(mm * p);
      if (first == 0) first = added;
    }
    const auto curve =
        text.add(fmt::format("POLYLINE('{}',({}{}))", loop.kind, StepText::list(first, loop.points.size()),
                             loop.open ? "" : fmt::format(",#{}", first)));
    curves += fmt::format("{}#{}", curves.empty() ? "" : ",", curve);
  }
  const auto set = text.add(fmt::format("GEOMETRIC_CURVE_SET('{}',({}))", lines.title, curves));
  const auto shape =
      text.add(fmt::format("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',({},#{}),{})",
                           StepText::origin(), set, StepText::context()));
  text.represent(text.product(lines.title), shape);
  write_file(path, std::move(text).finished());
}

const WrittenFormat<WrittenLines>& format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const auto& format : line_formats()) {
    if (format.extension == extension) return format;
  }
  throw UsageError(path + ": lines are written as ." + extensions_text(line_formats()) +
                   "; change the extension");
}

}  // namespace

WrittenLines lines_to_write(const PartModel& model, const Assignment& assignment, const PartingLine& line) {
  WrittenLines lines{
      .loops = {}, .direction = assignment.direction, .unit = model.part.unit, .name = part_name(model.part)};
  for (const PartingLoop& loop : line.loops) {
    lines.loops.push_back({.kind = loop_name(loop.kind), .points = loop.points});
  }
  return lines;
}

std::span<const WrittenFormat<WrittenLines>> line_formats() {
  static constexpr WrittenFormat<WrittenLines> k_formats[] = {
      {"dxf", write_dxf}, {"svg", write_svg}, {"obj", write_obj}, {"csv", write_csv}, {"step", write_step}};
  return k_formats;
}

void check_line_extension(const std::string& path) { static_cast<void>(format_of(path)); }

void write_lines(const std::string& path, const WrittenLines& lines) { format_of(path).write(path, lines); }

}  // namespace moldlight
