// Signals at random moments while every command works on shapes that are hard on purpose: from the signal to
// the end a program may take one second of the processor.
#include <chrono>
#include <cmath>
#include <csignal>
#include <numbers>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/mesh_writer.hpp"
#include "mesh/weld.hpp"
#include "support/boxes.hpp"
#include "support/mesh_edits.hpp"
#include "support/process.hpp"
#include "support/random.hpp"
#include "support/scratch_folder.hpp"

extern char** environ;

namespace moldlight {
namespace {

constexpr double k_most_after_s = 1.0;

/// Facets of such a size, anywhere in a cube.
TriangleMesh soup(std::size_t facets, double size) {
  test::Random random(11);
  std::vector<glm::dvec3> corners;
  for (std::size_t k = 0; k < facets; ++k) {
    const glm::dvec3 at = random.in_cube(1.0);
    for (int corner = 0; corner < 3; ++corner) corners.push_back(at + random.in_cube(size));
  }
  return weld_corners(corners);
}

/// A prism over a star of so many needles.
TriangleMesh star(std::size_t points) {
  std::vector<glm::dvec3> corners;
  const auto at = [&](std::size_t k, double z) {
    const double turn =
        2.0 * std::numbers::pi * static_cast<double>(k % points) / static_cast<double>(points);
    return glm::dvec3((k % 2 == 0 ? 0.001 : 1.0) * glm::dvec2(std::cos(turn), std::sin(turn)), z);
  };
  for (std::size_t k = 0; k < points; ++k) {
    const glm::dvec3 a = at(k, 0), b = at(k + 1, 0), c = at(k, 1), d = at(k + 1, 1);
    for (const glm::dvec3& corner : {a, b, c, b, d, c, glm::dvec3(0, 0, 0), b, a, glm::dvec3(0, 0, 1), c, d})
      corners.push_back(corner);
  }
  return weld_corners(corners);
}

TriangleMesh boxes(std::size_t count) {
  test::Random random(3);
  std::vector<glm::dvec3> corners;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 low = random.in_cube(5.0);
    for (const glm::dvec3& corner : test::box_corners(low, low + 1.6 + random.in_cube(1.5)))
      corners.push_back(corner);
  }
  return weld_corners(corners);
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

struct Ended {
  int exit_code = 0;
  double after_s = 0.0;  // processor time from the signal on
};

Ended run_and_signal(const std::vector<std::string>& words, int signal, std::chrono::milliseconds delay) {
  std::vector<char*> pointers;
  std::vector<std::string> kept = words;
  for (std::string& word : kept) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  pid_t pid = -1;
  const int error = ::posix_spawn(&pid, words.front().c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return {.exit_code = 127};
  std::this_thread::sleep_for(delay);
  Ended ended;
  const double before = test::processor_seconds(pid);
  ::kill(pid, signal);
  int status = 0;
  rusage used = {};
  ::wait4(pid, &status, 0, &used);
  ended.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ended.after_s = seconds_of(used.ru_utime) + seconds_of(used.ru_stime) - before;
  return ended;
}

class HardShapes : public testing::Test {
 protected:
  std::string write(const std::string& name, const TriangleMesh& mesh) {
    const std::string path = (folder_.path() / (name + ".stl")).string();
    write_solid_stl(path, mesh, "mm");
    return path;
  }
  /// Every command for a part, each with a signal at a random moment.
  void expect_soon_ended(const std::string& part) {
    const std::string out = (folder_.path() / "out").string();
    const std::vector<std::vector<std::string>> commands = {
        {"info", part},
        {"classify", part, "--direction", "0.133,0.546,-0.914", "--mesh", out + ".ply"},
        {"classify", part, "--direction", "best"},
        {"actions", part, "--direction", "0.133,0.546,-0.914"},
        {"mold", part, "--direction", "z", "--fill-undercut", "--out", out},
        {"sweep", part, "--top", "3"},
        {"pieces", part},
        {"compare", part, part, "--direction", "z", "--align"}};
    for (const auto& command : commands) {
      std::vector<std::string> words = command;
      words.insert(words.begin(), MOLDLIGHT_BINARY);
      const int signal = random_.below(2) == 0 ? SIGINT : SIGTERM;
      const std::chrono::milliseconds delay(50 + random_.below(1500));
      const Ended ended = run_and_signal(words, signal, delay);
      const std::string about = command[0] + " " + part + " signal " + std::to_string(signal) + " after " +
                                std::to_string(delay.count()) + " ms";
      const double most = test::built_with_sanitizers() ? 10.0 * k_most_after_s : k_most_after_s;
      if (ended.exit_code == 130) {
        EXPECT_LT(ended.after_s, most) << about;
      }
      // Done before, a criterion that fails, not read, or ended before it listened.
      const bool of_its_own = ended.exit_code <= 3 || ended.exit_code == 128 + signal;
      EXPECT_TRUE(ended.exit_code == 130 || of_its_own) << about << ": " << ended.exit_code;
      EXPECT_LT(ended.after_s, 30.0) << about;
    }
  }

  test::ScratchFolder folder_;
  test::Random random_{5};
};

TEST_F(HardShapes, LooseFacets) { expect_soon_ended(write("loose", soup(3000, 1.0))); }
TEST_F(HardShapes, SmallLooseFacets) { expect_soon_ended(write("soup", soup(20'000, 0.02))); }
TEST_F(HardShapes, Star) { expect_soon_ended(write("star", star(2000))); }
TEST_F(HardShapes, OverlappingBoxes) { expect_soon_ended(write("boxes", boxes(1200))); }
TEST_F(HardShapes, ManyFacets) { expect_soon_ended(write("fine", test::subdivided(boxes(20), 400'000))); }

}  // namespace
}  // namespace moldlight
