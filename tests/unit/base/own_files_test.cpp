// Files found from the program's own place.
#include "base/own_files.hpp"

#include <gtest/gtest.h>

namespace moldlight {
namespace {

TEST(OwnFiles, TheFirstPlaceThatIsThereIsTaken) {
  constexpr const char* k_places[] = {"no such file", "../bin/./test_unit_base", "."};
  const auto found = own_file(k_places);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(*found, std::filesystem::read_symlink("/proc/self/exe"));
}

TEST(OwnFiles, NothingIsMadeUp) {
  constexpr const char* k_places[] = {"no such file", "../no such folder/file"};
  EXPECT_FALSE(own_file(k_places).has_value());
}

}  // namespace
}  // namespace moldlight
