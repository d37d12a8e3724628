#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "io/part_formats.hpp"
#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_error;

TEST(PartReader, SaysWhatAFileIsThatIsNoPart) {
  EXPECT_EQ(read_error("a.stl", ""), "a.stl: is empty (0 bytes); export the part again");
  EXPECT_EQ(read_error("a.obj", std::string("\xfe\xff\0v\0 \0", 7)),
            "a.obj: byte 0: is UTF-16 text; save it as UTF-8 or plain ASCII");
  std::string without_mark;
  for (const char c : std::string("v 0 0 0\nv 1 0 0\n")) without_mark += {c, '\0'};
  EXPECT_EQ(read_error("a.obj", without_mark),
            "a.obj: byte 0: is UTF-16 text; save it as UTF-8 or plain ASCII");
  EXPECT_EQ(read_error("a.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:0\n"),
            "a.stl: line 1: is a Git LFS pointer, not the part itself; run 'git lfs pull' first");
  EXPECT_EQ(read_error("a.stl.gz", "\x1f\x8b\x08 and so on"),
            "a.stl.gz: byte 0: is compressed with gzip; unpack it first");
  EXPECT_EQ(read_error("a.stl", "This is a note, not a part.\n"),
            "a.stl: line 1: is text, but no STL, which begins with 'solid'; export the part again");
  EXPECT_EQ(
      read_error("a.txt", "This is a note, not a part.\n"),
      "a.txt: byte 0: is not a part file: none of STL, OBJ, PLY, OFF, 3MF, STEP and IGES by content or name");
}

TEST(PartReader, GoesByContentBeforeName) {
  const std::string obj = "# a triangle\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(test::read_bytes("part.stl", obj).format, "OBJ");
  EXPECT_EQ(test::read_bytes("part", obj).format, "OBJ");
  const std::string stl =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid\n";
  EXPECT_EQ(test::read_bytes("part.obj", stl).format, "STL ASCII");
}

TEST(PartReader, KnowsByTheBeginningWhatIsNoPart) {
  // Read whole, these would take all memory there is.
  const test::ScratchFolder folder;
  const auto error_of = [&](const std::string& name, std::string_view beginning) -> std::string {
    const std::string path = folder.write(name, beginning);
    std::filesystem::resize_file(path, std::uintmax_t{1} << 40);
    try {
      static_cast<void>(read_part(path, {}, Progress()));
    } catch (const FileError& error) {
      return std::string(error.what()).substr(path.size());
    }
    return "no error";
  };
  const std::string zeros(8192, '\0');
  EXPECT_EQ(
      error_of("zeros.stl", zeros),
      ": byte 84: 1099511627692 bytes follow the 0 facets that the header declares; export the part again");
  EXPECT_EQ(error_of("zeros.obj", zeros), ": byte 0: is binary data, and OBJ is text; export the part again");
  EXPECT_EQ(error_of("note.off", "some words\x02 and more"),
            ": byte 10: is binary data, and OFF is text; export the part again");
  EXPECT_EQ(
      error_of("zeros.3mf", zeros),
      ": byte 0: is a damaged or truncated zip archive (it does not begin as one); export the part again");
  EXPECT_EQ(
      error_of("zeros.dat", zeros),
      ": byte 0: is not a part file: none of STL, OBJ, PLY, OFF, 3MF, STEP and IGES by content or name");
}

TEST(PartReader, SaysWhatCannotBeOpened) {
  const test::ScratchFolder folder;
  const auto error_of = [](const std::string& path) -> std::string {
    try {
      static_cast<void>(read_part(path, {}, Progress()));
    } catch (const FileError& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string missing = folder.file("missing.stl");
  EXPECT_EQ(error_of(missing), missing + ": cannot be opened: No such file or directory");
  EXPECT_EQ(error_of(folder.path().string()), folder.path().string() + ": is a folder; name a part file");
  const std::string pipe = folder.file("pipe.stl");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(error_of(pipe), pipe + ": is not a regular file; save the part to a file first");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // the sanitizer itself takes more
/// Ends with 0 where a part of 4 GiB is refused for want of memory, with nothing taken.
[[noreturn]] void read_with_little_memory(const std::string& path) {
  const rlimit little = {std::uint64_t{3} << 29, RLIM_INFINITY};
  ::setrlimit(RLIMIT_AS, &little);
  try {
    static_cast<void>(read_part(path, {}, Progress()));
  } catch (const FileError& error) {
    std::cerr << error.what();
    std::_Exit(0);
  }
  std::_Exit(1);
}

TEST(PartReaderDeathTest, SaysWhenMemoryIsShortBeforeTakingIt) {
  const test::ScratchFolder folder;
  const std::uint32_t facets = 84'000'000;
  std::string header(80, ' ');
  header.append(reinterpret_cast<const char*>(&facets), 4);
  const std::string path = folder.write("large.stl", header);
  std::filesystem::resize_file(path, 84 + std::uint64_t{50} * facets);
  EXPECT_EXIT(read_with_little_memory(path), testing::ExitedWithCode(0),
              "needs 3.9 GiB of memory at least, but [01].[0-9] GiB are free");
}
#endif

TEST(PartReader, KeepsTheNameAsGiven) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("p\xc3\xa4rt.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(read_part(path, {}, Progress()).file, path);
}

TEST(PartReader, StopsWhenCancelled) {
  const test::ScratchFolder folder;
  Progress progress;
  progress.cancel();
  const std::string path = folder.write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THROW(static_cast<void>(read_part(path, {}, progress)), Cancelled);
}

}  // namespace
}  // namespace moldlight
