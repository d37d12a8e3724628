#include "classify/method_options.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight {

std::span<const Option<MethodSettings>> method_options() {
  using S = MethodSettings;
  static const std::vector<Option<S>> k_options = {
      {"tau_deg", "--tau", "Near-vertical below", "deg",
       "Near-vertical tolerance (τ). A facet with less draft is tested along both directions.",
       RealKind<S>{&S::tau_deg, 0.0, 10.0, 0.1}},
      {"kernel", "--kernel", "Kernel", "texel",
       "Width of the PCF kernel for near-vertical facets in the shadow maps. The default is as wide as the "
       "lateral tolerance.",
       IntegerKind<S>{&S::kernel, 1, 9, true, 3}},
      {"couple_kernel", "--couple-kernel", "Lateral tolerance by the kernel", "",
       "Use the radius of --kernel as the lateral tolerance of the exact regions, too.",
       SwitchKind<S>{&S::couple_kernel}},
      {"tolerance", "--tolerance", "Lateral tolerance", "part's unit",
       "Lateral tolerance (δ): distance beside a near-vertical facet at which it is tested. The default is "
       "1/2048 of the part's diagonal.",
       PositiveKind<S>{[](S& s) -> double& { return s.tolerance; }}},
      {"kernel_shape", "--kernel-shape", "Kernel shape", "",
       "One-sided looks up on the outer side only. Symmetric is the paper's neighbourhood, in which one lit "
       "texel suffices.",
       choice<&S::kernel_shape>({"one-sided", "symmetric"})},
      {"edge_thickness", "--edge-thickness", "Edge thickness", "texel",
       "Width of the thick concave contour edges in the shadow maps. 0 leaves them out.",
       RealKind<S>{&S::edge_thickness, 0.0, 8.0, 0.5}},
      {"resolution", "--resolution", "Map resolution", k_texels_across,
       "Width and height of each shadow map.", IntegerKind<S>{&S::resolution, 64, 8192}},
      {"readout", "--readout", "Readout", "",
       "Exact computes the regions. Samples looks up surface samples in the shadow maps. Facet-id is the "
       "paper's two-pass readback, with one region per facet.",
       choice<&S::readout>({"exact", "samples", "facet-id"})},
      {"samples", "--samples", "Samples", "",
       "Number of surface samples for --readout samples and --compare-maps. Each facet gets at least four.",
       IntegerKind<S>{&S::samples, 1000, 100'000'000}},
      {"backend", "--backend", "Backend", "", "OpenGL backend without a window.",
       choice<&S::backend>({"auto", "egl", "osmesa"})},
  };
  return k_options;
}

std::span<const Option<ReadOptions>> reading_options() {
  using S = ReadOptions;
  static const std::string k_weld_help = fmt::format(
      "Largest distance between vertices that --repair joins. The default is {} of the part's diagonal.",
      rounded(k_weld_share));
  static const std::vector<Option<S>> k_options = {
      {"unit", "--unit", "Unit", "",
       "Unit of a file that states none; um, dm and ft are possible, too. Any other file is converted to it.",
       TextKind<S>{"UNIT",
                   [](const S& s) { return s.unit; },
                   [](S& s, std::string_view text) { s.unit = text; },
                   {"mm", "cm", "m", "in"}}},
      {"body", "--body", "Body", "",
       "Use only this body of the file, by its name or by its number in the list of moldlight info.",
       TextKind<S>{"N|NAME|all", [](const S& s) { return s.body; },
                   [](S& s, std::string_view text) { s.body = text; }}},
      {"repair", "--repair", "Repair", "",
       "Repair the mesh and report the changes. Weld joins vertices that nearly coincide. Full also drops "
       "duplicate and empty facets, corrects the winding and fills small holes. Union also makes one solid "
       "of bodies that overlap or touch.",
       ChoiceKind<S>{{"none", "weld", "full", "union"},
                     [](const S& s) { return static_cast<int>(s.repair.level); },
                     [](S& s, int level) { s.repair.level = static_cast<RepairLevel>(level); }}},
      {"weld_tolerance", "--weld-tolerance", "Weld tolerance", "part's unit", k_weld_help,
       PositiveKind<S>{[](S& s) -> double& { return s.repair.weld_tolerance; }}},
      {"linear_deflection", "--linear-deflection", "Linear deflection", "file's unit",
       "STEP: largest distance between facets and the CAD surface, in the file's unit. The default is 0.0005 "
       "of the part's diagonal.",
       PositiveKind<S>{[](S& s) -> double& { return s.linear_deflection; }}},
      {"angular_deflection_deg", "--angular-deflection", "Angular deflection", "deg",
       "STEP: largest angle between neighbouring chords.",
       PositiveKind<S>{[](S& s) -> double& { return s.angular_deflection_deg; }, 90.0}},
      {"max_facets", "--max-facets", "Most facets", "", "Refuse files with more facets than this.",
       IntegerKind<S>{&S::max_facets, 1, 1'400'000'000}},
      {"effort", "--effort", "Effort", "",
       "Limit of time and memory for exact regions, as a multiple of the usual one. Beyond it, facets that "
       "too many others cross are sampled, and the result states its error.",
       RealKind<S>{&S::effort, 1.0, 10'000.0, 1.0}},
  };
  return k_options;
}

double kernel_share(const MethodSettings& settings) {
  return 0.5 * (settings.kernel - 1) / settings.resolution;
}

double lateral_tolerance(const MethodSettings& settings, double diagonal) {
  constexpr double k_standard_share = 1.0 / 2048.0;
  if (settings.kernel > 0 && (settings.couple_kernel || settings.readout != Readout::exact))
    return kernel_share(settings) * diagonal;
  if (settings.tolerance > 0.0) return std::min(settings.tolerance, diagonal);
  return k_standard_share * diagonal;
}

void validate(const MethodSettings& settings) {
  if (settings.readout == Readout::facet_id && settings.kernel_shape == KernelShape::symmetric) {
    throw UsageError("--readout facet-id does not use the kernel: leave out --kernel-shape symmetric");
  }
}

void validate(const MethodSettings& settings, double diagonal) {
  validate(settings);
  if (settings.tolerance > 0.0) require_within_part("--tolerance", settings.tolerance, diagonal);
}

std::span<const Option<LookSettings>> look_options() {
  using S = LookSettings;
  static const std::vector<Option<S>> k_options = {
      {"palette", "--palette", "Palette", "",
       "Paper: core blue, cavity green, both grey, undercut red. Safe: for colour-blind eyes.",
       choice<&S::palette>({"paper", "safe"})},
      {"colouring", "--colouring", "Colour by", "", "Colour the surface by region or by draft angle.",
       choice<&S::colour_mode>({"regions", "draft"})},
      {"open_mold", "--open-mold", "Opened", k_half_diagonal,
       "Move the surfaces of core and cavity apart along the parting direction. Undercuts stay in place.",
       RealKind<S>{&S::open_mold, 0.0, 1.0, 0.01}},
      {"transparency", "--transparency", "Transparency", k_share,
       "Transparency of all surface but the undercuts, so that hidden undercuts show.",
       RealKind<S>{&S::transparency, 0.0, 0.95, 0.05}},
      {"section", "--section", "Section", "",
       "Cut the part by a plane: across the parting direction, along it, or across an axis of the part.",
       choice<&S::section>({"off", "across", "along", "x", "y", "z"})},
      {"section_at", "--section-at", "Section at", k_share,
       "Place of the section plane, from one end of the part to the other. The part beyond it is cut away.",
       RealKind<S>{&S::section_at, 0.0, 1.0, 0.01}},
      {"section_turn", "--section-turn", "Section turned", "deg",
       "Angle of a section plane along the parting direction, about this direction.",
       RealKind<S>{&S::section_turn_deg, 0.0, 360.0, 5.0}},
      {"hatching", "--hatching", "Hatching", "", "Hatch the undercuts, so that they show without colour.",
       SwitchKind<S>{&S::hatching}},
      {"feature_edges", "--feature-edges", "Feature edges", "", "Draw the sharp edges.",
       SwitchKind<S>{&S::feature_edges}},
      {"facet_edges", "--facet-edges", "Facet edges", "", "Draw the edges of all facets.",
       SwitchKind<S>{&S::facet_edges}},
      {"near_vertical", "--near-vertical", "Near-vertical", "",
       "Mark the near-vertical facets: those with less draft than --tau.", SwitchKind<S>{&S::near_vertical}},
      {"parting_line", "--parting-line", "Parting line", "",
       "Draw the borders between core, cavity and both.", SwitchKind<S>{&S::parting_line}},
      {"arrows", "--arrows", "Arrows", "", "Show the parting direction as an arrow through the part.",
       SwitchKind<S>{&S::arrows}},
      {"regions", "--regions", "Regions by", "",
       "Show the exact regions of a direction at rest, or the regions of the shadow maps.",
       choice<&S::regions_by>({"exact", "maps"})},
      {"mark_difference", "--mark-difference", "Mark the difference", "",
       "Hatch the surface where the shadow maps and the exact regions differ.",
       SwitchKind<S>{&S::mark_difference}},
  };
  return k_options;
}

}  // namespace moldlight
