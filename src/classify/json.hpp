// JSON as the program writes it: keys in the order in which they were set. What is in it needs
// nlohmann/json.hpp.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace moldlight {

using Json = nlohmann::ordered_json;

}  // namespace moldlight
