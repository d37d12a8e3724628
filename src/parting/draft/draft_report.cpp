#include "parting/draft/draft_report.hpp"

#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "classify/classify_report.hpp"
#include "classify/number_format.hpp"
#include "io/atomic_file.hpp"

namespace moldlight {

namespace {

using Json = nlohmann::ordered_json;

glm::dvec3 facet_centre(const PartModel& model, FacetIndex facet) {
  const auto& [a, b, c] = model.part.mesh.facets[facet];
  const auto& vertices = model.part.mesh.vertices;
  return (vertices[a] + vertices[b] + vertices[c]) / 3.0;
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

}  // namespace

Json draft_json(const PartModel& model, const DraftCheck& check) {
  Json below, bins = Json::array(), walls = Json::array();
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
            {"place", check.reverse.facet ? point_json(facet_centre(model, *check.reverse.facet)) : Json()}}},
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

}  // namespace moldlight
