#include "mold/sweep/scan_scorer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mold/measure.hpp"
#include "mold/scan/wall_lookup.hpp"
#include "mold/sweep/even_samples.hpp"

namespace moldlight {

namespace {

/// Clusters with fewer texels, or walls with fewer samples, are pooled with others of their kind.
constexpr std::uint64_t k_least_fragments = 8;
constexpr double k_least_wall_samples = 4.0;
/// Less near-vertical surface than this share of the part is measured by rays alone: they take less time than
/// the second-depth maps then.
constexpr double k_second_depth_from = 0.12;
/// Thin clusters lie scattered, so that even samples of few of them are little better than independent ones:
/// more for a small share, but a part of those of walls for a large one, as rays cost more than look-ups.
constexpr double k_samples_of_thin_clusters = 0.6, k_thin_exponent = 0.75;
/// Even samples beat independent ones: the variance of a share r seen by n of them falls as n^-1.5. The
/// factors were found on real parts, so that two standard errors cover 95 of 100 errors.
constexpr double k_texel_variance = 4.0, k_sample_variance = 1.0;
/// Rays start above their facet by the rounding of coordinates, so that they miss it.
constexpr float k_start_above = 5e-7F;
constexpr double k_certain = 5.0;  // standard errors

constexpr auto k_undercut = static_cast<std::size_t>(Region::undercut);

double even_variance(double share, double count) {
  return share * (1.0 - share) / (count * std::sqrt(count));
}

/// Variance of a share of `hits` in `count` samples as if independent, one more of either kind counted.
double independent_variance(double hits, double count) {
  const double seen = (hits + 1.0) / (count + 2.0);
  return seen * (1.0 - seen) / (count + 2.0);
}

Region region_of_layer(scan::Layer layer) {
  return layer == scan::k_up_layer ? Region::core : Region::cavity;
}

}  // namespace

double ScanScorer::Wall::samples() const {
  return static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
}

void ScanScorer::Wall::add(const Wall& other) {
  area += other.area;
  for (std::size_t k = 0; k < k_region_count; ++k) counts[k] += other.counts[k];
}

ScanScorer::ScanScorer(const ScanScorerPart& part, const ScanScorerSettings& settings)
    : part_(part),
      settings_(settings),
      maps_(settings.resolution),
      square_(part.part.frame().diagonal * part.part.frame().diagonal) {}

DirectionScore ScanScorer::score(const glm::dvec3& direction) {
  maps_.draw(part_.part, map_frame(direction),
             {.tau_deg = settings_.tau_deg,
              .second_depth_from = settings_.settle_by_rays ? k_second_depth_from : 0.0});
  find_cluster_areas();
  Estimate estimate;
  add_clusters(estimate);
  const double certain = estimate.areas[Region::undercut] - k_certain * std::sqrt(estimate.undercut_variance);
  if (certain * square_ > limit()) {
    for (const scan::Layer layer : {scan::k_up_layer, scan::k_down_layer}) {
      leave_open(region_of_layer(layer), thin_areas_[layer], estimate);
    }
    leave_open(Region::both, maps_.class_area(FacetClass::near_vertical), estimate);
    DirectionScore score = finished(estimate);
    score.given_up = true;
    return score;
  }
  add_thin_clusters(estimate);
  add_walls(estimate);
  return finished(estimate);
}

double ScanScorer::share(double area) const { return area * square_ / part_.part.geometry().total_area; }

void ScanScorer::find_cluster_areas() {
  const glm::vec3 direction(maps_.frame().z);
  const auto threshold = static_cast<float>(std::sin(glm::radians(settings_.tau_deg))) + 1e-5F;
  const ScanPart::Clusters& clusters = part_.part.clusters();
  cluster_areas_.assign(clusters.all.size(), {0.0F, 0.0F});
  mixed_.assign(clusters.all.size(), 0);
  for (std::size_t i = 0; i < clusters.all.size(); ++i) {
    const ScanPart::Cluster& cluster = clusters.all[i];
    const float sine = glm::dot(cluster.axis, direction);
    const float cosine = std::sqrt(std::max(0.0F, 1.0F - sine * sine));
    // The least slope of a normal in the cone about the axis.
    const float least_sine = std::abs(sine) * cluster.cone_cosine - cosine * cluster.cone_sine;
    if (least_sine > threshold && cluster.cone_cosine > cosine) {
      cluster_areas_[i][sine > 0.0F ? scan::k_up_layer : scan::k_down_layer] = cluster.area;
      continue;
    }
    mixed_[i] = 1;
    for (const FacetIndex facet : clusters.facets_of(cluster)) {
      const FacetClass facet_class = maps_.facet_class(facet);
      if (facet_class == FacetClass::near_vertical) continue;
      cluster_areas_[i][static_cast<std::size_t>(facet_class)] += part_.part.areas()[facet];
    }
  }
}

void ScanScorer::add_clusters(Estimate& estimate) {
  thin_.clear();
  thin_areas_ = {};
  for (std::uint32_t i = 0; i < cluster_areas_.size(); ++i) {
    for (const scan::Layer layer : {scan::k_up_layer, scan::k_down_layer}) {
      const auto area = static_cast<double>(cluster_areas_[i][layer]);
      if (area <= 0.0) continue;
      const scan::ClusterSums& sums = maps_.sums().clusters[2 * i + layer];
      if (sums.fragments < k_least_fragments) {
        thin_.push_back({i, layer});
        thin_areas_[layer] += area;
        continue;
      }
      const double hidden = sums.hidden_weight / sums.weight;
      estimate.areas[region_of_layer(layer)] += area * (1.0 - hidden);
      estimate.areas[Region::undercut] += area * hidden;
      estimate.undercut_variance +=
          k_texel_variance * area * area * even_variance(hidden, static_cast<double>(sums.fragments));
    }
  }
}

void ScanScorer::add_thin_clusters(Estimate& estimate) {
  const ScanPart::Clusters& clusters = part_.part.clusters();
  const double whole = thin_areas_[0] + thin_areas_[1];
  EvenSamples samples(
      part_.part, whole,
      k_samples_of_thin_clusters * settings_.samples * std::pow(share(whole), k_thin_exponent));
  for (const scan::Layer layer : {scan::k_up_layer, scan::k_down_layer}) {
    const double area = thin_areas_[layer];
    if (area <= 0.0) continue;
    origins_.clear();
    for (const Thin& thin : thin_) {
      if (thin.layer != layer) continue;
      for (const FacetIndex facet : clusters.facets_of(clusters.all[thin.cluster])) {
        if (static_cast<std::size_t>(maps_.facet_class(facet)) != layer) continue;
        const glm::vec3 raise = k_start_above * part_.part.normal(facet);
        samples.on_facet(facet, [&](const glm::vec3& position) { origins_.push_back(position + raise); });
      }
    }
    if (origins_.empty()) {
      leave_open(region_of_layer(layer), area, estimate);
      continue;
    }
    answers_[0].resize(origins_.size());
    const glm::vec3 side(maps_.frame().z);
    part_.rays.blocked(origins_, layer == scan::k_up_layer ? side : -side, answers_[0]);
    const auto count = static_cast<double>(origins_.size());
    const auto blocked = static_cast<double>(std::count(answers_[0].begin(), answers_[0].end(), 1));
    estimate.areas[region_of_layer(layer)] += area * (1.0 - blocked / count);
    estimate.areas[Region::undercut] += area * blocked / count;
    estimate.undercut_variance += area * area * independent_variance(blocked, count);
  }
}

void ScanScorer::sample_walls(double area) {
  const ScanPart& part = part_.part;
  const WallLookup lookup(part, maps_, settings_.lateral);
  EvenSamples samples(part, area, settings_.samples * share(area));
  const ScanPart::Clusters& clusters = part.clusters();
  walls_.assign(clusters.all.size(), {});
  verdicts_.clear();
  sample_clusters_.clear();
  doubtful_.clear();
  origins_.clear();
  for (std::uint32_t cluster = 0; cluster < walls_.size(); ++cluster) {
    if (!mixed_[cluster]) continue;
    for (const FacetIndex facet : clusters.facets_of(clusters.all[cluster])) {
      if (maps_.facet_class(facet) != FacetClass::near_vertical) continue;
      walls_[cluster].area += static_cast<double>(part.areas()[facet]);
      const WallLookup::Wall wall = lookup.wall(facet);
      samples.on_facet(facet, [&](const glm::vec3& position) {
        verdicts_.push_back(maps_.has_second_depth() ? lookup.ask(wall, position) : verdict::k_doubtful);
        sample_clusters_.push_back(cluster);
        if (verdicts_.back() != verdict::k_doubtful) return;
        doubtful_.push_back(static_cast<std::uint32_t>(verdicts_.size() - 1));
        origins_.push_back(lookup.lateral_point(wall, position));
      });
    }
  }
}

void ScanScorer::settle_walls() {
  const glm::vec3 direction(maps_.frame().z);
  for (std::vector<std::uint8_t>& answers : answers_) answers.resize(origins_.size());
  part_.rays.blocked(origins_, direction, answers_[0]);
  part_.rays.blocked(origins_, -direction, answers_[1]);
  for (std::size_t i = 0; i < doubtful_.size(); ++i) {
    verdicts_[doubtful_[i]] =
        static_cast<std::uint8_t>((answers_[0][i] != 0 ? 0 : verdict::k_accessible_plus) |
                                  (answers_[1][i] != 0 ? 0 : verdict::k_accessible_minus));
  }
}

void ScanScorer::add_walls(Estimate& estimate) {
  const double whole = maps_.class_area(FacetClass::near_vertical);
  if (whole <= 0.0) return;
  sample_walls(whole);
  if (settings_.settle_by_rays) {
    settle_walls();
  } else if (!verdicts_.empty()) {
    estimate.unsettled +=
        whole * static_cast<double>(doubtful_.size()) / static_cast<double>(verdicts_.size());
  }
  for (std::size_t i = 0; i < verdicts_.size(); ++i) {
    ++walls_[sample_clusters_[i]].counts[static_cast<std::size_t>(verdict_region(verdicts_[i]))];
  }
  Wall rest;
  const auto add = [&](const Wall& wall, double count) {
    for (const Region region : k_regions) {
      estimate.areas[region] += wall.area * wall.counts[static_cast<std::size_t>(region)] / count;
    }
  };
  for (const Wall& wall : walls_) {
    if (wall.area <= 0.0) continue;
    const double count = wall.samples();
    if (count < k_least_wall_samples) {
      rest.add(wall);
      continue;
    }
    add(wall, count);
    estimate.undercut_variance +=
        k_sample_variance * wall.area * wall.area * even_variance(wall.counts[k_undercut] / count, count);
  }
  if (rest.area <= 0.0) return;
  if (const double count = rest.samples(); count > 0.0) {
    add(rest, count);
    estimate.undercut_variance +=
        rest.area * rest.area * independent_variance(rest.counts[k_undercut], count);
  } else {
    leave_open(Region::both, rest.area, estimate);
  }
}

void ScanScorer::leave_open(Region region, double area, Estimate& estimate) {
  estimate.areas[region] += area;
  estimate.unsettled += area;
}

DirectionScore ScanScorer::finished(const Estimate& estimate) const {
  DirectionScore score;
  for (const Region region : k_regions) score.areas[region] = estimate.areas[region] * square_;
  score.undercut_error = (2.0 * std::sqrt(estimate.undercut_variance) + estimate.unsettled) * square_;
  const double shadow = maps_.shadow_area();
  score.shadow_area = shadow * square_;
  // What near-vertical facets hide of the projection need not be undercut: they are tested beside themselves.
  const double hidden = maps_.projected_area() - maps_.projected_near_vertical_area() - 2.0 * shadow;
  const double error = shadow_error_share(settings_.resolution) * part_.part.geometry().total_area;
  score.undercut_bound = std::max(0.0, hidden * square_ - error);
  return score;
}

}  // namespace moldlight
