// How the part is shown. Nothing here changes what it is classified as.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "mold/region.hpp"

namespace moldlight {

/// Which body of a mold: a half, what is left to a loose insert, or what an action moves, with a colour of
/// its own.
enum class Steel : std::uint8_t { core, cavity, insert, moved };
inline constexpr std::size_t k_steels = 3;  // of one colour each

enum class Theme : std::uint8_t { dark, light };
/// What the surface is coloured by; plain is for pictures that show no region, and nobody's choice.
enum class ColourMode : std::uint8_t { regions, draft_angle, plain };
/// What lies behind the part: the theme's gradient, one colour, or nothing (alpha 0).
enum class Backdrop : std::uint8_t { gradient, flat, none };

/// Where the regions come from: the computed ones of the split surface, or look-ups in the shadow maps. Where
/// a subject has but one of them, it is that.
enum class RegionsBy : std::uint8_t { exact, maps };

/// How a section plane lies: across the parting direction, along it, or across an axis of the part.
enum class Section : std::uint8_t { off, across, along, x, y, z };

/// What a user chooses to see of a part; classify/method_options.hpp has its table.
struct LookSettings {
  Palette palette = Palette::paper;
  ColourMode colour_mode = ColourMode::regions;
  double open_mold = 0.0;     // [0, 1]: how far core and cavity surface are moved apart along +-d
  double transparency = 0.0;  // of everything but the undercuts, [0, 1]
  Section section = Section::off;
  double section_at = 0.5;  // [0, 1] of the part's extent across the plane; what lies beyond is cut away
  double section_turn_deg = 0.0;  // [0, 360]: of a plane along d, about d
  bool hatching = true;           // stripes on undercuts
  bool feature_edges = true;      // edges sharper than the crease angle, and open ones
  bool facet_edges = false;
  bool near_vertical = false;               // level lines on facets that are neither up nor down
  bool parting_line = false;                // of exact regions
  bool arrows = true;                       // the parting arrows
  RegionsBy regions_by = RegionsBy::exact;  // of a direction at rest; one that moves has the maps' regions
  bool mark_difference = false;             // where shadow maps and exact regions differ

  bool operator==(const LookSettings&) const = default;
};

/// A mold that is open all the way: the halves have moved by this much of the part's diagonal each.
inline constexpr double k_mold_travel = 0.5;

/// A plane that cuts a part: what lies beyond `offset` along `normal` is cut away. Unit frame.
struct CutPlane {
  glm::dvec3 normal{0.0, 0.0, 1.0};  // unit
  double offset = 0.0;               // from the frame's origin
  double extent = 0.0;               // of the part along the normal
  glm::dvec3 foot{0.0};              // on the plane: where its arrow stands

  bool operator==(const CutPlane&) const = default;
};

/// How the steel of a mold is shown, where a picture has it: around the part, which then stays whole.
struct SteelLook {
  bool shown = false;
  bool clear = false;              // the part shows through
  double opened = 0.0;             // [0, 1], of k_mold_travel
  double first = 0.0, last = 0.0;  // [0, 1], of the ways of what moves before the halves, and after them
  std::uint64_t of = 0;            // another for every steel

  bool operator==(const SteelLook&) const = default;
};

/// All of it. What is changed here restarts the refinement of a picture at rest.
struct ViewSettings : LookSettings {
  Theme theme = Theme::dark;
  Backdrop backdrop = Backdrop::gradient;
  bool ambient_occlusion = true;
  double required_draft_deg = 1.0;  // for the scale of the draft colours
  std::optional<CutPlane> cut{};    // follows from the section
  bool cut_arrow = false;           // on the plane, for a hand to hold it by
  SteelLook steel{};
  double dimmed = 0.0;        // [0, 1]: how gray the colours of the part's surface are, beside what is lit
  double arrows_apart = 0.0;  // as an opened mold would move the arrows, where it is more than that
  // A picture of both kinds of regions: what is left of here, in pixels, has those of the maps, the rest the
  // exact ones, whatever `regions_by` says.
  std::optional<double> maps_left_of_px{};
  std::optional<double> ground{};  // of a studio, whose floor the part's soft shadow lies on: z, unit frame
  double pixel_scale = 1.0;        // widths of lines and hatches in units of a pixel
  int samples = 16;                // pictures at rest average this many shifted ones, [1, 64]

  /// By which core and cavity surface are moved, unit frame.
  [[nodiscard]] double travel() const { return open_mold * k_mold_travel; }
  bool operator==(const ViewSettings&) const = default;
};

/// What is marked on top of a finished picture; changing it costs next to nothing.
struct ViewMarks {
  // Faces, by the numbers that PartView::set_faces() has given them:
  std::optional<std::uint32_t> hovered = {};   // under the cursor
  std::optional<std::uint32_t> blocking = {};  // what is in the hovered point's way
  std::optional<std::uint32_t> chosen = {};
  double undercut_glow = 0.0;  // [0, 1]: for a pulse when an undercut appears
  // Something is lit: the rest of the part goes gray, all of it where no region is what is lit.
  bool others_gray = false;
  std::optional<Region> lit = {};

  bool operator==(const ViewMarks&) const = default;
};

/// sRGB in [0, 1].
[[nodiscard]] glm::vec3 screen_value(Colour colour);
/// The squares of that: what light adds up in.
[[nodiscard]] glm::vec3 light_value(Colour colour);

/// The backdrop's gradient; a flat one is `below`.
struct BackdropColours {
  Colour above, below;
};
[[nodiscard]] BackdropColours backdrop_colours(Theme theme);

/// Colours of the draft angle, from steep undersides to steep tops: band k lies between limits k - 1 and k
/// (in degrees, ascending); the middle band is what counts as near-vertical.
struct DraftScale {
  std::array<double, 6> limits_deg{};
  std::array<Colour, 7> colours{};
};
[[nodiscard]] DraftScale draft_scale(double required_deg, Palette palette);

/// Of a body of the mold: a paler sister of the colour of what it forms.
[[nodiscard]] Colour steel_colour(Steel steel, Palette palette);
/// The same of a body that is moved, which has a colour of its own.
[[nodiscard]] Colour moved_steel_colour(Colour own);

inline constexpr Colour k_plain_surface = {199, 203, 209};
inline constexpr Colour k_cut_surface = {176, 170, 160};
inline constexpr Colour k_hover_mark = {255, 255, 255};
inline constexpr Colour k_difference_mark = {202, 60, 255};
inline constexpr Colour k_tube = {255, 190, 40}, k_chosen_tube = {255, 246, 214};
inline constexpr Colour k_block_mark = {255, 204, 102};

}  // namespace moldlight
