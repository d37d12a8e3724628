// A folder of many small parts, each another, and what a batch of them says.
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/small_part.hpp"

namespace moldlight::test {

/// A tetrahedron that no other number gives, as an OFF file: classified in a millisecond.
[[nodiscard]] inline std::string tetrahedron_text(int number) {
  return fmt::format("OFF\n4 4 0\n0 0 0\n{} 0 0\n0 10 0\n0 0 10\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
                     10 + 0.01 * number);
}

/// Parts in `parts`, and room for batches beside them.
class SmallParts {
 public:
  explicit SmallParts(int count) {
    std::filesystem::create_directories(folder_.path() / "parts");
    for (int k = 0; k < count; ++k) add(fmt::format("part-{:04}.off", k), tetrahedron_text(k));
  }
  void add(const std::string& name, const std::string& bytes) const {
    static_cast<void>(folder_.write("parts/" + name, bytes));
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }

  /// Plans `source` of this folder as `name`; with classify along z unless other work is given.
  [[nodiscard]] ProcessResult plan(const std::string& source = "parts", const std::string& name = "night",
                                   std::vector<std::string> work = {"classify", "--direction", "z"}) const {
    std::vector<std::string> arguments = {"batch", "plan", path(source), "--out", path(name), "--"};
    arguments.insert(arguments.end(), work.begin(), work.end());
    return run_moldlight(arguments);
  }
  /// moldlight batch COMMAND night …
  [[nodiscard]] ProcessResult batch(const std::string& command, const std::vector<std::string>& more = {},
                                    const std::string& name = "night",
                                    const ProcessSettings& settings = {}) const {
    std::vector<std::string> arguments = {"batch", command, path(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_moldlight(arguments, settings);
  }
  /// The batch's counts by `status`.
  [[nodiscard]] nlohmann::ordered_json status(const std::string& name = "night") const {
    return json_of(batch("status", {"--json", "-"}, name).out);
  }
  /// The results by their file's name below the batch, without what shows when and how fast they were made.
  [[nodiscard]] std::map<std::string, nlohmann::ordered_json> results(
      const std::string& name = "night") const {
    namespace fs = std::filesystem;
    std::map<std::string, nlohmann::ordered_json> found;
    const fs::path root = folder_.path() / name / "results";
    if (!fs::exists(root)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.path().extension() != ".json") continue;
      auto result = json_of(file_bytes(entry.path()));
      for (const char* member : {"elapsed_s", "finished_at", "checksum"}) result.erase(member);
      if (result.contains("report")) result["report"].erase("timings_ms");
      found[entry.path().filename().string()] = std::move(result);
    }
    return found;
  }
  [[nodiscard]] const ScratchFolder& folder() const { return folder_; }

 private:
  ScratchFolder folder_;
};

}  // namespace moldlight::test
