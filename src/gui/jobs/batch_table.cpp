#include "gui/jobs/batch_table.hpp"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "classify/json.hpp"
#include "classify/method_options.hpp"
#include "classify/option_json.hpp"

namespace moldlight::gui {

namespace {

using batch::PartResult;

/// The settings among these that a table of options has.
template <typename S>
void take_settings(std::span<const Option<S>> options, S& settings, const Json& effective) {
  Json known = Json::object();
  for (const Option<S>& option : options) {
    const std::string key(option.key);
    if (effective.contains(key)) known[key] = effective[key];
  }
  set_options(options, settings, known);
}

}  // namespace

BatchTable load_batch_table(const std::string& path, const Progress& progress) {
  BatchTable table;
  table.manifest = batch::read_manifest(path);
  table.rows.reserve(table.manifest.rows);
  table.counts = batch::for_each_result(table.manifest, progress,
                                        [&](const PartResult& row) { table.rows.push_back(row); });
  return table;
}

BatchPart batch_part(const BatchTable& table, std::size_t number) {
  const PartResult& row = table.rows[number];
  const Json& effective = table.manifest.settings[row.settings_number].effective;
  BatchPart part;
  part.path = (std::filesystem::path(table.manifest.parts_folder()) / row.path).lexically_normal().string();
  take_settings(reading_options(), part.reading, effective);
  take_settings(method_options(), part.notes.settings.method, effective);
  part.notes.unit = part.reading.unit;
  if (row.direction) {
    const auto& d = *row.direction;
    part.notes.settings.direction = glm::dvec3(d[0], d[1], d[2]);
  } else if (const auto d = effective.find("direction"); d != effective.end() && d->is_array()) {
    part.notes.settings.direction =
        glm::dvec3((*d)[0].get<double>(), (*d)[1].get<double>(), (*d)[2].get<double>());
  }
  return part;
}

}  // namespace moldlight::gui
