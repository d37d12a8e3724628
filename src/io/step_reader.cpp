#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>

#include "base/error.hpp"
#include "base/own_files.hpp"
#include "io/file_contents.hpp"
#include "io/readers.hpp"
#include "io/step_result.hpp"
#include "io/text_scanner.hpp"
#include "mesh/weld.hpp"

extern char** environ;

namespace moldlight {

namespace {

constexpr int k_poll_ms = 50;

/// Ends the child with the scope: no way out leaves it running or unwaited for.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      wait();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void kill() const { ::kill(pid_, SIGKILL); }
  int wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

 private:
  pid_t pid_;
};

/// The same under a number above those that the child uses, lest one is laid over another.
Descriptor above_the_childs(Descriptor low) {
  return Descriptor(low.number() < 0 ? -1
                                     : ::fcntl(low.number(), F_DUPFD_CLOEXEC, k_step_file_descriptor + 1));
}

struct ChildResult {
  std::string bytes;  // what it wrote to the descriptor
  int exit_code = 0;
  int signal = 0;  // that ended it; 0 for none
  bool timed_out = false;
  bool too_long = false;  // it wrote more than it may
};

struct ChildCommand {
  std::string program;  // path
  std::vector<std::string> arguments;
  int file = -1;                 // open; the child finds it at k_step_file_descriptor
  std::uint64_t most_bytes = 0;  // that it may hand back
  std::chrono::seconds time_limit{60};
};

pid_t start(const ChildCommand& command, int writing_end) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, writing_end, k_step_result_descriptor);
  posix_spawn_file_actions_adddup2(&actions, command.file, k_step_file_descriptor);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  std::vector<std::string> words = {command.program};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t pid = -1;
  const int error = ::posix_spawn(&pid, command.program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return pid;
  errno = error;
  return -1;
}

/// Runs the program with its standard streams closed off, until it ends, `time_limit` is over or `progress`
/// is cancelled (throws Cancelled). None where it cannot be started, for the reason in errno.
std::optional<ChildResult> run_child(const ChildCommand& command, const Progress& progress) {
  Pipe pipe;
  pipe.writing = above_the_childs(std::move(pipe.writing));
  if (pipe.writing.number() < 0) return std::nullopt;
  const pid_t pid = start(command, pipe.writing.number());
  if (pid < 0) return std::nullopt;
  Child child(pid);
  pipe.writing.close();

  ChildResult result;
  const auto deadline = std::chrono::steady_clock::now() + command.time_limit;
  std::vector<char> chunk(std::size_t{1} << 16);
  while (true) {
    progress.report("reading", 0.5);
    if (std::chrono::steady_clock::now() > deadline) {
      result.timed_out = true;
      child.kill();
      break;
    }
    pollfd waiting = {pipe.reading.number(), POLLIN, 0};
    if (::poll(&waiting, 1, k_poll_ms) <= 0) continue;
    const ssize_t got = ::read(pipe.reading.number(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    if (result.bytes.size() + static_cast<std::size_t>(got) > command.most_bytes) {
      result.too_long = true;
      child.kill();
      break;
    }
    result.bytes.append(chunk.data(), static_cast<std::size_t>(got));
  }
  const int status = child.wait();
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return result;
}

constexpr std::string_view k_end_mark = "END-ISO-10303-21";
constexpr std::uint64_t k_base_memory_bytes = std::uint64_t{3} << 30;
constexpr std::uint64_t k_memory_bytes_a_byte = 100;
// Of what is handed back: a facet with three corners of its own and a name of its own; names and sentences.
constexpr std::uint64_t k_result_bytes_a_facet = 128, k_result_bytes_a_byte = 16,
                        k_base_result_bytes = std::uint64_t{1} << 20;
constexpr std::chrono::seconds k_base_time{120};
constexpr std::uint64_t k_bytes_a_second = 50'000;

constexpr const char* k_broken =
    "breaks the STEP reader OpenCASCADE; repair it in the CAD program or export STL";

[[noreturn]] void fail_for_signal(const ReadContext& context, int signal) {
  if (signal == SIGINT || signal == SIGTERM) throw Cancelled();  // went to both programs
  const bool limit = signal == SIGKILL || signal == SIGXCPU;
  context.fail("", "{} (signal {}); {} export the part as STL",
               limit ? "cannot be read within the system's limits of memory and time"
                     : "breaks the STEP reader OpenCASCADE",
               signal, limit ? "raise them, coarsen the deflection or" : "repair it in the CAD program or");
}

/// The file as the reading program gets it, which takes bytes in memory from a file that has no name.
Descriptor opened(const ReadContext& context) {
  if (!context.in_memory) return Descriptor(::open(context.path.c_str(), O_RDONLY | O_CLOEXEC));
  Descriptor file(::memfd_create("part", MFD_CLOEXEC));
  for (std::string_view left = context.bytes(); file.number() >= 0 && !left.empty();) {
    const ssize_t done = ::write(file.number(), left.data(), left.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return {};
    left.remove_prefix(static_cast<std::size_t>(done));
  }
  if (file.number() >= 0) ::lseek(file.number(), 0, SEEK_SET);
  return file;
}

std::string run_reading_program(const ReadContext& context, std::uint64_t file_bytes) {
  const auto program = step_reading_program();
  if (!program) {
    context.fail("",
                 "is a STEP file, and this build has no STEP support (the program moldlight-step is "
                 "missing); export the part as STL");
  }
  const Descriptor file = above_the_childs(opened(context));
  if (file.number() < 0) context.fail("", "cannot be opened again: {}", std::strerror(errno));
  ChildCommand command;
  command.program = *program;
  command.file = file.number();
  command.most_bytes = k_base_result_bytes + k_result_bytes_a_facet * context.options.max_facets +
                       k_result_bytes_a_byte * file_bytes;
  command.time_limit = k_base_time + std::chrono::seconds(file_bytes / k_bytes_a_second);
  command.arguments = {fmt::format("{}", context.options.linear_deflection),
                       fmt::format("{}", context.options.angular_deflection_deg),
                       std::to_string(context.options.max_facets),
                       std::to_string(k_base_memory_bytes + k_memory_bytes_a_byte * file_bytes)};
  const auto child = run_child(command, context.progress);
  if (!child) {
    context.fail("", "cannot be read: {} does not start ({}); allow more processes and memory", *program,
                 std::strerror(errno));
  }
  if (child->timed_out) {
    context.fail("", "takes more than {} s to read; coarsen the deflection or export the part as STL",
                 command.time_limit.count());
  }
  if (child->too_long) context.fail("", "{}", k_broken);
  if (child->signal != 0) fail_for_signal(context, child->signal);
  if (child->exit_code != 0) {
    context.fail("", "cannot be read: {} ends with exit code {}; it may need more memory than is allowed",
                 *program, child->exit_code);
  }
  return child->bytes;
}

/// The reading program may have been broken by its file in ways that leave it running.
void check_result(const ReadContext& context, const StepResult& result) {
  context.check_facet_count(result.facets.size());
  std::uint64_t covered = 0;
  for (const StepBody& body : result.bodies) {
    if (body.facets == 0 || body.facets > result.facets.size() - covered) context.fail("", "{}", k_broken);
    covered += body.facets;
  }
  if (covered == 0 || covered != result.facets.size() || result.faces.size() != covered)
    context.fail("", "{}", k_broken);
  const auto faces = static_cast<std::uint32_t>(result.face_colours.size());
  if (faces > 0 && std::ranges::any_of(result.faces, [faces](std::uint32_t face) { return face >= faces; }))
    context.fail("", "{}", k_broken);
  for (std::size_t i = 0; i < result.vertices.size(); ++i) {
    const auto& [x, y, z] = result.vertices[i];
    if (is_usable_point({x, y, z})) continue;
    context.fail(fmt::format("vertex {}", i), "is ({}, {}, {}); export the part as STL", x, y, z);
  }
  for (const auto& facet : result.facets) {
    for (const std::uint32_t corner : facet)
      if (corner >= result.vertices.size()) context.fail("", "{}", k_broken);
  }
}

}  // namespace

std::optional<std::string> step_reading_program() {
  // Beside the program or the module, in a build folder, or installed with either.
  constexpr const char* k_places[] = {
      "moldlight-step",
      "../libexec/moldlight/moldlight-step",
      "../../bin/moldlight-step",
      "../../../../libexec/moldlight/moldlight-step",
  };
  const auto program = own_file(k_places);
  if (!program || ::access(program->c_str(), X_OK) != 0) return std::nullopt;
  return program->string();
}

Part read_step(const ReadContext& context) {
  const std::string_view bytes = context.bytes();
  const std::string_view tail = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 4096));
  if (tail.find(k_end_mark) == std::string_view::npos) {
    context.fail(fmt::format("byte {}", bytes.size()),
                 "the STEP file ends without '{}'; export the part again", k_end_mark);
  }
  const std::uint64_t file_bytes = bytes.size();
  if (!context.in_memory) context.contents.release();
  return part_of_step_result(context, run_reading_program(context, file_bytes));
}

Part part_of_step_result(const ReadContext& context, std::string_view bytes) {
  StepResult result;
  try {
    result = StepResult::from_bytes(bytes);
  } catch (const std::out_of_range&) {
    context.fail("", "{}", k_broken);
  }
  if (!result.error.empty()) context.fail("", "{}", clean_name(result.error));
  check_result(context, result);

  Part part;
  part.unit = clean_name(result.unit);
  for (const std::string& warning : result.warnings) part.warnings.push_back(clean_name(warning));
  FacetIndex first = 0;
  for (const StepBody& body : result.bodies) {
    part.bodies.push_back({clean_name(body.name), first, static_cast<FacetIndex>(body.facets)});
    first += part.bodies.back().facet_count;
  }
  for (const auto& [x, y, z] : result.vertices) part.mesh.vertices.emplace_back(x, y, z);
  part.mesh.facets = std::move(result.facets);
  part.facet_source = std::move(result.faces);
  part.has_cad_faces = true;
  part.face_colours = std::move(result.face_colours);
  part.mesh = weld_vertices(part.mesh);
  return part;
}

}  // namespace moldlight
