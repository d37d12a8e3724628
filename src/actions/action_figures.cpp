#include "actions/action_figures.hpp"

namespace moldlight {

namespace {

using Kind = FigureKind;
using Found = std::optional<double>;

bool is_thread(const SideAction& action) { return action.kind == ActionKind::unscrew && action.about; }

constexpr FigureRow<SideAction> k_action_figures[] = {
    {"travel", "travel", Kind::length, [](const SideAction& a) -> Found { return a.travel; },
     "Travel of the action. A slide's travel includes the clearance."},
    {"stroke", "stroke", Kind::length, [](const SideAction& a) -> Found { return a.stroke; },
     "Stroke of the ejector."},
    {"area", "area", Kind::area, [](const SideAction& a) -> Found { return a.area; },
     "Undercut area that it releases."},
    {"pitch",
     {},
     Kind::length,
     [](const SideAction& a) { return is_thread(a) ? Found(a.about->pitch) : std::nullopt; }},
    {"turns",
     {},
     Kind::number,
     [](const SideAction& a) { return is_thread(a) ? Found(a.about->turns) : std::nullopt; }},
    {"strain",
     {},
     Kind::share,
     [](const SideAction& a) {
       return a.kind == ActionKind::strip && a.about ? Found(a.about->strain) : std::nullopt;
     }},
    {"clear_to", {}, Kind::length, [](const SideAction& a) -> Found { return a.clear_to; }},
    {"room_needed",
     {},
     Kind::length,
     [](const SideAction& a) { return a.kind == ActionKind::lifter ? Found(a.room_needed) : std::nullopt; }},
};

constexpr FigureRow<SideAction> k_body_figures[] = {
    {"body/volume", "body", Kind::volume,
     [](const SideAction& a) { return a.body ? Found(a.body->volume) : std::nullopt; },
     "Volume of the solid that moves."},
    {"body/least_section", "section", Kind::area,
     [](const SideAction& a) { return a.body ? Found(a.body->least_section) : std::nullopt; },
     "Largest cross-section of its thinnest piece."},
    {"core_pin/width",
     {},
     Kind::length,
     [](const SideAction& a) { return a.core_pin ? Found(a.core_pin->width) : std::nullopt; }},
    {"core_pin/length",
     {},
     Kind::length,
     [](const SideAction& a) { return a.core_pin ? Found(a.core_pin->length) : std::nullopt; }},
};

constexpr FigureRow<Undercut> k_undercut_sizes[] = {
    {"area", "area", Kind::area, [](const Undercut& u) -> Found { return u.area; }},
    {"size_across", "across", Kind::length, [](const Undercut& u) -> Found { return u.size_across; }},
    {"size_along", "along", Kind::length, [](const Undercut& u) -> Found { return u.size_along; }},
};

constexpr FigureRow<UndercutReport> k_undercut_figures[] = {
    {"formed_area", {}, Kind::area, [](const UndercutReport& u) -> Found { return u.formed_area; }},
    {"depth", "depth", Kind::length, [](const UndercutReport& u) -> Found { return u.depth; },
     "Distance across the parting direction to where the part no longer blocks it."},
};

}  // namespace

std::span<const FigureRow<SideAction>> action_figures() { return k_action_figures; }
std::span<const FigureRow<SideAction>> body_figures() { return k_body_figures; }
std::span<const FigureRow<Undercut>> undercut_sizes() { return k_undercut_sizes; }
std::span<const FigureRow<UndercutReport>> undercut_figures() { return k_undercut_figures; }

}  // namespace moldlight
