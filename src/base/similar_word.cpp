#include "base/similar_word.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/shown_text.hpp"

namespace moldlight {

namespace {

/// Letters to change, add, leave out or swap with their neighbour.
std::size_t letters_apart(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        least[i][k] = i + k;
        continue;
      }
      const std::size_t changed = least[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      least[i][k] = std::min({changed, least[i - 1][k] + 1, least[i][k - 1] + 1});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        least[i][k] = std::min(least[i][k], least[i - 2][k - 2] + 1);
    }
  }
  return least[a.size()][b.size()];
}

}  // namespace

std::string did_you_mean(std::string_view typed, std::span<const std::string_view> known,
                         std::string_view advice) {
  constexpr std::size_t k_most_apart = 2;
  const std::string lower = lower_letters(typed);
  std::string_view nearest;
  std::size_t least = k_most_apart + 1;
  for (const std::string_view word : known) {
    const std::size_t apart = letters_apart(lower, word);
    if (apart >= least || 2 * apart >= typed.size()) continue;
    least = apart;
    nearest = word;
  }
  const std::string guess = nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
  return advice.empty() ? guess : fmt::format("{}{}{}", guess, guess.empty() ? "; " : " ", advice);
}

std::string did_you_mean(std::string_view typed, const std::vector<std::string>& known,
                         std::string_view advice) {
  return did_you_mean(typed, std::vector<std::string_view>(known.begin(), known.end()), advice);
}

}  // namespace moldlight
