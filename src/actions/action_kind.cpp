#include "actions/action_kind.hpp"

#include <array>

namespace moldlight {

namespace {

constexpr std::array<ActionFacts, k_action_kinds> k_facts = {{
    {"slide", "slide", "slides", 1.0},
    {"inclined", "inclined slide", "inclined slides", 1.3},
    {"lifter", "lifter", "lifters", 1.2},
    {"unscrew", "unscrewing core", "unscrewing cores", 2.5},
    {"strip", "stripped ring", "stripped rings", 0.1},
    {"insert", "loose insert", "loose inserts", 3.0},
}};

}  // namespace

const ActionFacts& facts(ActionKind kind) { return k_facts[static_cast<std::size_t>(kind)]; }

}  // namespace moldlight
