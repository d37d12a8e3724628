// Price of each kind of side action in the choice of the least set.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "actions/action_kind.hpp"

namespace moldlight {

/// By kind; a slide is 1. What a mold maker minds, no money.
using ActionPrices = std::array<double, k_action_kinds>;
[[nodiscard]] ActionPrices default_prices();

/// "lifter=2,insert=5": those that are not the default.
[[nodiscard]] std::string prices_text(const ActionPrices& prices);
/// Such text, or the name of a file, *.json, with an object such as {"lifter": 2, "insert": 5}; what is not
/// in it keeps its default. Throws UsageError for other kinds and for prices that are not within (0, 1000],
/// FileError for a file that cannot be read.
[[nodiscard]] ActionPrices parse_prices(std::string_view text);

}  // namespace moldlight
