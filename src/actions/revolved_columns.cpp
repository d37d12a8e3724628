#include "actions/revolved_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "actions/revolved.hpp"

namespace moldlight {

namespace {

constexpr double k_least_revolved = 1e-4;  // of the part's area: a smaller patch is neither thread nor ring

class RevolvedFinder {
 public:
  RevolvedFinder(const RevolvedContext& context, const std::vector<Atom>& atoms)
      : model_(context.model),
        split_(context.split),
        undercuts_(context.undercuts),
        query_(context.query),
        settings_(context.settings),
        progress_(context.progress),
        atoms_(atoms) {}

  std::vector<Column> find() {
    std::vector<std::size_t> stuck, threads;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      if (!atoms_[k].pulls.empty() || atoms_[k].area() < k_least_revolved * model_.geometry.total_area)
        continue;
      stuck.push_back(k);
      if (atoms_[k].allows(ActionKind::unscrew)) threads.push_back(k);
    }
    if (threads.size() > 1 && add_thread(threads)) return std::move(found_);
    for (const std::size_t k : stuck) {
      if (progress_.cancelled()) throw Cancelled();
      const bool turns = atoms_[k].allows(ActionKind::unscrew) && add_thread({k});
      if (!turns && settings_.strip_strain_pct > 0.0 && atoms_[k].allows(ActionKind::strip)) add_ring(k);
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] Revolution axis_of(const HelixFit& fit) const {
    return {.point = model_.frame.center + model_.frame.diagonal * fit.point, .direction = query_.direction};
  }

  void add(ActionKind kind, bool core_side, const Revolution& about, const std::vector<std::size_t>& atoms) {
    double least = k_never, greatest = -k_never;
    for (const std::size_t k : atoms) {
      for (const UndercutSample& sample : atoms_[k].samples) {
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
    found_.push_back({pull, atoms});
  }

  [[nodiscard]] std::vector<FacetIndex> facets_of(const std::vector<std::size_t>& atoms) const {
    std::vector<FacetIndex> facets;
    for (const std::size_t k : atoms) {
      for (const std::uint32_t piece : undercuts_.patches[atoms_[k].patch].pieces)
        facets.push_back(split_.pieces[piece].facet);
    }
    std::ranges::sort(facets);
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    return facets;
  }

  bool add_thread(const std::vector<std::size_t>& atoms) {
    const std::vector<UndercutSample> samples = samples_of(atoms_, atoms);
    const auto thread = find_thread(model_, {samples, facets_of(atoms)}, query_);
    if (!thread) return false;
    Revolution about = axis_of(thread->helix);
    about.pitch = (thread->right_handed ? 1.0 : -1.0) * thread->pitch * model_.frame.diagonal;
    add(ActionKind::unscrew, thread->core_side, about, atoms);
    std::vector<std::size_t>& released = found_.back().atoms;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      if (progress_.cancelled()) throw Cancelled();
      if (!atoms_[k].pulls.empty() && atoms_[k].allows(ActionKind::unscrew) &&
          goes_with(model_, *thread, {samples, atoms_[k].samples}, query_))
        released.push_back(k);
    }
    std::ranges::sort(released);
    return true;
  }

  void add_ring(std::size_t k) {
    const auto ring = find_ring(model_, {atoms_[k].samples, facets_of({k})}, query_);
    if (!ring) return;
    if (100.0 * ring->strain > settings_.strip_strain_pct) return;
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
  const std::vector<Atom>& atoms_;
  std::vector<Column> found_;
};

}  // namespace

std::vector<Column> revolved_columns(const RevolvedContext& context, const std::vector<Atom>& atoms) {
  return RevolvedFinder(context, atoms).find();
}

}  // namespace moldlight
