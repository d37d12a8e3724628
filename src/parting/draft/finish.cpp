#include "parting/draft/finish.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "io/atomic_file.hpp"
#include "io/file_contents.hpp"
#include "io/text_scanner.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

namespace {

constexpr double k_mm_an_inch = 25.4;
/// A texture asks for no less than a polished wall.
constexpr double k_least_texture_deg = 0.5;

double texture_draft_deg(double depth_mm, TextureRule rule) {
  const double asked =
      rule == TextureRule::metric ? depth_mm / 0.025 : 1.5 * depth_mm / (0.001 * k_mm_an_inch);
  return std::max(asked, k_least_texture_deg);
}

std::string_view without_space(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// "0.03", "0.03 mm", "0.001 in".
std::optional<double> depth_mm(std::string_view text) {
  TextScanner scanner(text);
  const auto depth = parse_number(scanner.next());
  const std::string_view unit = scanner.next();
  if (!depth || !(*depth > 0.0) || !scanner.at_end()) return std::nullopt;
  if (unit.empty() || unit == "mm") return depth;
  return unit == "in" ? std::optional(*depth * k_mm_an_inch) : std::nullopt;
}

std::string colour_text(std::uint32_t colour) { return fmt::format("#{:06x}", colour); }

/// CAD faces of a colour as a STEP file gives it, "#rrggbb" in letters of either case.
std::vector<std::uint32_t> faces_of_colour(const Part& part, std::string_view colour) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c; };
  std::vector<std::uint32_t> found;
  for (std::uint32_t face = 0; face < part.face_colours.size(); ++face)
    if (part.face_colours[face] != k_no_colour &&
        std::ranges::equal(colour_text(part.face_colours[face]), colour, {}, {}, lower))
      found.push_back(face);
  return found;
}

std::string colours_text(const Part& part) {
  const std::set<std::uint32_t> colours(part.face_colours.begin(), part.face_colours.end());
  std::vector<std::string> names;
  for (const std::uint32_t colour : colours)
    if (colour != k_no_colour) names.push_back(colour_text(colour));
  return names.empty() ? "the file gives no face a colour"
                       : fmt::format("the file has {}", fmt::join(names, ", "));
}

}  // namespace

std::span<const Option<FinishSettings>> finish_options() {
  using S = FinishSettings;
  static const std::array<Option<S>, 1> k_options = {
      {{"texture_rule", "--texture-rule", "Texture rule", "",
        "Draft that a texture of --finish needs. metric: 1° for each 0.025 mm of depth. inch: 1.5° for each "
        "0.001 in.",
        choice<&S::texture_rule>({"metric", "inch"})}}};
  return k_options;
}

std::optional<Finish> parse_finish(std::string_view text, TextureRule rule) {
  text = without_space(text);
  Finish finish{.name = std::string(text)};
  const auto found = std::ranges::find(k_named_finishes, text, &NamedFinish::name);
  constexpr std::string_view k_texture = "texture ", k_draft = "draft ";
  if (found != k_named_finishes.end()) {
    finish.required_deg = found->required_deg;
  } else if (text.starts_with(k_texture)) {
    const auto depth = depth_mm(text.substr(k_texture.size()));
    if (!depth) return std::nullopt;
    finish.required_deg = texture_draft_deg(*depth, rule);
  } else if (text.starts_with(k_draft)) {
    const auto angle = parse_number(without_space(text.substr(k_draft.size())));
    if (!angle || !(*angle > 0.0)) return std::nullopt;
    finish.required_deg = *angle;
  } else {
    return std::nullopt;
  }
  return finish.required_deg <= k_most_required_deg ? std::optional(finish) : std::nullopt;
}

std::vector<FaceFinish> finishes_in(std::string_view text, const std::string& path, const PartModel& model,
                                    TextureRule rule) {
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  TextScanner scanner(text);
  std::map<std::uint32_t, Finish> of_face;
  std::optional<Finish> of_others;
  for (bool first = true; !scanner.at_end();) {
    const std::string_view line = scanner.rest_of_line();
    if (line.empty() || line.starts_with("# ")) continue;
    const auto refuse = [&](const std::string& what) {
      throw FileError(path, fmt::format("line {}", scanner.line()), what);
    };
    const std::size_t comma = line.find_first_of(",;");
    const std::string_view where = without_space(line.substr(0, comma)),
                           what =
                               comma == std::string_view::npos ? "" : without_space(line.substr(comma + 1));
    const bool is_heading = std::exchange(first, false) && where == "face";
    if (is_heading) continue;
    const auto finish = parse_finish(what, rule);
    if (!finish)
      refuse(fmt::format("{} is not a finish; write polished, shut-off, texture DEPTH, draft ANGLE or none",
                         in_quotes(what)));
    if (where == "*") {
      of_others = finish;
      continue;
    }
    if (where.starts_with('#')) {
      const std::vector<std::uint32_t> coloured = faces_of_colour(model.part, where);
      if (coloured.empty())
        refuse(fmt::format("no face has the colour {}; {}", in_quotes(where), colours_text(model.part)));
      for (const std::uint32_t face : coloured)
        if (face < faces.count() && !faces.facets(face).empty()) of_face[face] = *finish;
      continue;
    }
    const auto face = number_from<std::uint32_t>(where);
    if (!face || *face >= faces.count() || faces.facets(*face).empty())
      refuse(fmt::format("the part has no face {}; classify --faces writes their numbers", in_quotes(where)));
    of_face[*face] = *finish;
  }
  if (of_face.empty() && !of_others)
    throw FileError(path, "", "names no face; write FACE,FINISH in each line");
  for (std::uint32_t face = 0; of_others && face < faces.count(); ++face)
    if (!faces.facets(face).empty()) of_face.try_emplace(face, *of_others);
  std::vector<FaceFinish> finishes;
  for (auto& [face, finish] : of_face) finishes.push_back({face, std::move(finish)});
  return finishes;
}

std::vector<FaceFinish> read_finishes(const std::string& path, const PartModel& model, TextureRule rule,
                                      const Progress& progress) {
  const FileContents contents(path, progress);
  return finishes_in(contents.bytes(), path, model, rule);
}

void write_finishes(const std::string& path, std::span<const FaceFinish> finishes) {
  AtomicFile file(path);
  file.write("face,finish\n");
  for (const FaceFinish& one : finishes) file.write(fmt::format("{},{}\n", one.face, one.finish.name));
  file.commit();
}

void set_finish(std::vector<FaceFinish>& finishes, std::uint32_t face, std::optional<Finish> finish) {
  const auto at = std::ranges::lower_bound(finishes, face, {}, &FaceFinish::face);
  const bool there = at != finishes.end() && at->face == face;
  if (there && !finish) finishes.erase(at);
  if (there && finish) at->finish = *std::move(finish);
  if (!there && finish) finishes.insert(at, {face, *std::move(finish)});
}

const Finish* finish_of(std::span<const FaceFinish> finishes, std::uint32_t face) {
  const auto at = std::ranges::lower_bound(finishes, face, {}, &FaceFinish::face);
  return at == finishes.end() || at->face != face ? nullptr : &at->finish;
}

}  // namespace moldlight
