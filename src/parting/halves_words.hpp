// What is said of the halves in short lines: their figures, what is wrong with them.
#pragma once

#include <string>
#include <vector>

#include "parting/mold_report.hpp"

namespace moldlight {

struct HalvesLine {
  std::string text;
  bool doubt = false;       // something is to be done
  std::string figure = {};  // with its unit, where the text is its title
};

/// Of what is said.
struct SaidHalves {
  const PartModel& model;
  const MoldSettings& settings;
  const MoldHalves& halves;
  const PartingLine* line = nullptr;                      // null while it is not known
  const std::vector<InsertActions>* by_action = nullptr;  // of a mold with slides; else null
};

/// Why there are no halves, where, and what to change, without flags of commands; empty where there are.
[[nodiscard]] std::string halves_refusal(const SaidHalves& said);
/// That alone where there are none.
[[nodiscard]] std::vector<HalvesLine> halves_lines(const SaidHalves& said);

}  // namespace moldlight
