// Recorded input for the window, read but not played.
#include <cstddef>
#include <cstdint>

#include "base/check.hpp"
#include "base/error.hpp"
#include "replay/script.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto script =
        moldlight::gui::parse_script(std::string_view(reinterpret_cast<const char*>(data), size));
    CHECK(!script.empty());
    for (const auto& event : script) CHECK(event.play != nullptr);
  } catch (const moldlight::UsageError& error) {
    CHECK(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
