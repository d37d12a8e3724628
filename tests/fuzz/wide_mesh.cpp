#include "fuzz/wide_mesh.hpp"

#include <bit>
#include <cmath>

#include "base/check.hpp"
#include "base/error.hpp"
#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "compare/comparison.hpp"
#include "fuzz/small_mesh.hpp"
#include "mesh/weld.hpp"
#include "study/study.hpp"

namespace moldlight::fuzz {

namespace {

constexpr std::size_t k_most_changes = 12, k_change_bytes = 3;
/// Beyond, readers refuse a coordinate: the square of a part's size is to be a number.
constexpr double k_largest = 1e150;

double changed(double value, unsigned how) {
  constexpr unsigned k_exponent_bits = 11, k_first_bit = 52;
  if (how < k_exponent_bits + 1) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ std::uint64_t{1}
                                                                           << (k_first_bit + how));
  }
  const double factor = std::pow(10.0, static_cast<double>(static_cast<int>(how) - 134) / 6.0);
  return factor * (value == 0.0 ? 1.0 : value);
}

WidePart wide_part_of(std::span<const std::uint8_t> bytes, double share) {
  std::size_t changes = 0;
  std::span<const std::uint8_t> rest = bytes;
  if (!bytes.empty()) {
    changes = std::min<std::size_t>(bytes[0] % (k_most_changes + 1), (bytes.size() - 1) / k_change_bytes);
    rest = bytes.subspan(1 + k_change_bytes * changes);
  }
  SmallMesh small = small_mesh(rest);
  WidePart wide;
  wide.part.mesh = std::move(small.mesh);
  wide.direction = small.direction;
  std::vector<glm::dvec3>& vertices = wide.part.mesh.vertices;
  const auto made = static_cast<std::size_t>(share * static_cast<double>(changes));
  for (std::size_t k = 0; k < made && !vertices.empty(); ++k) {
    const std::uint8_t* change = &bytes[1 + k_change_bytes * k];
    double& coordinate = vertices[change[0] % vertices.size()][change[1] % 3];
    const double value = changed(coordinate, change[2]);
    if (std::abs(value) <= k_largest) coordinate = value;
  }
  wide.part.mesh = weld_vertices(wide.part.mesh);
  wide.part.bodies = {{"part", 0, static_cast<FacetIndex>(wide.part.mesh.facets.size())}};
  return wide;
}

void expect_numbers(const RegionValues& areas, double total) {
  for (const double area : areas.values) CHECK(std::isfinite(area) && area >= 0.0);
  CHECK(std::abs(areas.total() - total) <= 1e-6 * total);
}

/// False for what nothing can be asked of, as a reader would say in words.
template <typename Ask>
bool asked(const WidePart& wide, const Ask& ask) {
  if (wide.part.mesh.facets.empty()) return false;
  try {
    const auto model = prepare_part(wide.part, Progress());
    if (!(model->geometry.total_area > 0.0)) return false;
    Questions questions;
    questions.query.direction = Direction(wide.direction);
    questions.mold.fill_undercut = true;
    Study study(model, questions);
    ask(study);
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

WidePart wide_part(std::span<const std::uint8_t> bytes) { return wide_part_of(bytes, 1.0); }

bool try_split_mesh(const WidePart& wide) {
  return asked(wide, [](Study& study) {
    const Classification& result = study.find<SplitRegions>(Progress()).result;
    expect_numbers(result.areas, study.model().geometry.total_area);
    CHECK(result.split != nullptr);
    for (const glm::dvec3& vertex : result.split->vertices)
      CHECK(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z));
    for (const SplitPiece& piece : result.split->pieces) {
      CHECK(piece.facet < study.model().part.mesh.facets.size());
      for (const VertexIndex corner : piece.corners) CHECK(corner < result.split->vertices.size());
    }
  });
}

bool try_actions(const WidePart& wide) {
  return asked(wide, [](Study& study) {
    const ActionPlan& plan = study.find<ActionPlan>(Progress());
    for (const SideAction& action : plan.actions) {
      CHECK(std::isfinite(action.travel) && action.travel >= 0.0);
      CHECK(std::isfinite(action.direction.x + action.direction.y + action.direction.z));
    }
    CHECK(!study.verdict(Progress()).sentence.empty());
  });
}

bool try_mold(const WidePart& wide) {
  return asked(wide, [](Study& study) {
    const MoldHalves& halves = study.find<MoldHalves>(Progress());
    if (!halves.made()) {
      CHECK(!halves.refusal.empty());
      return;
    }
    CHECK(std::abs(halves.volume_gap) <= 1e-9);
    for (const WrittenBody& body : halves.written.bodies)
      CHECK(body.closed || !halves.written.refusal.empty());
  });
}

bool try_compare(std::span<const std::uint8_t> bytes) {
  const WidePart former = wide_part_of(bytes, 0.5);
  return asked(wide_part(bytes), [&](Study& study) {
    if (former.part.mesh.facets.empty()) return;
    const auto model = prepare_part(former.part, Progress());
    if (!(model->geometry.total_area > 0.0)) return;
    Comparison comparison = prepare_comparison(model, study.shared_model(), {}, Progress());
    const Query& query = study.questions().query;
    compare_parts(comparison, {query.direction, query.direction, query.method}, Progress());
    expect_numbers(comparison.b.result.areas, study.model().geometry.total_area);
    CHECK(!comparison_verdict(comparison).empty());
  });
}

}  // namespace moldlight::fuzz
