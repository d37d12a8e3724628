#include "actions/set_cover.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "base/check.hpp"

namespace moldlight {

namespace {

/// A relative saving below this is rounding.
constexpr double k_saving = 1e-12;

class Search {
 public:
  Search(std::size_t atoms, std::span<const CoverColumn> columns, std::span<const CoverClash> clashes,
         std::size_t most_nodes, const Progress& progress)
      : columns_(columns),
        most_nodes_(most_nodes),
        progress_(progress),
        having_(atoms),
        prices_(columns.size()),
        covered_(atoms, 0),
        allowed_(columns.size(), 1),
        price_(columns.size(), 0.0) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      CHECK(columns[c].cost > 0.0);
      for (const std::size_t atom : columns[c].atoms) having_[atom].push_back(c);
    }
    for (const CoverClash& clash : clashes) {
      CHECK(clash.a != clash.b && clash.price >= 0.0);
      prices_[clash.a][clash.b] += clash.price;
      prices_[clash.b][clash.a] += clash.price;
    }
    drop_dominated();
  }

  Cover run() {
    Cover cover;
    for (std::size_t atom = 0; atom < having_.size(); ++atom) {
      if (!having_[atom].empty()) continue;
      cover.uncovered.push_back(atom);
      covered_[atom] = 1;
    }
    branch(0.0);
    cover.columns = best_;
    std::ranges::sort(cover.columns);
    cover.cost = best_.empty() ? 0.0 : best_cost_;
    cover.optimal = nodes_ <= most_nodes_;
    return cover;
  }

 private:
  void drop_dominated() {
    std::vector<std::vector<std::size_t>> sorted;
    for (const CoverColumn& column : columns_) {
      sorted.push_back(column.atoms);
      std::ranges::sort(sorted.back());
    }
    // In place of `a`, whatever else is chosen.
    const auto serves = [&](std::size_t b, std::size_t a) {
      return columns_[b].cost <= columns_[a].cost && std::ranges::includes(sorted[b], sorted[a]) &&
             clashes_no_more(b, a);
    };
    for (std::size_t a = 0; a < columns_.size(); ++a) {
      if (progress_.cancelled()) throw Cancelled();
      for (std::size_t b = 0; b < columns_.size() && allowed_[a] != 0; ++b) {
        if (a == b || allowed_[b] == 0 || !serves(b, a)) continue;
        if (b < a || !serves(a, b)) allowed_[a] = 0;
      }
    }
    for (auto& having : having_) std::erase_if(having, [&](std::size_t c) { return allowed_[c] == 0; });
  }

  [[nodiscard]] bool clashes_no_more(std::size_t one, std::size_t than) const {
    return std::ranges::all_of(prices_[one], [&](const auto& clash) {
      const auto same = prices_[than].find(clash.first);
      return clash.first == than || (same != prices_[than].end() && same->second >= clash.second);
    });
  }

  /// Cost that the open atoms need at least: of atoms that share no column each needs one of its own.
  [[nodiscard]] double bound() const {
    double least = 0.0;
    std::vector<char> touched(columns_.size(), 0);
    for (std::size_t atom = 0; atom < having_.size(); ++atom) {
      if (covered_[atom] > 0) continue;
      const auto& having = having_[atom];
      if (std::ranges::any_of(having, [&](std::size_t c) { return touched[c] != 0; })) continue;
      double cheapest = std::numeric_limits<double>::infinity();
      for (const std::size_t c : having) {
        cheapest = std::min(cheapest, cost_now(c));
        touched[c] = 1;
      }
      least += cheapest;
    }
    return least;
  }

  /// With the prices of its clashes with what is chosen.
  [[nodiscard]] double cost_now(std::size_t column) const { return columns_[column].cost + price_[column]; }

  void choose(std::size_t column) {
    chosen_.push_back(column);
    for (const std::size_t atom : columns_[column].atoms) ++covered_[atom];
    for (const auto& [other, price] : prices_[column]) price_[other] += price;
  }
  void take_back() {
    const std::size_t column = chosen_.back();
    chosen_.pop_back();
    for (const std::size_t atom : columns_[column].atoms) --covered_[atom];
    // Summed up anew: sums that are taken apart again would keep rounding.
    for (const auto& [other, price] : prices_[column]) {
      price_[other] = 0.0;
      for (const std::size_t c : chosen_) {
        const auto clash = prices_[other].find(c);
        if (clash != prices_[other].end()) price_[other] += clash->second;
      }
    }
  }

  void branch(double cost) {
    if (progress_.cancelled()) throw Cancelled();
    if (++nodes_ > most_nodes_ && !best_.empty()) return;
    std::size_t rarest = having_.size(), fewest = std::numeric_limits<std::size_t>::max();
    for (std::size_t atom = 0; atom < having_.size(); ++atom) {
      if (covered_[atom] > 0 || having_[atom].size() >= fewest) continue;
      rarest = atom;
      fewest = having_[atom].size();
    }
    if (rarest == having_.size()) {
      if (cost < best_cost_ * (1.0 - k_saving)) {
        best_cost_ = cost;
        best_ = chosen_;
      }
      return;
    }
    if (cost + bound() >= best_cost_ * (1.0 - k_saving)) return;
    // Those that cover most for their cost first: a good cover is found soon.
    std::vector<std::size_t> order = having_[rarest];
    const auto worth = [&](std::size_t c) {
      const auto open =
          std::ranges::count_if(columns_[c].atoms, [&](std::size_t atom) { return covered_[atom] == 0; });
      return static_cast<double>(open) / cost_now(c);
    };
    std::ranges::stable_sort(order, std::greater(), worth);
    for (const std::size_t c : order) {
      const double more = cost_now(c);
      choose(c);
      branch(cost + more);
      take_back();
    }
  }

  std::span<const CoverColumn> columns_;
  std::size_t most_nodes_;
  const Progress& progress_;
  std::vector<std::vector<std::size_t>> having_;       // columns of each atom
  std::vector<std::map<std::size_t, double>> prices_;  // of each column's clashes, by the other column
  std::vector<int> covered_;                           // how often each atom is
  std::vector<char> allowed_;
  std::vector<double> price_;  // of each column, of its clashes with what is chosen
  std::vector<std::size_t> chosen_, best_;
  double best_cost_ = std::numeric_limits<double>::infinity();
  std::size_t nodes_ = 0;
};

}  // namespace

Cover least_cover(std::size_t atoms, std::span<const CoverColumn> columns,
                  std::span<const CoverClash> clashes, std::size_t most_nodes, const Progress& progress) {
  return Search(atoms, columns, clashes, most_nodes, progress).run();
}

}  // namespace moldlight
