#include "sweep/candidates/find_candidates.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sweep/candidates/candidate_sources.hpp"

namespace moldlight {

std::vector<Candidate> find_candidates(const PartModel& model, const CandidateOptions& options,
                                       const Progress& progress) {
  const FacetGeometry& geometry = model.geometry;
  const bool has_area = geometry.total_area > 0.0;
  const std::vector<NormalCell> cells = normal_histogram(geometry);
  const auto ask = [&](CandidateKind kind) -> std::vector<Candidate> {
    switch (kind) {
      case CandidateKind::user:     // asked below, listed or not
      case CandidateKind::refined:  // a sweep makes these
        return {};
      case CandidateKind::axis:
        return coordinate_axis_candidates();
      case CandidateKind::revolution:
        return has_area ? revolution_candidates(geometry, model.adjacency, options.most_per_kind)
                        : std::vector<Candidate>();
      case CandidateKind::plane:
        return plane_candidates(cells, geometry.total_area, options.most_per_kind);
      case CandidateKind::perpendicular:
        return perpendicular_candidates(cells, geometry.total_area, options.most_per_kind);
      case CandidateKind::hull:
        return hull_candidates(model.part.mesh, options.most_per_kind, progress);
      case CandidateKind::principal:
        return principal_axis_candidates(model.part.mesh, geometry);
      case CandidateKind::uniform:
        return uniform_candidates(options.uniform_count);
    }
    return {};
  };

  std::vector<Candidate> all = user_candidates(options.user);
  if (has_area) {
    std::ranges::copy_if(canonical_candidates(model), std::back_inserter(all), [&](const Candidate& each) {
      return std::ranges::find(options.kinds, each.kind()) != options.kinds.end();
    });
  }
  for (std::size_t i = 0; i < options.kinds.size(); ++i) {
    progress.report("candidates", static_cast<double>(i) / static_cast<double>(options.kinds.size()));
    std::vector<Candidate> found = ask(options.kinds[i]);
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  progress.report("candidates", 1.0);
  return merge_candidates(std::move(all), options.merge_deg);
}

}  // namespace moldlight
