#include "classify/look_options.hpp"

namespace moldlight {

std::span<const Option<LookSettings>> look_options() {
  using S = LookSettings;
  static const std::vector<Option<S>> k_options = {
      {"palette", "--palette", "Palette", "",
       "Paper: core blue, cavity green, both gray, undercut red. Safe: for colour-blind eyes.",
       choice<&S::palette>({"paper", "safe"})},
      {"colouring", "--colouring", "Colour by", "", "Colour the surface by region or by draft angle.",
       choice<&S::colour_mode>({"regions", "draft"})},
      {"open_mold", "--open-mold", "Open the mold", k_half_diagonal,
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
