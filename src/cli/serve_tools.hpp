// The questions that a client of `moldlight serve` asks, each with the settings of the command that answers
// it.
#pragma once

#include <string>
#include <vector>

#include "serve/session.hpp"

namespace moldlight::cli {

/// Answers are text for people and the JSON report of the command; what cannot be answered is the line that
/// the command prints. Throws FileError for what is no folder.
[[nodiscard]] std::vector<serve::Tool> serve_tools(const std::string& folder);

}  // namespace moldlight::cli
