#include "actions/revolved_options.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "actions/revolved.hpp"

namespace moldlight {

namespace {

constexpr double k_least_revolved =
    1e-4;  // of the part's area: a smaller undercut is neither thread nor ring

class RevolvedFinder {
 public:
  RevolvedFinder(const RevolvedContext& context, const std::vector<UndercutPart>& undercut_parts)
      : model_(context.model),
        split_(context.split),
        undercuts_(context.undercuts),
        query_(context.query),
        settings_(context.settings),
        progress_(context.progress),
        undercut_parts_(undercut_parts) {}

  RevolvedOptions find() {
    std::vector<std::size_t> stuck, threads;
    for (std::size_t k = 0; k < undercut_parts_.size(); ++k) {
      if (!undercut_parts_[k].pulls.empty() ||
          undercut_parts_[k].area() < k_least_revolved * model_.geometry.total_area)
        continue;
      stuck.push_back(k);
      if (undercut_parts_[k].allows(ActionKind::unscrew)) threads.push_back(k);
    }
    if (threads.size() > 1 && add_thread(threads)) return {std::move(found_), {}};
    for (const std::size_t k : stuck) {
      if (progress_.cancelled()) throw Cancelled();
      const bool turns = undercut_parts_[k].allows(ActionKind::unscrew) && add_thread({k});
      if (!turns && settings_.strip_strain_pct > 0.0 && undercut_parts_[k].allows(ActionKind::strip))
        add_ring(k);
    }
    return {std::move(found_), std::move(rejected_)};
  }

 private:
  [[nodiscard]] Revolution axis_of(const HelixFit& fit) const {
    return {.point = model_.frame.center + model_.frame.diagonal * fit.point, .direction = query_.direction};
  }

  void add(ActionKind kind, bool core_side, const Revolution& about,
           const std::vector<std::size_t>& undercut_parts) {
    double least = k_never, greatest = -k_never;
    for (const std::size_t k : undercut_parts) {
      for (const UndercutSample& sample : undercut_parts_[k].samples) {
        const double height = glm::dot(glm::dvec3(sample.position), query_.direction);
        least = std::min(least, height);
        greatest = std::max(greatest, height);
      }
    }
    Pull pull{.kind = kind,
              .direction = core_side ? query_.direction : -query_.direction,
              .travel = greatest - least,
              .core_side = core_side,
              .about = about};
    if (about.pitch != 0.0) pull.about->turns = pull.travel * model_.frame.diagonal / std::abs(about.pitch);
    found_.push_back({pull, undercut_parts});
  }

  [[nodiscard]] std::vector<FacetIndex> facets_of(const std::vector<std::size_t>& undercut_parts) const {
    std::vector<FacetIndex> facets;
    for (const std::size_t k : undercut_parts) {
      for (const std::uint32_t piece : undercuts_.counted[undercut_parts_[k].undercut].pieces)
        facets.push_back(split_.pieces[piece].facet);
    }
    std::ranges::sort(facets);
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    return facets;
  }

  bool add_thread(const std::vector<std::size_t>& undercut_parts) {
    const std::vector<UndercutSample> samples = samples_of(undercut_parts_, undercut_parts);
    const auto thread = find_thread(model_, {samples, facets_of(undercut_parts)}, query_);
    if (!thread) return false;
    Revolution about = axis_of(thread->helix);
    about.pitch = (thread->right_handed ? 1.0 : -1.0) * thread->pitch * model_.frame.diagonal;
    add(ActionKind::unscrew, thread->core_side, about, undercut_parts);
    std::vector<std::size_t>& released = found_.back().undercut_parts;
    for (std::size_t k = 0; k < undercut_parts_.size(); ++k) {
      if (progress_.cancelled()) throw Cancelled();
      if (!undercut_parts_[k].pulls.empty() && undercut_parts_[k].allows(ActionKind::unscrew) &&
          goes_with(model_, *thread, {samples, undercut_parts_[k].samples}, query_))
        released.push_back(k);
    }
    std::ranges::sort(released);
    return true;
  }

  void add_ring(std::size_t k) {
    const auto ring = find_ring(model_, {undercut_parts_[k].samples, facets_of({k})}, query_);
    if (!ring) return;
    if (100.0 * ring->strain > settings_.strip_strain_pct) {
      constexpr double k_most_told = 0.3;  // no material stretches so far
      if (ring->strain > k_most_told) return;
      const glm::dvec3 at(undercut_parts_[k].samples.front().position);
      rejected_.push_back({.undercut = undercut_parts_[k].undercut,
                           .kind = ActionKind::strip,
                           .direction = ring->core_side ? query_.direction : -query_.direction,
                           .core_side = ring->core_side,
                           .reason = RejectReason::too_strained,
                           .place = model_.frame.center + model_.frame.diagonal * at,
                           .room = std::numeric_limits<double>::infinity(),
                           .depth = model_.frame.diagonal * ring->depth,
                           .strain = ring->strain});
      return;
    }
    Revolution about = axis_of(ring->axis);
    about.strain = ring->strain;
    add(ActionKind::strip, ring->core_side, about, {k});
  }

  const PartModel& model_;
  const SplitMesh& split_;
  const Undercuts& undercuts_;
  const ExactQuery& query_;
  const ActionSettings& settings_;
  const Progress& progress_;
  const std::vector<UndercutPart>& undercut_parts_;
  std::vector<ActionOption> found_;
  std::vector<RejectedAction> rejected_;
};

}  // namespace

RevolvedOptions revolved_options(const RevolvedContext& context,
                                 const std::vector<UndercutPart>& undercut_parts) {
  return RevolvedFinder(context, undercut_parts).find();
}

}  // namespace moldlight
