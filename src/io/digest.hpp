// SHA-256, by which contents and results are named.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace moldlight {

using Digest = std::array<std::uint8_t, 32>;

struct DigestHash {
  [[nodiscard]] std::size_t operator()(const Digest& digest) const {
    std::size_t value;
    std::memcpy(&value, digest.data(), sizeof(value));
    return value;
  }
};

[[nodiscard]] Digest digest_of(std::string_view bytes);

struct FileDigest {
  Digest digest{};
  int error = 0;  // errno where the file cannot be read; 0: it was
};
/// Of a regular file's content; throws Cancelled.
[[nodiscard]] FileDigest digest_of_file(const std::string& path, const Progress& progress);

/// 64 hexadecimal digits in lower case.
[[nodiscard]] std::string hex_of(const Digest& digest);
/// Nothing for what is no such text.
[[nodiscard]] std::optional<Digest> digest_from(std::string_view hex);

}  // namespace moldlight
