#include "report/live_view.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "gl/shader_text.hpp"
#include "page/page.hpp"
#include "report/model_view.hpp"

namespace moldlight::report {

namespace {

/// The bytes of all numbers, the lowest of each first.
template <typename Bits>
void pack_planes(const std::vector<Bits>& numbers, PackedBytes& bytes) {
  for (std::size_t byte = 0; byte < sizeof(Bits); ++byte)
    for (const Bits number : numbers) bytes.add_byte(static_cast<unsigned char>(number >> (8 * byte) & 0xFF));
}

/// Bytes a coordinate.
int pack_coordinates(const TriangleMesh& mesh, const std::vector<VertexIndex>& order, PackedBytes& bytes) {
  std::vector<std::uint32_t> single;
  std::vector<std::uint64_t> full;
  bool fits = true;
  for (const VertexIndex vertex : order) {
    for (int axis = 0; axis < 3; ++axis) {
      const double value = mesh.vertices[vertex][axis];
      const auto rounded = static_cast<float>(value);
      single.push_back(std::bit_cast<std::uint32_t>(rounded));
      full.push_back(std::bit_cast<std::uint64_t>(value));
      fits = fits && std::bit_cast<std::uint64_t>(static_cast<double>(rounded)) == full.back();
    }
  }
  if (fits) {
    pack_planes(single, bytes);
  } else {
    pack_planes(full, bytes);
  }
  return fits ? 4 : 8;
}

Json sphere_json(const Image& image) {
  if (image.rgba.empty()) return nullptr;
  PackedBytes bytes;
  for (const unsigned char byte : image.rgba) bytes.add_byte(byte);
  return {{"size", image.width}, {"data", bytes.deflated_base64()}};
}

/// An attribute that the page's script reads.
std::string direction_html(const glm::dvec3& direction) {
  return fmt::format(" data-direction=\"{},{},{}\"", direction.x, direction.y, direction.z);
}

std::string stage_text(const char* path, const gl::Defines& defines) {
  return gl::es_text(gl::expand_shader(path, defines, gl::shader_files()));
}

}  // namespace

Json packed(const LiveView& live) {
  PackedBytes corners, bytes;
  const std::vector<VertexIndex> order = pack_corners(live.mesh, corners);
  Json json;
  json["corners"] = order.size();
  json["facets"] = live.mesh.facets.size();
  json["bytes"] = pack_coordinates(live.mesh, order, bytes);
  bytes.append(corners);
  json["centre"] = point_json(live.centre);
  json["diagonal"] = live.diagonal;
  json["area"] = live.total_area;
  json["length_unit"] = live.length_unit;
  json["area_unit"] = live.area_unit;
  json["tau"] = live.method.tau_deg;
  json["lateral"] = live.lateral;
  json["thickness"] = live.method.edge_thickness;
  json["resolution"] = live.method.resolution;
  json["samples"] = k_live_samples;
  json["known"] = Json::array();
  for (const LiveDirection& known : live.known) {
    RegionValues areas = known.areas;
    for (const double sign : {1.0, -1.0}) {
      json["known"].push_back({{"direction", point_json(sign * known.direction)}, {"areas", areas.values}});
      std::swap(areas[Region::core], areas[Region::cavity]);
    }
  }
  json["errors"] = Json::array();
  for (const LiveError& error : live.errors)
    json["errors"].push_back({error.resolution, error.moving, error.resting});
  json["measured"] = live.measured;
  json["sphere"] = sphere_json(live.sphere);
  json["data"] = bytes.deflated_base64();
  return json;
}

std::string live_stage_html(const LiveView& live) {
  constexpr std::size_t k_most_numbered = 5;
  std::string html =
      "<div id=\"ball\" tabindex=\"0\" role=\"application\" hidden aria-label=\"Ball of parting directions: "
      "drag, or arrow keys\">";
  for (const int k : {0, 1, 2}) {
    glm::dvec3 axis(0.0);
    axis[k] = 1.0;
    html += fmt::format("<span class=\"axis\"{}>{}</span>", direction_html(axis), "xyz"[k]);
  }
  for (std::size_t k = 0; k < std::min(live.known.size(), k_most_numbered); ++k) {
    if (!live.known[k].verdict.empty())
      html += fmt::format("<span{}>{}</span>", direction_html(live.known[k].direction), k + 1);
  }
  return html + "</div>";
}

std::string live_controls_html(const LiveView& live) {
  std::string html =
      "<div class=\"direct\" hidden>\n<p id=\"standing\" role=\"status\"></p>\n"
      "<div class=\"goals\" role=\"group\" aria-label=\"Parting direction\">\n";
  const auto button = [&html](const glm::dvec3& direction, std::string_view look, const std::string& text) {
    html += fmt::format("<button type=\"button\"{}{}>{}</button>\n", look, direction_html(direction), text);
  };
  for (const char* axis : {"+x", "−x", "+y", "−y", "+z", "−z"}) {
    const std::string_view name(axis);
    glm::dvec3 direction(0.0);
    direction[name.back() - 'x'] = name.front() == '+' ? 1.0 : -1.0;
    button(direction, "", axis);
  }
  html +=
      "<label>direction <input id=\"direction\" spellcheck=\"false\" autocomplete=\"off\" "
      "aria-label=\"Direction: x, y, z\"></label>\n</div>\n";
  if (live.known.size() > 1 || !live.known.front().verdict.empty()) {
    html += "<div class=\"cards\">\n";
    for (std::size_t k = 0; k < live.known.size(); ++k) {
      const LiveDirection& known = live.known[k];
      if (known.verdict.empty()) continue;
      button(known.direction, " class=\"card\"",
             fmt::format("<b>{} · {}</b><span>{}</span>", k + 1, page::html_text(known.name),
                         page::html_text(known.verdict)));
    }
    html += "</div>\n";
  }
  std::string sizes;
  for (const LiveError& error : live.errors)
    sizes += fmt::format("<option{0}>{1}</option>",
                         error.resolution == live.method.resolution ? " selected" : "", error.resolution);
  html += fmt::format(
      "<details class=\"settings\"><summary>Shadow maps</summary><div class=\"controls\">\n"
      "<label><span>Near-vertical below <output id=\"tau-is\">{0}</output>°</span><input id=\"tau\" "
      "type=\"range\" min=\"0\" max=\"10\" step=\"0.1\" value=\"{0}\"></label>\n"
      "<label>PCF kernel<select id=\"kernel\"><option value=\"0\">lateral tolerance of the report</option>"
      "<option value=\"3\">3 texels</option><option value=\"5\">5 texels</option>"
      "<option value=\"7\">7 texels</option><option value=\"9\">9 texels</option></select></label>\n"
      "<label><span>Edge thickness <output id=\"thickness-is\">{1}</output> texels</span><input "
      "id=\"thickness\" type=\"range\" min=\"0\" max=\"8\" step=\"0.5\" value=\"{1}\"></label>\n"
      "<label>Map resolution<select id=\"resolution\">{2}</select></label>\n"
      "<label class=\"check\"><span><input id=\"bymaps\" type=\"checkbox\"> maps along the report's "
      "direction, too</span></label>\n</div></details>\n<p id=\"picked\" role=\"status\"></p>\n</div>\n",
      live.method.tau_deg, live.method.edge_thickness, sizes);
  return html;
}

Json page_shaders(bool live) {
  Json json;
  const auto add = [&json](const char* name, const char* vertex, const char* fragment,
                           const gl::Defines& defines = {}) {
    json[name] = {stage_text(vertex, defines), stage_text(fragment, defines)};
  };
  add("surface", "page/surface.vert", "page/surface.frag");
  add("line", "page/surface.vert", "page/line.frag");
  if (!live) return json;
  add("live_surface", "page/surface.vert", "page/surface.frag", {{"LIVE", ""}});
  add("facet_map", "maps/second_depth.vert", "maps/second_depth.frag");
  add("strip_map", "maps/contour_edge.vert", "maps/contour_edge.frag");
  add("samples", "common/fullscreen.vert", "measure/samples.frag", {{"WITH_DOUBT", ""}});
  add("ball", "page/ball.vert", "page/ball.frag");
  return json;
}

}  // namespace moldlight::report
