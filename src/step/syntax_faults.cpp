#include "step/syntax_faults.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace moldlight::step {

void SyntaxFaults::send(const TCollection_AsciiString& message, Message_Gravity /*gravity*/) const {
  // "**** ERR StepFile : Undefined Parsing: Line 121: Incorrect syntax: …"
  constexpr std::string_view k_fault = "Undefined Parsing: Line ";
  const std::string_view text(message.ToCString());
  const std::size_t at = text.find(k_fault);
  if (first_line_ > 0 || at == std::string_view::npos) return;
  // OpenCASCADE counts one line too many.
  const auto line = static_cast<std::size_t>(std::strtoull(text.data() + at + k_fault.size(), nullptr, 10));
  first_line_ = std::max<std::size_t>(line, 2) - 1;
}

}  // namespace moldlight::step
