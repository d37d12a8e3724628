#include "gui/store/part_notes.hpp"

#include <cstdint>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "classify/json.hpp"
#include "classify/method_options.hpp"
#include "classify/option_json.hpp"
#include "gui/store/files.hpp"
#include "gui/view/direction.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_schema = "moldlight.view/3";

/// FNV-1a: names of files in the state folder stay the same from run to run.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 14695981039346656037U;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return value;
}

Bookmark parse_bookmark(const Json& json) {
  if (!json.is_object() || !json.contains("direction") || !json["direction"].is_array() ||
      json["direction"].size() != 3) {
    throw UsageError("settings: a bookmark has no direction of three numbers");
  }
  Bookmark bookmark;
  const std::string text = moldlight::detail::json_text(json["direction"]);
  bookmark.direction = tidy(parse_direction({text, "settings: a bookmark's direction"}));
  if (json.contains("note") && json["note"].is_string()) bookmark.note = json["note"].get<std::string>();
  if (json.contains("actions")) set_options(action_options(), bookmark.actions.emplace(), json["actions"]);
  return bookmark;
}

Json settings_json(const Query& query) {
  Json json = {{"direction", moldlight::detail::value_json(query.direction.given())}};
  json.update(options_json(method_options(), query.method));
  return json;
}

void set_settings(Query& query, Json json) {
  if (json.is_object() && json.contains("direction")) {
    const std::string text = moldlight::detail::json_text(json["direction"]);
    query.direction = parse_direction({text, "--direction"});
    json.erase("direction");
  }
  set_options(method_options(), query.method, json);
}

Json revision_json(const RevisionSettings& settings) {
  Json json = options_json(compare_options(), static_cast<const CompareSettings&>(settings));
  json.update(options_json(revision_options(), settings));
  return json;
}

/// Sets what the options have of the object's members, and takes these out of it.
template <typename S>
void take_options(std::span<const Option<S>> options, S& settings, Json& json) {
  Json own = Json::object();
  for (const Option<S>& option : options) {
    const std::string key(option.key);
    if (!json.is_object() || !json.contains(key)) continue;
    own[key] = json[key];
    json.erase(key);
  }
  set_options(options, settings, own);
}

void set_revision(RevisionSettings& settings, Json json) {
  take_options(revision_options(), settings, json);
  set_options(compare_options(), static_cast<CompareSettings&>(settings), json);
}

Json draft_settings_json(const RequiredDraft& settings) {
  Json json = options_json(required_draft_options(), settings);
  json.update(options_json(finish_options(), static_cast<const FinishSettings&>(settings)));
  json["finishes"] = Json::object();
  for (const FaceFinish& one : settings.finishes)
    json["finishes"][std::to_string(one.face)] = one.finish.name;
  return json;
}

void set_draft(RequiredDraft& settings, Json json) {
  take_options(finish_options(), static_cast<FinishSettings&>(settings), json);
  if (json.is_object() && json.contains("finishes")) {
    settings.finishes.clear();
    for (const auto& item : json["finishes"].items()) {
      const auto face = number_from<std::uint32_t>(item.key());
      const auto finish = item.value().is_string()
                              ? parse_finish(item.value().get<std::string>(), settings.texture_rule)
                              : std::nullopt;
      if (!face || !finish)
        throw UsageError(
            fmt::format("settings: face {} has no finish like {}", item.key(), item.value().dump()));
      set_finish(settings.finishes, *face, finish);
    }
    json.erase("finishes");
  }
  set_options(required_draft_options(), settings, json);
}

/// Takes notes of former versions to the present one. Until 1, figures were sums over samples, and a kernel
/// was always set; until 2, a look had the opacity of other surface, one way to lay a section, and
/// contour edges.
void renew(Json& json) {
  const auto object = [&](const char* key) { return json.contains(key) && json[key].is_object(); };
  if (json["schema"] == "moldlight.view/1") {
    if (object("settings"))
      for (const char* key : {"exact_rays", "readout", "kernel"}) json["settings"].erase(key);
    json["schema"] = "moldlight.view/2";
  }
  if (json["schema"] == "moldlight.view/2") {
    if (object("look")) {
      Json& look = json["look"];
      const auto take = [&](const char* key) {
        const Json value = look.contains(key) ? look[key] : Json();
        look.erase(key);
        return value;
      };
      if (const Json opacity = take("others_opacity"); opacity.is_number())
        look["transparency"] = 1.0 - opacity.get<double>();
      if (const Json cut = take("section"); cut.is_boolean())
        look["section"] = cut.get<bool>() ? "across" : "off";
      if (const Json height = take("section_height"); height.is_number()) look["section_at"] = height;
      if (const Json edges = take("contour_edges"); edges.is_boolean()) look["parting_line"] = edges;
    }
    json["schema"] = k_schema;
  }
  if (json["schema"] == k_schema) return;
  throw UsageError(fmt::format("settings: the schema is {}, not {}", json["schema"].dump(), k_schema));
}

}  // namespace

std::span<const Option<RevisionSettings>> revision_options() {
  static const std::vector<Option<RevisionSettings>> k_options = {
      {"each_best", "", "Its own direction", "",
       "Show the other revision along its own best direction, or along this part's direction.",
       SwitchKind<RevisionSettings>{&RevisionSettings::each_best}}};
  return k_options;
}

std::span<const Option<RequiredDraft>> required_draft_options() {
  static const std::vector<Option<RequiredDraft>> k_options = {
      {"required_draft_deg", "", "Required draft", "deg",
       "Walls with less draft than this are reported, with the thickness that the missing draft costs. The "
       "regions do not change.",
       RealKind<RequiredDraft>{&RequiredDraft::deg, 0.1, 10.0, 0.1}}};
  return k_options;
}

std::string part_notes_json(const PartNotes& notes, const std::string& part_path) {
  Json json;
  json["schema"] = k_schema;
  json["part"] = part_path;
  if (!notes.unit.empty()) json["unit"] = notes.unit;
  json["settings"] = settings_json(notes.settings);
  json["look"] = options_json(look_options(), notes.settings.look);
  json["draft"] = draft_settings_json(notes.settings.required_draft);
  json["actions"] = options_json(action_options(), notes.settings.actions);
  json["mold"] = options_json(mold_options(), notes.settings.mold);
  json["revision"] = revision_json(notes.settings.revision);
  json["bookmarks"] = Json::array();
  for (const Bookmark& bookmark : notes.bookmarks) {
    const glm::dvec3& d = bookmark.direction;
    Json entry = {{"note", bookmark.note}, {"direction", {d.x, d.y, d.z}}};
    if (bookmark.actions) entry["actions"] = options_json(action_options(), *bookmark.actions);
    json["bookmarks"].push_back(std::move(entry));
  }
  // A note in an unknown encoding must not keep the rest from being saved.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

PartNotes parse_part_notes(std::string_view text, PartNotes notes) {
  Json json = parse_json(text);
  if (!json.is_object()) throw UsageError("settings: not a JSON object");
  if (!json.contains("schema")) {
    set_settings(notes.settings, json);
    return notes;
  }
  renew(json);
  if (json.contains("unit")) {
    const auto unit =
        json["unit"].is_string() ? find_length_unit(json["unit"].get<std::string>()) : std::nullopt;
    if (!unit) throw UsageError(fmt::format("settings: the unit {} is unknown", json["unit"].dump()));
    notes.unit = unit->name;
  }
  if (json.contains("settings")) set_settings(notes.settings, json["settings"]);
  if (json.contains("look")) set_options(look_options(), notes.settings.look, json["look"]);
  if (json.contains("draft")) set_draft(notes.settings.required_draft, json["draft"]);
  if (json.contains("actions")) set_options(action_options(), notes.settings.actions, json["actions"]);
  if (json.contains("mold")) set_options(mold_options(), notes.settings.mold, json["mold"]);
  if (json.contains("revision")) set_revision(notes.settings.revision, json["revision"]);
  if (json.contains("bookmarks")) {
    notes.bookmarks.clear();
    for (const Json& bookmark : json["bookmarks"]) notes.bookmarks.push_back(parse_bookmark(bookmark));
  }
  return notes;
}

std::string notes_path_beside(const std::string& part_path) { return part_path + ".moldlight.json"; }

std::string notes_path(const std::string& part_path) {
  std::error_code error;
  if (const std::string beside = notes_path_beside(part_path); fs::is_regular_file(beside, error))
    return beside;
  const auto folder = state_folder();
  if (!folder) return {};
  fs::path whole = fs::weakly_canonical(part_path, error);
  if (error) whole = part_path;
  return (*folder / "parts" / fmt::format("{}-{:016x}.json", whole.stem().string(), hash(whole.string())))
      .string();
}

}  // namespace moldlight::gui
