// What OpenCASCADE's parser has to say about the syntax of a STEP file, which it shows to printers only.
#pragma once

#include <cstddef>

#include <Message_Printer.hxx>
#include <TCollection_AsciiString.hxx>

namespace moldlight::step {

/// While it is added to the default messenger, keeps the line of the first fault in a file's syntax. The
/// parser drops the entity there and goes on, so that a part of the file is lost.
class SyntaxFaults : public Message_Printer {
 public:
  SyntaxFaults() { SetTraceLevel(Message_Trace); }  // the least of all, as which the parser counts them

  /// From 1; 0 where the syntax is sound.
  [[nodiscard]] std::size_t first_line() const { return first_line_; }

 protected:
  void send(const TCollection_AsciiString& message, Message_Gravity gravity) const override;

 private:
  mutable std::size_t first_line_ = 0;
};

}  // namespace moldlight::step
