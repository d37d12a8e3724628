#include "batch/store.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <functional>

#include <dirent.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_done = ".json", k_failed = ".failed.json", k_damaged = ".damaged";
constexpr int k_folders = 256;  // a result's is the first two digits of its key
constexpr std::size_t k_key_digits = 64;
constexpr off_t k_most_bytes = off_t{256} << 20;  // of a result
constexpr std::string_view k_before_checksum = ",\"checksum\":\"", k_after_checksum = "\"}\n";

/// One line that ends with the checksum of what it would be without it.
std::string sealed(Json result, const Digest& key) {
  result.erase("checksum");
  result["key"] = hex_of(key);
  std::string text = result.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::string checksum = hex_of(digest_of(text));
  text.pop_back();
  return text.append(k_before_checksum).append(checksum).append(k_after_checksum);
}

/// Why this is not what was put under the key; nothing where it is.
std::string fault_of(std::string_view text, const Digest& key, Json& result) {
  const std::size_t tail = k_before_checksum.size() + k_key_digits + k_after_checksum.size();
  if (text.size() <= tail || !text.ends_with(k_after_checksum) ||
      text.substr(text.size() - tail, k_before_checksum.size()) != k_before_checksum)
    return "is damaged and does not end with its checksum";
  const std::string_view noted = text.substr(text.size() - tail + k_before_checksum.size(), k_key_digits);
  const std::string whole = std::string(text.substr(0, text.size() - tail)) + "}";
  if (hex_of(digest_of(whole)) != noted) return "was changed and does not match its checksum";
  result = Json::parse(whole, nullptr, false);
  if (!result.is_object()) return "is damaged";
  const auto own = result.find("key");
  if (own == result.end() || *own != hex_of(key)) return "is the result of another part";
  return "";
}

std::string_view ending_of(ResultState state) {
  CHECK(state != ResultState::missing);
  return state == ResultState::done ? k_done : k_failed;
}

std::string_view ending_of(Beside what) { return what == Beside::picture ? ".png" : ".html"; }

/// Calls `visit` with the key and the ending of every file of results.
void for_each_file(const std::string& folder, const Progress& progress,
                   const std::function<void(const Digest&, std::string_view)>& visit) {
  for (int k = 0; k < k_folders; ++k) {
    if (progress.cancelled()) throw Cancelled();
    const std::string one = fmt::format("{}/{:02x}", folder, k);
    DIR* entries = ::opendir(one.c_str());
    if (entries == nullptr) {
      if (errno == ENOENT) continue;
      throw FileError(one, "", fmt::format("cannot be read: {}", std::strerror(errno)));
    }
    while (const dirent* entry = ::readdir(entries)) {
      const std::string_view name(entry->d_name);
      const auto key = digest_from(name.substr(0, k_key_digits));
      if (key) visit(*key, name.substr(k_key_digits));
    }
    ::closedir(entries);
  }
}

/// A renamed file survives a power cut only once its folder is on the disk, too.
void sync_folder(const std::string& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) static_cast<void>(::fsync(opened.number()));
}

}  // namespace

ResultStore::ResultStore(const std::string& batch_folder)
    : folder_((fs::path(batch_folder) / "results").string()) {}

std::string ResultStore::path(const Digest& key, std::string_view ending) const {
  const std::string name = hex_of(key);
  return fmt::format("{}/{}/{}{}", folder_, name.substr(0, 2), name, ending);
}

ResultState ResultStore::state(const Digest& key) const {
  if (::access(path(key, k_done).c_str(), F_OK) == 0) return ResultState::done;
  return ::access(path(key, k_failed).c_str(), F_OK) == 0 ? ResultState::failed : ResultState::missing;
}

ResultIndex ResultStore::index(const Progress& progress) const {
  ResultIndex found;
  for_each_file(folder_, progress, [&](const Digest& key, std::string_view ending) {
    if (ending == k_done) found[key] = ResultState::done;
    if (ending == k_failed) found.emplace(key, ResultState::failed);
  });
  return found;
}

ResultIndex ResultStore::those_with(Beside what, const Progress& progress) const {
  ResultIndex found;
  for_each_file(folder_, progress, [&](const Digest& key, std::string_view ending) {
    if (ending == ending_of(what)) found[key] = ResultState::done;
  });
  return found;
}

void ResultStore::make_folder(const Digest& key) const {
  const std::string folder = fs::path(path(key, k_done)).parent_path().string();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, "", "cannot be made: " + error.message());
}

void ResultStore::put(const Digest& key, ResultState state, const Json& result) const {
  make_folder(key);
  const std::string file = path(key, ending_of(state));
  write_file(file, sealed(result, key));
  if (state == ResultState::done) ::unlink(path(key, k_failed).c_str());
  sync_folder(fs::path(file).parent_path().string());
}

std::optional<Json> ResultStore::read(const Digest& key, ResultState state) const {
  const std::string file = path(key, ending_of(state));
  struct stat status = {};
  if (::lstat(file.c_str(), &status) != 0) {
    if (errno == ENOENT) return std::nullopt;
    throw FileError(file, "", fmt::format("cannot be read: {}", std::strerror(errno)));
  }
  if (!S_ISREG(status.st_mode)) throw FileError(file, "", "is not a regular file");
  if (status.st_size > k_most_bytes)
    throw FileError(file, "", fmt::format("is larger than any result ({} MiB)", k_most_bytes >> 20));
  const FileContents contents(file, Progress());
  Json result;
  if (const std::string fault = fault_of(contents.bytes(), key, result); !fault.empty())
    throw FileError(file, "", fault);
  return result;
}

void ResultStore::set_aside(const Digest& key, ResultState state) const {
  const std::string file = path(key, ending_of(state));
  // Another row of the same content may have done it.
  if (::rename(file.c_str(), (file + std::string(k_damaged)).c_str()) != 0 && errno != ENOENT)
    throw FileError(file, "", fmt::format("cannot be renamed: {}", std::strerror(errno)));
}

std::string ResultStore::beside(const Digest& key, Beside what) const { return path(key, ending_of(what)); }

bool ResultStore::has(const Digest& key, Beside what) const {
  return ::access(beside(key, what).c_str(), F_OK) == 0;
}

void ResultStore::remove_leftovers(const Progress& progress) const {
  for (int k = 0; k < k_folders; ++k) {
    if (progress.cancelled()) throw Cancelled();
    moldlight::remove_leftovers(fmt::format("{}/{:02x}", folder_, k));
  }
}

}  // namespace moldlight::batch
