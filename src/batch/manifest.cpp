#include "batch/manifest.hpp"

#include <ctime>
#include <filesystem>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "classify/classify_report.hpp"
#include "io/atomic_file.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_plan_schema = "moldlight.batch/1";
const std::vector<std::string> k_row_columns = {"path", "settings", "content", "same_as", "fault"};
constexpr std::size_t k_name_digits = 12;  // of a digest, in a file's name

std::string manifest_path(const std::string& folder) { return (fs::path(folder) / k_manifest_name).string(); }

std::string text_of(const std::string& path) { return std::string(FileContents(path, Progress()).bytes()); }

/// A pipe in its place would be waited for.
const std::string& if_regular(const std::string& path) {
  if (!fs::is_regular_file(path))
    throw FileError(path, "", "cannot be read; the batch has lost its table of parts, plan again");
  return path;
}

Json settings_json(const RowSettings& settings) {
  return {
      {"arguments", settings.arguments}, {"picture", settings.picture}, {"effective", settings.effective}};
}

Json manifest_json(const Manifest& manifest) {
  Json settings = Json::array();
  for (const RowSettings& one : manifest.settings) settings.push_back(settings_json(one));
  return {{"schema", k_plan_schema},     {"version", manifest.version}, {"planned_at", manifest.planned_at},
          {"command", manifest.command}, {"given", manifest.given},     {"source", manifest.source},
          {"parts", manifest.parts},     {"rows", manifest.rows},       {"rows_file", manifest.rows_file},
          {"settings", settings}};
}

/// Keeps a manifest that is about to be replaced.
void keep_former(const std::string& folder) {
  const std::string path = manifest_path(folder);
  if (!fs::exists(path)) return;
  const std::string bytes = text_of(path);
  const std::string name = fmt::format("batch-{}.json", hex_of(digest_of(bytes)).substr(0, k_name_digits));
  write_file((fs::path(folder) / name).string(), bytes);
}

}  // namespace

std::string Manifest::parts_folder() const {
  return fs::path(parts).is_absolute() ? parts : (fs::path(folder) / parts).lexically_normal().string();
}

bool is_batch(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return fs::is_regular_file(manifest_path(path), ignored);
  return fs::path(path).filename() == k_manifest_name && fs::is_regular_file(path, ignored);
}

Manifest read_manifest(const std::string& given) {
  std::string folder = given;
  if (fs::path(given).filename() == k_manifest_name && !fs::is_directory(given))
    folder = fs::absolute(given).parent_path().string();
  const std::string path = manifest_path(folder);
  if (!fs::is_directory(folder))
    throw FileError(folder, "", "is not a folder; moldlight batch plan makes one");
  if (!fs::exists(path)) {
    throw FileError(
        folder, "",
        fmt::format("is not a batch: it holds no {}; moldlight batch plan makes one", k_manifest_name));
  }
  Manifest manifest;
  manifest.folder = folder;
  try {
    const Json json = Json::parse(text_of(path));
    if (const auto schema = json.at("schema").get<std::string>(); schema != k_plan_schema) {
      throw FileError(
          path, "",
          fmt::format("is of the schema {}, which this version does not read; plan again into another folder",
                      Json(schema).dump(-1, ' ', true, Json::error_handler_t::replace)));
    }
    json.at("version").get_to(manifest.version);
    json.at("planned_at").get_to(manifest.planned_at);
    json.at("command").get_to(manifest.command);
    json.at("given").get_to(manifest.given);
    json.at("source").get_to(manifest.source);
    json.at("parts").get_to(manifest.parts);
    json.at("rows").get_to(manifest.rows);
    json.at("rows_file").get_to(manifest.rows_file);
    for (const Json& entry : json.at("settings")) {
      RowSettings settings;
      entry.at("arguments").get_to(settings.arguments);
      entry.at("picture").get_to(settings.picture);
      settings.effective = entry.at("effective");
      manifest.settings.push_back(std::move(settings));
    }
  } catch (const Json::exception&) {
    throw FileError(path, "", "is damaged, or not the plan of a batch; plan again");
  }
  // Out of the folder nothing is read.
  if (fs::path(manifest.rows_file).has_parent_path())
    throw FileError(path, "", "is damaged, or not the plan of a batch; plan again");
  return manifest;
}

void write_plan(Manifest& manifest, const std::vector<Row>& rows) {
  std::string table = csv_record(k_row_columns);
  for (const Row& row : rows) {
    table += fmt::format("{},{},{},{},{}\n", csv_field(row.path), row.settings,
                         row.fault.empty() ? hex_of(row.content) : "",
                         row.same_as ? fmt::format("{}", *row.same_as) : "", csv_field(row.fault));
  }
  manifest.rows = rows.size();
  manifest.rows_file = fmt::format("parts-{}.csv", hex_of(digest_of(table)).substr(0, k_name_digits));
  manifest.planned_at = utc_now();
  write_file((fs::path(manifest.folder) / manifest.rows_file).string(), table);
  keep_former(manifest.folder);
  write_file(manifest_path(manifest.folder), json_text(manifest_json(manifest)));
}

RowReader::RowReader(const Manifest& manifest)
    : manifest_(manifest),
      path_((fs::path(manifest.folder) / manifest.rows_file).string()),
      file_(if_regular(path_), std::ios::binary),
      table_(file_, path_) {
  if (!file_) throw FileError(path_, "", "cannot be read; the batch has lost its table of parts, plan again");
  if (!table_.next(fields_) || fields_ != k_row_columns) damaged("its columns are not those of a plan");
}

void RowReader::damaged(const std::string& what) const {
  throw FileError(path_, fmt::format("line {}", table_.line()), what + "; plan again");
}

bool RowReader::next(Row& row) {
  if (!table_.next(fields_)) {
    if (number_ != manifest_.rows) damaged(fmt::format("it holds {} of {} rows", number_, manifest_.rows));
    return false;
  }
  if (fields_.size() != k_row_columns.size() || number_ == manifest_.rows) damaged("it is damaged");
  const auto settings = number_from<std::uint32_t>(fields_[1]);
  const auto content = digest_from(fields_[2]);
  row.fault = fields_[4];
  if (!settings || *settings >= manifest_.settings.size() || (!content && row.fault.empty()))
    damaged("it is damaged");
  row.number = number_++;
  row.path = fields_[0];
  row.settings = *settings;
  row.content = content.value_or(Digest{});
  row.same_as = number_from<std::size_t>(fields_[3]);
  return true;
}

KeyMaker::KeyMaker(const Manifest& manifest) {
  for (const RowSettings& settings : manifest.settings) {
    beginnings_.push_back(
        fmt::format("moldlight {}\n{}\n{}\n", manifest.version, manifest.command,
                    settings.effective.dump(-1, ' ', true, Json::error_handler_t::replace)));
  }
}

Digest KeyMaker::operator()(const Row& row) const {
  // What could not be read has no content to be known by.
  return digest_of(beginnings_[row.settings] +
                   (row.fault.empty() ? hex_of(row.content) : "unreadable " + row.path));
}

std::string utc_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(std::time(nullptr))); }

}  // namespace moldlight::batch
