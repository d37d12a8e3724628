// A batch with made-up results, for measuring status and merge: bench_make_batch FOLDER COUNT RESULT.json,
// where the result is one of a real run; each gets figures of its own.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "batch/manifest.hpp"
#include "batch/store.hpp"
#include "support/scratch_folder.hpp"

int main(int argc, char** argv) {
  using namespace moldlight;
  using namespace moldlight::batch;
  if (argc != 4) {
    std::fputs("bench_make_batch FOLDER COUNT RESULT.json\n", stderr);
    return 2;
  }
  Json result = Json::parse(test::file_bytes(argv[3]));
  Manifest manifest;
  manifest.folder = argv[1];
  manifest.version = result["version"];
  manifest.command = result["command"];
  manifest.source = manifest.parts = "/parts";
  manifest.settings = {{{"--direction=z"}, {}, result["report"]["settings"]}};
  std::filesystem::create_directories(manifest.folder);
  std::vector<Row> rows(static_cast<std::size_t>(std::atol(argv[2])));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].number = k;
    rows[k].path = fmt::format("family-{:03}/variant-{:07}.stl", k % 1000, k);
    rows[k].content = digest_of(rows[k].path);
  }
  write_plan(manifest, rows);
  const ResultStore store(manifest.folder);
  const KeyMaker key_of(manifest);
  for (const Row& row : rows) {
    const Digest key = key_of(row);
    result["path"] = row.path;
    if (auto& areas = result["report"]["areas"]; areas.is_object())
      areas["undercut"] = static_cast<double>(row.number % 977);
    store.make_folder(key);
    std::ofstream(std::filesystem::path(store.picture(key)).replace_extension(".json"))
        << result.dump() << '\n';
  }
  return 0;
}
