// The scan converter's maps against those of the GL, texel by texel, and what is looked up in both.
#include "mold/second_depth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "render/readout_passes.hpp"
#include "support/classify_mesh.hpp"
#include "support/map_lookup.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

/// Both snap corners to 1/256 of a texel after roundings of their own.
constexpr double k_edge_rounding = 1.0 / 64.0;  // texels
constexpr double k_depth_rounding = 1e-6;  // unit frame, more on slopes: k_edge_rounding of a texel aside
constexpr double k_most_differing = 3e-4;  // of the covered texels
constexpr double k_most_other_verdicts = 5e-4;  // of the samples

std::vector<glm::dvec3> directions() {
  return {{1, 0, 0}, {0, 0, 1}, {0.36, 0.48, 0.8}, {-0.61, 0.17, 0.25}, {0.002, -0.001, -1}};
}

/// A part drawn by both.
class BothMaps {
 public:
  explicit BothMaps(std::shared_ptr<const PartModel> model)
      : model_(std::move(model)), classifier_(test::shared_context(), model_) {}

  void draw(const Query& query) {
    query_ = query;
    classifier_.draw_maps(query);
    scan_.emplace(model_, query);
  }

  struct Comparison {
    std::size_t covered = 0, differing = 0;
    std::vector<std::string> unexplained;
  };
  [[nodiscard]] Comparison compare() const;

  struct Verdicts {
    std::size_t samples = 0, other = 0;
  };
  /// Looks surface samples up in either maps.
  [[nodiscard]] Verdicts compare_verdicts(SamplePass& pass) const;

 private:
  [[nodiscard]] bool is_explained(int x, int y, std::uint32_t gl_entry, std::uint32_t scan_entry) const;
  [[nodiscard]] bool is_near_edge(FacetIndex facet, double x, double y) const;

  std::shared_ptr<const PartModel> model_;
  Classifier classifier_;
  std::optional<test::ScannedMaps> scan_;
  Query query_;
};

/// True if an edge of the facet passes within rounding of the texel's centre.
bool BothMaps::is_near_edge(FacetIndex facet, double x, double y) const {
  const MapFrame& frame = scan_->frame;
  const double size = query_.method.resolution;
  glm::dvec2 corners[3];
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 p(model_->frame.to_unit(model_->part.mesh.corner(facet, k)));
    corners[k] = {(glm::dot(p, frame.x) + 0.5) * size, (glm::dot(p, frame.y) + 0.5) * size};
  }
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 from = corners[k], along = corners[(k + 1) % 3] - from,
                     to = glm::dvec2(x + 0.5, y + 0.5) - from;
    const double length = glm::dot(along, along);
    const double at = length > 0.0 ? std::clamp(glm::dot(to, along) / length, 0.0, 1.0) : 0.0;
    if (glm::length(to - at * along) <= k_edge_rounding) return true;
  }
  return false;
}

bool BothMaps::is_explained(int x, int y, std::uint32_t gl_entry, std::uint32_t scan_entry) const {
  for (const std::uint32_t entry : {gl_entry, scan_entry}) {
    if (entry != 0 && is_near_edge(entry - 1, x, y)) return true;
  }
  if (gl_entry == 0 || scan_entry == 0) return false;
  // Two facets at the same depth, as far as their slopes let the snapped corners show.
  const MapFrame& frame = scan_->frame;
  const double u = (x + 0.5) / query_.method.resolution - 0.5, v = (y + 0.5) / query_.method.resolution - 0.5;
  double heights[2] = {}, slope = 0.0;
  for (int k = 0; k < 2; ++k) {
    const FacetIndex facet = (k == 0 ? gl_entry : scan_entry) - 1;
    const glm::dvec3& normal = model_->geometry.normals[facet];
    const glm::dvec3 corner =
        (model_->part.mesh.corner(facet, 0) - model_->frame.center) / model_->frame.diagonal;
    const double sine = glm::dot(normal, frame.z);
    heights[k] =
        (glm::dot(normal, corner) - u * glm::dot(normal, frame.x) - v * glm::dot(normal, frame.y)) / sine;
    slope = std::max(slope, std::sqrt(1.0 - sine * sine) / std::abs(sine));
  }
  return std::abs(heights[0] - heights[1]) <=
         k_depth_rounding + slope * k_edge_rounding / query_.method.resolution;
}

BothMaps::Comparison BothMaps::compare() const {
  Comparison result;
  for (const bool plus : {true, false}) {
    const std::vector<std::uint32_t> gl_map = classifier_.maps().read(plus);
    for (int y = 0; y < query_.method.resolution; ++y) {
      for (int x = 0; x < query_.method.resolution; ++x) {
        const std::uint32_t by_gl =
            gl_map[static_cast<std::size_t>(y) * static_cast<std::size_t>(query_.method.resolution) +
                   static_cast<std::size_t>(x)];
        const std::uint32_t by_scan = scan_->entry(plus, x, y);
        result.covered += by_gl != 0 || by_scan != 0 ? 1 : 0;
        if (by_gl == by_scan) continue;
        ++result.differing;
        if (is_explained(x, y, by_gl, by_scan)) continue;
        result.unexplained.push_back("texel " + std::to_string(x) + ", " + std::to_string(y) +
                                     (plus ? " +" : " -") + "d: GL " + std::to_string(by_gl) + ", scan " +
                                     std::to_string(by_scan));
      }
    }
  }
  return result;
}

BothMaps::Verdicts BothMaps::compare_verdicts(SamplePass& pass) const {
  const SurfaceSamples samples = sample_surface(model_->part.mesh, model_->geometry, model_->frame, 20'000);
  const std::vector<std::uint8_t> by_gl = pass.run(samples.samples, classifier_.maps());
  Verdicts result;
  result.samples = by_gl.size();
  for (std::size_t i = 0; i < by_gl.size(); ++i) {
    const SurfaceSample& sample = samples.samples[i];
    result.other += test::accessible_from(*scan_, sample.position, sample.facet) != by_gl[i] ? 1 : 0;
  }
  return result;
}

struct NamedModel {
  std::string name;
  std::shared_ptr<const PartModel> model;
};

/// The shipped parts, some shapes, and real parts where they are found.
std::vector<NamedModel> models() {
  std::vector<NamedModel> all;
  for (const char* name : {"bottle_cap.stl", "cable_clip.stl", "enclosure_lid.stl", "tilted_bracket.stl"}) {
    all.push_back(
        {name, load_part((test::asset_folder() / "parts" / name).string(), ReadOptions{}, Progress{})});
  }
  for (const test::Shape& shape :
       {test::snap_hook({}), test::hollow_sphere({}), test::frustum_over_tau({})}) {
    all.push_back({shape.name, test::model_of(test::subdivided(shape.mesh, 5000))});
  }
  if (const auto shared = test::shared_folder()) {
    for (const char* name : {"lego_brick_2x4.stl", "m5_stackchan_basecover_tilted.stl",
                             "odri_hip_cover_64k.stl", "numpystl_rear_case.stl"}) {
      all.push_back({name, load_part((*shared / "parts" / name).string(), ReadOptions{}, Progress{})});
    }
  }
  return all;
}

TEST(SecondDepth, AreThoseOfTheGlTexelByTexel) {
  std::size_t covered = 0, differing = 0;
  for (const NamedModel& part : models()) {
    BothMaps both(part.model);
    for (const int resolution : {512, 251}) {
      for (const glm::dvec3& direction : directions()) {
        Query query;
        query.direction = direction;
        query.method.resolution = resolution;
        // Without the thick edges every difference has its reason.
        query.method.edge_thickness = 0.0;
        both.draw(query);
        const BothMaps::Comparison bare = both.compare();
        EXPECT_TRUE(bare.unexplained.empty()) << part.name << ": " << bare.unexplained.size()
                                              << " texels, the first " << bare.unexplained.front();
        query.method.edge_thickness = 2.0;
        both.draw(query);
        // The strips have edges of their own.
        const BothMaps::Comparison thick = both.compare();
        EXPECT_LE(static_cast<double>(thick.unexplained.size()),
                  3.0 + k_most_differing * static_cast<double>(thick.covered))
            << part.name;
        covered += bare.covered + thick.covered;
        differing += bare.differing + thick.differing;
      }
    }
  }
  std::printf("%zu of %zu covered texels differ\n", differing, covered);
  EXPECT_LE(static_cast<double>(differing), k_most_differing * static_cast<double>(covered));
}

TEST(SecondDepth, GiveTheSameVerdictsAsTheGl) {
  SamplePass pass(test::shared_context().functions());
  BothMaps::Verdicts all;
  for (const NamedModel& part : models()) {
    BothMaps both(part.model);
    for (const glm::dvec3& direction : directions()) {
      Query query;
      query.direction = direction;
      query.method.resolution = 512;
      both.draw(query);
      const BothMaps::Verdicts verdicts = both.compare_verdicts(pass);
      const auto most = 8.0 * k_most_other_verdicts * static_cast<double>(verdicts.samples);
      EXPECT_LE(static_cast<double>(verdicts.other), most) << part.name;
      all.samples += verdicts.samples;
      all.other += verdicts.other;
    }
  }
  std::printf("of %zu samples %zu differ\n", all.samples, all.other);
  EXPECT_LE(static_cast<double>(all.other), k_most_other_verdicts * static_cast<double>(all.samples));
}

}  // namespace
}  // namespace moldlight
