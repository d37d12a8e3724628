#include "study/verdict_surface.hpp"

#include <algorithm>
#include <set>

#include "mesh/health.hpp"

namespace moldlight {

namespace {

using Of = Subject::Of;

/// Whether the subject is among undercuts of this kind; `of`: what a plan says of the piece.
bool is_of(Of subject, std::int32_t of) {
  if (subject == Of::tiny) return of == k_no_action_of_piece;
  return subject == Of::unreleased ? of == k_unreleased_piece : of != k_no_action_of_piece;
}

void add_facet(SplitMesh& surface, const TriangleMesh& mesh, FacetIndex facet) {
  surface.pieces.push_back({mesh.facets[facet], facet, Region::undercut});
}

SubjectSurface surface_at_edges(const TriangleMesh& mesh, EdgeDefect defect) {
  SubjectSurface found{.mesh = {.vertices = mesh.vertices, .pieces = {}}, .edges = {}};
  const std::vector<EdgeChain> chains = defect_chains(mesh, defect);
  for (const EdgeChain& chain : chains)
    for (std::size_t k = 0; k < chain.edge_count(); ++k)
      found.edges.emplace_back(
          std::minmax(chain.vertices[k], chain.vertices[(k + 1) % chain.vertices.size()]));
  if (chains.empty()) return found;
  add_facet(found.mesh, mesh, chains.front().facet);
  const std::set edges(found.edges.begin(), found.edges.end());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const auto& [a, b, c] = mesh.facets[facet];
    if (edges.contains(std::minmax(a, b)) || edges.contains(std::minmax(b, c)) ||
        edges.contains(std::minmax(c, a)))
      add_facet(found.mesh, mesh, facet);
  }
  return found;
}

SubjectSurface surface_at_crossings(const PartModel& model) {
  const TriangleMesh& mesh = model.part.mesh;
  SubjectSurface found{.mesh = {.vertices = mesh.vertices, .pieces = {}}, .edges = {}};
  const ExactPart& exact = model.exact(Progress());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet)
    if (!exact.crossings(facet).empty()) add_facet(found.mesh, mesh, facet);
  return found;
}

}  // namespace

SubjectSurface surface_of(const Subject& subject, const PartModel& model, const SplitMesh* split,
                          const ActionPlan* plan) {
  if (subject.of == Of::open_edges) return surface_at_edges(model.part.mesh, EdgeDefect::open);
  if (subject.of == Of::turned_edges) return surface_at_edges(model.part.mesh, EdgeDefect::inconsistent);
  if (subject.of == Of::crossings) return surface_at_crossings(model);
  const bool region = subject.of == Of::region;
  if (split == nullptr) return {};
  if (!region && (plan == nullptr || plan->action_of_piece.size() != split->pieces.size())) return {};
  SubjectSurface found{.mesh = {.vertices = split->vertices, .pieces = {}}, .edges = {}};
  for (std::size_t k = 0; k < split->pieces.size(); ++k) {
    SplitPiece piece = split->pieces[k];
    if (piece.region != subject.region || !(region || is_of(subject.of, plan->action_of_piece[k]))) continue;
    piece.region = Region::undercut;
    found.mesh.pieces.push_back(piece);
  }
  return found;
}

std::optional<std::size_t> least_released(const ActionPlan& plan) {
  if (plan.unreleased.empty()) return std::nullopt;
  const auto most = std::ranges::max_element(plan.unreleased_areas);
  return plan.unreleased[static_cast<std::size_t>(most - plan.unreleased_areas.begin())];
}

}  // namespace moldlight
