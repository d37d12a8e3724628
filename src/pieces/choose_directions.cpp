#include "pieces/choose_directions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "mold/direction.hpp"
#include "mold/surface_samples.hpp"
#include "pieces/direction_cover.hpp"
#include "pieces/sample_access.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_samples = 4000, k_samples_of_left = 1024;
constexpr int k_most_rounds = 40;
/// Of searches: for one number of directions in all, for one pair, and for covers by liked lines.
constexpr std::size_t k_nodes = 20'000, k_nodes_of_a_pair = 300, k_nodes_of_liked = 3000;
/// What exact areas distinguish, as a share of the surface.
constexpr double k_resolved_share = 1e-6;
constexpr std::size_t k_most_pairs = 40;
/// Covers that leave so many samples more are as good, and depths that differ by less the same.
constexpr std::size_t k_same_samples = 4;
constexpr double k_same_depth = 0.01;

/// Standard deviation of how many of `count` samples are of a share of the surface.
std::size_t sampling_error(std::size_t count, double share) {
  return static_cast<std::size_t>(std::sqrt(static_cast<double>(count) * share * (1.0 - share)));
}

class Chooser {
 public:
  Chooser(const PartModel& model, const ExactQuery& query, const PiecesSettings& settings,
          const Progress& progress)
      : model_(model),
        settings_(settings),
        progress_(progress),
        lines_(pull_lines(model, settings, progress)),
        access_(model, query, lines_),
        left_(model, query) {
    for (std::size_t k = 0; k < settings.fixed.size(); ++k) forced_.push_back(2 * k);
    // Of a solid some surface faces away from any one direction, be it less than eps.
    if (model.health.closed && settings.most > 1) least_ = 2;
    for (const PullLine& line : lines_) depths_.push_back(depth_along(line.direction));
  }

  ChosenDirections run();

 private:
  /// A cover, and whether no smaller one exists among the candidates.
  struct Choice {
    std::vector<std::size_t> columns;
    bool optimal = true, enough = true;
  };

  [[nodiscard]] double depth_along(const glm::dvec3& direction) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const glm::dvec3& vertex : model_.part.mesh.vertices) {
      low = std::min(low, glm::dot(vertex, direction));
      high = std::max(high, glm::dot(vertex, direction));
    }
    return (high - low) / model_.frame.diagonal;
  }
  [[nodiscard]] std::vector<std::size_t> columns_liked(int liking) const {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < 2 * lines_.size(); ++c) {
      if (static_cast<int>(lines_[c / 2].liking) <= liking) columns.push_back(c);
    }
    return columns;
  }
  void add_even_samples(ChosenDirections& chosen);
  [[nodiscard]] Choice choose();
  [[nodiscard]] std::vector<std::size_t> liked_cover(std::vector<std::size_t> any, std::size_t most);
  [[nodiscard]] std::optional<std::vector<std::size_t>> with_pair(CoverSearch& search, int liking,
                                                                  std::size_t most) const;
  void replace_disliked(std::vector<std::size_t>& columns) const;
  [[nodiscard]] double add_left_samples(std::span<const std::size_t> columns,
                                        std::span<const LeftPolygon> left, double area, double allowed);

  const PartModel& model_;
  const PiecesSettings& settings_;
  const Progress& progress_;
  std::vector<PullLine> lines_;
  SampleAccess access_;
  LeftSurface left_;
  std::vector<std::size_t> forced_;
  std::vector<double> depths_;  // of the part along each line, share of its diagonal
  std::size_t least_ = 1;       // fewer directions were excluded
  std::size_t nodes_left_ = k_nodes;
  bool all_ = true;      // candidates release all but eps
  bool certain_ = true;  // by searches that came to their end
};

/// With an opposite pair; of several the most liked, of these that which leaves least by itself, then the
/// flattest.
std::optional<std::vector<std::size_t>> Chooser::with_pair(CoverSearch& search, int liking,
                                                           std::size_t most) const {
  struct Pair {
    std::vector<std::size_t> columns;
    LineLiking liking{};
    std::size_t left = 0;
    double depth = 0.0;
  };
  std::vector<Pair> pairs;
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    // A line without a reason is worth a pair only where the pair is all.
    const bool liked = static_cast<int>(lines_[line].liking) <= liking;
    if (!liked || (most > 2 && lines_[line].liking == LineLiking::other)) continue;
    std::vector<std::size_t> columns = forced_;
    for (const std::size_t column : {2 * line, 2 * line + 1}) {
      if (std::ranges::find(columns, column) == columns.end()) columns.push_back(column);
    }
    if (columns.size() > most) continue;
    const std::size_t left = moldlight::left_by(access_.task(), columns).count();
    pairs.push_back({std::move(columns), lines_[line].liking, left / k_same_samples,
                     std::round(depths_[line] / k_same_depth)});
  }
  std::ranges::stable_sort(pairs, {},
                           [](const Pair& pair) { return std::tuple(pair.liking, pair.left, pair.depth); });
  if (pairs.size() > k_most_pairs) pairs.resize(k_most_pairs);
  for (const Pair& pair : pairs) {
    const DirectionCover cover =
        search.find({.forced = pair.columns, .most = most, .most_nodes = k_nodes_of_a_pair});
    if (cover.found) return cover.columns;
  }
  return std::nullopt;
}

/// Each direction that is neither fixed nor of a pair by the most liked that does as well.
void Chooser::replace_disliked(std::vector<std::size_t>& columns) const {
  const CoverTask task = access_.task();
  for (std::size_t k = forced_.size(); k < columns.size(); ++k) {
    if (std::ranges::find(columns, opposite_column(columns[k])) != columns.end()) continue;
    const auto rating = [&](std::size_t column, std::size_t left) {
      return std::tuple(lines_[column / 2].liking, left / k_same_samples);
    };
    std::vector<std::size_t> others = columns;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const BitSet without = moldlight::left_by(task, others);
    BitSet left = without;
    left.remove(task.columns[columns[k]]);
    auto best = rating(columns[k], left.count());
    for (std::size_t c = 0; c < task.columns.size(); ++c) {
      left = without;
      left.remove(task.columns[c]);
      if (const auto found = rating(c, left.count()); found < best && leaves_enough(task, left)) {
        best = found;
        columns[k] = c;
      }
    }
  }
}

std::vector<std::size_t> Chooser::liked_cover(std::vector<std::size_t> any, std::size_t most) {
  const CoverTask task = access_.task();
  for (int liking = 0; liking < k_line_likings; ++liking) {
    CoverSearch search(task, columns_liked(liking), progress_);
    if (auto pair = with_pair(search, liking, most)) {
      replace_disliked(*pair);
      return *pair;
    }
    const DirectionCover cover =
        search.find({.forced = forced_, .most = most, .most_nodes = k_nodes_of_liked});
    if (!cover.found) continue;
    any = cover.columns;
    break;
  }
  replace_disliked(any);
  return any;
}

Chooser::Choice Chooser::choose() {
  const CoverTask task = access_.task();
  CoverSearch search(task, columns_liked(k_line_likings), progress_);
  const auto most = static_cast<std::size_t>(settings_.most);
  for (; least_ <= most; ++least_, nodes_left_ = k_nodes) {
    if (least_ < forced_.size()) continue;
    const DirectionCover cover = search.find({.forced = forced_, .most = least_, .most_nodes = nodes_left_});
    nodes_left_ -= std::min(nodes_left_, cover.nodes);
    if (cover.found) return {.columns = liked_cover(cover.columns, least_), .optimal = certain_};
    certain_ = certain_ && cover.complete;
  }
  return {
      .columns = greedy_cover(task, {.forced = forced_, .most = most},
                              [&](std::size_t column) { return static_cast<int>(lines_[column / 2].liking); })
                     .columns,
      .optimal = false,
      .enough = false};
}

/// Samples of what is left; the area of it that some candidate releases.
double Chooser::add_left_samples(std::span<const std::size_t> columns, std::span<const LeftPolygon> left,
                                 double area, double allowed) {
  const std::vector<SurfaceSample> samples = left_samples(model_, left, k_samples_of_left);
  access_.add(samples, columns, progress_);
  const std::size_t group = access_.groups() - 1, count = samples.size();
  const std::size_t reachable = access_.reachable(group);
  const double share = std::min(1.0, allowed / area);
  const std::size_t spare = static_cast<std::size_t>(static_cast<double>(count) * share) +
                            sampling_error(count, share) + (all_ ? 0 : count - reachable);
  // What these directions leave is too much, whatever the error.
  access_.set_spare(group, std::min(spare, count - 1));
  return area * static_cast<double>(reachable) / static_cast<double>(count);
}

void Chooser::add_even_samples(ChosenDirections& chosen) {
  const SurfaceSamples base =
      sample_surface_evenly(model_.part.mesh, model_.geometry, model_.frame, k_samples);
  progress_.report("asking rays", 0.0);
  const std::size_t count = base.samples.size();
  access_.add(base.samples, {}, progress_);
  BitSet reached(count);
  for (const BitSet& column : access_.task().columns) reached.add(column);
  for (std::size_t k = 0; k < count; ++k) chosen.samples.push_back({base.samples[k], reached.has(k)});
  const auto spare = static_cast<std::size_t>(static_cast<double>(count) * settings_.eps);
  const std::size_t unreachable = count - access_.reachable(0);
  all_ = unreachable <= spare + sampling_error(count, settings_.eps);
  access_.set_spare(0, spare + sampling_error(count, settings_.eps) + (all_ ? 0 : unreachable));
}

ChosenDirections Chooser::run() {
  ChosenDirections chosen;
  add_even_samples(chosen);
  const double allowed = std::max(settings_.eps, k_resolved_share) * model_.geometry.total_area;
  Choice choice;
  for (int round = 0; round < k_most_rounds; ++round) {
    progress_.report("choosing directions", static_cast<double>(round) / k_most_rounds);
    choice = choose();
    std::vector<glm::dvec3> directions;
    for (const std::size_t column : choice.columns) directions.push_back(column_direction(lines_, column));
    chosen.left = left_.left_by(directions, progress_);
    chosen.left_area = area_of(chosen.left);
    chosen.unreachable_area = 0.0;
    chosen.releases_all = chosen.left_area <= allowed;
    chosen.enough = choice.enough || chosen.releases_all;
    if (chosen.releases_all) break;
    const double missed = add_left_samples(choice.columns, chosen.left, chosen.left_area, allowed);
    chosen.unreachable_area = chosen.left_area - missed;
    if (!choice.enough || (!all_ && missed <= allowed)) break;
    chosen.enough = false;  // unless another round finds better
  }
  chosen.optimal = choice.optimal && chosen.enough;
  for (const std::size_t column : choice.columns) {
    PullLine line = lines_[column / 2];
    line.direction = column_direction(lines_, column);
    if (column % 2 != 0 && nearest_axis(line.direction).is_met())
      line.name = nearest_axis(line.direction).name;
    chosen.directions.push_back(line);
  }
  return chosen;
}

}  // namespace

ChosenDirections choose_directions(const PartModel& model, const ExactQuery& query,
                                   const PiecesSettings& settings, const Progress& progress) {
  return Chooser(model, query, settings, progress).run();
}

}  // namespace moldlight
