#include "parting/mold_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "actions/actions_files.hpp"
#include "base/error.hpp"
#include "classify/number_format.hpp"
#include "io/mesh_writer.hpp"
#include "mesh/edge_collapse.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/flat_faces.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/exact/exact_regions.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/halves/tidy_solid.hpp"

namespace moldlight {

namespace {

namespace fs = std::filesystem;

constexpr double k_most_written_fold = 1e-8;  // of the block's rectangle
/// So many steps of rounding may a surface move where needles are taken out of it.
constexpr double k_rounding_steps = 2.0;

/// Rounded to single precision, with equal vertices joined and facets gone that have two of one.
TriangleMesh rounded(const TriangleMesh& mesh, const auto& place) {
  TriangleMesh result;
  std::map<std::array<float, 3>, VertexIndex> known;
  std::vector<VertexIndex> becomes;
  becomes.reserve(mesh.vertices.size());
  for (const glm::dvec3& vertex : mesh.vertices) {
    const glm::dvec3 at = place(vertex);
    const std::array<float, 3> key = {static_cast<float>(at.x) + 0.0F, static_cast<float>(at.y) + 0.0F,
                                      static_cast<float>(at.z) + 0.0F};
    const auto [entry, fresh] = known.try_emplace(key, static_cast<VertexIndex>(result.vertices.size()));
    if (fresh) result.vertices.emplace_back(key[0], key[1], key[2]);
    becomes.push_back(entry->second);
  }
  for (const auto& facet : mesh.facets) {
    const std::array<VertexIndex, 3> corners = {becomes[facet[0]], becomes[facet[1]], becomes[facet[2]]};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      result.facets.push_back(corners);
  }
  return result;
}

bool in_lid(const TriangleMesh& mesh, FacetIndex facet, const glm::dvec3& lid, double top) {
  for (int c = 0; c < 3; ++c) {
    if (glm::dot(mesh.corner(facet, c), lid) != top) return false;
  }
  return true;
}

/// What of a half faces along its pull and is not its lid, and what its facets do not cover, seen along
/// `up`; as a share of the rectangle.
double fold_of(const TriangleMesh& mesh, const glm::dvec3& lid, double rectangle) {
  double facing = 0.0, away = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const double seen = 0.5 * glm::dot(lid, twice_area_vector(mesh, facet));
    (seen > 0.0 ? facing : away) += std::abs(seen);
  }
  return std::max(std::abs(facing - rectangle), std::abs(away - rectangle)) / rectangle;
}

/// The middle of the facet by which a half folds over itself most, seen along its pull.
glm::dvec3 folded_at(const TriangleMesh& mesh, const glm::dvec3& lid, double top) {
  double most = -INFINITY;
  glm::dvec3 place(0.0);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const double seen = glm::dot(lid, twice_area_vector(mesh, facet));
    if (seen <= most || in_lid(mesh, facet, lid, top)) continue;
    most = seen;
    place = mesh.middle(facet);
  }
  return place;
}

/// Share of a half's area that leans along its pull although it is not the lid.
double leaning_of(const TriangleMesh& mesh, const glm::dvec3& lid, double top) {
  double leaning = 0.0, all = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3 normal = twice_area_vector(mesh, facet);
    const double area = glm::length(normal);
    all += area;
    const bool leans = glm::dot(normal, lid) > k_leaning_sine * area;
    if (leans && !in_lid(mesh, facet, lid, top)) leaning += area;
  }
  return all > 0.0 ? leaning / all : 0.0;
}

/// The way up in the frame of the files.
glm::dvec3 written_up(const MoldHalves& halves, const WrittenMold& mold) {
  return mold.part_frame ? halves.frame.z : glm::dvec3(0.0, 0.0, 1.0);
}
/// A half's pull, in that frame; none of the other bodies.
glm::dvec3 written_pull(const MoldHalves& halves, const WrittenMold& mold, std::size_t body) {
  const double sign = body == 0 ? 1.0 : body == 1 ? -1.0 : 0.0;
  return sign * written_up(halves, mold);
}

MoldBody& body_of(MoldHalves& halves, std::size_t number) {
  return number == 0 ? halves.core : number == 1 ? halves.cavity : halves.inserts[number - 2];
}

/// From the bodies' frame to that of the files.
glm::dvec3 written_place(const MoldHalves& halves, bool part_frame, const glm::dvec3& at) {
  return part_frame ? halves.scale * halves.centre + halves.frame.to_part(at) : at;
}

/// A body as it is written; an open edge, if it has one.
WrittenBody written_body(const MoldHalves& halves, const MoldBody& body, const WrittenMold& mold,
                         const glm::dvec3& pull, std::optional<glm::dvec3>& open_at) {
  const auto place = [&](const glm::dvec3& at) { return written_place(halves, mold.part_frame, at); };
  WrittenBody written{
      .name = body.name, .file = {}, .mesh = rounded(body.mesh, place), .volume = body.volume};
  tidy_solid(written.mesh, {.tolerance = k_rounding_steps * rounding_step(written.mesh), .pull = pull});
  const BodyCheck check = check_body(written.mesh.vertices, written.mesh.facets);
  written.closed = check.open_edges == 0;
  if (check.open_at) open_at = check.open_at;
  if (written.closed) written.nonmanifold_edges = split_touching(written.mesh);
  return written;
}

std::string fill(WrittenMold& mold, const MoldHalves& halves, bool part_frame) {
  mold.part_frame = part_frame;
  mold.bodies.clear();
  mold.surface = halves.surface_mesh;
  for (glm::dvec3& vertex : mold.surface.vertices) vertex = written_place(halves, part_frame, vertex);
  const glm::dvec3 up = written_up(halves, mold);
  std::optional<glm::dvec3> open_at;
  const auto in_part = [&](const glm::dvec3& at) { return place_in_part(halves, mold, at); };
  const auto add = [&](const MoldBody& body) {
    mold.bodies.push_back(
        written_body(halves, body, mold, written_pull(halves, mold, mold.bodies.size()), open_at));
  };
  add(halves.core);
  add(halves.cavity);
  std::ranges::for_each(halves.inserts, add);
  for (std::size_t k = 0; k < 2; ++k) {
    // As large as the lid, rounded as it is.
    WrittenBody& half = mold.bodies[k];
    const glm::dvec3 lid = k == 0 ? up : -up;
    double top = -INFINITY;
    for (const glm::dvec3& v : half.mesh.vertices) top = std::max(top, glm::dot(v, lid));
    double rectangle = 0.0;
    for (FacetIndex facet = 0; facet < half.mesh.facets.size(); ++facet) {
      if (in_lid(half.mesh, facet, lid, top))
        rectangle += 0.5 * glm::dot(lid, twice_area_vector(half.mesh, facet));
    }
    half.undercut = rectangle > 0.0 ? fold_of(half.mesh, lid, rectangle) : 1.0;
    half.leaning = leaning_of(half.mesh, lid, top);
    if (half.undercut > k_most_written_fold) {
      mold.refused_at = in_part(folded_at(half.mesh, lid, top));
      return fmt::format("in single precision {} of the {} would fold over itself", error_text(half.undercut),
                         half.name);
    }
  }
  for (const WrittenBody& body : mold.bodies) {
    if (body.closed) continue;
    mold.refused_at = in_part(*open_at);
    return fmt::format("in single precision the {} would not be closed", body.name);
  }
  mold.refused_at.reset();
  return {};
}

}  // namespace

glm::dvec3 place_in_part(const MoldHalves& halves, const WrittenMold& mold, const glm::dvec3& at) {
  return mold.part_frame ? at / halves.scale : halves.centre + halves.frame.to_part(at) / halves.scale;
}

bool hides_itself(const MoldHalves& halves, const Progress& progress) {
  constexpr double k_most_hidden = 1e-6, k_hair = 1e-6, k_upright_deg = 0.01;
  for (std::size_t k = 0; k < 2; ++k) {
    const TriangleMesh& half = halves.written.bodies[k].mesh;
    const FacetGeometry geometry = facet_geometry(half);
    const ExactPart part(half, geometry, unit_frame(bounds(half)), progress);
    const ExactAreas found = exact_areas(
        part, {.direction = written_up(halves, halves.written), .tau_deg = k_upright_deg, .lateral = k_hair},
        progress);
    if (found.areas[Region::undercut] > k_most_hidden * geometry.total_area) return true;
  }
  return false;
}

WrittenMold written_mold(const MoldHalves& halves) {
  WrittenMold mold;
  if (!halves.made()) {
    mold.refusal = halves.refusal;
    mold.refused_at = halves.refused_at;
    return mold;
  }
  if (axis_of(halves.frame.z) >= 0 && fill(mold, halves, true).empty()) return mold;
  mold.refusal = fill(mold, halves, false);
  return mold;
}

std::size_t mend_crossed(MoldHalves& halves, std::size_t number, double thinnest, const Progress& progress) {
  // Of the thinnest facet: edges of an insert that are shorter are rounding.
  constexpr double k_short_edges[] = {10.0, 100.0};
  TriangleMesh& mesh = halves.written.bodies[number].mesh;
  MoldBody& body = body_of(halves, number);
  std::vector<FacetIndex> crossed = crossed_facets(mesh, progress);
  std::size_t mended = 0;
  if (!crossed.empty()) {
    TriangleMesh before = mesh;
    std::vector<FacetIndex> left = uncross(mesh,
                                           {.tolerance = k_rounding_steps * rounding_step(mesh),
                                            .pull = written_pull(halves, halves.written, number)},
                                           crossed, progress);
    // What is mended must not become needles.
    if (find_needles(mesh, thinnest).count > find_needles(before, thinnest).count) {
      mesh = std::move(before);
    } else {
      mended = crossed.size() - std::min(crossed.size(), left.size());
      crossed = std::move(left);
    }
  }
  for (const double length : k_short_edges) {
    if (crossed.empty() || number < 2) break;
    TriangleMesh shorter = mesh;
    collapse_short_edges(shorter, length * thinnest);
    if (!crossed_facets(shorter, progress).empty()) continue;
    mended += crossed.size();
    mesh = std::move(shorter);
    crossed.clear();
  }
  body.crossed_facets = crossed.size();
  if (!crossed.empty())
    body.crossed_at = place_in_part(halves, halves.written, mesh.corner(crossed.front(), 0));
  return mended;
}

bool put_body(MoldHalves& halves, std::size_t number, MoldBody body, double thinnest,
              const Progress& progress) {
  std::optional<glm::dvec3> open_at;
  WrittenBody written =
      written_body(halves, body, halves.written, written_pull(halves, halves.written, number), open_at);
  if (!written.closed) return false;
  body.thinnest = thinnest_of(body.mesh);
  if (number < 2) {
    const WrittenBody& known = halves.written.bodies[number];
    written.undercut = known.undercut;
    written.leaning = known.leaning;
    body.nonmanifold_edges = written.nonmanifold_edges;
    body.needles = find_needles(written.mesh, thinnest).count;
  } else if (number - 2 == halves.inserts.size()) {
    halves.inserts.emplace_back();
    halves.written.bodies.emplace_back();
  }
  MoldBody& place = body_of(halves, number);
  std::swap(place, body);
  std::swap(halves.written.bodies[number], written);
  mend_crossed(halves, number, thinnest, progress);
  if (place.crossed_facets == 0) return true;
  std::swap(place, body);
  std::swap(halves.written.bodies[number], written);
  if (place.mesh.facets.empty()) {
    halves.inserts.pop_back();
    halves.written.bodies.pop_back();
  }
  return false;
}

void set_in_order(MoldHalves& put) {
  std::vector<std::size_t> order(put.inserts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return put.inserts[k].kind; });
  std::vector<MoldBody> bodies;
  std::vector<WrittenBody> written = {put.written.bodies[0], put.written.bodies[1]};
  for (const std::size_t k : order) {
    bodies.push_back(std::move(put.inserts[k]));
    written.push_back(std::move(put.written.bodies[k + 2]));
  }
  put.inserts = std::move(bodies);
  put.written.bodies = std::move(written);
  std::size_t loose = 0;
  for (std::size_t k = 0; k < put.inserts.size(); ++k) {
    if (put.inserts[k].kind != PieceKind::insert) continue;
    put.inserts[k].name = put.written.bodies[k + 2].name = fmt::format("insert_{}", ++loose);
  }
}

void write_mold(const std::string& folder, const MoldFileSettings& settings, const std::string& unit,
                WrittenMold& mold) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, "", "cannot be made a folder: " + error.message());
  std::vector<NamedSolid> solids;
  for (WrittenBody& body : mold.bodies) {
    body.file = (fs::path(folder) / (body.name + ".stl")).string();
    write_solid_stl(body.file, body.mesh, unit);
    const std::size_t k = solids.size();
    solids.push_back(
        {body.name, &body.mesh,
         k < 2 ? region_colour(region_of(k_mold_sides[k]), Palette::paper) : action_colour(k - 2)});
  }
  if (settings.as_3mf) write_solids_3mf((fs::path(folder) / "mold.3mf").string(), solids, unit);
  if (settings.as_step) {
    if (!mold.surface.facets.empty())
      solids.push_back({.name = "parting_surface", .mesh = &mold.surface, .closed = false});
    write_solids_step((fs::path(folder) / "mold.step").string(), "mold", solids, unit);
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().stem().string();
    const bool numbered = name.find_last_not_of("0123456789_") == name.find('_') - 1;
    const bool ours = std::ranges::any_of(
        std::array{"slide_", "lifter_", "insert_", "piece_", "left_"}, [&](const char* kind) {
          return numbered && name.starts_with(kind) && entry.path().extension() == ".stl";
        });
    if (!ours || std::ranges::find(mold.bodies, name, &WrittenBody::name) != mold.bodies.end()) continue;
    fs::remove(entry.path(), error);
    if (error)
      throw FileError(entry.path().string(), "", "is out of date and cannot be removed: " + error.message());
  }
}

std::vector<StepSurface> parting_surfaces(const PartModel& model, const MoldHalves& halves) {
  constexpr double k_flat = 1e-7;  // of the part's diagonal
  const double mm = mm_per_unit(model.part.unit), bend = k_flat * model.frame.diagonal;
  TriangleMesh mesh = in_part(halves, halves.surface_mesh);
  collapse_short_edges(mesh, bend);
  const FlatFaces flat = flat_faces(mesh, bend);
  std::vector<std::size_t> order(flat.shells.size()), place(flat.shells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(),
                           [&](std::size_t shell) { return flat.shells[shell].bounds.diagonal(); });
  std::vector<StepSurface> surfaces;
  for (const std::size_t shell : order) {
    place[shell] = surfaces.size();
    surfaces.push_back({.name = fmt::format("parting surface {}", surfaces.size() + 1),
                        .faces = {},
                        .tolerance = mm * bend});
  }
  const auto point = [](const glm::dvec3& at) { return StepSurface::Point{at.x, at.y, at.z}; };
  for (const FlatFaces::Face& face : flat.faces) {
    StepSurface::Face made{point(mm * face.point), point(face.normal), {}};
    for (const FlatFaces::Loop& loop : face.loops) {
      auto& points = made.loops.emplace_back();
      for (const FlatFaces::Use& use : loop) {
        const FlatFaces::Edge& edge = flat.edges[use.edge];
        points.push_back(point(mm * mesh.vertices[use.backwards ? edge.to : edge.from]));
      }
    }
    surfaces[place[face.shell]].faces.push_back(std::move(made));
  }
  return surfaces;
}

}  // namespace moldlight
