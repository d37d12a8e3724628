// moldlight-step: reads one STEP file for moldlight from descriptor 4 and writes the facets to descriptor 3,
// then, if it stays, the part as the labels say that come to descriptor 5. Not meant to be run by hand.
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <istream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <dlfcn.h>
#include <ext/stdio_filebuf.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "io/step_labels.hpp"
#include "step/cad_part.hpp"
#include "step/part_writer.hpp"
#include "step/sandbox.hpp"
#include "step/tessellation.hpp"

namespace {

using moldlight::StepResult;

constexpr std::size_t k_buffer_bytes = std::size_t{1} << 16;
// More than what OpenCASCADE asks for at a time.
constexpr std::uint64_t k_margin_bytes = std::uint64_t{32} << 20;
constexpr std::uint64_t k_margin_divisor = 16;  // and that part of the limit

/// /proc/self/status, opened while files still may be.
int open_status = -1;

std::uint64_t peak_address_space() {
  std::array<char, 4096> text{};
  const ssize_t got = ::pread(open_status, text.data(), text.size() - 1, 0);
  const std::string_view lines(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  constexpr std::string_view k_peak = "VmPeak:";
  const std::size_t at = lines.find(k_peak);
  return at == std::string_view::npos ? 0
                                      : 1024 * std::strtoull(lines.data() + at + k_peak.size(), nullptr, 10);
}

/// Limits the address space, but never raises a limit that is there, and opens what memory_ran_short() reads.
/// `refused` is called where an allocation in C++ fails, and must not return.
void limit_memory([[maybe_unused]] std::uint64_t bytes, void (*refused)()) {
  std::set_new_handler(refused);
  open_status = ::open("/proc/self/status", O_RDONLY | O_CLOEXEC);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  rlimit limit = {};
  // The superuser could raise what the caller has set.
  if (::getrlimit(RLIMIT_AS, &limit) == 0) bytes = std::min({bytes, limit.rlim_cur, limit.rlim_max});
  limit = {bytes, bytes};
  static_cast<void>(::setrlimit(RLIMIT_AS, &limit));
#endif
}

/// True where the address space was nearly used up at some time. OpenCASCADE passes over many an allocation
/// that fails and leaves out the faces it was for.
bool memory_ran_short() {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
  return peak_address_space() + k_margin_bytes + limit.rlim_cur / k_margin_divisor > limit.rlim_cur;
}

/// Of both kinds of result the error comes first.
std::string failed(const std::string& sentence) {
  StepResult result;
  result.error = sentence;
  return result.to_bytes();
}

bool written(const void* bytes, std::size_t size) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t now =
        ::write(moldlight::k_step_result_descriptor, static_cast<const char*>(bytes) + done, size - done);
    if (now <= 0) return false;
    done += static_cast<std::size_t>(now);
  }
  return true;
}

/// How many bytes, and the bytes. Ends the program where nobody takes them.
void hand_back(const std::string& bytes) {
  const std::uint64_t size = bytes.size();
  if (!written(&size, sizeof size) || !written(bytes.data(), bytes.size())) ::_exit(1);
}

/// Made before memory can be short.
const std::string& no_memory_left() {
  static const std::string bytes =
      failed("needs more memory than is allowed; coarsen the deflection or export the part as STL");
  return bytes;
}

[[noreturn]] void end_without_memory() {
  hand_back(no_memory_left());
  ::_exit(0);
}

/// The part file for those who open it by name.
std::FILE* iges_file = nullptr;

std::string all_of(int descriptor) {
  std::string bytes;
  std::vector<char> chunk(k_buffer_bytes);
  for (ssize_t got = 0; (got = ::read(descriptor, chunk.data(), chunk.size())) > 0;)
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
  return bytes;
}

struct Task {
  moldlight::step::TessellationSettings settings;
  bool is_iges = false, stays = false;
};

/// What `make` gives as bytes, or what went wrong; `failure` is said of OpenCASCADE, in two halves.
template <typename Make>
std::string answer(const Make& make, const std::array<const char*, 2>& failure) {
  std::string bytes;
  try {
    bytes = make();
  } catch (const Standard_OutOfMemory&) {
    end_without_memory();
  } catch (const Standard_Failure& failed_there) {
    bytes = failed(failure[0] + std::string(failed_there.DynamicType()->Name()) + failure[1]);
  } catch (const std::exception& error) {
    bytes = failed(error.what());
  }
  if (memory_ran_short()) end_without_memory();
  return bytes;
}

moldlight::step::CadPart read(const Task& task) {
  __gnu_cxx::stdio_filebuf<char> buffer(moldlight::k_step_file_descriptor, std::ios::in, k_buffer_bytes);
  std::istream file(&buffer);
  moldlight::step::prepare();
  if (task.is_iges) iges_file = ::fdopen(moldlight::k_step_file_descriptor, "r");
  if (const std::string fault = moldlight::step::give_up_rights(); !fault.empty())
    throw std::runtime_error(fault);
  return task.is_iges ? moldlight::step::read_iges() : moldlight::step::read_step(file);
}

/// True where nobody is left to read the result, as after an interrupt just before the call of prctl.
bool is_orphan() {
  pollfd result = {moldlight::k_step_result_descriptor, 0, 0};
  return ::poll(&result, 1, 0) > 0 && (result.revents & (POLLERR | POLLNVAL)) != 0;
}

}  // namespace

/// In place of the C library's: the kernel's filter refuses to open files, and OpenCASCADE's reader of IGES
/// knows them by name alone.
extern "C" std::FILE* fopen(const char* name, const char* mode) {
  if (std::string_view(name) == moldlight::step::k_iges_name) return std::exchange(iges_file, nullptr);
  const auto real = reinterpret_cast<decltype(&std::fopen)>(::dlsym(RTLD_NEXT, "fopen"));
  return real == nullptr ? nullptr : real(name, mode);
}

/// Arguments: linear deflection, angular deflection in degrees, facet limit, memory limit in bytes, "STEP" or
/// "IGES", "read" or "stay". The file is open as k_step_file_descriptor, and if it stays, labels come to
/// k_step_labels_descriptor. Ends without tidying up OpenCASCADE's tables, which takes time and serves
/// nobody.
int main(int argc, char** argv) {
  if (argc != 7) return 2;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (is_orphan()) return 1;
  const rlimit no_core_file = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core_file);
  no_memory_left();
  limit_memory(std::strtoull(argv[4], nullptr, 10), end_without_memory);
  Task task;
  task.settings.linear_deflection = std::strtod(argv[1], nullptr);
  task.settings.angular_deflection_deg = std::strtod(argv[2], nullptr);
  task.settings.max_facets = std::strtoull(argv[3], nullptr, 10);
  task.is_iges = std::string_view(argv[5]) == "IGES";
  task.stays = std::string_view(argv[6]) == "stay";
  moldlight::step::CadPart part;
  hand_back(answer(
      [&] {
        part = read(task);
        return moldlight::step::tessellate(part, task.settings).to_bytes();
      },
      {"cannot be read by OpenCASCADE (", "); export the part again"}));
  const std::string labels = task.stays ? all_of(moldlight::k_step_labels_descriptor) : std::string();
  if (labels.empty()) ::_exit(0);
  hand_back(answer(
      [&] {
        return moldlight::step::write_labelled(part, moldlight::StepLabels::from_bytes(labels)).to_bytes();
      },
      {"cannot be split by OpenCASCADE (", "); use --mesh"}));
  ::_exit(0);
}
