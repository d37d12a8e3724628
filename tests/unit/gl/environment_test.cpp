// The surroundings of a process: a desktop that must not be asked, a home that cannot be written.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "backends.hpp"
#include "gl/headless_backends.hpp"
#include "gl/headless_context.hpp"

namespace moldlight::gl {
namespace {

namespace fs = std::filesystem;

class EnvironmentTest : public ::testing::Test {
 protected:
  EnvironmentTest() {
    // Every death test starts this program anew: what Mesa reads once is read in the surroundings made below.
    ::testing::FLAGS_gtest_death_test_style = "threadsafe";
    fs::create_directories(folder_);
  }
  ~EnvironmentTest() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::temp_directory_path() / ("moldlight_gl_" + std::to_string(::getpid()));
};

// A socket in the abstract name space (empty first byte) or in the file system that nobody answers on.
int listen_at(const std::string& name) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  name.copy(address.sun_path, sizeof(address.sun_path) - 1);
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  if (::bind(listener, reinterpret_cast<const sockaddr*>(&address), length) != 0 ||
      ::listen(listener, 4) != 0) {
    std::cerr << "cannot listen\n";
    std::exit(2);
  }
  return listener;
}

bool was_called(int listener) {
  pollfd waiting = {listener, POLLIN, 0};
  return ::poll(&waiting, 1, 0) > 0;
}

// Ends the process: 0 if every backend gave a context and no display server was called. A client that did
// call would wait for an answer, so the alarm ends that.
[[noreturn]] void create_beside_displays(const fs::path& folder) {
  const std::string number = std::to_string(::getpid());
  const int x_server = listen_at(std::string(1, '\0') + "/tmp/.X11-unix/X" + number);
  const int wayland = listen_at((folder / "wayland").string());
  ::setenv("DISPLAY", (":" + number).c_str(), 1);
  ::setenv("WAYLAND_DISPLAY", (folder / "wayland").c_str(), 1);
  ::alarm(30);
  const auto contexts = available_contexts();
  std::exit(contexts.empty() ? 3 : was_called(x_server) ? 4 : was_called(wayland) ? 5 : 0);
}

[[noreturn]] void create_beside_nonsense() {
  ::setenv("DISPLAY", ":99999", 1);
  ::setenv("WAYLAND_DISPLAY", "no-such-compositor", 1);
  ::setenv("XAUTHORITY", "/no/such/file", 1);
  std::exit(available_contexts().empty() ? 3 : 0);
}

[[noreturn]] void create_without_home() {
  ::unsetenv("XDG_CACHE_HOME");
  ::unsetenv("MESA_SHADER_CACHE_DIR");
  ::setenv("HOME", "/no/such/home", 1);
  const auto context = create_headless_context(HeadlessBackend::automatic);
  const char* disabled = std::getenv("MESA_SHADER_CACHE_DISABLE");
  std::exit(disabled != nullptr && std::string(disabled) == "true" ? 0 : 3);
}

TEST_F(EnvironmentTest, NoDisplayServerIsCalled) {
  EXPECT_EXIT(create_beside_displays(folder_), ::testing::ExitedWithCode(0), "");
}

TEST_F(EnvironmentTest, NonsenseDisplaysDoNotMatter) {
  EXPECT_EXIT(create_beside_nonsense(), ::testing::ExitedWithCode(0), "");
}

TEST_F(EnvironmentTest, NothingIsSaidWithoutAHome) {
  EXPECT_EXIT(create_without_home(), ::testing::ExitedWithCode(0), "^$");
}

TEST_F(EnvironmentTest, ShaderCacheFolderIsFoundAsMesaDoes) {
  ::unsetenv("MESA_SHADER_CACHE_DIR");
  ::unsetenv("XDG_CACHE_HOME");
  ::setenv("HOME", folder_.c_str(), 1);
  EXPECT_TRUE(shader_cache_is_writable());
  ::setenv("HOME", (folder_ / "absent").c_str(), 1);
  EXPECT_FALSE(shader_cache_is_writable());
  ::setenv("XDG_CACHE_HOME", (folder_ / "made_by_mesa").c_str(), 1);
  EXPECT_TRUE(shader_cache_is_writable());
  ::setenv("XDG_CACHE_HOME", "", 1);
  EXPECT_FALSE(shader_cache_is_writable());
  ::setenv("MESA_SHADER_CACHE_DIR", folder_.c_str(), 1);
  EXPECT_TRUE(shader_cache_is_writable());
  ::setenv("MESA_SHADER_CACHE_DIR", (folder_ / "two" / "levels").c_str(), 1);
  EXPECT_FALSE(shader_cache_is_writable());
}

}  // namespace
}  // namespace moldlight::gl
