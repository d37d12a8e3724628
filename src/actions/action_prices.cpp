#include "actions/action_prices.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/option.hpp"

namespace moldlight {

namespace {

constexpr double k_most_price = 1000.0;
constexpr std::string_view k_prices_what = "--prices";

void set_price(ActionPrices& prices, std::string_view name, double price) {
  Words names;
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind)
    names.push_back(facts(static_cast<ActionKind>(kind)).name);
  const auto kind = static_cast<std::size_t>(parse_word({name, k_prices_what}, names));
  if (!(price > 0.0 && price <= k_most_price))
    throw UsageError(fmt::format("{}: {} is {}; give a price greater than 0 and up to {}", k_prices_what,
                                 name, price, k_most_price));
  prices[kind] = price;
}

ActionPrices prices_of_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw FileError(path, "", "cannot be opened; --prices takes a JSON file");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) throw FileError(path, "", "is not a JSON object; write {\"lifter\": 2}");
  ActionPrices prices = default_prices();
  for (const auto& [name, price] : json.items()) {
    if (!price.is_number()) throw FileError(path, name, "is not a number");
    set_price(prices, name, price.get<double>());
  }
  return prices;
}

}  // namespace

ActionPrices default_prices() {
  ActionPrices prices{};
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind)
    prices[kind] = facts(static_cast<ActionKind>(kind)).weight;
  return prices;
}

std::string prices_text(const ActionPrices& prices) {
  const ActionPrices usual = default_prices();
  std::string text;
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind) {
    if (prices[kind] == usual[kind]) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", facts(static_cast<ActionKind>(kind)).name,
                        real_text(prices[kind]));
  }
  return text;
}

ActionPrices parse_prices(std::string_view text) {
  if (text.ends_with(".json")) return prices_of_file(std::string(text));
  ActionPrices prices = default_prices();
  while (!text.empty()) {
    const std::string_view one = text.substr(0, text.find(','));
    text.remove_prefix(std::min(one.size() + 1, text.size()));
    const std::size_t equals = one.find('=');
    if (equals == std::string_view::npos)
      throw UsageError(
          fmt::format("{}: {} has no price; write lifter=2 or name a JSON file", k_prices_what, one));
    set_price(prices, one.substr(0, equals), parse_real({one.substr(equals + 1), k_prices_what}));
  }
  return prices;
}

}  // namespace moldlight
