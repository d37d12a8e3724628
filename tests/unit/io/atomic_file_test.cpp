#include "io/atomic_file.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;
using test::ScratchFolder;

std::size_t entries(const ScratchFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

/// The file that this process was writing, empty without one.
fs::path left_by(const ScratchFolder& folder, pid_t process) {
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (entry.path().filename().string().find(fmt::format("-{}-", process)) != std::string::npos)
      return entry.path();
  }
  return {};
}

std::string write_error(const std::string& path, std::string_view bytes = "new") {
  try {
    write_file(path, bytes);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(AtomicFile, ReplacesTheTargetOnCommitOnly) {
  const ScratchFolder folder;
  const std::string path = folder.write("a.txt", "old");
  {
    AtomicFile file(path);
    file.write(std::string(3'000'000, 'n'));
    EXPECT_EQ(file_bytes(path), "old");
  }
  EXPECT_EQ(file_bytes(path), "old");
  EXPECT_EQ(entries(folder), 1u);
  AtomicFile file(path);
  file.write(std::string(3'000'000, 'n'));
  file.write("end");
  file.commit();
  EXPECT_EQ(file_bytes(path), std::string(3'000'000, 'n') + "end");
  EXPECT_EQ(entries(folder), 1u);
}

TEST(AtomicFile, FilesOfAProgramThatWasKilledGoWithTheNextOne) {
  const ScratchFolder folder;
  const std::string target = folder.file("a.txt");
  // A child says through a pipe that its file is there, or ends, which closes the pipe.
  std::array<int, 2> said = {};
  ASSERT_EQ(::pipe(said.data()), 0);
  const auto write_in_child = [&](bool ends) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    AtomicFile file(target);
    file.write("half");
    file.put_on_disk();
    if (ends) ::kill(::getpid(), SIGKILL);
    static_cast<void>(::write(said[1], "w", 1));
    for (;;) ::pause();
  };
  const pid_t killed = write_in_child(true);
  ASSERT_EQ(::waitpid(killed, nullptr, 0), killed);
  ASSERT_EQ(entries(folder), 1u) << "what it left behind";
  const pid_t writing = write_in_child(false);
  ::close(said[1]);
  char word = 0;
  ASSERT_EQ(::read(said[0], &word, 1), 1);
  ::close(said[0]);
  EXPECT_EQ(left_by(folder, killed), "");
  const fs::path written = left_by(folder, writing);
  ASSERT_NE(written, "");
  static_cast<void>(folder.write(".moldlight-0a1b2c3d-1-0.part", "of another machine, a moment ago"));
  static_cast<void>(folder.write(".moldlight-notes.txt", "no such file"));
  fs::last_write_time(written, fs::file_time_type::clock::now() - std::chrono::hours(1));
  remove_leftovers(folder.path().string());
  EXPECT_EQ(entries(folder), 3u) << "what is being written stays, also while its machine sleeps";
  ::kill(writing, SIGKILL);
  ASSERT_EQ(::waitpid(writing, nullptr, 0), writing);
  remove_leftovers(folder.path().string());
  EXPECT_EQ(entries(folder), 2u);
}

TEST(AtomicFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const ScratchFolder folder;
  const std::string path = folder.write("a.txt", "old");
  rlimit before = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {100'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = write_error(path, std::string(200'000, 'n'));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(error, path + ": cannot be written: File too large");
  EXPECT_EQ(file_bytes(path), "old");
  EXPECT_EQ(entries(folder), 1u);
}

TEST(AtomicFile, SaysWhyItCannotWrite) {
  const ScratchFolder folder;
  EXPECT_EQ(write_error("/dev/full"),
            "/dev/full: cannot be written: No space left on device; make room or name another place");
  const std::string nowhere = folder.file("missing/a.txt");
  EXPECT_EQ(write_error(nowhere),
            nowhere + ": cannot be written: No such file or directory; does its folder exist?");
  EXPECT_EQ(write_error(folder.path().string()),
            folder.path().string() + ": cannot be written: Is a directory");
  const std::string below_file = folder.write("a.txt", "old") + "/b.txt";
  EXPECT_EQ(write_error(below_file), below_file + ": cannot be written: Not a directory");
  EXPECT_EQ(write_error(""), ": cannot be written: No such file or directory; does its folder exist?");
}

TEST(AtomicFile, KeepsProtectedFiles) {
  if (::getuid() == 0) GTEST_SKIP() << "nothing is protected from the administrator";
  const ScratchFolder folder;
  const std::string path = folder.write("a.txt", "old");
  ::chmod(path.c_str(), 0400);
  EXPECT_EQ(write_error(path), path + ": cannot be written: Permission denied");
  EXPECT_EQ(file_bytes(path), "old");
}

TEST(AtomicFile, WritesThroughDevicesAndLinks) {
  const ScratchFolder folder;
  write_file("/dev/null", "new");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const std::string target = folder.write("target.txt", "old");
  fs::create_symlink("target.txt", folder.file("link.txt"));
  fs::create_symlink("later.txt", folder.file("dangling.txt"));
  write_file(folder.file("link.txt"), "new");
  write_file(folder.file("dangling.txt"), "new");
  EXPECT_TRUE(fs::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(file_bytes(target), "new");
  EXPECT_EQ(file_bytes(folder.file("later.txt")), "new");
}

TEST(AtomicFile, KeepsTheModeOfTheOldFile) {
  const ScratchFolder folder;
  const std::string path = folder.write("a.txt", "old");
  ::chmod(path.c_str(), 0640);
  write_file(path, "new");
  struct stat status = {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

}  // namespace
}  // namespace moldlight
