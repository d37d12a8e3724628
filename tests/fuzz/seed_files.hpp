// Small sound files in every format and many spellings: where fuzzing and mutating start.
#pragma once

#include <string>
#include <vector>

namespace moldlight::fuzz {

struct SeedFile {
  std::string name;
  std::string bytes;
  bool is_model = false;  // bytes are the model document of a 3MF package, still to be packed
};

/// Part files that read without an error.
[[nodiscard]] std::vector<SeedFile> seed_files();

/// Texts of the model document of a 3MF package.
[[nodiscard]] std::vector<SeedFile> threemf_model_seeds();

}  // namespace moldlight::fuzz
