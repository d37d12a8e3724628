#include "base/progress.hpp"

#include <gtest/gtest.h>

namespace moldlight {
namespace {

TEST(Progress, IsCancelledWithItsParentAndTellsNobody) {
  int noted = 0;
  Progress parent([&](std::string_view, double) { ++noted; });
  const Progress child(&parent), grandchild(&child);
  grandchild.report("working", 0.5);
  EXPECT_EQ(noted, 0);
  EXPECT_FALSE(grandchild.cancelled());
  parent.cancel();
  // Loops of several threads ask, and do not report.
  EXPECT_TRUE(child.cancelled());
  EXPECT_TRUE(grandchild.cancelled());
  EXPECT_THROW(grandchild.report("working", 0.5), Cancelled);
}

TEST(Progress, LeavesItsParentAlone) {
  const Progress parent;
  Progress child(&parent);
  child.cancel();
  EXPECT_TRUE(child.cancelled());
  EXPECT_FALSE(parent.cancelled());
}

}  // namespace
}  // namespace moldlight
