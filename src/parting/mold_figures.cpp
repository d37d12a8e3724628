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
    {"free", "Either could form", Kind::area, member<&Assignment::free_area>},
    {"reverse_draft", "Reverse draft", Kind::area, member<&Assignment::reverse_draft_area>,
     "leans back by less than --soft-draft", unless_nothing},
    {"height", "", Kind::length, member<&Assignment::height>},
    {"energy", "", Kind::number, member<&Assignment::energy>},
    {"energy_all_to_core", "", Kind::number, member<&Assignment::energy_to_core>},
    {"energy_all_to_cavity", "", Kind::number, member<&Assignment::energy_to_cavity>},
};

constexpr FigureRow<PartingLoop> k_loop_figures[] = {
    {"length", "length", Kind::length, member<&PartingLoop::length>},
    {"climb", "step height", Kind::length, member<&PartingLoop::climb>,
     "From its lowest point to its highest, along the direction."},
    {"flatness", "", Kind::length, member<&PartingLoop::flatness>},
    {"steep_length", "steps", Kind::length, member<&PartingLoop::steep_length>,
     "Length of line steeper than 64°. Steel slides on steel there and needs draft."},
    {"sharpest_deg", "", Kind::angle, member<&PartingLoop::sharpest_deg>},
    {"steepest_deg", "steepest", Kind::angle, member<&PartingLoop::steepest_deg>,
     "The greatest slope of its edges."},
    {"on_crease", "on edges", Kind::share, member<&PartingLoop::on_crease>,
     "Share of its length along edges of the part, where it does not show."},
    {"breaks", "breaks", Kind::count, member<&PartingLoop::breaks>,
     "Number of places where a side action replaces the other half."},
    {"low", "", Kind::length, member<&PartingLoop::low>},
    {"high", "", Kind::length, member<&PartingLoop::high>},
    {"up_and_down", "", Kind::length, member<&PartingLoop::up_and_down>},
    {"steep_draft_deg", "", Kind::angle, member<&PartingLoop::steep_draft_deg>},
    {"projected_area", "", Kind::area, member<&PartingLoop::area>},
    {"break_length", "", Kind::length, member<&PartingLoop::break_length>},
    {"smoothed/points", "", Kind::count, member<&PartingLoop::moved>},
    {"smoothed/length", "", Kind::length, member<&PartingLoop::smoothed_length>},
    {"smoothed/climb", "", Kind::length, member<&PartingLoop::smoothed_climb>},
};

template <MoldSide k_side>
Found borders(const EulerCheck& euler) {
  return euler.borders[static_cast<std::size_t>(k_side)];
}
template <MoldSide k_side>
Found handles(const EulerCheck& euler) {
  return euler.twice_handles(k_side) / 2;
}

constexpr FigureRow<EulerCheck> k_euler_figures[] = {
    {"part", "", Kind::count, member<&EulerCheck::part>},
    {"core", "", Kind::count, member<&EulerCheck::core>},
    {"cavity", "", Kind::count, member<&EulerCheck::cavity>},
    {"action", "", Kind::count, member<&EulerCheck::action>},
    {"touching", "", Kind::count, member<&EulerCheck::touching>},
    {"sums", "", Kind::flag, member<&EulerCheck::sums>},
    {"bodies", "", Kind::count, member<&EulerCheck::bodies>},
    {"core_pieces", "", Kind::count, member<&EulerCheck::core_pieces>},
    {"cavity_pieces", "", Kind::count, member<&EulerCheck::cavity_pieces>},
    {"action_pieces", "", Kind::count, member<&EulerCheck::action_pieces>},
    {"borders/core", "", Kind::count, borders<MoldSide::core>},
    {"borders/cavity", "", Kind::count, borders<MoldSide::cavity>},
    {"borders/action", "", Kind::count, borders<MoldSide::action>},
    {"handles/core", "", Kind::count, handles<MoldSide::core>},
    {"handles/cavity", "", Kind::count, handles<MoldSide::cavity>},
    {"handles/action", "", Kind::count, handles<MoldSide::action>},
    {"accounted", "", Kind::flag, member<&EulerCheck::accounted>},
    {"loops", "", Kind::count, member<&EulerCheck::loops>},
    {"expected_loops", "", Kind::count, member<&EulerCheck::expected_loops>},
    {"genus", "", Kind::count, member<&EulerCheck::genus>},
};

constexpr FigureRow<WrittenBody> k_written_figures[] = {
    {"volume", "", Kind::volume, member<&WrittenBody::volume>},
    {"closed", "", Kind::flag, member<&WrittenBody::closed>},
    {"crowded_edges", "", Kind::count, member<&WrittenBody::nonmanifold_edges>},
};

template <PieceKind k_kind>
Found number_of_pieces(const MoldHalves& halves) {
  const std::size_t count = halves.count(k_kind);
  return count > 0 ? Found(number_of(count)) : std::nullopt;
}
template <PieceKind k_kind>
Found volume_of(const MoldHalves& halves) {
  return halves.count(k_kind) > 0 ? Found(halves.volume(k_kind)) : std::nullopt;
}

constexpr FigureRow<MoldBody> k_half_figures[] = {
    {"crossed_facets", "", Kind::count, member<&MoldBody::crossed_facets>},
    {"needles", "", Kind::count, member<&MoldBody::needles>},
};

constexpr FigureRow<MoldHalves> k_halves_figures[] = {
    {"", "Core half", Kind::volume, member<&MoldHalves::core, &MoldBody::volume>},
    {"", "Cavity half", Kind::volume, member<&MoldHalves::cavity, &MoldBody::volume>},
    {"halves/part_volume", "Part", Kind::volume, member<&MoldHalves::part_volume>},
    {"halves/upright_volume", "Added to the part", Kind::volume, member<&MoldHalves::upright_volume>,
     "to set walls upright that are off by less than two lateral tolerances", details},
    {"halves/insert_volume", "", Kind::volume,
     [](const MoldHalves& h) -> Found { return h.volume(PieceKind::insert) + h.specks_volume; }},
    {"", "Inserts", Kind::volume, volume_of<PieceKind::insert>},
    {"", "Number of inserts", Kind::count, number_of_pieces<PieceKind::insert>},
    {"halves/slide_volume", "Slides", Kind::volume, volume_of<PieceKind::slide>},
    {"", "Number of slides", Kind::count, number_of_pieces<PieceKind::slide>},
    {"halves/lifter_volume", "Lifters", Kind::volume, volume_of<PieceKind::lifter>},
    {"", "Number of lifters", Kind::count, number_of_pieces<PieceKind::lifter>},
    {"volume_gap", "Volume check", Kind::gap, member<&MoldHalves::volume_gap>,
     "of the block, the difference of block, part and pieces", details},
    {"surfaces/parting", "Parting surface", Kind::area,
     member<&MoldHalves::surface, &SurfaceFigures::parting_area>},
    {"surface/shelf/share", "Parting surface in one plane", Kind::share,
     member<&MoldHalves::surface, &SurfaceFigures::shelf_share>},
    {"surface/shelf/height", "", Kind::length, member<&MoldHalves::surface, &SurfaceFigures::shelf_height>},
    {"surface/ramps", "", Kind::area, member<&MoldHalves::surface, &SurfaceFigures::ramp_area>},
    {"surface/land", "", Kind::length, member<&MoldHalves::land>},
    {"surface/rise", "Height of parting surface", Kind::length,
     [](const MoldHalves& h) -> Found { return h.surface.high - h.surface.low; }, "", unless_nothing},
    {"surface/rim_range", "Height of the block's edge", Kind::length,
     [](const MoldHalves& h) -> Found { return h.surface.rim_range(); }, "", unless_nothing},
    {"surface/faces", "", Kind::count, member<&MoldHalves::surface, &SurfaceFigures::faces>},
    {"surface/margin", "Steel beside the part", Kind::length, member<&MoldHalves::margin>},
    {"surfaces/shut_offs", "Shut-offs", Kind::area,
     member<&MoldHalves::surface, &SurfaceFigures::shut_off_area>, "", unless_nothing},
    {"surfaces/steepest_deg", "Steepest slope", Kind::angle,
     member<&MoldHalves::surface, &SurfaceFigures::steepest_deg>, "", unless_nothing},
    {"surfaces/too_steep", "Steeper than permitted", Kind::area,
     member<&MoldHalves::surface, &SurfaceFigures::too_steep_area>, "", unless_nothing},
    {"surfaces/contact", "Steel on steel without draft", Kind::area, member<&MoldHalves::contact_area>, "",
     unless_nothing},
    {"surfaces/contact_places", "Places of steel on steel", Kind::count,
     [](const MoldHalves& h) -> Found { return number_of(h.contacts.size()); }, "", unless_nothing},
    {"surfaces/contact_height", "Highest steel on steel", Kind::length,
     [](const MoldHalves& h) {
       return h.contacts.empty() ? std::nullopt
                                 : Found(std::ranges::max(h.contacts, {}, &ContactWall::height).height);
     }},
    {"surfaces/forced_deg", "", Kind::angle, member<&MoldHalves::forced_deg>},
    {"halves/scale", "", Kind::number, member<&MoldHalves::scale>},
    {"halves/block_volume", "", Kind::volume, member<&MoldHalves::block_volume>},
    {"halves/specks_volume", "Undercut too small for an insert", Kind::volume,
     member<&MoldHalves::specks_volume>, "", details},
};

}  // namespace

std::span<const FigureRow<Assignment>> assignment_figures() { return k_assignment_figures; }
std::span<const FigureRow<PartingLoop>> loop_figures() { return k_loop_figures; }
std::span<const FigureRow<EulerCheck>> euler_figures() { return k_euler_figures; }
std::span<const FigureRow<WrittenBody>> written_figures() { return k_written_figures; }
std::span<const FigureRow<MoldBody>> half_figures() { return k_half_figures; }
std::span<const FigureRow<MoldHalves>> halves_figures() { return k_halves_figures; }

}  // namespace moldlight
