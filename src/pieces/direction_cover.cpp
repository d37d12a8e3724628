#include "pieces/direction_cover.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

namespace moldlight {

namespace {

constexpr std::size_t k_word = 64;

std::size_t count_in(const SampleGroup& group, const BitSet& set, const BitSet& other) {
  const std::size_t first = group.first / k_word, end = (group.first + group.count + k_word - 1) / k_word;
  return common_bits(set.words().data() + first, other.words().data() + first, end - first);
}

std::size_t count_in(const SampleGroup& group, const BitSet& set) { return count_in(group, set, set); }

BitSet all_samples(const CoverTask& task) {
  BitSet all(task.groups.empty() ? 0 : task.groups.back().first + task.groups.back().count);
  for (const SampleGroup& group : task.groups) {
    for (std::size_t k = 0; k < group.count; ++k) all.set(group.first + k);
  }
  return all;
}

/// Those of `columns` that no other one reaches all samples of; of equal ones the first stays.
std::vector<std::size_t> undominated(std::span<const BitSet> all, std::span<const std::size_t> columns,
                                     const Progress& progress) {
  std::vector<std::size_t> counts, kept;
  counts.reserve(columns.size());
  for (const std::size_t c : columns) counts.push_back(all[c].count());
  std::vector<std::size_t> order(columns.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t k) { return counts[k]; });
  std::vector<std::size_t> places;
  for (const std::size_t k : order) {
    if (progress.cancelled()) throw Cancelled();
    if (counts[k] == 0) continue;
    const bool served = std::ranges::any_of(
        places, [&](std::size_t other) { return all[columns[other]].contains(all[columns[k]]); });
    if (!served) places.push_back(k);
  }
  std::ranges::sort(places);
  for (const std::size_t k : places) kept.push_back(columns[k]);
  return kept;
}

}  // namespace

CoverSearch::CoverSearch(const CoverTask& task, std::span<const std::size_t> allowed,
                         const Progress& progress)
    : task_(task), progress_(progress), columns_(undominated(task.columns, allowed, progress)) {
  rows_.assign(all_samples(task).words().size() * k_word, BitSet(columns_.size()));
  for (std::size_t c = 0; c < columns_.size(); ++c)
    column(c).for_each([&](std::size_t sample) { rows_[sample].set(c); });
}

DirectionCover CoverSearch::find(const CoverChoice& choice) {
  DirectionCover cover;
  nodes_ = 0;
  most_nodes_ = choice.most_nodes;
  chosen_.clear();
  State state{.open = left_by(task_, choice.forced), .allowed = BitSet(columns_.size()), .spare = {}};
  for (std::size_t c = 0; c < columns_.size(); ++c) state.allowed.set(c);
  for (const std::size_t out : choice.without) {
    const auto found = std::ranges::lower_bound(columns_, out);
    if (found != columns_.end() && *found == out)
      state.allowed.reset(static_cast<std::size_t>(found - columns_.begin()));
  }
  for (const SampleGroup& group : task_.groups) state.spare.push_back(group.spare);
  cover.found = branch(std::move(state), choice.most - choice.forced.size());
  cover.complete = nodes_ <= most_nodes_;
  cover.nodes = nodes_;
  if (!cover.found) return cover;
  cover.columns = choice.forced;
  for (const std::size_t c : chosen_) cover.columns.push_back(columns_[c]);
  return cover;
}

std::size_t CoverSearch::group_of(std::size_t sample) const {
  std::size_t group = task_.groups.size() - 1;
  while (task_.groups[group].first > sample) --group;
  return group;
}

/// Gives up samples that nothing reaches any more; false where these are too many.
bool CoverSearch::drop_unreachable(State& state, std::size_t& rarest) const {
  std::size_t fewest = columns_.size() + 1;
  bool enough = true;
  BitSet dropped(state.open.words().size() * k_word);
  state.open.for_each([&](std::size_t sample) {
    const std::size_t count = rows_[sample].count_with(state.allowed);
    if (count == 0) {
      dropped.set(sample);
      std::size_t& spare = state.spare[group_of(sample)];
      enough = enough && spare > 0;
      if (spare > 0) --spare;
    } else if (count < fewest) {
      fewest = count;
      rarest = sample;
    }
  });
  state.open.remove(dropped);
  return enough;
}

bool CoverSearch::satisfied(const State& state) const {
  for (std::size_t g = 0; g < task_.groups.size(); ++g) {
    if (count_in(task_.groups[g], state.open) > state.spare[g]) return false;
  }
  return true;
}

/// False where even the best `rest` columns do not reach enough of some group.
bool CoverSearch::may_suffice(const State& state, std::size_t rest, std::vector<std::size_t>& gains) const {
  gains.assign(columns_.size(), 0);
  std::vector<std::size_t> of_group;
  for (std::size_t g = 0; g < task_.groups.size(); ++g) {
    const SampleGroup& group = task_.groups[g];
    const std::size_t open = count_in(group, state.open);
    of_group.clear();
    state.allowed.for_each([&](std::size_t c) {
      of_group.push_back(count_in(group, state.open, column(c)));
      gains[c] += of_group.back();
    });
    const std::size_t taken = std::min(rest, of_group.size());
    std::partial_sort(of_group.begin(), of_group.begin() + static_cast<std::ptrdiff_t>(taken), of_group.end(),
                      std::greater());
    const std::size_t reached = std::accumulate(
        of_group.begin(), of_group.begin() + static_cast<std::ptrdiff_t>(taken), std::size_t{0});
    if (reached + state.spare[g] < open) return false;
  }
  return true;
}

bool CoverSearch::branch(State state, std::size_t rest) {
  if (progress_.cancelled()) throw Cancelled();
  if (satisfied(state)) return true;
  if (rest == 0 || ++nodes_ > most_nodes_) return false;
  if (rest == 1) return choose_last(state);
  std::size_t rarest = 0;
  if (!drop_unreachable(state, rarest)) return false;
  std::vector<std::size_t> gains;
  if (!may_suffice(state, rest, gains)) return false;
  std::vector<std::size_t> order;
  rows_[rarest].for_each([&](std::size_t c) {
    if (state.allowed.has(c)) order.push_back(c);
  });
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t c) { return gains[c]; });
  for (const std::size_t c : order) {
    state.allowed.reset(c);  // what comes after it does without it
    State next = state;
    next.open.remove(column(c));
    chosen_.push_back(c);
    if (branch(std::move(next), rest - 1)) return true;
    chosen_.pop_back();
    if (nodes_ > most_nodes_) return false;
  }
  return branch(std::move(state), rest);  // gives the sample up: nothing reaches it any more
}

/// The column that reaches most of those that reach enough.
bool CoverSearch::choose_last(const State& state) {
  std::vector<std::size_t> wanted;
  for (std::size_t g = 0; g < task_.groups.size(); ++g)
    wanted.push_back(count_in(task_.groups[g], state.open));
  std::size_t best = columns_.size(), most = 0;
  state.allowed.for_each([&](std::size_t c) {
    std::size_t sum = 0;
    for (std::size_t g = 0; g < task_.groups.size(); ++g) {
      const std::size_t gain = count_in(task_.groups[g], state.open, column(c));
      if (gain + state.spare[g] < wanted[g]) return;
      sum += gain;
    }
    if (best < columns_.size() && sum <= most) return;
    best = c;
    most = sum;
  });
  if (best == columns_.size()) return false;
  chosen_.push_back(best);
  return true;
}

BitSet left_by(const CoverTask& task, std::span<const std::size_t> columns) {
  BitSet left = all_samples(task);
  for (const std::size_t c : columns) left.remove(task.columns[c]);
  return left;
}

bool leaves_enough(const CoverTask& task, const BitSet& left) {
  return std::ranges::all_of(task.groups,
                             [&](const SampleGroup& group) { return count_in(group, left) <= group.spare; });
}

namespace {

/// The one of least liking among those that reach about as much as any.
std::size_t best_column(const CoverTask& task, const BitSet& left,
                        const std::function<int(std::size_t)>& liking) {
  constexpr double k_as_much = 0.9;
  std::vector<std::size_t> gains(task.columns.size(), 0);
  for (std::size_t c = 0; c < gains.size(); ++c) gains[c] = left.count_with(task.columns[c]);
  const std::size_t most = gains.empty() ? 0 : std::ranges::max(gains);
  std::size_t best = gains.size();
  for (std::size_t c = 0; most > 0 && c < gains.size(); ++c) {
    if (static_cast<double>(gains[c]) < k_as_much * static_cast<double>(most)) continue;
    if (best == gains.size() ||
        std::pair(liking(c), most - gains[c]) < std::pair(liking(best), most - gains[best]))
      best = c;
  }
  return best;
}

/// The two that reach most together, of equal ones those of least liking; none where there are too many.
std::vector<std::size_t> best_pair(const CoverTask& task, const BitSet& left,
                                   const std::function<int(std::size_t)>& liking) {
  constexpr std::size_t k_most_columns = 1500;
  const std::size_t count = task.columns.size();
  if (count > k_most_columns) return {};
  std::vector<std::size_t> best;
  std::pair<std::size_t, int> least{left.count(), 0};
  for (std::size_t one = 0; one < count; ++one) {
    BitSet rest = left;
    rest.remove(task.columns[one]);
    const std::size_t beside_one = rest.count();
    for (std::size_t other = one + 1; other < count; ++other) {
      const std::pair its(beside_one - rest.count_with(task.columns[other]), liking(one) + liking(other));
      if (its >= least) continue;
      least = its;
      best = {one, other};
    }
  }
  return best;
}

}  // namespace

DirectionCover greedy_cover(const CoverTask& task, const CoverChoice& choice,
                            const std::function<int(std::size_t)>& liking) {
  // Samples of the first group stand for the surface, the others for small places that were left once: they
  // decide between what leaves as much of it.
  const auto of_surface = [&](BitSet set) {
    for (std::size_t k = 1; k < task.groups.size(); ++k)
      for (std::size_t i = 0; i < task.groups[k].count; ++i) set.reset(task.groups[k].first + i);
    return set;
  };
  std::optional<std::pair<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>>> best;
  for (const bool by_pairs : {false, true}) {
    std::vector<std::size_t> columns = choice.forced;
    BitSet left = left_by(task, columns);
    const auto next_of = [&](const BitSet& wanted) {
      std::vector<std::size_t> next;
      if (by_pairs && columns.size() + 2 <= choice.most) next = best_pair(task, wanted, liking);
      if (next.empty()) next = {best_column(task, wanted, liking)};
      return next;
    };
    while (columns.size() < choice.most) {
      std::vector<std::size_t> next = next_of(of_surface(left));
      if (next.front() == task.columns.size()) next = next_of(left);
      if (next.front() == task.columns.size()) break;
      for (const std::size_t c : next) {
        columns.push_back(c);
        left.remove(task.columns[c]);
      }
    }
    const std::pair its(of_surface(left).count(), left.count());
    if (!best || its < best->first) best = {its, std::move(columns)};
  }
  return {.columns = std::move(best->second), .found = true, .complete = false};
}

}  // namespace moldlight
