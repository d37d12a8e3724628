#include "parting/mold_figures.hpp"

#include <algorithm>

namespace moldlight {

namespace {

using Kind = FigureKind;
using Found = std::optional<double>;

double number_of(std::size_t count) { return static_cast<double>(count); }

constexpr FigureRow<Assignment> k_assignment_figures[] = {
    {"core", {}, Kind::area, [](const Assignment& a) -> Found { return a.area(MoldSide::core); }},
    {"cavity", {}, Kind::area, [](const Assignment& a) -> Found { return a.area(MoldSide::cavity); }},
    {"action", {}, Kind::area, [](const Assignment& a) -> Found { return a.area(MoldSide::action); }},
    {"free", "Either could form", Kind::area, [](const Assignment& a) -> Found { return a.free_area; }},
    {"reverse_draft", "Leans against its half", Kind::area,
     [](const Assignment& a) -> Found { return a.reverse_draft_area; }, "by less than the soft draft"},
    {"height", {}, Kind::length, [](const Assignment& a) -> Found { return a.height; }},
    {"energy", {}, Kind::number, [](const Assignment& a) -> Found { return a.energy; }},
    {"energy_all_to_core", {}, Kind::number, [](const Assignment& a) -> Found { return a.energy_to_core; }},
    {"energy_all_to_cavity",
     {},
     Kind::number,
     [](const Assignment& a) -> Found { return a.energy_to_cavity; }},
};

constexpr FigureRow<PartingLoop> k_loop_figures[] = {
    {"length", "length", Kind::length, [](const PartingLoop& l) -> Found { return l.length; }},
    {"climb", "step height", Kind::length, [](const PartingLoop& l) -> Found { return l.climb(); },
     "From its lowest point to its highest, along the direction."},
    {"flatness", "flat to", Kind::length, [](const PartingLoop& l) -> Found { return l.flatness; },
     "How far it is from its best plane."},
    {"steep_length", "steep", Kind::length, [](const PartingLoop& l) -> Found { return l.steep_length; },
     "Length of the runs that climb by more than 64°: steel on steel, which wants draft."},
    {"sharpest_deg", "sharpest", Kind::angle, [](const PartingLoop& l) -> Found { return l.sharpest_deg; },
     "The least angle between neighbouring edges."},
    {"on_crease", "on crease", Kind::share, [](const PartingLoop& l) -> Found { return l.on_crease; },
     "Share of its length along edges of the part, where it does not show."},
    {"breaks", "breaks", Kind::count, [](const PartingLoop& l) -> Found { return number_of(l.breaks); },
     "How often a side action takes the place of the other half."},
    {"low", {}, Kind::length, [](const PartingLoop& l) -> Found { return l.low; }},
    {"high", {}, Kind::length, [](const PartingLoop& l) -> Found { return l.high; }},
    {"up_and_down", {}, Kind::length, [](const PartingLoop& l) -> Found { return l.up_and_down; }},
    {"steep_draft_deg", {}, Kind::angle, [](const PartingLoop& l) -> Found { return l.steep_draft_deg; }},
    {"steepest_deg", {}, Kind::angle, [](const PartingLoop& l) -> Found { return l.steepest_deg; }},
    {"projected_area", {}, Kind::area, [](const PartingLoop& l) -> Found { return l.area; }},
    {"break_length", {}, Kind::length, [](const PartingLoop& l) -> Found { return l.break_length; }},
    {"smoothed/points", {}, Kind::count, [](const PartingLoop& l) -> Found { return number_of(l.moved); }},
    {"smoothed/length", {}, Kind::length, [](const PartingLoop& l) -> Found { return l.smoothed_length; }},
    {"smoothed/climb", {}, Kind::length, [](const PartingLoop& l) -> Found { return l.smoothed_climb; }},
};

constexpr FigureRow<MoldHalves> k_halves_figures[] = {
    {{}, "Core half", Kind::volume, [](const MoldHalves& h) -> Found { return h.core.volume; }},
    {{}, "Cavity half", Kind::volume, [](const MoldHalves& h) -> Found { return h.cavity.volume; }},
    {"halves/part_volume", "Part", Kind::volume, [](const MoldHalves& h) -> Found { return h.part_volume; }},
    {"halves/upright_volume", "Upright walls add", Kind::volume,
     [](const MoldHalves& h) -> Found { return h.upright_volume; },
     "to the part: the walls leaned by the rounding of its file."},
    {"halves/insert_volume", "Left to inserts", Kind::volume,
     [](const MoldHalves& h) -> Found { return h.insert_volume - h.slide_volume(); }},
    {{},
     "Inserts",
     Kind::count,
     [](const MoldHalves& h) -> Found { return number_of(h.inserts.size() - h.slide_count()); }},
    {"halves/slide_volume", "Left to slides", Kind::volume,
     [](const MoldHalves& h) { return h.slide_count() > 0 ? Found(h.slide_volume()) : std::nullopt; }},
    {{},
     "Slides",
     Kind::count,
     [](const MoldHalves& h) {
       return h.slide_count() > 0 ? Found(number_of(h.slide_count())) : std::nullopt;
     }},
    {"volume_gap", "Volumes differ", Kind::gap, [](const MoldHalves& h) -> Found { return h.volume_gap; },
     "of the block, less halves, part and inserts"},
    {"surfaces/parting", "Parting surface", Kind::area,
     [](const MoldHalves& h) -> Found { return h.surface.parting_area; }},
    {"surface/shelf/share", "of it in one plane", Kind::share,
     [](const MoldHalves& h) -> Found { return h.surface.shelf_share(); },
     "The shelf: the plane across the direction that has most of the surface around the part."},
    {"surface/shelf/height",
     {},
     Kind::length,
     [](const MoldHalves& h) -> Found { return h.surface.shelf_height; }},
    {"surface/ramps", {}, Kind::area, [](const MoldHalves& h) -> Found { return h.surface.ramp_area; }},
    {"surface/land", {}, Kind::length, [](const MoldHalves& h) -> Found { return h.land; }},
    {"surface/rise", "Parting surface rises by", Kind::length,
     [](const MoldHalves& h) -> Found { return h.surface.high - h.surface.low; }},
    {"surface/rim_range", "The block's edge rises by", Kind::length,
     [](const MoldHalves& h) -> Found { return h.surface.rim_high - h.surface.rim_low; }},
    {"surface/faces",
     {},
     Kind::count,
     [](const MoldHalves& h) -> Found { return number_of(h.surface.faces); }},
    {"surface/margin", "Steel beside the part", Kind::length,
     [](const MoldHalves& h) -> Found { return h.margin; }},
    {"surfaces/shut_offs", "Shut-offs", Kind::area,
     [](const MoldHalves& h) -> Found { return h.surface.shut_off_area; }},
    {"surfaces/steepest_deg", "Steepest", Kind::angle,
     [](const MoldHalves& h) -> Found { return h.surface.steepest_deg; }},
    {"surfaces/too_steep", "Too steep", Kind::area,
     [](const MoldHalves& h) -> Found { return h.surface.too_steep_area; }, "steeper than --slope"},
    {"surfaces/contact", "Steel on steel without draft", Kind::area,
     [](const MoldHalves& h) -> Found { return h.contact_area; }},
    {"surfaces/contact_places", "Contacts", Kind::count,
     [](const MoldHalves& h) -> Found { return number_of(h.contacts.size()); }},
    {"surfaces/contact_height", "Highest contact", Kind::length,
     [](const MoldHalves& h) {
       return h.contacts.empty() ? std::nullopt
                                 : Found(std::ranges::max(h.contacts, {}, &ContactWall::height).height);
     }},
    {"surfaces/forced_deg", {}, Kind::angle, [](const MoldHalves& h) -> Found { return h.forced_deg; }},
    {"halves/scale", {}, Kind::number, [](const MoldHalves& h) -> Found { return h.scale; }},
    {"halves/block_volume", {}, Kind::volume, [](const MoldHalves& h) -> Found { return h.block_volume; }},
    {"halves/specks_volume", {}, Kind::volume, [](const MoldHalves& h) -> Found { return h.specks_volume; }},
};

}  // namespace

std::span<const FigureRow<Assignment>> assignment_figures() { return k_assignment_figures; }
std::span<const FigureRow<PartingLoop>> loop_figures() { return k_loop_figures; }
std::span<const FigureRow<MoldHalves>> halves_figures() { return k_halves_figures; }

}  // namespace moldlight
