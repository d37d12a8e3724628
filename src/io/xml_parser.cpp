#include "io/xml_parser.hpp"

#include <algorithm>
#include <new>

#include <expat.h>

#include "base/check.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

/// expat looks at an unfinished tag anew with every chunk, so a tag without end would take quadratic time.
constexpr std::uint64_t k_max_tag_bytes = std::uint64_t{1} << 20;

/// What expat calls. C++ exceptions must not pass through it: they are kept and thrown again behind it.
struct XmlParser::Callbacks {
  template <typename Work>
  static void run(void* self, const Work& work) {
    auto& parser = *static_cast<XmlParser*>(self);
    if (parser.thrown_) return;
    try {
      work(parser);
    } catch (...) {
      parser.thrown_ = std::current_exception();
      XML_StopParser(parser.parser_.get(), XML_FALSE);
    }
  }
  static void start(void* self, const char* name, const char** attributes) {
    run(self, [&](XmlParser& parser) { parser.start_element(name, XmlAttributes(attributes)); });
  }
  static void end(void* self, const char* name) {
    run(self, [&](XmlParser& parser) { parser.end_element(name); });
  }
  static void start_namespace(void* self, const char* prefix, const char* name) {
    run(self, [&](XmlParser& parser) {
      parser.start_namespace(prefix == nullptr ? "" : prefix, name == nullptr ? "" : name);
    });
  }
  static void doctype(void* self, const char*, const char*, const char*, int) {
    run(self, [](XmlParser& parser) {
      parser.context_.fail(parser.place(),
                           "declares a document type, which is forbidden here; export the part again");
    });
  }
};

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char** pair = pairs_; *pair != nullptr; pair += 2)
    if (name == pair[0]) return pair[1];
  return std::nullopt;
}

XmlParser::XmlParser(const ReadContext& context, std::string document)
    : context_(context),
      document_(std::move(document)),
      parser_(XML_ParserCreateNS(nullptr, '|'), XML_ParserFree) {
  if (parser_ == nullptr) throw std::bad_alloc();
  XML_SetUserData(parser_.get(), this);
  XML_SetElementHandler(parser_.get(), Callbacks::start, Callbacks::end);
  XML_SetStartNamespaceDeclHandler(parser_.get(), Callbacks::start_namespace);
  XML_SetStartDoctypeDeclHandler(parser_.get(), Callbacks::doctype);
}

XmlParser::~XmlParser() = default;

void XmlParser::start_namespace(std::string_view, std::string_view) {}

std::string XmlParser::place() const {
  return fmt::format("{} line {}", in_quotes(document_), XML_GetCurrentLineNumber(parser_.get()));
}

void XmlParser::parse(std::string_view text, bool last) {
  CHECK(text.size() < k_max_tag_bytes);
  const XML_Status status =
      XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), last ? 1 : 0);
  if (thrown_) std::rethrow_exception(thrown_);
  const XML_Error error = XML_GetErrorCode(parser_.get());
  if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
  if (status != XML_STATUS_OK)
    context_.fail(place(), "is damaged XML ({}); export the part again", XML_ErrorString(error));
  fed_bytes_ += text.size();
  const auto done =
      static_cast<std::uint64_t>(std::max<XML_Index>(XML_GetCurrentByteIndex(parser_.get()), 0));
  if (fed_bytes_ - done > k_max_tag_bytes)
    context_.fail(place(), "holds a tag of more than {} bytes; export the part again", k_max_tag_bytes);
}

}  // namespace moldlight
