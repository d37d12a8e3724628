// The results of a batch: a file each under its key, written under another name and renamed, so that any
// number of runs on any number of machines may write at once and need no locks. A failure that is final is a
// result too.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>

#include "base/progress.hpp"
#include "classify/json.hpp"
#include "io/file_contents.hpp"

namespace moldlight::batch {

enum class ResultState : std::uint8_t { missing, failed, done };

/// What may lie beside a result that is done, for people to look at. Reports of either kind are one file.
enum class Beside : std::uint8_t { picture, report, live_report };

/// What is there at one time; a key that is not in it has no result.
using ResultIndex = std::unordered_map<Digest, ResultState, DigestHash>;

class ResultStore {
 public:
  /// Of the batch in this folder; nothing is made before the first result.
  explicit ResultStore(const std::string& batch_folder);

  /// Asks the disk.
  [[nodiscard]] ResultState state(const Digest& key) const;
  /// The names of all results, in one pass over the folders. Throws FileError where they cannot be read.
  [[nodiscard]] ResultIndex index(const Progress& progress) const;
  /// The same with those keys alone that this lies beside.
  [[nodiscard]] ResultIndex those_with(Beside what, const Progress& progress) const;

  /// Puts the result on the disk, whole, with its key and a checksum of its text; a failure that stands under
  /// the key goes. Throws FileError.
  void put(const Digest& key, ResultState state, const Json& result) const;
  /// Nothing where there is none. Throws FileError for what cannot be read and for what is not what was put
  /// there: a file of another kind, larger than any result, of another key or with another checksum.
  [[nodiscard]] std::optional<Json> read(const Digest& key, ResultState state) const;
  /// Takes a damaged result out of the way, so that the next run makes it anew.
  void set_aside(const Digest& key, ResultState state) const;

  /// Its file: an image of PNG, or a page.
  [[nodiscard]] std::string beside(const Digest& key, Beside what) const;
  [[nodiscard]] bool has(const Digest& key, Beside what) const;
  /// Makes the folder that the key's files lie in.
  void make_folder(const Digest& key) const;
  /// Removes temporary files that runs left behind when they were killed.
  void remove_leftovers(const Progress& progress) const;

 private:
  [[nodiscard]] std::string path(const Digest& key, std::string_view ending) const;

  std::string folder_;
};

}  // namespace moldlight::batch
