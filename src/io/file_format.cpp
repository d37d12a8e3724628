#include "io/file_format.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_looked_at_bytes = 4096;

/// Control characters that no text holds show a binary file.
bool looks_binary(std::string_view head) {
  return std::any_of(head.begin(), head.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && (byte < '\t' || byte > '\r') && byte != 0x10 && byte != 0x1a && byte != 0x1b;
  });
}

bool looks_utf16(std::string_view head) {
  if (head.starts_with("\xfe\xff") || head.starts_with("\xff\xfe")) return true;
  if (head.size() < 16) return false;
  std::array<std::size_t, 2> zeros = {0, 0};
  const std::size_t looked_at = std::min<std::size_t>(head.size(), 256) & ~std::size_t{1};
  for (std::size_t i = 0; i < looked_at; ++i) zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  return (zeros[0] == 0 && zeros[1] == looked_at / 2) || (zeros[1] == 0 && zeros[0] == looked_at / 2);
}

/// Format that the first words of a text tell.
std::optional<FileFormat> format_of_text(std::string_view head) {
  TextScanner words(head, {.has_comments = true});
  const std::string_view first = words.next();
  if (equals_ignoring_case(first, "solid")) return FileFormat::stl_ascii;
  if (equals_ignoring_case(first, "facet") && equals_ignoring_case(words.next(), "normal")) {
    return FileFormat::stl_ascii;
  }
  if (first == "ply") return FileFormat::ply;
  if (first.starts_with("ISO-10303-21")) return FileFormat::step;
  for (const std::string_view keyword :
       {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"}) {
    if (first == keyword) return FileFormat::off;
  }
  for (const std::string_view keyword : {"v", "vn", "vt", "vp", "f", "o", "g", "s", "mtllib", "usemtl"}) {
    if (first == keyword) return FileFormat::obj;
  }
  return std::nullopt;
}

std::optional<FileFormat> format_of_extension(const std::string& extension) {
  if (extension == "stl") return FileFormat::stl_ascii;
  if (extension == "obj") return FileFormat::obj;
  if (extension == "ply") return FileFormat::ply;
  if (extension == "off" || extension == "coff") return FileFormat::off;
  if (extension == "3mf") return FileFormat::threemf;
  if (extension == "step" || extension == "stp") return FileFormat::step;
  return std::nullopt;
}

}  // namespace

std::string_view format_name(FileFormat format) {
  static constexpr std::array<std::string_view, 7> k_names = {"STL binary", "STL ASCII", "OBJ", "PLY",
                                                              "OFF",        "3MF",       "STEP"};
  return k_names[static_cast<std::size_t>(format)];
}

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

FileFormat detect_format(const std::string& path, std::string_view bytes) {
  if (bytes.empty()) throw FileError(path, "", "is empty (0 bytes); export the part again");
  // A size that fits the count is worth more than any word in the header: many binary files begin with
  // "solid".
  if (binary_stl_size_fits(bytes)) return FileFormat::stl_binary;
  if (bytes.starts_with("PK\x03\x04")) return FileFormat::threemf;
  if (bytes.starts_with("\x1f\x8b"))
    throw FileError(path, "byte 0", "is compressed with gzip; unpack it first");

  const std::string_view head = bytes.substr(0, k_looked_at_bytes);
  if (looks_utf16(head)) throw FileError(path, "byte 0", "is UTF-16 text; save it as UTF-8 or plain ASCII");
  if (head.starts_with("version https://git-lfs")) {
    throw FileError(path, "line 1", "is a Git LFS pointer, not the part itself; run 'git lfs pull' first");
  }
  const std::optional<FileFormat> told = format_of_text(head);
  const bool binary = looks_binary(head);
  if (told == FileFormat::ply || (told && !binary)) return *told;

  const std::string extension = lower_extension(path);
  if (extension == "stl" && binary) return FileFormat::stl_binary;
  if (const auto named = format_of_extension(extension)) return *named;
  throw FileError(path, "byte 0",
                  "is no part file: neither STL nor OBJ, PLY, OFF, 3MF or STEP by content or name");
}

}  // namespace moldlight
