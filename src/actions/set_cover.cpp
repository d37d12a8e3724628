#include "actions/set_cover.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "base/check.hpp"

namespace moldlight {

namespace {

/// A relative saving below this is rounding.
constexpr double k_saving = 1e-12;

class Search {
 public:
  Search(std::size_t undercut_parts, std::span<const CoverOption> options,
         std::span<const CoverClash> clashes, std::size_t most_nodes, const Progress& progress)
      : options_(options),
        most_nodes_(most_nodes),
        progress_(progress),
        options_of_part_(undercut_parts),
        prices_(options.size()),
        covered_(undercut_parts, 0),
        allowed_(options.size(), 1),
        price_(options.size(), 0.0),
        touched_(options.size(), 0) {
    for (std::size_t c = 0; c < options.size(); ++c) {
      CHECK(options[c].cost > 0.0);
      for (const std::size_t undercut_part : options[c].undercut_parts)
        options_of_part_[undercut_part].push_back(c);
    }
    std::vector<std::map<std::size_t, double>> prices(options.size());
    for (const CoverClash& clash : clashes) {
      CHECK(clash.a != clash.b && clash.price >= 0.0);
      prices[clash.a][clash.b] += clash.price;
      prices[clash.b][clash.a] += clash.price;
    }
    for (std::size_t c = 0; c < prices.size(); ++c) prices_[c].assign(prices[c].begin(), prices[c].end());
    drop_dominated();
  }

  Cover run() {
    Cover cover;
    for (std::size_t undercut_part = 0; undercut_part < options_of_part_.size(); ++undercut_part) {
      if (!options_of_part_[undercut_part].empty()) continue;
      cover.uncovered.push_back(undercut_part);
      covered_[undercut_part] = 1;
    }
    branch(0.0);
    cover.options = best_;
    std::ranges::sort(cover.options);
    cover.cost = best_.empty() ? 0.0 : best_cost_;
    cover.optimal = nodes_ <= most_nodes_;
    return cover;
  }

 private:
  using Price = std::pair<std::size_t, double>;  // of a clash, after the other option

  void drop_dominated() {
    std::vector<std::vector<std::size_t>> sorted;
    for (const CoverOption& option : options_) {
      sorted.push_back(option.undercut_parts);
      std::ranges::sort(sorted.back());
    }
    // In place of `a`, whatever else is chosen.
    const auto serves = [&](std::size_t b, std::size_t a) {
      return options_[b].cost <= options_[a].cost && std::ranges::includes(sorted[b], sorted[a]) &&
             clashes_no_more(b, a);
    };
    for (std::size_t a = 0; a < options_.size(); ++a) {
      if (progress_.cancelled()) throw Cancelled();
      for (std::size_t b = 0; b < options_.size() && allowed_[a] != 0; ++b) {
        if (a == b || allowed_[b] == 0 || !serves(b, a)) continue;
        if (b < a || !serves(a, b)) allowed_[a] = 0;
      }
    }
    for (auto& having : options_of_part_)
      std::erase_if(having, [&](std::size_t c) { return allowed_[c] == 0; });
  }

  [[nodiscard]] bool clashes_no_more(std::size_t one, std::size_t than) const {
    return std::ranges::all_of(prices_[one], [&](const auto& clash) {
      const auto same = std::ranges::lower_bound(prices_[than], clash.first, {}, &Price::first);
      return clash.first == than ||
             (same != prices_[than].end() && same->first == clash.first && same->second >= clash.second);
    });
  }

  /// Whether what the open undercut parts need at least, beside the cost so far, saves nothing: of undercut
  /// parts that share no option each needs one of its own.
  [[nodiscard]] bool is_hopeless(double cost) {
    const double most = best_cost_ * (1.0 - k_saving);
    double least = 0.0;
    ++round_;
    for (std::size_t undercut_part = 0; undercut_part < options_of_part_.size(); ++undercut_part) {
      if (covered_[undercut_part] > 0) continue;
      const auto& having = options_of_part_[undercut_part];
      if (std::ranges::any_of(having, [&](std::size_t c) { return touched_[c] == round_; })) continue;
      double cheapest = std::numeric_limits<double>::infinity();
      for (const std::size_t c : having) {
        cheapest = std::min(cheapest, cost_now(c));
        touched_[c] = round_;
      }
      least += cheapest;
      if (cost + least >= most) return true;
    }
    return cost >= most;
  }

  /// With the prices of its clashes with what is chosen.
  [[nodiscard]] double cost_now(std::size_t option) const { return options_[option].cost + price_[option]; }

  void choose(std::size_t option) {
    chosen_.push_back(option);
    for (const std::size_t undercut_part : options_[option].undercut_parts) ++covered_[undercut_part];
    for (const auto& [other, price] : prices_[option]) {
      former_.push_back(price_[other]);
      price_[other] += price;
    }
  }
  void take_back() {
    const std::size_t option = chosen_.back();
    chosen_.pop_back();
    for (const std::size_t undercut_part : options_[option].undercut_parts) --covered_[undercut_part];
    // Sums that are taken apart again would keep rounding.
    for (auto other = prices_[option].rbegin(); other != prices_[option].rend(); ++other) {
      price_[other->first] = former_.back();
      former_.pop_back();
    }
  }

  void branch(double cost) {
    if (progress_.cancelled()) throw Cancelled();
    if (++nodes_ > most_nodes_ && !best_.empty()) return;
    std::size_t rarest = options_of_part_.size(), fewest = std::numeric_limits<std::size_t>::max();
    for (std::size_t undercut_part = 0; undercut_part < options_of_part_.size(); ++undercut_part) {
      if (covered_[undercut_part] > 0 || options_of_part_[undercut_part].size() >= fewest) continue;
      rarest = undercut_part;
      fewest = options_of_part_[undercut_part].size();
    }
    if (rarest == options_of_part_.size()) {
      if (cost < best_cost_ * (1.0 - k_saving)) {
        best_cost_ = cost;
        best_ = chosen_;
      }
      return;
    }
    if (is_hopeless(cost)) return;
    // Those that cover most for their cost first: a good cover is found soon.
    std::vector<std::pair<double, std::size_t>> order;
    const auto worth = [&](std::size_t c) {
      const auto open = std::ranges::count_if(options_[c].undercut_parts, [&](std::size_t undercut_part) {
        return covered_[undercut_part] == 0;
      });
      return static_cast<double>(open) / cost_now(c);
    };
    for (const std::size_t c : options_of_part_[rarest]) order.emplace_back(worth(c), c);
    std::ranges::stable_sort(order, std::greater(), &std::pair<double, std::size_t>::first);
    for (const auto& [value, c] : order) {
      const double more = cost_now(c);
      choose(c);
      branch(cost + more);
      take_back();
    }
  }

  std::span<const CoverOption> options_;
  std::size_t most_nodes_;
  const Progress& progress_;
  std::vector<std::vector<std::size_t>> options_of_part_;  // options of each undercut part
  std::vector<std::vector<Price>> prices_;                 // of each option's clashes
  std::vector<int> covered_;                               // how often each undercut part is
  std::vector<char> allowed_;
  std::vector<double> price_;         // of each option, of its clashes with what is chosen
  std::vector<double> former_;        // prices, before what is chosen was
  std::vector<std::size_t> touched_;  // options that is_hopeless() came past, the last time
  std::size_t round_ = 0;             // of is_hopeless()
  std::vector<std::size_t> chosen_, best_;
  double best_cost_ = std::numeric_limits<double>::infinity();
  std::size_t nodes_ = 0;
};

}  // namespace

Cover least_cover(std::size_t undercut_parts, std::span<const CoverOption> options,
                  std::span<const CoverClash> clashes, std::size_t most_nodes, const Progress& progress) {
  return Search(undercut_parts, options, clashes, most_nodes, progress).run();
}

}  // namespace moldlight
