// SHA-256 of known texts, and of files.
#include <cerrno>

#include <gtest/gtest.h>

#include "io/file_contents.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

TEST(Digest, OfTheTextsOfTheStandard) {
  EXPECT_EQ(hex_of(digest_of("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex_of(digest_of("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Digest, HexReadsBackAndNothingElseDoes) {
  const Digest digest = digest_of("part");
  EXPECT_EQ(digest_from(hex_of(digest)), digest);
  EXPECT_FALSE(digest_from(""));
  EXPECT_FALSE(digest_from(hex_of(digest).substr(1)));
  EXPECT_FALSE(digest_from(hex_of(digest).substr(1) + "g"));
  EXPECT_FALSE(digest_from(std::string(64, 'A')));
}

TEST(Digest, OfAFileIsThatOfItsBytes) {
  const test::ScratchFolder folder;
  const std::string bytes(1'000'000, 'x');
  const FileDigest found = digest_of_file(folder.write("part.stl", bytes), Progress());
  EXPECT_EQ(found.error, 0);
  EXPECT_EQ(found.digest, digest_of(bytes));
  EXPECT_EQ(digest_of_file(folder.file("none.stl"), Progress()).error, ENOENT);
  EXPECT_EQ(digest_of_file(folder.path().string(), Progress()).error, EISDIR);
  EXPECT_EQ(digest_of_file("/dev/null", Progress()).error, EINVAL);
}

}  // namespace
}  // namespace moldlight
