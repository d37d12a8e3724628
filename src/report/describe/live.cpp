// Reports whose page finds the regions of any direction by itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "classify/classifier.hpp"
#include "classify/picture_maps.hpp"
#include "mesh/coarsened.hpp"
#include "mold/direction.hpp"
#include "mold/direction_field.hpp"
#include "mold/draft.hpp"
#include "mold/map_frame.hpp"
#include "mold/measure.hpp"
#include "mold/surface_samples.hpp"
#include "render/readout_passes.hpp"
#include "report/describe/parts.hpp"
#include "sweep/sample_rays.hpp"

namespace moldlight::report {

namespace {

/// What a page offers, beside the resolution that was asked for.
constexpr std::array k_resolutions = {512, 1024, 2048};
/// What was measured is an example: the next direction may be worse by this much, and samples are never all
/// of the surface.
constexpr double k_margin = 2.0, k_sampling_share = 5e-4;

/// Diagonals between two and three axes, and directions that are none of these.
constexpr glm::dvec3 k_oblique[] = {{1, 1, 0},  {0, 1, -1},         {1, 0, 1},          {1, 1, 1},
                                    {1, -1, 1}, {0.35, 0.05, 0.95}, {-0.1, 0.97, 0.25}, {0.9, 0.3, -0.2}};

/// The axes and the direction shown, and beside each of them those along which its walls have tau or a little
/// more draft: there maps are at their worst, as a texel spans much of a wall's height. Then the oblique
/// ones.
std::vector<glm::dvec3> measured_directions(const glm::dvec3& shown, double tau_deg) {
  constexpr double k_least_tau_deg = 0.5;
  // Leans towards the two other axes, in tau.
  constexpr glm::dvec2 k_leans[] = {{1.0, 0.0}, {0.0, 1.0}, {1.8, 0.6}, {0.6, 1.8}, {3.0, 0.0}, {0.0, -3.0}};
  const MapFrame frame = map_frame(shown);
  std::vector<glm::dmat3> bases = {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                   {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                   {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (!nearest_axis(shown).is_met()) bases.push_back({frame.x, frame.y, frame.z});
  std::vector<glm::dvec3> directions(std::begin(k_oblique), std::end(k_oblique));
  const double tau = glm::radians(std::max(tau_deg, k_least_tau_deg));
  for (const glm::dmat3& base : bases) {
    directions.push_back(base[2]);
    for (const glm::dvec2& lean : k_leans)
      directions.push_back(base[2] + std::tan(lean.x * tau) * base[0] + std::tan(lean.y * tau) * base[1]);
  }
  return directions;
}

double greatest_difference(const RegionValues& found, const RegionValues& exact) {
  double greatest = 0.0;
  for (const Region region : k_regions)
    greatest = std::max(greatest, std::abs(found[region] - exact[region]));
  return greatest;
}

RegionValues areas_of(const std::vector<std::uint8_t>& verdicts, double total_area) {
  SampleCounts counts;
  for (const std::uint8_t verdict : verdicts)
    ++counts.regions[static_cast<std::size_t>(verdict_region(verdict))];
  return counts.areas(total_area);
}

/// Gives samples whose verdict is in doubt that of exact rays.
void settle_by_rays(const PartModel& model, const Query& query, const std::vector<SurfaceSample>& samples,
                    std::vector<std::uint8_t>& verdicts) {
  const glm::dvec3 direction = query.direction.unit();
  SampleRays rays;
  rays.begin({direction, lateral_tolerance(query.method, model.frame.diagonal) / model.frame.diagonal});
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if ((verdicts[k] & k_doubtful) == 0) continue;
    const glm::dvec3& normal = model.geometry.normals[samples[k].facet];
    rays.add(k, samples[k].position, normal, facet_class(normal, direction, query.method.tau_deg));
  }
  rays.ask(model.rays());
  rays.for_each([&verdicts](std::size_t k, bool plus, bool minus, float) {
    verdicts[k] = static_cast<std::uint8_t>((plus ? verdict::k_accessible_plus : 0) |
                                            (minus ? verdict::k_accessible_minus : 0));
  });
}

/// What the page draws: the part, or a coarser one of its shape, whose error is in the measured ones, too.
std::shared_ptr<const PartModel> drawn_part(const ReportContext& context) {
  const Part& part = context.model->part;
  if (part.mesh.facets.size() <= context.most_live_facets) return context.model;
  Part coarse;
  coarse.file = part.file;
  coarse.unit = part.unit;
  coarse.mesh = coarsened(part.mesh, context.most_live_facets, context.progress);
  coarse.bodies = {{"", 0, static_cast<FacetIndex>(coarse.mesh.facets.size())}};
  return prepare_part(std::move(coarse), context.progress);
}

void measure_errors(const ReportContext& context, const std::shared_ptr<const PartModel>& drawn,
                    const std::vector<LiveDirection>& known, LiveView& live) {
  const PartModel& model = *drawn;
  const double total_area = model.geometry.total_area;
  std::set<int> resolutions(k_resolutions.begin(), k_resolutions.end());
  resolutions.insert(live.method.resolution);
  for (const int resolution : resolutions) live.errors.push_back({resolution});
  PictureMaps maps(*context.gl, drawn);
  const SurfaceSamples samples =
      sample_surface_evenly(model.part.mesh, model.geometry, model.frame, k_live_samples);
  SamplePass pass(context.gl->functions());
  std::vector<LiveDirection> directions = known;
  for (const glm::dvec3& direction : measured_directions(known.front().direction, live.method.tau_deg))
    directions.push_back({"", direction, {}});
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const Query query{directions[k].direction, live.method};
    if (k >= known.size())
      directions[k].areas = classify_exact(*context.model, query, Progress(&context.progress)).areas;
    for (LiveError& error : live.errors) {
      context.progress.report("measuring the maps",
                              static_cast<double>(k) / static_cast<double>(directions.size()));
      maps.draw_quickly(page_query(model, query, error.resolution));
      std::vector<std::uint8_t> verdicts = pass.run(samples.samples, maps.maps(), Doubt::marked);
      const auto off = [&] {
        return greatest_difference(areas_of(verdicts, total_area), directions[k].areas) / total_area;
      };
      error.moving = std::max(error.moving, off());
      settle_by_rays(model, query, samples.samples, verdicts);
      error.resting = std::max(error.resting, off());
    }
  }
  for (LiveError& error : live.errors)
    for (double* share : {&error.moving, &error.resting}) *share = k_margin * *share + k_sampling_share;
  live.measured = directions.size();
}

}  // namespace

Image sphere_texture(const UndercutField& field) {
  constexpr int k_size = 128;
  constexpr double k_radius = 0.46,
                   k_beyond = 1.06;  // as in shaders/page/ball.frag; a little of what lies below
  Image image{k_size, k_size, std::vector<unsigned char>(4 * k_size * k_size)};
  for (int y = 0; y < k_size; ++y) {
    for (int x = 0; x < k_size; ++x) {
      const glm::dvec2 point = (glm::dvec2(x + 0.5, y + 0.5) / static_cast<double>(k_size) - 0.5) / k_radius;
      if (glm::length(point) > k_beyond) continue;
      const DirectionField::Reading reading = field.areas.at(glm::normalize(equal_area_direction(point)));
      const Colour colour = undercut_scale_colour(undercut_scale(reading.value, field.worst));
      unsigned char* pixel = &image.rgba[4 * static_cast<std::size_t>(y * k_size + x)];
      pixel[0] = colour.r;
      pixel[1] = colour.g;
      pixel[2] = colour.b;
      pixel[3] = static_cast<unsigned char>(std::lround(255.0 * reading.cover));
    }
  }
  return image;
}

Query page_query(const PartModel& model, const Query& query, int resolution) {
  constexpr double k_least_lateral_texels = 0.71, k_rim_texels = 8.0;  // as in page/files/live_maps.js
  const MapFrame frame = map_frame(query.direction.unit());
  const glm::dvec3 half = 0.5 * (model.health.bounds.max - model.health.bounds.min) / model.frame.diagonal;
  const double across = 2.0 * std::max(glm::dot(glm::abs(frame.x), half), glm::dot(glm::abs(frame.y), half));
  const double side = across / (1.0 - k_rim_texels / resolution);
  Query page = query;
  page.method.resolution = static_cast<int>(std::clamp(std::lround(resolution / side), 64L, 8192L));
  page.method.tolerance =
      model.frame.diagonal *
      std::max(lateral_tolerance(query.method, model.frame.diagonal) / model.frame.diagonal,
               k_least_lateral_texels * side / resolution);
  page.method.kernel = 0;
  page.method.kernel_shape = KernelShape::one_sided;
  return page;
}

void add_live(const ReportContext& context, const Classification& shown, std::vector<LiveDirection> known,
              Report& report) {
  if (!context.live || !context.drawn()) return;
  const PartModel& model = *context.model;
  const std::shared_ptr<const PartModel> drawn = drawn_part(context);
  if (drawn != context.model)
    report.live_notice = fmt::format(
        "Along directions other than the report's the page draws a coarser mesh of {} facets; the part has "
        "{}. The stated ± has its error, too.",
        drawn->part.mesh.facets.size(), model.part.mesh.facets.size());
  const FigureStyle style(model);
  LiveView live;
  live.mesh = drawn->part.mesh;
  live.centre = drawn->frame.center;
  live.diagonal = drawn->frame.diagonal;
  live.total_area = drawn->geometry.total_area;
  live.length_unit = style.unit(FigureKind::length);
  live.area_unit = style.unit(FigureKind::area);
  live.method = shown.settings;
  live.method.readout = Readout::exact;
  live.lateral = shown.lateral_tolerance / live.diagonal;
  if (shown.settings.readout != Readout::exact)
    known.front().areas =
        classify_exact(model, {shown.direction, live.method}, Progress(&context.progress)).areas;
  measure_errors(context, drawn, known, live);
  live.known = std::move(known);
  report.live = std::move(live);
}

}  // namespace moldlight::report
