// Zip archives made in memory, for tests.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace moldlight::test {

/// A deflated archive of the entries (name, bytes) in order.
[[nodiscard]] std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& entries);

/// The smallest 3MF package around the text of its model.
[[nodiscard]] std::string threemf_bytes(const std::string& model);

}  // namespace moldlight::test
