#include "io/part_formats.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"
#include "mesh/part.hpp"
#include "mold/exact/united_bodies.hpp"

namespace moldlight {

namespace {

/// Place of the first control character that no text holds and that shows a binary file; npos: none.
std::size_t binary_byte(std::string_view head) {
  const auto found = std::ranges::find_if(head, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && (byte < '\t' || byte > '\r') && byte != 0x10 && byte != 0x1a && byte != 0x1b;
  });
  return found == head.end() ? std::string_view::npos : static_cast<std::size_t>(found - head.begin());
}

bool looks_utf16(std::string_view head) {
  if (head.starts_with("\xfe\xff") || head.starts_with("\xff\xfe")) return true;
  if (head.size() < 16) return false;
  std::array<std::size_t, 2> zeros = {0, 0};
  const std::size_t looked_at = std::min<std::size_t>(head.size(), 256) & ~std::size_t{1};
  for (std::size_t i = 0; i < looked_at; ++i) zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  return (zeros[0] == 0 && zeros[1] == looked_at / 2) || (zeros[1] == 0 && zeros[0] == looked_at / 2);
}

template <std::size_t k_count>
bool is_one_of(std::string_view word, const std::array<std::string_view, k_count>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

using Words = std::string_view;

bool begins_ascii_stl(Words first, Words second) {
  return equals_ignoring_case(first, "solid") ||
         (equals_ignoring_case(first, "facet") && equals_ignoring_case(second, "normal"));
}

bool begins_obj(Words first, Words) {
  constexpr std::array<std::string_view, 10> k_statements = {"v", "vn", "vt", "vp",     "f",
                                                             "o", "g",  "s",  "mtllib", "usemtl"};
  return is_one_of(first, k_statements);
}

bool begins_off(Words first, Words) {
  constexpr std::array<std::string_view, 8> k_keywords = {"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                          "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  return is_one_of(first, k_keywords);
}

bool begins_ply(const FileBeginning& file) {
  TextScanner words(file.bytes, {.has_comments = true});
  return words.next() == "ply";
}

bool begins_zip(const FileBeginning& file) { return file.bytes.starts_with("PK\x03\x04"); }

bool begins_iges(const FileBeginning& file) { return is_iges_record(file.bytes, 'S'); }

void refuse_threemf(const std::string& path, const FileBeginning&) {
  throw FileError(path, "byte 0",
                  "is a damaged or truncated zip archive (it does not begin as one); export the part again");
}

const PartFormat* by_extension(const std::string& extension, bool binary) {
  const PartFormat* found = nullptr;
  for (const PartFormat& format : part_formats()) {
    const auto& own = format.extensions;
    if (std::find(own.begin(), own.end(), extension) == own.end()) continue;
    if (found == nullptr || format.binary == binary) found = &format;
  }
  return found;
}

}  // namespace

std::span<const PartFormat> part_formats() {
  // The size of a binary STL that fits its count is worth more than any word in the header: many begin with
  // "solid". A PLY's header is text, whatever follows.
  static const std::vector<PartFormat> k_formats = {
      {"STL binary", {"stl"}, true, binary_stl_size_fits, nullptr, refuse_binary_stl, read_binary_stl},
      {"STL ASCII", {"stl"}, false, nullptr, begins_ascii_stl, nullptr, read_ascii_stl},
      {"OBJ", {"obj"}, false, nullptr, begins_obj, nullptr, read_obj},
      {"PLY", {"ply"}, false, begins_ply, nullptr, nullptr, read_ply},
      {"OFF", {"off", "coff"}, false, nullptr, begins_off, nullptr, read_off},
      {"3MF", {"3mf"}, true, begins_zip, nullptr, refuse_threemf, read_threemf},
      {"STEP",
       {"step", "stp"},
       false,
       nullptr,
       [](Words first, Words) { return first.starts_with("ISO-10303-21"); },
       nullptr,
       read_step},
      {"IGES", {"iges", "igs"}, false, begins_iges, nullptr, nullptr, read_iges},
  };
  return k_formats;
}

std::string part_format_names(std::string_view last) {
  std::vector<std::string> names;
  for (const PartFormat& format : part_formats()) {
    std::string name(format.extensions.front());
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (names.empty() || names.back() != name) names.push_back(std::move(name));
  }
  std::string text = names.front();
  for (std::size_t k = 1; k < names.size(); ++k)
    text.append(k + 1 == names.size() ? last : ", ").append(names[k]);
  return text;
}

bool is_part_file_name(const std::string& name) {
  return by_extension(lower_extension(name), false) != nullptr;
}

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

const PartFormat& detect_format(const std::string& path, const FileBeginning& file,
                                const std::string& extension) {
  if (file.size == 0) throw FileError(path, "", "is empty (0 bytes); export the part again");
  for (const PartFormat& format : part_formats())
    if (format.magic != nullptr && format.magic(file)) return format;
  const std::string_view head = file.bytes;
  if (head.starts_with("\x1f\x8b"))
    throw FileError(path, "byte 0", "is compressed with gzip; unpack it first");
  if (looks_utf16(head)) throw FileError(path, "byte 0", "is UTF-16 text; save it as UTF-8 or plain ASCII");
  if (head.starts_with("version https://git-lfs"))
    throw FileError(path, "line 1", "is a Git LFS pointer, not the part itself; run 'git lfs pull' first");
  const std::size_t binary_at = binary_byte(head);
  const bool binary = binary_at != std::string_view::npos;
  TextScanner words(head, {.has_comments = true});
  const std::string_view first = words.next(), second = words.next();
  for (const PartFormat& format : part_formats())
    if (!binary && format.words != nullptr && format.words(first, second)) return format;
  if (const PartFormat* named = by_extension(extension, binary)) {
    if (named->refuse != nullptr) named->refuse(path, file);
    if (binary && !named->binary) {
      throw FileError(path, fmt::format("byte {}", binary_at),
                      fmt::format("is binary data, and {} is text; export the part again", named->name));
    }
    return *named;
  }
  throw FileError(
      path, "byte 0",
      fmt::format("is not a part file: none of {} by content or name", part_format_names(" and ")));
}

namespace {

std::string named_extension(const std::string& path, const ReadOptions& options) {
  return options.format.empty() ? lower_extension(path) : lower_extension("part." + options.format);
}

Part part_of(const PartFormat& format, const ReadContext& context) {
  const ReadOptions& options = context.options;
  const std::size_t size_mib = context.bytes().size() >> 20;
  try {
    Part part = format.read(context);
    part.file = context.path;
    part.format = format.name;
    part.effort = options.effort;
    if (!options.unit.empty()) set_unit(part, options.unit);
    part = select_body(std::move(part), options.body);
    mend_part(part, options.repair, context.progress);
    if (part.mesh.facets.empty()) context.fail("", "has no facet with an area; the repair left nothing");
    return part;
  } catch (const std::bad_alloc&) {
    context.fail("", "there is not enough memory for this part (a file of {} MiB)", size_mib);
  }
}

}  // namespace

Part read_part(const std::string& path, const ReadOptions& options, const Progress& progress) {
  const PartFormat* format = nullptr;
  FileContents contents(path, progress, [&](const FileBeginning& file) {
    format = &detect_format(path, file, named_extension(path, options));
  });
  return part_of(*format, {path, contents, options, progress});
}

Part read_part_bytes(const std::string& name, std::string_view bytes, const ReadOptions& options,
                     const Progress& progress) {
  const FileBeginning beginning{bytes.substr(0, FileBeginning::k_most_bytes), bytes.size()};
  const PartFormat& format = detect_format(name, beginning, named_extension(name, options));
  check_memory(name, bytes.size());
  FileContents contents(bytes);
  return part_of(format, {name, contents, options, progress, true});
}

}  // namespace moldlight
