// Real parts along their axes and known pulls, and what the halves of each are like to a toolmaker.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "parting/loops.hpp"
#include "parting/mold_files.hpp"

namespace moldlight::test {

struct PartRows {
  std::filesystem::path path;
  std::vector<glm::dvec3> directions;  // three axes, and the known pull where it is none of them
  glm::dvec3 pull{0, 0, 1};            // known, or z
};

/// The shipped parts and, where they are found, the shared ones of up to so many facets: larger ones take as
/// long as all others.
[[nodiscard]] std::vector<PartRows> part_rows(std::size_t most_facets = 70000);
/// "part.stl along 0, 0, 1".
[[nodiscard]] std::string row_name(const PartRows& part, const glm::dvec3& direction);

/// Lengths as shares of the part's diagonal.
struct SteelRow {
  std::string name;
  std::string refusal;  // the rest is empty then
  double ms = 0.0;      // of the halves
  bool planar_line = false;
  double line_climb = 0.0;
  double rim = 0.0;           // how much the block's outer edge rises
  double surface_rise = 0.0;  // how much the surface around the part does
  double shelf_share = 0.0;
  std::size_t faces = 0;
  std::size_t narrow = 0;  // facets of halves narrower than a 2000th, beyond those of the part
  std::size_t crossed = 0;
  double contact = 0.0;  // area, as a share of the square
  double margin = 0.0;   // the most between the part's box and the block
};

[[nodiscard]] SteelRow steel_row(const PartModel& model, const glm::dvec3& direction,
                                 const std::string& name);

/// What the bars are about, in lines.
[[nodiscard]] std::string steel_summary(const std::vector<SteelRow>& rows);
[[nodiscard]] std::string steel_line(const SteelRow& row);

}  // namespace moldlight::test
