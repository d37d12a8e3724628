#include "io/ply_header.hpp"

#include <algorithm>
#include <array>

#include "io/text_scanner.hpp"

namespace moldlight {

namespace {

/// By PlyType: what headers call it, and its bytes.
constexpr std::array<std::array<std::string_view, 2>, 8> k_type_names = {{{"char", "int8"},
                                                                          {"uchar", "uint8"},
                                                                          {"short", "int16"},
                                                                          {"ushort", "uint16"},
                                                                          {"int", "int32"},
                                                                          {"uint", "uint32"},
                                                                          {"float", "float32"},
                                                                          {"double", "float64"}}};
constexpr std::array<std::size_t, 8> k_type_sizes = {1, 1, 2, 2, 4, 4, 4, 8};

class PlyHeaderParser {
 public:
  explicit PlyHeaderParser(const ReadContext& context) : context_(context), words_(context.bytes()) {}

  [[nodiscard]] PlyHeader parse();

 private:
  void parse_format();
  void parse_element();
  void parse_property();
  [[nodiscard]] PlyType parse_type();
  void check_counts() const;
  [[nodiscard]] std::string place() const { return fmt::format("line {}", words_.line()); }

  const ReadContext& context_;
  TextScanner words_;
  PlyHeader header_;
};

PlyHeader PlyHeaderParser::parse() {
  bool has_format = false;
  static_cast<void>(words_.next());
  words_.rest_of_line();
  while (true) {
    const std::string_view keyword = words_.next();
    if (keyword == "format") {
      parse_format();
      has_format = true;
    } else if (keyword == "element") {
      parse_element();
    } else if (keyword == "property") {
      parse_property();
    } else if (keyword == "end_header") {
      break;
    } else if (keyword.empty()) {
      context_.fail(place(), "the PLY header ends without 'end_header'; export the part again");
    } else if (keyword != "comment" && keyword != "obj_info") {
      context_.fail(place(), "{} is not a line of a PLY header; export the part again", in_quotes(keyword));
    }
    words_.rest_of_line();
  }
  if (!has_format) context_.fail(place(), "the PLY header names no format; export the part again");
  header_.lines = words_.line();
  words_.rest_of_line();
  header_.bytes = words_.offset();
  check_counts();
  return std::move(header_);
}

void PlyHeaderParser::parse_format() {
  const std::string_view name = words_.next_on_line();
  if (name == "ascii") {
    header_.encoding = PlyEncoding::ascii;
  } else if (name == "binary_little_endian") {
    header_.encoding = PlyEncoding::little_endian;
  } else if (name == "binary_big_endian") {
    header_.encoding = PlyEncoding::big_endian;
  } else {
    context_.fail(place(), "expected a PLY format such as 'ascii', found {}; export the part again",
                  in_quotes(name));
  }
}

void PlyHeaderParser::parse_element() {
  PlyElement element;
  element.name = words_.next_on_line();
  const std::string_view word = words_.next_on_line();
  const auto count = parse_integer(word);
  if (!count || *count < 0)
    context_.fail(place(), "expected a count of elements, found {}; export the part again", in_quotes(word));
  element.count = static_cast<std::uint64_t>(*count);
  header_.elements.push_back(std::move(element));
}

void PlyHeaderParser::parse_property() {
  if (header_.elements.empty())
    context_.fail(place(), "a property stands before any element; export the part again");
  PlyProperty property;
  const TextScanner before = words_;
  if (words_.next_on_line() == "list") {
    property.count_type = parse_type();
  } else {
    words_ = before;
  }
  property.type = parse_type();
  property.name = words_.next_on_line();
  if (property.name.empty()) context_.fail(place(), "a property has no name; export the part again");
  header_.elements.back().properties.push_back(std::move(property));
}

PlyType PlyHeaderParser::parse_type() {
  const std::string_view word = words_.next_on_line();
  for (std::size_t type = 0; type < k_type_names.size(); ++type)
    if (std::ranges::count(k_type_names[type], word) > 0) return static_cast<PlyType>(type);
  context_.fail(place(), "expected a PLY type such as 'float', found {}; export the part again",
                in_quotes(word));
}

/// No row is shorter than its values, or in text than a digit and a space for each.
void PlyHeaderParser::check_counts() const {
  std::uint64_t left = context_.bytes().size() - header_.bytes + 1;
  for (const PlyElement& element : header_.elements) {
    std::uint64_t row = 0;
    for (const PlyProperty& property : element.properties) {
      const PlyType first = property.count_type.value_or(property.type);
      row += header_.encoding == PlyEncoding::ascii ? 2 : ply_type_size(first);
    }
    if (row == 0 && element.count > 0) {
      context_.fail("", "the PLY element {} has no properties; export the part again",
                    in_quotes(element.name));
    }
    if (element.count > 0 && element.count > left / row) {
      context_.fail(fmt::format("byte {}", context_.bytes().size()),
                    "the file ends before the {} elements {} that its header declares; export the part again",
                    element.count, in_quotes(element.name));
    }
    left -= element.count * row;
  }
}

}  // namespace

std::size_t ply_type_size(PlyType type) { return k_type_sizes[static_cast<std::size_t>(type)]; }

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return i;
  return std::nullopt;
}

PlyHeader read_ply_header(const ReadContext& context) { return PlyHeaderParser(context).parse(); }

}  // namespace moldlight
