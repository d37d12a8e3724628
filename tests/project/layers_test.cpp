// The layers of src/: who may include whom, and which library belongs to which layer. Read from the include
// lines.
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using Layers = std::set<std::string>;

/// Each layer and what it may include, itself aside; src/README.md says why.
const std::map<std::string, Layers>& allowed_layers() {
  static const Layers k_domain = {"base", "mesh", "mold"};
  static const Layers k_classify = {"base", "mesh", "mold", "io", "picture", "gl", "render"};
  static const auto with = [](Layers layers, const char* one) {
    layers.insert(one);
    return layers;
  };
  static const Layers k_actions = with(k_classify, "classify"), k_parting = with(k_actions, "actions"),
                      k_sweep = with(with(k_parting, "parting"), "proof"), k_pieces = with(k_sweep, "sweep"),
                      k_study = with(k_pieces, "pieces"), k_above_study = with(k_study, "study"),
                      k_entry = with(with(k_above_study, "compare"), "batch"),
                      k_report = with(with(k_above_study, "compare"), "page"),
                      k_gui = with(k_entry, "report"), k_replay = with(k_gui, "gui"),
                      k_program = with(with(with(k_replay, "replay"), "page"), "serve");
  static const std::map<std::string, Layers> k_allowed = {
      {"base", {}},
      {"mesh", {"base"}},
      {"mold", {"base", "mesh"}},
      {"proof", k_domain},
      {"io", k_domain},
      {"page", {"base", "io"}},
      {"gl", {"base"}},
      {"render", {"base", "mesh", "mold", "gl"}},
      {"classify", k_classify},
      {"actions", k_actions},
      {"parting", k_parting},
      {"sweep", k_sweep},
      {"pieces", k_pieces},
      {"study", k_study},
      {"compare", k_above_study},
      {"batch", {"base", "io", "page", "classify"}},
      {"report", k_report},
      {"serve", {"base"}},
      {"step", {"io", "mesh"}},
      {"gui", k_gui},
      {"replay", k_replay},
      {"cli", k_program},
      {"python", with(with(k_above_study, "compare"), "report")},
      {"freecad", {}},  // Python alone
      {"picture", {"base", "mold"}},
  };
  return k_allowed;
}

/// Headers of a library, and the layers that may include them.
struct LibraryRule {
  std::string name;
  std::regex headers;
  Layers layers;
};

const std::vector<LibraryRule>& library_rules() {
  static const std::vector<LibraryRule> k_rules = {
      {"Dear ImGui", std::regex("imgui.*"), {"gui", "replay"}},
      {"GLFW", std::regex("GLFW/.*"), {"gui", "replay"}},
      {"OpenGL", std::regex("(GL|GLES2|GLES3|EGL|KHR)/.*"), {"gl", "render"}},
      {"OpenMesh", std::regex("OpenMesh/.*"), {"mesh"}},
      {"Embree", std::regex("embree.*"), {"mold"}},
      {"OpenCASCADE", std::regex("[A-Z][A-Za-z]+(_[A-Za-z]+)?\\.hxx"), {"step"}},
      {"Cairo", std::regex("cairo.*"), {"picture"}},
      {"CLI11", std::regex("CLI/.*"), {"cli"}},
      {"OpenSSL", std::regex("openssl/.*"), {"io"}},
      {"zlib", std::regex("zlib.h"), {"report"}},
      {"SQLite", std::regex("sqlite3.h"), {"batch"}},
      {"pybind11", std::regex("pybind11/.*|Python.h"), {"python"}},
      {"JSON",
       std::regex("nlohmann/.*"),
       {"actions", "batch", "classify", "compare", "io", "page", "parting", "pieces", "report", "sweep",
        "gui", "replay", "cli", "python", "serve", "study"}},
  };
  return k_rules;
}

/// What a source text of a layer includes, or calls, that it may not.
std::vector<std::string> violations(const std::string& layer, const std::string& text) {
  static const std::regex k_include(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  static const std::regex k_gl_call(R"re(\bGL_[A-Z][A-Z0-9_]+\b|functions\(\)\.[A-Z])re");
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, k_include)) {
      const std::string header = match[1];
      const std::string folder = header.substr(0, header.find('/'));
      if (folder != header && allowed_layers().contains(folder) && folder != layer &&
          !allowed_layers().at(layer).contains(folder)) {
        found.push_back(header);
      }
      for (const LibraryRule& rule : library_rules()) {
        if (std::regex_match(header, rule.headers) && !rule.layers.contains(layer)) found.push_back(header);
      }
    }
    const bool comment = line.find("//") != std::string::npos && line.find("//") < line.find("GL_");
    if (layer != "gl" && layer != "render" && !comment && std::regex_search(line, k_gl_call))
      found.push_back(line);
  }
  return found;
}

/// A header and its source file are one unit, "gui/app"; each with the units of its own layer that it
/// includes.
using Units = std::map<std::string, std::set<std::string>>;

void add_unit(Units& units, const std::string& file, const std::string& text) {
  static const std::regex k_include(R"re(^\s*#\s*include\s*"([^"]+)\.hpp")re");
  const std::string unit = file.substr(0, file.rfind('.')), layer = file.substr(0, file.find('/') + 1);
  auto& included = units[unit];
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, k_include) && match[1].str().starts_with(layer) && match[1] != unit)
      included.insert(match[1]);
  }
}

/// Units that include each other in a circle, and those between circles: what is left when units that include
/// none of the others, or are included by none, are taken away again and again.
std::set<std::string> units_in_circles(Units units) {
  for (bool changed = true; changed;) {
    std::set<std::string> included;
    for (auto& [unit, others] : units) {
      std::erase_if(others, [&](const std::string& other) { return !units.contains(other); });
      included.insert(others.begin(), others.end());
    }
    changed = std::erase_if(units, [&](const auto& unit) {
                return unit.second.empty() || !included.contains(unit.first);
              }) > 0;
  }
  std::set<std::string> left;
  for (const auto& [unit, others] : units) left.insert(unit);
  return left;
}

TEST(Layers, CirclesOfUnitsAreSeen) {
  Units units;
  add_unit(units, "gui/a.hpp", "#include \"gui/b.hpp\"\n");
  add_unit(units, "gui/b.hpp", "#include <vector>\n#include \"mesh/a.hpp\"\n");
  add_unit(units, "gui/b.cpp", "#include \"gui/b.hpp\"\n#include \"gui/view/c.hpp\"\n");
  add_unit(units, "gui/view/c.hpp", "");
  EXPECT_TRUE(units_in_circles(units).empty());
  add_unit(units, "gui/view/c.cpp", "#include \"gui/view/c.hpp\"\n#include \"gui/a.hpp\"\n");
  add_unit(units, "gui/d.cpp", "#include \"gui/a.hpp\"\n");
  EXPECT_EQ(units_in_circles(units), (std::set<std::string>{"gui/a", "gui/b", "gui/view/c"}));
}

TEST(Layers, UnitsOfALayerIncludeEachOtherInNoCircle) {
  const fs::path source = test::asset_folder().parent_path() / "src";
  Units units;
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    const std::string file = fs::relative(entry.path(), source).generic_string();
    if (file.ends_with(".hpp") || file.ends_with(".cpp"))
      add_unit(units, file, test::file_bytes(entry.path()));
  }
  EXPECT_GT(units.size(), 300u);
  for (const std::string& unit : units_in_circles(units)) ADD_FAILURE() << unit << " is in a circle of units";
}

TEST(Layers, ViolationsAreSeen) {
  EXPECT_TRUE(violations("classify", "#include \"render/shadow_maps.hpp\"\n#include <vector>\n").empty());
  EXPECT_EQ(violations("mesh", "#include \"io/part_reader.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("gl", "#include \"mesh/part.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("classify", "#include \"cli/console.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("classify", "#include <imgui.h>\n").size(), 1u);
  EXPECT_EQ(violations("io", "# include <OpenMesh/Core/Mesh/PolyMesh.hh>\n").size(), 1u);
  EXPECT_EQ(violations("gui", "#include <GL/glcorearb.h>\n").size(), 1u);
  EXPECT_EQ(violations("classify", "context.functions().Finish();\n").size(), 1u);
  EXPECT_EQ(violations("gui", "clear(GL_COLOR_BUFFER_BIT);\n").size(), 1u);
}

TEST(Layers, SourcesKeepToThem) {
  const fs::path source = test::asset_folder().parent_path() / "src";
  std::size_t files = 0;
  for (const auto& folder : fs::directory_iterator(source)) {
    if (!folder.is_directory()) continue;
    const std::string layer = folder.path().filename().string();
    ASSERT_TRUE(allowed_layers().contains(layer)) << "src/" << layer << " is no layer that this test knows";
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      ++files;
      for (const std::string& violation : violations(layer, test::file_bytes(entry.path()))) {
        ADD_FAILURE() << fs::relative(entry.path(), source).string() << ": " << violation;
      }
    }
  }
  EXPECT_GT(files, 80u);
}

TEST(Layers, TheWindowHasNoMoreLinesThanItMay) {
  constexpr std::ptrdiff_t k_most = 15'800;
  std::ptrdiff_t lines = 0;
  for (const auto& entry : fs::recursive_directory_iterator(test::asset_folder().parent_path() / "src/gui")) {
    if (!entry.is_regular_file()) continue;
    const std::string text = test::file_bytes(entry.path());
    lines += std::count(text.begin(), text.end(), '\n');
  }
  EXPECT_LE(lines, k_most) << "what is added needs as much taken away";
}

TEST(Layers, FilesAreNamedAndHeadedAsTheyShould) {
  const fs::path root = test::asset_folder().parent_path();
  const std::regex name(R"([a-z0-9_]+\.(cpp|hpp))");
  for (const char* top : {"src", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file()) continue;
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp") continue;
      EXPECT_TRUE(std::regex_match(entry.path().filename().string(), name)) << entry.path();
      if (extension == ".hpp") {
        const std::string text = test::file_bytes(entry.path());
        EXPECT_TRUE(text.starts_with("//")) << entry.path() << " does not say what it is";
        EXPECT_NE(text.find("#pragma once"), std::string::npos) << entry.path();
      }
    }
  }
}

}  // namespace
}  // namespace moldlight
