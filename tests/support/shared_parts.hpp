// Real parts and reference areas that tests use where they are found: $MOLDLIGHT_SHARED, or the folder
// `shared` beside the checkout. They are no part of the project; without them the tests that need them skip.
#pragma once

#include <filesystem>
#include <optional>

namespace moldlight::test {

/// The folder that holds parts/ and reference/, if there is one.
[[nodiscard]] std::optional<std::filesystem::path> shared_folder();

/// The project's own folder of shipped parts.
[[nodiscard]] std::filesystem::path asset_folder();

/// Small files of our own that only tests read.
[[nodiscard]] std::filesystem::path data_folder();

}  // namespace moldlight::test
