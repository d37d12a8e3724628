// How a toolmaker would like the halves of real parts: bench_mold_rows [PART…]. A line for each of the
// shipped and shared parts, or of those whose names contain a given text, along each axis and the known pull.
#include "support/mold_rows.hpp"

#include <algorithm>
#include <iostream>
#include <string_view>

#include "classify/part_model.hpp"

int main(int argc, char** argv) {
  using namespace moldlight;
  std::vector<test::SteelRow> rows;
  for (const test::PartRows& part : test::part_rows()) {
    const std::string file = part.path.filename().string();
    if (argc > 1 && std::none_of(argv + 1, argv + argc,
                                 [&](std::string_view text) { return file.find(text) != std::string::npos; }))
      continue;
    const auto model = load_part(part.path.string(), {}, Progress{});
    if (!model->health.closed) continue;
    static_cast<void>(model->exact(Progress{}));
    for (const glm::dvec3& d : part.directions) {
      rows.push_back(test::steel_row(*model, d, test::row_name(part, d)));
      std::cout << test::steel_line(rows.back()) << std::endl;
    }
  }
  std::cout << test::steel_summary(rows);
}
