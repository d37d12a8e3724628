// A part whose file lists the same facets in another order, and begins them at other corners, has the same
// answers to the bit: side actions, mold, sweep.
#include "mesh/file_order.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "classify/part_model.hpp"
#include "io/part_formats.hpp"
#include "mesh/weld.hpp"
#include "study/study.hpp"
#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

/// What may differ: how long it took, and the file's numbers of facets.
void drop_what_may_differ(Json& json) {
  static const std::set<std::string> dropped = {"timings_ms", "elapsed_s", "facet", "facets", "blocked_by"};
  if (json.is_object()) {
    for (const std::string& key : dropped) json.erase(key);
  }
  if (json.is_structured()) {
    for (Json& each : json) drop_what_may_differ(each);
  }
}

std::vector<std::string> answers(const TriangleMesh& mesh, bool sweeps) {
  Part part;
  part.unit = "mm";
  part.mesh = weld_vertices(mesh);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  put_in_place_order(part);
  Questions questions;
  questions.with_actions = true;
  Study study(prepare_part(std::move(part), {}), questions);
  std::vector<Json> found = {actions_json(study, {}), mold_json(study, {})};
  if (sweeps) found.push_back(sweep_json(study, {}));
  std::vector<std::string> texts;
  for (Json& json : found) {
    drop_what_may_differ(json);
    texts.push_back(json.dump());
  }
  return texts;
}

void expect_same_answers(const std::filesystem::path& path, bool sweeps) {
  const TriangleMesh mesh = read_part(path.string(), {}, {}).mesh;
  const std::vector<std::string> own = answers(mesh, sweeps);
  const std::vector<std::string> other = answers(test::permuted(mesh, 11), sweeps);
  for (std::size_t k = 0; k < own.size(); ++k) EXPECT_TRUE(own[k] == other[k]) << path << ' ' << k;
}

TEST(FileOrder, ChangesNoBitOfShippedParts) {
  for (const char* name : {"cable_clip.stl", "tilted_bracket.stl"})
    expect_same_answers(test::asset_folder() / "parts" / name, std::string(name) == "cable_clip.stl");
}

TEST(FileOrder, ChangesNoBitOfSharedParts) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  for (const auto& [name, sweeps] :
       {std::pair("framework_expansion_card.stl", true), std::pair("so100_lego_gauge.stl", true),
        std::pair("trimesh_shared_edge.stl", true), std::pair("m5_rfid2_face_shell.stl", false),
        std::pair("m5_stackchan_basecover.stl", false)})
    expect_same_answers(*test::shared_folder() / "parts" / name, sweeps);
}

}  // namespace
}  // namespace moldlight
