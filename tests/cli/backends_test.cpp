// The same input gives the same output to the last byte, whatever makes the GL context.
#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

using test::run_moldlight;
using test::SmallPart;
using test::with;

struct Outputs {
  int exit_code = -1;
  std::string err, json, csv, mesh;
};

/// Everything but what names the machine and the time taken.
Outputs outputs(const SmallPart& part, std::vector<std::string> arguments, const std::string& backend) {
  const std::string csv = part.output(backend + ".csv"), mesh = part.output(backend + ".ply");
  arguments.insert(arguments.end(), {"--backend", backend, "--json", "-", "--facets", csv, "--mesh", mesh});
  const auto run = run_moldlight(arguments);
  Outputs result{run.exit_code, run.err, "", test::file_bytes(csv), test::file_bytes(mesh)};
  if (run.exit_code != 0) return result;
  auto json = test::json_of(run.out);
  json.erase("timings_ms");
  EXPECT_TRUE(json["settings"].contains("renderer"));
  json["settings"].erase("backend");
  json["settings"].erase("renderer");
  result.json = json.dump();
  return result;
}

void expect_same(const SmallPart& part, const std::vector<std::string>& arguments) {
  const Outputs osmesa = outputs(part, arguments, "osmesa");
  const Outputs again = outputs(part, arguments, "osmesa");
  const Outputs egl = outputs(part, arguments, "egl");
  ASSERT_EQ(osmesa.exit_code, 0) << osmesa.err;
  ASSERT_EQ(egl.exit_code, 0) << egl.err;
  EXPECT_EQ(osmesa.json, again.json);
  EXPECT_EQ(osmesa.csv, again.csv);
  EXPECT_EQ(osmesa.json, egl.json);
  EXPECT_EQ(osmesa.csv, egl.csv);
  EXPECT_EQ(osmesa.mesh, egl.mesh);
}

/// OSMesa is software; an EGL on a graphics card rounds in ways of its own.
bool egl_is_software(const SmallPart& part) {
  const auto arguments = with(part.classify({"--json", "-", "--readout", "samples"}), "--backend", "egl");
  const auto run = run_moldlight(arguments);
  return run.exit_code == 0 && test::json_of(run.out)["settings"]["renderer"].get<std::string>().find(
                                   "llvmpipe") != std::string::npos;
}

TEST(Backends, GiveTheSameToTheByte) {
  const SmallPart part;
  if (!egl_is_software(part)) GTEST_SKIP() << "EGL is not software here";
  for (const std::string direction : {"0,0,1", "0.3,-0.5,0.7"}) {
    expect_same(part, {"classify", part.file(), "--direction", direction, "--readout", "samples", "--samples",
                       "100000"});
  }
  expect_same(part, {"classify", part.file(), "--direction", "0,0,1", "--readout", "facet-id"});
  expect_same(part, {"classify", part.file(), "--direction", "0.1,0,1", "--readout", "samples",
                     "--kernel-shape", "symmetric"});
}

TEST(Backends, GiveTheSameToTheByteForARealPart) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  const SmallPart part;
  if (!egl_is_software(part)) GTEST_SKIP() << "EGL is not software here";
  expect_same(part, {"classify", (*shared / "parts" / "so101_trigger.stl").string(), "--direction",
                     "0.2,0.1,1", "--readout", "samples"});
}

}  // namespace
}  // namespace moldlight
