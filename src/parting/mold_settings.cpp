#include "parting/mold_settings.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

namespace {

constexpr double k_margin_share = 0.15;  // of the part's diagonal
constexpr double k_land_share = 0.02;
constexpr double k_most_margin = 100.0;  // diagonals: points of a wider plane would have too few digits

/// "core:1,2".
CosmeticFaces parse_half(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view half = text.substr(0, colon);
  if (colon == std::string_view::npos || (half != "core" && half != "cavity"))
    throw UsageError(fmt::format("--cosmetic: '{}' is not core:FACES or cavity:FACES", text));
  return {.core = half == "core", .faces = parse_faces(text.substr(colon + 1))};
}

}  // namespace

std::span<const Option<MoldSettings>> mold_options() {
  using S = MoldSettings;
  static const std::vector<Option<S>> k_options = {
      {"soft_deg", "--soft-draft", "Soft draft", "deg",
       "Either half may form walls with less draft than this. Reverse draft costs extra.",
       RealKind<S>{&S::soft_deg, 0.0, 10.0, 0.5}},
      {"parting_height", "--parting-height", "Parting height", "part's unit",
       "Height along the direction at which the halves meet, in the part's coordinates. By default it "
       "follows the part's horizontal edges.",
       TextKind<S>{
           .name = "H",
           .get = [](const S& s) { return s.parting_height ? real_text(*s.parting_height) : std::string(); },
           .set =
               [](S& s, std::string_view text) {
                 s.parting_height =
                     text.empty() ? std::nullopt : std::optional(parse_real({text, "--parting-height"}));
               }}},
      {"planar_worth_pct", "--planar-worth", "Worth of a plane", "%",
       "The parting line runs in one plane where the part's outer walls let it, if that costs no more than "
       "this share of the part's diagonal. The cost is length of line; climbs count four times, edges half.",
       RealKind<S>{&S::planar_worth_pct, 0.0, 1000.0, 10.0}},
      {"cosmetic", "--cosmetic", "Cosmetic faces", "",
       "Faces that the core or the cavity must form, by the numbers that classify --faces writes. Separate "
       "the halves by a slash: core:1,2/cavity:3.",
       TextKind<S>{.name = "core|cavity:FACES",
                   .get = [](const S& s) { return s.cosmetic; },
                   .set =
                       [](S& s, std::string_view text) {
                         static_cast<void>(parse_cosmetic(text));
                         s.cosmetic = text;
                       }}},
      {"margin", "--margin", "Margin", "part's unit",
       "Least steel around the part, on all sides. The default is 15 % of the part's diagonal. It grows "
       "until the block's edge is flat.",
       PositiveKind<S>{[](S& s) -> double& { return s.margin; }}},
      {"shrink_pct", "--shrink", "Shrinkage", "%",
       "Shrinkage of the molded part. The mold is larger by the factor 1 / (1 - shrinkage).",
       RealKind<S>{&S::shrink_pct, 0.0, 20.0, 0.1}},
      {"ramp_deg", "--ramp", "Ramp", "deg",
       "Slope of the ramps between the parting surface's shelf and a parting line above or below it.",
       RealKind<S>{&S::ramp_deg, 15.0, 80.0, 5.0}},
      {"land", "--land", "Land", "part's unit",
       "Width of the level land between the parting line and a ramp. The default is 2 % of the part's "
       "diagonal.",
       PositiveKind<S>{[](S& s) -> double& { return s.land; }}},
      {"slope_deg", "--slope", "Slope", "deg",
       "Steepest parting surface where the part's outline is steeper than a ramp.",
       RealKind<S>{&S::slope_deg, 15.0, 85.0, 5.0}},
      {"fill_undercut", "--fill-undercut", "Fill undercuts", "",
       "Leave the surface that the halves cannot form to loose inserts.", SwitchKind<S>{&S::fill_undercut}},
      {"registration", "--registration", "Registration", "",
       "Add cones to the block's corners that align the halves. One is smaller, so that the halves fit one "
       "way only.",
       SwitchKind<S>{&S::registration}},
  };
  return k_options;
}

std::vector<std::uint32_t> parse_faces(std::string_view text) {
  for (std::vector<std::uint32_t> faces;;) {
    const std::size_t comma = text.find(',');
    const auto face = number_from<std::uint32_t>(text.substr(0, comma));
    if (!face) throw UsageError(fmt::format("--cosmetic: '{}' is not a face number", text.substr(0, comma)));
    faces.push_back(*face);
    if (comma == std::string_view::npos) return faces;
    text.remove_prefix(comma + 1);
  }
}

void check_face(std::uint32_t face, const Faces& faces) {
  if (face >= faces.count())
    throw UsageError(
        fmt::format("--cosmetic: there is no face {}; the part has 0 to {}", face, faces.count() - 1));
}

std::vector<CosmeticFaces> parse_cosmetic(std::string_view text) {
  std::vector<CosmeticFaces> cosmetic;
  while (!text.empty()) {
    const std::size_t end = text.find('/');
    cosmetic.push_back(parse_half(text.substr(0, end)));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return cosmetic;
}

std::vector<std::uint32_t> cosmetic_faces(std::string_view text, bool core) {
  std::vector<std::uint32_t> faces;
  for (const CosmeticFaces& half : parse_cosmetic(text)) {
    if (half.core == core) faces.insert(faces.end(), half.faces.begin(), half.faces.end());
  }
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::string cosmetic_with(std::string_view text, std::uint32_t face, std::optional<bool> core) {
  std::string with;
  for (const bool half : {true, false}) {
    std::vector<std::uint32_t> faces = cosmetic_faces(text, half);
    std::erase(faces, face);
    if (core == half) faces.insert(std::ranges::lower_bound(faces, face), face);
    if (!faces.empty())
      with +=
          fmt::format("{}{}:{}", with.empty() ? "" : "/", half ? "core" : "cavity", fmt::join(faces, ","));
  }
  return with;
}

void validate(const MoldSettings& settings, double diagonal) {
  if (settings.margin > k_most_margin * diagonal)
    throw UsageError(
        fmt::format("--margin: {:g} is more than {:g} times the part, {:g} from corner to corner",
                    settings.margin, k_most_margin, diagonal));
}

double land_width(const MoldSettings& settings, double diagonal) {
  return settings.land > 0.0 ? settings.land : k_land_share * diagonal;
}

double block_margin(const MoldSettings& settings, double diagonal) {
  return settings.margin > 0.0 ? settings.margin : k_margin_share * diagonal;
}

std::vector<FacetWish> assigned_facets(const PartModel& model, const MoldSettings& settings) {
  std::vector<FacetWish> assigned(model.part.mesh.facets.size(), FacetWish::none);
  if (settings.cosmetic.empty()) return assigned;
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  for (const CosmeticFaces& half : parse_cosmetic(settings.cosmetic)) {
    for (const std::uint32_t face : half.faces) {
      check_face(face, faces);
      for (const FacetIndex facet : faces.facets(face))
        assigned[facet] = half.core ? FacetWish::core : FacetWish::cavity;
    }
  }
  return assigned;
}

}  // namespace moldlight
