// make_corpus FOLDER [PART…]: writes the seeds of the fuzz targets, FOLDER/<target>/…: small files of our own
// in every spelling, and those given parts that are small and of the target's format.
// FOLDER/fuzz_settings.dict holds the words of the option tables.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "classify/method_options.hpp"
#include "classify/option_json.hpp"
#include "fuzz/seed_files.hpp"
#include "gui/store/part_notes.hpp"
#include "gui/store/user_state.hpp"
#include "io/part_formats.hpp"
#include "io/step_result.hpp"

namespace fs = std::filesystem;
using namespace moldlight;

namespace {

constexpr std::uintmax_t k_max_seed_bytes = 60'000;

void write_seed(const fs::path& folder, const std::string& target, const std::string& name,
                const std::string& bytes) {
  fs::create_directories(folder / target);
  std::ofstream(folder / target / name, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string target_of(const PartFormat& format) {
  static const std::map<std::string_view, std::string> k_targets = {{"STL binary", "fuzz_binary_stl"},
                                                                    {"STL ASCII", "fuzz_ascii_stl"},
                                                                    {"OBJ", "fuzz_obj"},
                                                                    {"PLY", "fuzz_ply"},
                                                                    {"OFF", "fuzz_off"},
                                                                    {"3MF", "fuzz_threemf"}};
  const auto found = k_targets.find(format.name);
  return found != k_targets.end() ? found->second : "";
}

FileBeginning beginning_of(std::string_view bytes) {
  return {bytes.substr(0, FileBeginning::k_most_bytes), bytes.size()};
}

void add_part(const fs::path& folder, const fs::path& path) {
  std::error_code error;
  if (fs::file_size(path, error) > k_max_seed_bytes || error) return;
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  try {
    const std::string target =
        target_of(detect_format(path.string(), beginning_of(bytes), lower_extension(path.string())));
    if (!target.empty()) write_seed(folder, target, path.filename().string(), bytes);
  } catch (const FileError&) {
    // No part file by content or name: no seed either.
  }
}

std::string step_result_seed() {
  StepResult result;
  result.unit = "mm";
  result.warnings = {"1 entity is faulty"};
  result.bodies = {{"pin", 1}, {"", 1}};
  result.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  result.facets = {{0, 1, 2}, {1, 2, 3}};
  result.faces = {0, 1};
  return result.to_bytes();
}

/// Of tetrahedra, boxes and loose facets, on the grid and off it.
void write_small_meshes(const fs::path& folder) {
  const std::vector<std::vector<std::uint8_t>> meshes = {
      {0x00, 3, 3, 4, 0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 2, 5, 1, 2, 1, 5, 2},
      {0x11, 4, 5, 6, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 1, 1, 1, 5, 1, 1, 1, 5, 1, 1, 1, 5},
      {0x05, 3, 3, 4, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 4, 0, 0, 4, 4, 0, 0, 4, 0, 2, 2, 6},
      {0x02, 3, 3, 4, 0, 0, 0, 4, 4, 2, 1, 1, 2, 3, 3, 4},
      {0x46, 6, 3, 4, 0, 0, 0, 4, 4, 2, 2, 2, 1, 6, 6, 5},
      {0x83, 3, 4, 5, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 1, 1, 2, 5, 1, 3, 1, 5, 2, 3, 3, 7}};
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const std::string bytes(meshes[k].begin(), meshes[k].end());
    write_seed(folder, "fuzz_exact_regions", std::to_string(k), bytes);
    // Of a wide part the first byte is the number of coordinates that are changed: none.
    for (const char* wide : {"fuzz_split_mesh", "fuzz_actions", "fuzz_mold", "fuzz_compare"})
      write_seed(folder, wide, std::to_string(k), std::string(1, '\0') + bytes);
  }
}

void write_scripts(const fs::path& folder) {
  const std::vector<std::string> scripts = {
      R"([{"move": [10, 10]}, {"click": "Flip", "button": "right", "times": 2}, {"wheel": -2.5, "at": [5, 6]}])",
      R"([{"drag": [[1, 2], "Required draft@0.3", [3, 4]], "release": false}, {"hold": ["ctrl", "shift", "alt"]}])",
      R"([{"key": "F12", "ctrl": true, "shift": false, "alt": true}, {"type": "text"}, {"wait": "loaded"}])",
      R"([{"open": "a.stl"}, {"drop": "b.stl"}, {"resize": [800, 600]}, {"scale": 2}, {"wait": 0.5}])",
      R"([{"wait": "measured"}, {"wait": "swept"}, {"screenshot": "out.png"}])"};
  for (std::size_t k = 0; k < scripts.size(); ++k)
    write_seed(folder, "fuzz_script", std::to_string(k), scripts[k]);
}

template <typename Settings>
void add_words(std::span<const Option<Settings>> options, std::set<std::string>& words) {
  for (const Option<Settings>& option : options) {
    words.emplace(option.key);
    std::visit(
        [&](const auto& kind) {
          if constexpr (requires { kind.words; }) words.insert(kind.words.begin(), kind.words.end());
        },
        option.kind);
  }
}

void write_settings(const fs::path& folder) {
  gui::PartNotes notes;
  notes.bookmarks.push_back({.note = "hook", .direction = {0, 1, 0}});
  write_seed(folder, "fuzz_settings", "notes", gui::part_notes_json(notes, "part.stl"));
  gui::UserState user;
  user.recent = {"/a.stl"};
  write_seed(folder, "fuzz_settings", "user", gui::user_state_json(user));
  write_seed(folder, "fuzz_settings", "method", options_json(method_options(), MethodSettings{}).dump());
  write_seed(folder, "fuzz_settings", "reading", options_json(reading_options(), ReadOptions{}).dump());

  std::set<std::string> words = {"schema",
                                 "moldlight.view/1",
                                 "moldlight.view/3",
                                 "settings",
                                 "look",
                                 "bookmarks",
                                 "direction",
                                 "note",
                                 "recent",
                                 "sweep"};
  add_words(method_options(), words);
  add_words(reading_options(), words);
  add_words(look_options(), words);
  add_words(sweep_options(), words);
  add_words(gui::window_options(), words);
  std::ofstream dictionary(folder / "fuzz_settings.dict");
  for (const std::string& word : words) dictionary << "\"\\\"" << word << "\\\"\"\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const fs::path folder = argv[1];
  for (const fuzz::SeedFile& seed : fuzz::seed_files()) {
    const std::string target =
        target_of(detect_format(seed.name, beginning_of(seed.bytes), lower_extension(seed.name)));
    write_seed(folder, target, seed.name, seed.bytes);
  }
  for (const fuzz::SeedFile& seed : fuzz::threemf_model_seeds()) {
    write_seed(folder, "fuzz_threemf_model", seed.name, seed.bytes);
  }
  write_seed(folder, "fuzz_step_result", "two_bodies", step_result_seed());
  write_seed(folder, "fuzz_direction_list", "names", "x,y,z,note\n# two\n0,0,1,top\n0.5 ; -0.5 ;\t1e-3\r\n");
  write_small_meshes(folder);
  write_scripts(folder);
  write_settings(folder);
  for (int i = 2; i < argc; ++i) add_part(folder, argv[i]);
}
