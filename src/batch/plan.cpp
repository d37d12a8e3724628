#include "batch/plan.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>
#include <unordered_map>

#include <fmt/format.h>
#include <glob.h>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "io/part_formats.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t k_report_every = 256;  // entries

std::string absolute_folder(const fs::path& folder) {
  std::string text = fs::absolute(folder.empty() ? "." : folder).lexically_normal().string();
  if (text.size() > 1 && text.ends_with('/')) text.pop_back();
  return text;
}

/// Whether a link leads out of the folder, to what nobody named.
bool leads_out(const fs::directory_entry& entry, const fs::path& folder) {
  std::error_code error;
  if (!entry.is_symlink(error)) return false;
  const fs::path target = fs::canonical(entry.path(), error);
  return error || std::ranges::mismatch(folder, target).in1 != folder.end();
}

PlanSource folder_source(const std::string& folder, const Progress& progress) {
  PlanSource source{.parts = absolute_folder(folder), .entries = {}, .left_out = 0};
  std::error_code error;
  const fs::path folder_itself = fs::canonical(source.parts, error);
  for (fs::recursive_directory_iterator
           entry(source.parts, fs::directory_options::skip_permission_denied, error),
       end;
       !error && entry != end; entry.increment(error)) {
    if (source.entries.size() % k_report_every == 0) progress.report("looking for parts", 0.0);
    std::error_code ignored;
    const bool hidden = entry->path().filename().string().starts_with('.');
    if (hidden && entry->is_directory(ignored)) entry.disable_recursion_pending();
    if (hidden || !entry->is_regular_file(ignored) || !is_part_file_name(entry->path().filename().string()))
      continue;
    if (leads_out(*entry, folder_itself)) {
      ++source.left_out;
      continue;
    }
    source.entries.push_back(
        {.path = entry->path().lexically_relative(source.parts).string(), .settings = {}, .place = {}});
  }
  if (error) throw FileError(folder, "", "cannot be read: " + error.message());
  if (source.entries.empty() && source.left_out > 0) {
    throw FileError(folder, "",
                    "holds no part file, only links that lead out of it; name the parts in a list");
  }
  if (source.entries.empty()) {
    throw FileError(folder, "",
                    fmt::format("holds no part file with a name like {}", part_format_names(" or ")));
  }
  std::ranges::sort(source.entries, {}, &PlanEntry::path);
  return source;
}

PlanSource list_source(const std::string& list, const Progress& progress) {
  PlanSource source{.parts = absolute_folder(fs::path(list).parent_path()), .entries = {}, .left_out = 0};
  std::ifstream file(list, std::ios::binary);
  if (!file) throw FileError(list, "", fmt::format("cannot be read: {}", std::strerror(errno)));
  // Where commas are decimal marks, programs part fields by semicolons.
  std::string first;
  std::getline(file, first);
  file.clear();
  file.seekg(0);
  CsvReader records(file, list);
  if (first.find(',') == std::string::npos && first.find(';') != std::string::npos)
    records.set_separator(';');
  std::vector<std::string> names, fields;
  const bool has_names = records.next(names);
  const auto path_column = static_cast<std::size_t>(std::ranges::find(names, "path") - names.begin());
  if (!has_names || path_column == names.size())
    throw FileError(list, "line 1", "there is no column `path`; the first line names the columns");
  while (records.next(fields)) {
    const std::string place = fmt::format("line {}", records.line());
    if (fields.size() != names.size())
      throw FileError(list, place, fmt::format("has {} fields, not {}", fields.size(), names.size()));
    PlanEntry entry{.path = fields[path_column], .settings = {}, .place = place};
    if (entry.path.empty()) throw FileError(list, place, "the path is empty");
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (k != path_column && !fields[k].empty()) entry.settings.emplace_back(names[k], fields[k]);
    source.entries.push_back(std::move(entry));
    if (source.entries.size() % k_report_every == 0) progress.report("reading the list", 0.0);
  }
  if (source.entries.empty()) throw FileError(list, "", "names no part");
  return source;
}

PlanSource pattern_source(const std::string& pattern) {
  // A file's own name may look like a pattern.
  std::vector<std::string> files;
  if (fs::exists(pattern)) {
    files = {pattern};
  } else {
    glob_t found = {};
    if (::glob(pattern.c_str(), 0, nullptr, &found) == 0)
      files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    ::globfree(&found);
    std::erase_if(files, [](const std::string& file) { return !fs::is_regular_file(file); });
  }
  if (files.empty())
    throw FileError(pattern, "", "there is no such folder or list, and no file matches it as a pattern");
  // The deepest folder that all lie in.
  fs::path folder = absolute_folder(fs::path(files.front()).parent_path());
  PlanSource source;
  for (const std::string& file : files) {
    const fs::path absolute = fs::absolute(file).lexically_normal();
    while (!(absolute.string() + '/').starts_with(folder == "/" ? "/" : folder.string() + '/'))
      folder = folder.parent_path();
  }
  source.parts = folder.string();
  for (const std::string& file : files)
    source.entries.push_back(
        {.path = fs::absolute(file).lexically_normal().lexically_relative(folder).string(),
         .settings = {},
         .place = {}});
  return source;
}

/// Digests of the files, each read once; on all cores, more of them where reading is what takes the time.
std::vector<FileDigest> digests_of(const std::vector<std::string>& files, const Progress& progress) {
  std::vector<FileDigest> digests(files.size());
  std::atomic<std::size_t> next = 0;
  Progress stop(&progress);
  const auto read_some = [&] {
    try {
      for (std::size_t k = next++; k < files.size(); k = next++) digests[k] = digest_of_file(files[k], stop);
    } catch (const Cancelled&) {  // thrown again below
    }
  };
  const std::size_t wanted =
      std::min<std::size_t>(2 * static_cast<std::size_t>(usable_cores()), files.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < wanted; ++k) threads.emplace_back(read_some);
    while (next < files.size() && !progress.cancelled()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      const double share = static_cast<double>(next) / static_cast<double>(files.size());
      if (!progress.cancelled()) progress.report("reading the parts", std::min(share, 1.0));
    }
  }
  progress.report("reading the parts", 1.0);
  return digests;
}

/// Paths stay valid where folder of batch and parts move together; from the root down they have nothing in
/// common.
std::string parts_from(const std::string& batch_folder, const std::string& parts) {
  const fs::path batch = absolute_folder(batch_folder), relative = fs::path(parts).lexically_relative(batch);
  const auto up = std::count(relative.begin(), relative.end(), "..");
  const auto depth = std::distance(batch.begin(), batch.end()) - 1;
  return relative.empty() || up >= depth ? parts : relative.string();
}

}  // namespace

PlanSource read_plan_source(const std::string& source, const Progress& progress) {
  if (fs::is_directory(source)) return folder_source(source, progress);
  if (lower_extension(source) == "csv" && fs::is_regular_file(source)) return list_source(source, progress);
  return pattern_source(source);
}

std::vector<Row> plan_rows(Manifest& manifest, const PlanSource& source, const SettingsMaker& make,
                           const Progress& progress) {
  manifest.parts = parts_from(manifest.folder, source.parts);
  manifest.settings.clear();
  std::unordered_map<std::string, std::uint32_t>
      settings_numbers;  // of equal ones, each checked and kept once
  std::vector<Row> rows;
  std::vector<std::string> files;
  std::vector<std::size_t> file_of_row;
  std::unordered_map<std::string, std::size_t> file_numbers;
  for (const PlanEntry& entry : source.entries) {
    Row row;
    row.number = rows.size();
    row.path = entry.path;
    try {
      std::string text;
      for (const auto& [name, value] : entry.settings) text += fmt::format("{}={}\n", name, value);
      const auto [settings, is_new] =
          settings_numbers.emplace(text, static_cast<std::uint32_t>(manifest.settings.size()));
      if (is_new) manifest.settings.push_back(make(entry.settings));
      row.settings = settings->second;
    } catch (const UsageError& error) {
      if (entry.place.empty()) throw;
      throw UsageError(fmt::format("{}: {}: {}", manifest.source, entry.place, error.what()));
    }
    if (row.path.find('\0') != std::string::npos)
      throw FileError(manifest.source, entry.place, "the path holds a byte 0");
    const std::string file = (fs::path(source.parts) / row.path).string();
    const auto [number, is_new] = file_numbers.emplace(file, files.size());
    if (is_new) files.push_back(file);
    file_of_row.push_back(number->second);
    rows.push_back(std::move(row));
    if (rows.size() % k_report_every == 0) progress.report("planning", 0.0);
  }
  const std::vector<FileDigest> digests = digests_of(files, progress);
  const KeyMaker key_of(manifest);
  std::unordered_map<Digest, std::size_t, DigestHash> first_rows;
  for (Row& row : rows) {
    const FileDigest& file = digests[file_of_row[row.number]];
    row.content = file.digest;
    if (file.error != 0)
      row.fault = file.error == EINVAL ? "is not a regular file" : std::strerror(file.error);
    const auto [first, is_new] = first_rows.emplace(key_of(row), row.number);
    if (!is_new) row.same_as = first->second;
  }
  return rows;
}

}  // namespace moldlight::batch
