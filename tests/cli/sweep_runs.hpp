// Sweeps as JSON.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"

namespace moldlight::test {

/// What does not depend on the machine.
[[nodiscard]] inline nlohmann::ordered_json without_time(nlohmann::ordered_json json) {
  json.erase("elapsed_s");
  return json;
}

/// The report of a sweep that succeeds; its arguments have `--json -`.
[[nodiscard]] inline nlohmann::ordered_json sweep_of(const std::vector<std::string>& arguments) {
  const auto run = run_moldlight(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run.exit_code == 0 ? json_of(run.out) : nlohmann::ordered_json();
}

}  // namespace moldlight::test
