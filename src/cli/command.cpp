#include "cli/command.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "classify/classify_report.hpp"
#include "io/atomic_file.hpp"

namespace moldlight::cli {

namespace fs = std::filesystem;

namespace {

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path first = fs::weakly_canonical(a, error), second = fs::weakly_canonical(b, error);
  return !first.empty() && first == second;
}

/// A device or pipe may be named twice, and is not opened before it is written.
bool is_special(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

bool is_inside(const std::string& file, const std::string& folder) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  for (fs::path above = fs::weakly_canonical(file, error).parent_path(); above.has_relative_path();
       above = above.parent_path()) {
    if (above == whole) return true;
  }
  return false;
}

/// Throws FileError for a folder that is none, or that cannot be made or written to.
void check_folder(const std::string& folder) {
  std::error_code error;
  fs::path there = fs::absolute(folder, error);
  while (!there.empty() && !fs::exists(there, error) && there != there.parent_path())
    there = there.parent_path();
  if (!fs::is_directory(there, error))
    throw FileError(folder, "", fmt::format("cannot be a folder: {} is not one", there.string()));
  if (::access(there.c_str(), W_OK | X_OK) != 0) {
    throw FileError(folder, "",
                    fmt::format("cannot be written to: {}: {}", there.string(), std::strerror(errno)));
  }
}

}  // namespace

std::vector<CommandRow>& commands() {
  static std::vector<CommandRow> rows;
  return rows;
}

RegisteredCommand::RegisteredCommand(const CommandRow& row) {
  std::vector<CommandRow>& rows = commands();
  rows.insert(std::ranges::upper_bound(rows, row.place, {}, &CommandRow::place), row);
}

void check_outputs(const Outputs& outputs) {
  const auto& [inputs, files, folder] = outputs;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const NamedPath& file = files[i];
    if (file.path.empty() || is_special(file.path)) continue;
    if (file.path == "-")
      throw UsageError(fmt::format("{}: only --json can go to stdout; name a file", file.flag));
    for (const NamedPath& input : inputs) {
      if (input.path.empty() || !same_file(file.path, input.path)) continue;
      throw UsageError(
          fmt::format("{}: {} is the input {}; name another file", file.flag, file.path, input.flag));
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (files[k].path.empty() || !same_file(files[k].path, file.path)) continue;
      throw UsageError(fmt::format("{} and {} name the same file, {}", files[k].flag, file.flag, file.path));
    }
    if (!folder.path.empty() && is_inside(file.path, folder.path)) {
      throw UsageError(fmt::format("{}: {} is in the output folder of {}; name a place outside", file.flag,
                                   file.path, folder.flag));
    }
    const AtomicFile attempt(file.path);
  }
  if (!folder.path.empty()) check_folder(folder.path);
}

void put_report(Console& console, const std::string& json_path, const std::function<Json()>& json,
                const std::function<std::string()>& text) {
  if (json_path == "-") return console.result(json_text(json()));
  if (!json_path.empty()) write_file(json_path, json_text(json()));
  console.result(text());
}

}  // namespace moldlight::cli
