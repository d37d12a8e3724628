// How many side actions are solids of the mold: bench_mold_pieces [--out DIR] [PART…]. A line for each of the
// shipped and shared parts, or of those whose names contain a given text, along each axis.
#include <algorithm>
#include <iostream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/stopwatch.hpp"
#include "classify/part_model.hpp"
#include "mold/direction.hpp"
#include "study/study.hpp"
#include "support/mold_rows.hpp"

int main(int argc, char** argv) {
  using namespace moldlight;
  std::vector<std::string_view> texts(argv + 1, argv + argc);
  std::string out;
  if (texts.size() > 1 && texts[0] == "--out") {
    out = texts[1];
    texts.erase(texts.begin(), texts.begin() + 2);
  }
  std::size_t slides = 0, made = 0;
  for (const test::PartRows& part : test::part_rows()) {
    const std::string file = part.path.filename().string();
    if (!texts.empty() && std::ranges::none_of(texts, [&](std::string_view text) {
          return file.find(text) != std::string::npos;
        }))
      continue;
    const auto model = load_part(part.path.string(), {}, Progress{});
    if (!model->health.closed) continue;
    for (const glm::dvec3& d : part.directions) {
      Questions questions;
      questions.query.direction = Direction(d);
      questions.with_actions = true;
      Study study(model, questions);
      static_cast<void>(study.find<ActionPlan>(Progress{}));
      static_cast<void>(study.find<MoldHalves>(Progress{}));
      const Stopwatch watch;
      const MoldPieces& pieces = study.find<MoldPieces>(Progress{});
      const ActionPlan& plan = study.find<ActionPlan>(Progress{});
      std::size_t of_slides = 0;
      for (const SideAction& action : plan.actions) of_slides += is_slide(action.kind) ? 1 : 0;
      slides += of_slides;
      made += pieces.of_slides.size();
      std::cout << fmt::format("{}: {} of {} slides, {:.0f} ms, certified {}\n", test::row_name(part, d),
                               pieces.of_slides.size(), of_slides, watch.elapsed_ms(),
                               pieces.halves.certified());
      for (const UnmadeAction& unmade : pieces.unmade)
        std::cout << fmt::format("  {} along {}: {}\n", facts(plan.actions[unmade.action].kind).singular,
                                 direction_words(plan.actions[unmade.action].direction), unmade.why);
      std::cout << std::flush;
      if (!out.empty() && pieces.halves.written.refusal.empty()) {
        WrittenMold written = pieces.halves.written;
        write_mold(fmt::format("{}/{}_{}{}{}", out, part.path.stem().string(), d.x, d.y, d.z), {},
                   model->part.unit, written);
      }
    }
  }
  std::cout << fmt::format("{} of {} slides are solids\n", made, slides);
}
