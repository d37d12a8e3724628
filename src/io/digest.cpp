#include "io/digest.hpp"

#include <cerrno>
#include <new>
#include <vector>

#include <openssl/evp.h>
#include <sys/stat.h>

#include "base/check.hpp"
#include "io/descriptor.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_hash_bytes = std::size_t{1} << 18;

/// SHA-256 of what is added.
class Sum {
 public:
  Sum() : context_(EVP_MD_CTX_new()) {
    if (context_ == nullptr) throw std::bad_alloc();
    CHECK(EVP_DigestInit_ex(context_, EVP_sha256(), nullptr) == 1);
  }
  ~Sum() { EVP_MD_CTX_free(context_); }
  Sum(const Sum&) = delete;
  Sum& operator=(const Sum&) = delete;

  void add(const char* bytes, std::size_t count) { CHECK(EVP_DigestUpdate(context_, bytes, count) == 1); }
  [[nodiscard]] Digest value() {
    Digest digest;
    CHECK(EVP_DigestFinal_ex(context_, digest.data(), nullptr) == 1);
    return digest;
  }

 private:
  EVP_MD_CTX* context_;
};

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

}  // namespace

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
  Digest digest;
  if (hex.size() != 2 * digest.size()) return std::nullopt;
  for (std::size_t k = 0; k < digest.size(); ++k) {
    const int high = hex_value(hex[2 * k]), low = hex_value(hex[2 * k + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    digest[k] = static_cast<std::uint8_t>(16 * high + low);
  }
  return digest;
}

}  // namespace moldlight
