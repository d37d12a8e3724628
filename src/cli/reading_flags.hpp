// Flags for how a part is read and what is made of it at once: limits, unit, body, repair, CAD tessellation.
#pragma once

#include <CLI/CLI.hpp>

#include "io/read_options.hpp"

namespace moldlight::cli {

/// Values go into `options`, which outlives the command and holds the defaults.
void add_reading_flags(CLI::App& command, ReadOptions& options);

}  // namespace moldlight::cli
