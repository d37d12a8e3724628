#include "parting/mold_figures.hpp"

#include <algorithm>

namespace moldlight {

namespace {

using Kind = FigureKind;
using enum FigureShown;
using Found = std::optional<double>;

double number_of(std::size_t count) { return static_cast<double>(count); }

constexpr FigureRow<Assignment> k_assignment_figures[] = {
    {"core", "", Kind::area, [](const Assignment& a) -> Found { return a.area(MoldSide::core); }},
    {"cavity", "", Kind::area, [](const Assignment& a) -> Found { return a.area(MoldSide::cavity); }},
    {"action", "", Kind::area, [](const Assignment& a) -> Found { return a.area(MoldSide::action); }},
    {"free", "Either could form", Kind::area, [](const Assignment& a) -> Found { return a.free_area; }},
    {"reverse_draft", "Reverse draft", Kind::area,
     [](const Assignment& a) -> Found { return a.reverse_draft_area; }, "less than the soft draft",
     unless_nothing},
    {"height", "", Kind::length, [](const Assignment& a) -> Found { return a.height; }},
    {"energy", "", Kind::number, [](const Assignment& a) -> Found { return a.energy; }},
    {"energy_all_to_core", "", Kind::number, [](const Assignment& a) -> Found { return a.energy_to_core; }},
    {"energy_all_to_cavity", "", Kind::number,
     [](const Assignment& a) -> Found { return a.energy_to_cavity; }},
};

constexpr FigureRow<PartingLoop> k_loop_figures[] = {
    {"length", "length", Kind::length, [](const PartingLoop& l) -> Found { return l.length; }},
    {"climb", "step height", Kind::length, [](const PartingLoop& l) -> Found { return l.climb(); },
     "From its lowest point to its highest, along the direction."},
    {"flatness", "", Kind::length, [](const PartingLoop& l) -> Found { return l.flatness; }},
    {"steep_length", "steps", Kind::length, [](const PartingLoop& l) -> Found { return l.steep_length; },
     "Length of the runs that climb by more than 64°: steel on steel, which wants draft."},
    {"sharpest_deg", "", Kind::angle, [](const PartingLoop& l) -> Found { return l.sharpest_deg; }},
    {"steepest_deg", "steepest", Kind::angle, [](const PartingLoop& l) -> Found { return l.steepest_deg; },
     "The greatest slope of its edges."},
    {"on_crease", "on edges", Kind::share, [](const PartingLoop& l) -> Found { return l.on_crease; },
     "Share of its length along edges of the part, where it does not show."},
    {"breaks", "breaks", Kind::count, [](const PartingLoop& l) -> Found { return number_of(l.breaks); },
     "How often a side action takes the place of the other half."},
    {"low", "", Kind::length, [](const PartingLoop& l) -> Found { return l.low; }},
    {"high", "", Kind::length, [](const PartingLoop& l) -> Found { return l.high; }},
    {"up_and_down", "", Kind::length, [](const PartingLoop& l) -> Found { return l.up_and_down; }},
    {"steep_draft_deg", "", Kind::angle, [](const PartingLoop& l) -> Found { return l.steep_draft_deg; }},
    {"projected_area", "", Kind::area, [](const PartingLoop& l) -> Found { return l.area; }},
    {"break_length", "", Kind::length, [](const PartingLoop& l) -> Found { return l.break_length; }},
    {"smoothed/points", "", Kind::count, [](const PartingLoop& l) -> Found { return number_of(l.moved); }},
    {"smoothed/length", "", Kind::length, [](const PartingLoop& l) -> Found { return l.smoothed_length; }},
    {"smoothed/climb", "", Kind::length, [](const PartingLoop& l) -> Found { return l.smoothed_climb; }},
};

constexpr FigureRow<MoldHalves> k_halves_figures[] = {
    {"", "Core half", Kind::volume, [](const MoldHalves& h) -> Found { return h.core.volume; }},
    {"", "Cavity half", Kind::volume, [](const MoldHalves& h) -> Found { return h.cavity.volume; }},
    {"halves/part_volume", "Part", Kind::volume, [](const MoldHalves& h) -> Found { return h.part_volume; }},
    {"halves/upright_volume", "Added to the part", Kind::volume,
     [](const MoldHalves& h) -> Found { return h.upright_volume; },
     "by setting walls upright that lean by the rounding of the file", details},
    {"halves/insert_volume", "", Kind::volume,
     [](const MoldHalves& h) -> Found { return h.insert_volume - h.slide_volume(); }},
    {"", "Inserts", Kind::volume,
     [](const MoldHalves& h) -> Found { return h.insert_volume - h.slide_volume() - h.specks_volume; }, "",
     unless_nothing},
    {"", "Number of inserts", Kind::count,
     [](const MoldHalves& h) -> Found { return number_of(h.inserts.size() - h.slide_count()); }, "",
     unless_nothing},
    {"halves/slide_volume", "Slides", Kind::volume,
     [](const MoldHalves& h) { return h.slide_count() > 0 ? Found(h.slide_volume()) : std::nullopt; }},
    {"", "Number of slides", Kind::count,
     [](const MoldHalves& h) {
       return h.slide_count() > 0 ? Found(number_of(h.slide_count())) : std::nullopt;
     }},
    {"volume_gap", "Block less part and pieces", Kind::gap,
     [](const MoldHalves& h) -> Found { return h.volume_gap; }, "of the block's volume", details},
    {"surfaces/parting", "Parting surface", Kind::area,
     [](const MoldHalves& h) -> Found { return h.surface.parting_area; }},
    {"surface/shelf/share", "of it in one plane", Kind::share,
     [](const MoldHalves& h) -> Found { return h.surface.shelf_share(); }},
    {"surface/shelf/height", "", Kind::length,
     [](const MoldHalves& h) -> Found { return h.surface.shelf_height; }},
    {"surface/ramps", "", Kind::area, [](const MoldHalves& h) -> Found { return h.surface.ramp_area; }},
    {"surface/land", "", Kind::length, [](const MoldHalves& h) -> Found { return h.land; }},
    {"surface/rise", "Height of parting surface", Kind::length,
     [](const MoldHalves& h) -> Found { return h.surface.high - h.surface.low; }},
    {"surface/rim_range", "Height of the block's edge", Kind::length,
     [](const MoldHalves& h) -> Found { return h.surface.rim_high - h.surface.rim_low; }, "", unless_nothing},
    {"surface/faces", "", Kind::count,
     [](const MoldHalves& h) -> Found { return number_of(h.surface.faces); }},
    {"surface/margin", "Steel beside the part", Kind::length,
     [](const MoldHalves& h) -> Found { return h.margin; }},
    {"surfaces/shut_offs", "Shut-offs", Kind::area,
     [](const MoldHalves& h) -> Found { return h.surface.shut_off_area; }, "", unless_nothing},
    {"surfaces/steepest_deg", "Steepest slope", Kind::angle,
     [](const MoldHalves& h) -> Found { return h.surface.steepest_deg; }, "", unless_nothing},
    {"surfaces/too_steep", "Steeper than --slope", Kind::area,
     [](const MoldHalves& h) -> Found { return h.surface.too_steep_area; }, "", unless_nothing},
    {"surfaces/contact", "Steel on steel without draft", Kind::area,
     [](const MoldHalves& h) -> Found { return h.contact_area; }, "", unless_nothing},
    {"surfaces/contact_places", "in places", Kind::count,
     [](const MoldHalves& h) -> Found { return number_of(h.contacts.size()); }, "", unless_nothing},
    {"surfaces/contact_height", "as high as", Kind::length,
     [](const MoldHalves& h) {
       return h.contacts.empty() ? std::nullopt
                                 : Found(std::ranges::max(h.contacts, {}, &ContactWall::height).height);
     }},
    {"surfaces/forced_deg", "", Kind::angle, [](const MoldHalves& h) -> Found { return h.forced_deg; }},
    {"halves/scale", "", Kind::number, [](const MoldHalves& h) -> Found { return h.scale; }},
    {"halves/block_volume", "", Kind::volume, [](const MoldHalves& h) -> Found { return h.block_volume; }},
    {"halves/specks_volume", "Undercut too small for an insert", Kind::volume,
     [](const MoldHalves& h) -> Found { return h.specks_volume; }, "", details},
};

}  // namespace

std::span<const FigureRow<Assignment>> assignment_figures() { return k_assignment_figures; }
std::span<const FigureRow<PartingLoop>> loop_figures() { return k_loop_figures; }
std::span<const FigureRow<MoldHalves>> halves_figures() { return k_halves_figures; }

}  // namespace moldlight
