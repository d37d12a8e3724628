// The commands that write reports, each with quick arguments for the small part.
#pragma once

#include <string>
#include <vector>

#include "cli/small_part.hpp"

namespace moldlight::test {

struct ReportKind {
  std::string name;
  std::vector<std::string> more;
  std::size_t least_figures = 0;  // of the JSON report
};

inline std::vector<ReportKind> report_kinds() {
  return {{"classify", {"--direction", "z", "--required-draft", "1"}, 18},
          {"actions", {"--direction", "z"}, 5},
          {"mold", {"--direction", "z", "--fill-undercut"}, 15},
          {"compare", {"--direction", "z", "--fail-on", "undercut > +1%"}, 30},
          {"sweep",
           {"--directions", "60", "--refine", "2", "--top", "4", "--scoring-samples", "2000", "--prove", "1"},
           35}};
}

/// Arguments of a run, and more. A comparison is with a revision that has no hole in its side.
inline std::vector<std::string> report_run(const ReportKind& kind, const SmallPart& part,
                                           const std::vector<std::string>& more) {
  std::vector<std::string> words = {kind.name, part.file()};
  if (kind.name == "compare") {
    const TriangleMesh mesh = refined(cup(ShapeSettings{}), 300).mesh;
    words.push_back(part.output("revision.obj"));
    write_coloured_mesh(words.back(), {mesh, std::vector<Region>(mesh.facets.size(), Region::core)});
  }
  words.insert(words.end(), {"--backend", "osmesa"});
  words.insert(words.end(), kind.more.begin(), kind.more.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace moldlight::test
