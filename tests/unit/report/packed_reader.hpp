// Reads what PackedBytes writes.
#pragma once

#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

namespace moldlight::report {

inline std::string bytes_of_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6 | static_cast<std::uint32_t>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 255);
  }
  return bytes;
}

class PackedReader {
 public:
  explicit PackedReader(const nlohmann::ordered_json& packed) {
    const std::string small = bytes_of_base64(packed["data"].get<std::string>());
    bytes_.resize(std::size_t{1} << 24);
    uLongf size = static_cast<uLongf>(bytes_.size());
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes_.data()), &size,
                         reinterpret_cast<const Bytef*>(small.data()), static_cast<uLong>(small.size())),
              Z_OK);
    bytes_.resize(size);
  }
  unsigned char byte() { return static_cast<unsigned char>(bytes_.at(at_++)); }
  std::uint32_t number() {
    std::uint32_t value = 0;
    for (int shift = 0;; shift += 7) {
      const unsigned char next = byte();
      value |= static_cast<std::uint32_t>(next & 127) << shift;
      if (next < 128) return value;
    }
  }
  std::int32_t difference() {
    const std::uint32_t value = number();
    return value % 2 != 0 ? -static_cast<std::int32_t>(value / 2) - 1 : static_cast<std::int32_t>(value / 2);
  }
  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace moldlight::report
