// A part with all four regions, small enough to be classified over and over.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/mesh_writer.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"

namespace moldlight::test {

/// A part file in a folder of its own, and room beside it for what the program writes.
class SmallPart {
 public:
  SmallPart() : shape_(refined(cup_with_side_hole(ShapeSettings{}), 300)) {
    const std::vector<Region> regions(shape_.mesh.facets.size(), Region::core);
    write_coloured_mesh(file(), {shape_.mesh, regions});
  }

  [[nodiscard]] const Shape& shape() const { return shape_; }
  [[nodiscard]] std::string file() const { return folder_.file("cup.obj"); }
  [[nodiscard]] std::string output(const std::string& name) const { return folder_.file(name); }
  [[nodiscard]] const ScratchFolder& folder() const { return folder_; }

  /// Arguments of a quick classification along z, and more.
  [[nodiscard]] std::vector<std::string> classify(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"classify", file(),         "--direction", "0,0,1",     "--samples",
                                          "20000",    "--resolution", "256",         "--backend", "osmesa"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  /// Arguments of a quick sweep by undercut, and more.
  [[nodiscard]] std::vector<std::string> sweep(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"sweep",        file(),      "--directions",
                                          "60",           "--refine",  "2",
                                          "--top",        "4",         "--rank",
                                          "objective",    "--samples", "20000",
                                          "--resolution", "256",       "--scoring-samples",
                                          "2000",         "--backend", "osmesa"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

 private:
  ScratchFolder folder_;
  Shape shape_;
};

/// The arguments with this value for the flag, in place of the one that it has there, or for the "PART".
[[nodiscard]] inline std::vector<std::string> with(std::vector<std::string> arguments,
                                                   const std::string& flag, const std::string& value) {
  const auto found = flag == "PART" ? arguments.begin() : std::ranges::find(arguments, flag);
  if (found == arguments.end()) {
    arguments.insert(arguments.end(), {flag, value});
  } else {
    *(found + 1) = value;
  }
  return arguments;
}

/// Names of an object's members, in their order.
[[nodiscard]] inline std::vector<std::string> keys(const nlohmann::ordered_json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items()) names.push_back(key);
  return names;
}

[[nodiscard]] inline nlohmann::ordered_json json_of(const std::string& text) {
  return nlohmann::ordered_json::parse(text);
}

}  // namespace moldlight::test
