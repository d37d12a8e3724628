// `moldlight classify --image`.
#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/read_png.hpp"

namespace moldlight {
namespace {

using test::run_moldlight;
using test::SmallPart;

TEST(Image, IsWrittenInTheSizeAskedFor) {
  const SmallPart part;
  const std::string file = part.output("picture.png");
  const auto run = run_moldlight(part.classify(
      {"--image", file, "--size", "320x200", "--view", "front", "--theme", "dark", "--palette", "safe"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const Image image = test::read_png(file);
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 200);
}

TEST(Image, BadRequestsAreUsageErrorsBeforeAnyWork) {
  const SmallPart part;
  const std::string file = part.output("picture.png");
  for (const auto& [flag, value] : {std::pair{"--size", "320"}, {"--size", "320x5"}, {"--view", "above"}}) {
    const auto run = run_moldlight(part.classify({"--image", file, flag, value}));
    EXPECT_EQ(run.exit_code, 2) << flag << ' ' << value;
    EXPECT_NE(run.err.find(flag), std::string::npos) << run.err;
  }
  const auto run = run_moldlight(part.classify({"--image", part.output("no/such/folder.png")}));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("no/such/folder.png"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace moldlight
