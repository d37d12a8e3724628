// moldlight classify: the mold-piece regions of a part for one parting direction.
#include <memory>

#include "cli/command.hpp"
#include "cli/method_flags.hpp"
#include "cli/outputs.hpp"
#include "cli/still_flags.hpp"
#include "io/mesh_writer.hpp"
#include "io/png.hpp"
#include "session/classifier.hpp"
#include "session/classify_report.hpp"
#include "session/headless.hpp"
#include "session/still_options.hpp"
#include "session/write_outputs.hpp"

namespace moldlight::cli {

namespace {

struct ClassifyFlags {
  PartFlags part;
  MethodSettings method;
  std::string facets, faces, mesh, split_folder, image;
  StillSettings still;
};

void check_outputs(const ClassifyFlags& flags) {
  if (!flags.mesh.empty()) check_mesh_extension(flags.mesh);
  check_output_files(flags.part.part, {{"--json", flags.part.json == "-" ? "" : flags.part.json},
                                       {"--facets", flags.facets},
                                       {"--faces", flags.faces},
                                       {"--mesh", flags.mesh},
                                       {"--image", flags.image}});
  if (!flags.split_folder.empty()) check_output_folder(flags.split_folder);
}

void log_result(const Classification& result, Console& console) {
  if (!result.backend.empty()) console.log(fmt::format("{} ({})", result.backend, result.renderer));
  console.log(fmt::format("load {:.0f} ms, regions {:.0f} ms, readout {:.0f} ms", result.timings.load_ms,
                          result.timings.regions_ms, result.timings.readout_ms));
}

int run(const ClassifyFlags& flags, Console& console, const Progress& progress) {
  validate(flags.method);
  check_outputs(flags);
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  // Exact regions need no GL, other readouts and pictures do.
  const bool is_exact = flags.method.readout == Readout::exact;
  std::unique_ptr<gl::Context> context;
  if (!is_exact || !flags.image.empty()) context = create_context(flags.method.backend);
  const bool with_split = !(flags.image + flags.mesh + flags.split_folder).empty();
  const Classification result =
      is_exact ? classify_exact(*model, flags.method, progress, with_split)
               : Classifier(*context, model).classify(flags.method, progress, with_split);
  for (const std::string& warning : result.warnings) console.warning(warning);
  log_result(result, console);

  progress.report("writing", 0.0);
  const bool json_to_stdout = flags.part.json == "-";
  write_outputs({.json = json_to_stdout ? "" : flags.part.json,
                 .facets = flags.facets,
                 .faces = flags.faces,
                 .mesh = flags.mesh,
                 .split_folder = flags.split_folder},
                *model, result, flags.still.palette);
  if (!flags.image.empty())
    write_png(flags.image, StillPainter(*context, model).draw(result, flags.still, progress));
  console.result(json_to_stdout ? json_text(classify_json(*model, result))
                                : classify_table(*model, result, console.colour()));
  return 0;
}

}  // namespace

void add_classify_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "classify",
      "Find out for a parting direction which surface each mold half forms and what is an undercut");
  const auto flags = std::make_shared<ClassifyFlags>();
  add_part_flags(*command, flags->part, request);
  add_method_flags(*command, flags->method, DirectionFlag::required);
  command->add_option("--facets", flags->facets, "Write a table of facets: area and share of each region")
      ->option_text("FILE.csv")
      ->check(named());
  command
      ->add_option("--faces", flags->faces,
                   "Write a table of the CAD faces of a STEP file, or of a file's polygons, in the same way")
      ->option_text("FILE.csv")
      ->check(named());
  command
      ->add_option("--mesh", flags->mesh,
                   "Write the part with its facets coloured by region; in OBJ each region is a material")
      ->option_text("FILE.(ply|obj|stl)")
      ->check(named());
  command->add_option("--split-dir", flags->split_folder, "Write one STL a region to this folder")
      ->option_text("DIR")
      ->check(named());
  CLI::Option* image = command
                           ->add_option("--image", flags->image,
                                        "Draw the part in the colours of its regions, with a legend, and "
                                        "write the picture to this file")
                           ->option_text("FILE.png")
                           ->check(named());
  add_size_flag(*command, flags->still.size, "Width and height of the picture in pixels")->needs(image);
  for (const Option<StillSettings>& option : still_options()) {
    CLI::Option* flag = add_option_flag(*command, option, flags->still);
    // The palette is the meshes', too.
    if (option.key != "palette") flag->needs(image);
  }
  command->callback([flags, &request] {
    request.body = [flags](Console& console, const Progress& progress) {
      return run(*flags, console, progress);
    };
  });
}

}  // namespace moldlight::cli
