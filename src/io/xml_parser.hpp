// A stream of XML elements (expat), for files that may mean harm: no document types, no entities, bounded
// tags.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/readers.hpp"

struct XML_ParserStruct;

namespace moldlight {

/// Attributes of one element; names without a namespace are plain, others "<namespace>|<name>".
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  [[nodiscard]] std::optional<std::string_view> find(std::string_view name) const;

 private:
  const char** pairs_;  // name, value, name, value, …, null
};

/// Derive, then feed the text in pieces. Handlers may throw; feed() passes that on.
class XmlParser {
 public:
  /// `document` names the text in messages.
  XmlParser(const ReadContext& context, std::string document);
  virtual ~XmlParser();

  void feed(std::string_view text) { parse(text, false); }
  void finish() { parse({}, true); }

 protected:
  /// Names are "<namespace>|<name>", or plain without one.
  virtual void start_element(std::string_view name, const XmlAttributes& attributes) = 0;
  virtual void end_element(std::string_view name) = 0;
  virtual void start_namespace(std::string_view prefix, std::string_view name);

  /// Place of the element in work.
  [[nodiscard]] std::string place() const;
  [[nodiscard]] const ReadContext& context() const { return context_; }

 private:
  struct Callbacks;
  void parse(std::string_view text, bool last);

  const ReadContext& context_;
  std::string document_;
  std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> parser_;
  std::exception_ptr thrown_;
  std::uint64_t fed_bytes_ = 0;
};

}  // namespace moldlight
