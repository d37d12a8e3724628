#include "cli/served_parts.hpp"

#include <algorithm>
#include <system_error>

#include "base/error.hpp"
#include "base/shown_text.hpp"

namespace moldlight::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t k_parts_kept = 4, k_shown_path_bytes = 200;

bool is_same_file(const ServedPart& a, const ServedPart& b) {
  return a.path == b.path && a.size == b.size && a.changed == b.changed && a.reading == b.reading;
}

}  // namespace

ServedParts::ServedParts(const std::string& folder) {
  std::error_code error;
  folder_ = fs::canonical(folder, error);
  if (!error) fs::current_path(folder_, error);
  if (error) throw FileError(folder, "", "cannot be served as a folder: " + error.message());
}

std::string ServedParts::inside(const std::string& path) const {
  const std::string shown = shown_text(path, k_shown_path_bytes);
  if (path.find('\0') != std::string::npos) throw FileError(shown, "", "is no path: a byte of it is 0");
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder_ / path, error);
  if (error) throw FileError(shown, "", "cannot be opened: " + error.message());
  const fs::path inside = whole.lexically_relative(folder_);
  if (inside.empty() || *inside.begin() == "..")
    throw FileError(shown, "", "lies outside of the folder that is served; name a part in it");
  return inside.string();
}

ServedPart ServedParts::part(const std::string& path, const ReadOptions& reading,
                             const Progress& progress) const {
  ServedPart part{.path = inside(path), .reading = reading, .study = Study()};
  std::error_code error;
  part.size = fs::file_size(part.path, error);
  part.changed = fs::last_write_time(part.path, error);
  const auto known =
      std::ranges::find_if(parts_, [&](const ServedPart& one) { return is_same_file(one, part); });
  if (known != parts_.end()) return *known;
  // What cannot be looked at is reported by the reader.
  part.study = Study(load_part(part.path, reading, progress));
  return part;
}

void ServedParts::keep(ServedPart part) {
  std::erase_if(parts_,
                [&](const ServedPart& one) { return one.path == part.path && one.reading == part.reading; });
  parts_.push_front(std::move(part));
  if (parts_.size() > k_parts_kept) parts_.pop_back();
}

}  // namespace moldlight::cli
