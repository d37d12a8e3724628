#include "gui/view/scene.hpp"

#include <algorithm>

#include "classify/classifier.hpp"

namespace moldlight::gui {

constexpr double k_fill = 0.92;  // of the free area

Scene::Scene(const gl::Context& context, const LoadedPart& part)
    : context_(&context),
      part_(part),
      maps_(context, part.model),
      view_(context.functions(), *part.geometry),
      shown_(part.geometry),
      tools_(context.functions()),
      sections_(part.model->part.mesh, part.model->frame) {
  view_.set_faces(part_.faces->of_facet);
}

bool Scene::draw(const ViewTarget& target, const SceneSettings& settings) {
  const Query& query = settings.query;
  const MethodSettings& method = query.method;
  const MapInputs inputs{.direction = query.direction.unit(),
                         .tau_deg = method.tau_deg,
                         .settings = map_settings(method, part_.model->frame.diagonal)};
  if (settings.split != split_) {
    split_ = settings.split;
    split_ ? maps_.take_split(*split_, *shown_, query) : maps_.drop_split();
  }
  // Coarse maps do until the split mesh is there, which comes at once.
  const bool fine = settings.maps_looked_at && !settings.direction_moves;
  if (maps_of_ != inputs || (fine && maps_are_coarse_)) {
    fine ? maps_.draw_resting(query) : maps_.draw_moving(query);
    maps_of_ = inputs;
    maps_are_coarse_ = !fine;
    thumbnails_stale_ = true;
  }
  if (fine && settings.samples) compare_with(settings.samples);
  if (settings.view.settings.parting_line) find_parting_line();
  drawn_ = true;
  View view = settings.view;
  view.body_motions = settings.bodies;
  return view_.draw(target, maps_.subject(), view);
}

void Scene::compare_with(const std::shared_ptr<const PieceSamples>& samples) {
  const std::uint64_t revision = maps_.maps().revision();
  if (compared_samples_ == samples && compared_maps_ == revision) return;
  if (!sample_pass_) sample_pass_.emplace(context_->functions());
  comparison_ = std::make_shared<const MapComparison>(
      compare_maps(*samples, sample_pass_->run(samples->samples, maps_.maps())));
  compared_samples_ = samples;
  compared_maps_ = revision;
}

void Scene::find_parting_line() {
  if (parting_line_of_ == split_) return;
  view_.set_parting_line(split_ ? parting_line(*split_, part_.model->frame) : std::vector<ViewSegment>());
  parting_line_of_ = split_;
}

void Scene::mark_blocking(const std::optional<std::uint32_t>& face) {
  std::vector<ViewSegment> outline;
  std::vector<ViewVertex> vertices;
  std::vector<std::array<VertexIndex, 3>> triangles;
  if (face) {
    outline = outline_of(*part_.model, *part_.faces, *face);
    for (const FacetIndex facet : part_.faces->facets(*face)) {
      const auto first = static_cast<VertexIndex>(vertices.size());
      triangles.push_back({first, first + 1, first + 2});
      for (const VertexIndex corner : part_.geometry->facets[facet])
        vertices.push_back(part_.geometry->vertices[corner]);
    }
  }
  view_.set_marked_lines(MarkedLines::blocking, outline);
  view_.set_veiled_surface(vertices, triangles);
}

void Scene::hide(const std::set<std::size_t>& bodies) {
  std::vector<std::uint8_t> hidden(part_.geometry->facets.size(), 0);
  for (const std::size_t k : bodies) {
    const Body& body = part_.model->part.bodies[k];
    std::fill_n(hidden.begin() + body.first_facet, body.facet_count, std::uint8_t{1});
  }
  shown_ = bodies.empty() ? part_.geometry
                          : std::make_shared<const ViewGeometry>(shown_part(*part_.geometry, hidden));
  view_.set_geometry(*shown_);
  split_.reset();  // to be taken anew
}

void Scene::mark_faces(std::span<const std::uint32_t> faces) {
  std::vector<ViewSegment> outlines;
  for (const std::uint32_t face : faces) {
    const std::vector<ViewSegment> outline = outline_of(*part_.model, *part_.faces, face);
    outlines.insert(outlines.end(), outline.begin(), outline.end());
  }
  view_.set_marked_lines(MarkedLines::chosen, outlines);
}

void Scene::explain(const std::optional<Blocker>& blocker, const std::optional<CutSpan>& span) {
  if (blocker == blocker_ && span == span_) return;
  const auto face = [&](const std::optional<Blocker>& of) {
    return of ? std::optional(part_.faces->of_facet[of->facet]) : std::nullopt;
  };
  if (face(blocker) != face(blocker_)) mark_blocking(face(blocker));
  std::vector<ViewSegment> ways;
  if (blocker) ways.push_back({blocker->from, blocker->at});
  if (span) ways.push_back({span->start, span->end});
  view_.set_marked_lines(MarkedLines::ways, ways);
  blocker_ = blocker;
  span_ = span;
}

void Scene::take_bodies(const Bodies& bodies) {
  if (bodies == bodies_) return;
  bodies_ = bodies;
  view_.set_bodies(bodies ? std::span<const ViewBody>(*bodies) : std::span<const ViewBody>());
}

void Scene::take_mold(const ShownMold& mold) {
  if (mold == mold_) return;
  if (mold.solids != mold_.solids) {
    view_.set_steel(mold.solids ? std::span(mold.solids->shown) : std::span<const ViewSolid>());
    ++steel_;
  }
  std::vector<ViewSegment> line, chosen;
  for (std::size_t k = 0; mold.line && k < mold.line->loops.size(); ++k) {
    // What side actions form among themselves is not where the halves meet.
    const bool here = mold.loop == k;
    if (!here && mold.line->line.loops[k].kind == LoopKind::action) continue;
    const std::vector<ViewSegment>& loop = mold.line->loops[k];
    (here ? chosen : line).insert((here ? chosen : line).end(), loop.begin(), loop.end());
  }
  view_.set_tube(line, chosen);
  mold_ = mold;
}

MapTextures Scene::map_pictures(int size_px) {
  if (!maps_of_) return {};
  if (!plus_ || plus_->size().x != size_px) {
    plus_.emplace(context_->functions(), glm::ivec2(size_px));
    minus_.emplace(context_->functions(), glm::ivec2(size_px));
    thumbnails_stale_ = true;
  }
  if (thumbnails_stale_) {
    maps_.complete_depths();
    draw_map(tools_, {plus_->framebuffer(), plus_->size()}, maps_.maps(), true);
    draw_map(tools_, {minus_->framebuffer(), minus_->size()}, maps_.maps(), false);
    thumbnails_stale_ = false;
  }
  return {plus_->texture(), minus_->texture()};
}

Camera fitted_to(const Camera& camera, std::span<const glm::vec3> points, const FreeArea& area) {
  const glm::ivec2 free = glm::max(area.max - area.min, glm::ivec2(64));
  Camera fit = fitted(camera, points, free, k_fill);
  // The free area's picture, seen as a part of the window's.
  const double pixel = fit.height / free.y;
  const glm::dvec2 offset = 0.5 * glm::dvec2(area.min + area.max - area.window) * pixel;
  fit.height = pixel * area.window.y;
  fit.target += offset.y * fit.up() - offset.x * fit.right();
  return fit;
}

}  // namespace moldlight::gui
