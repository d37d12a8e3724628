#include "cli/step_output.hpp"

#include <memory>
#include <numeric>
#include <utility>

#include <nlohmann/json.hpp>

#include "classify/cad_labels.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "io/step_program.hpp"
#include "io/step_writer.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight::cli {

void add_step_flag(CLI::App& command, StudyFlags& flags, const std::string& help) {
  add_file_flag(command, flags.step, {"--step", "FILE.(step|stp)", help})->each([&flags](const std::string&) {
    flags.part.reading.stays = std::make_shared<StepProgram>();
  });
}

Json write_step(const StudyFlags& flags, const Study& study, StepContent content, Console& console,
                const Progress& progress) {
  const PartModel& model = study.model();
  const Query& query = study.questions().query;
  CadLabels found = cad_labels(model, content.split, content.groups, std::move(content.of_piece),
                               {.speck_width = lateral_tolerance(query.method, model.frame.diagonal),
                                .direction = query.direction.unit(),
                                .tau_deg = query.method.tau_deg});
  found.labels.lines = std::move(content.lines);
  found.labels.surfaces = std::move(content.surfaces);
  const auto [failed, areas] =
      write_step_part(flags.step, model.part, flags.part.reading, found.labels, progress);
  const double failed_area =
      std::accumulate(failed.begin(), failed.end(), 0.0,
                      [&](double sum, std::uint32_t face) { return sum + found.other_areas[face]; });
  if (!failed.empty()) {
    console.warning(
        fmt::format("{} of {} faces could not be split for {}: {} {} is in the colour of its face's "
                    "largest region; --mesh has the exact borders",
                    failed.size(), found.labels.split_faces.size(), one_line(flags.step),
                    rounded_area(failed_area, model.health.area), powered_unit(model.part, 2)));
  }
  const double mm = mm_per_unit(model.part.unit);
  Json exact = Json::object(), of_facets = Json::object();
  for (std::size_t k = 0; k < areas.size(); ++k) {
    exact[found.labels.names[k]] = areas[k] / (mm * mm);
    of_facets[found.labels.names[k]] = found.areas[k];
  }
  return {{"file", flags.step},
          {"areas", exact},
          {"facet_areas", of_facets},
          {"split_faces", found.labels.split_faces.size() - failed.size()},
          {"moved_area", found.moved_area},
          {"failed_faces", failed},
          {"failed_area", failed_area}};
}

}  // namespace moldlight::cli
