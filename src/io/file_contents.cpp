#include "io/file_contents.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <vector>

#include <fmt/format.h>
#include <openssl/evp.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/owned.hpp"

namespace moldlight {

namespace {

constexpr std::uint64_t k_unlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t k_unchecked_bytes = std::uint64_t{64} << 20;
constexpr double k_gib = 1024.0 * 1024.0 * 1024.0;

std::uint64_t difference(std::uint64_t limit, std::uint64_t used) { return limit > used ? limit - used : 0; }

std::uint64_t free_by_machine() {
  std::ifstream lines("/proc/meminfo");
  for (std::string word; lines >> word;) {
    std::uint64_t kib = 0;
    if (word == "MemAvailable:" && lines >> kib) return kib * 1024;
  }
  return k_unlimited;
}

std::uint64_t free_by_control_group() {
  std::ifstream limit_file("/sys/fs/cgroup/memory.max"), used_file("/sys/fs/cgroup/memory.current");
  std::uint64_t limit = 0, used = 0;
  return limit_file >> limit && used_file >> used ? difference(limit, used) : k_unlimited;
}

std::uint64_t free_by_own_limit() {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return k_unlimited;
  std::ifstream pages_file("/proc/self/statm");
  std::uint64_t pages = 0;
  if (!(pages_file >> pages)) return k_unlimited;
  return difference(limit.rlim_cur, pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)));
}

constexpr std::size_t k_read_bytes = std::size_t{8} << 20;

constexpr std::size_t k_hash_bytes = std::size_t{1} << 18;

/// SHA-256 of what is added.
class Sum {
 public:
  Sum() : context_(EVP_MD_CTX_new()) {
    if (!context_) throw std::bad_alloc();
    CHECK(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }

  void add(const char* bytes, std::size_t count) {
    CHECK(EVP_DigestUpdate(context_.get(), bytes, count) == 1);
  }
  [[nodiscard]] Digest value() {
    Digest digest;
    CHECK(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr) == 1);
    return digest;
  }

 private:
  Owned<EVP_MD_CTX, EVP_MD_CTX_free> context_;
};

}  // namespace

void check_memory(const std::string& path, std::uint64_t bytes) {
  if (bytes < k_unchecked_bytes) return;
  const std::uint64_t available = std::min({free_by_machine(), free_by_control_group(), free_by_own_limit()});
  if (bytes <= available) return;
  throw FileError(path, "",
                  fmt::format("needs {:.1f} GiB of memory at least, but {:.1f} GiB are free; close other "
                              "programs or coarsen the part",
                              static_cast<double>(bytes) / k_gib, static_cast<double>(available) / k_gib));
}

FileContents::FileContents(const std::string& path, const Progress& progress, const Look& look) {
  // Without O_NONBLOCK, opening a named pipe would wait for a writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.number() < 0) throw FileError(path, "", fmt::format("cannot be opened: {}", std::strerror(errno)));
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0)
    throw FileError(path, "", fmt::format("cannot be examined: {}", std::strerror(errno)));
  if (S_ISDIR(status.st_mode)) throw FileError(path, "", "is a folder; name a part file");
  if (!S_ISREG(status.st_mode))
    throw FileError(path, "", "is not a regular file; save the part to a file first");

  size_ = static_cast<std::size_t>(status.st_size);
  std::size_t done = 0;
  const auto read_to = [&](char* bytes, std::size_t end) {
    while (done < end) {
      progress.report("reading", static_cast<double>(done) / static_cast<double>(size_));
      const ssize_t got = ::read(file.number(), bytes + done, std::min(k_read_bytes, end - done));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) {
        throw FileError(path, fmt::format("byte {}", done),
                        fmt::format("cannot be read: {}", std::strerror(errno)));
      }
      if (got == 0) {
        throw FileError(path, fmt::format("byte {}", done),
                        "the file shrank while it was read; try again once it is saved");
      }
      done += static_cast<std::size_t>(got);
    }
  };
  std::array<char, FileBeginning::k_most_bytes> first;
  const std::size_t looked_at = std::min(first.size(), size_);
  read_to(first.data(), looked_at);
  if (look) look({{first.data(), looked_at}, size_});
  check_memory(path, size_);
  bytes_ = std::make_unique_for_overwrite<char[]>(size_);
  std::copy_n(first.data(), looked_at, bytes_.get());
  read_to(bytes_.get(), size_);
}

FileContents::FileContents(std::string_view bytes)
    : bytes_(std::make_unique_for_overwrite<char[]>(bytes.size())), size_(bytes.size()) {
  std::copy(bytes.begin(), bytes.end(), bytes_.get());
}

void FileContents::release() {
  bytes_.reset();
  size_ = 0;
}

Digest digest_of(std::string_view bytes) {
  Sum sum;
  sum.add(bytes.data(), bytes.size());
  return sum.value();
}

FileDigest digest_of_file(const std::string& path, const Progress& progress) {
  // Without O_NONBLOCK, opening a named pipe would wait for a writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.number() < 0) return {{}, errno};
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0) return {{}, errno};
  if (!S_ISREG(status.st_mode)) return {{}, S_ISDIR(status.st_mode) ? EISDIR : EINVAL};
  Sum sum;
  std::vector<char> chunk(k_hash_bytes);
  for (;;) {
    if (progress.cancelled()) throw Cancelled();
    const ssize_t got = ::read(file.number(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return {{}, errno};
    if (got == 0) return {sum.value(), 0};
    sum.add(chunk.data(), static_cast<std::size_t>(got));
  }
}

std::string hex_of(const Digest& digest) {
  constexpr std::string_view k_digits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * digest.size());
  for (const std::uint8_t byte : digest) {
    text += k_digits[byte >> 4];
    text += k_digits[byte & 15];
  }
  return text;
}

std::optional<Digest> digest_from(std::string_view hex) {
  Digest digest{};
  if (hex.size() != 2 * digest.size()) return std::nullopt;
  for (std::size_t k = 0; k < digest.size(); ++k) {
    const char* byte = hex.data() + 2 * k;
    if (std::from_chars(byte, byte + 2, digest[k], 16).ptr != byte + 2) return std::nullopt;
  }
  return hex_of(digest) == hex ? std::optional(digest) : std::nullopt;
}

}  // namespace moldlight
