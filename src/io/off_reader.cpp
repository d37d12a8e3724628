#include <vector>

#include "io/polygon_part_builder.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

namespace {

constexpr std::uint64_t k_off_lines_between_reports = 1 << 16;

class OffParser {
 public:
  explicit OffParser(const ReadContext& context)
      : context_(context), words_(context.bytes(), {.has_comments = true}), builder_(context) {}

  [[nodiscard]] Part parse();

 private:
  void parse_keyword();
  [[nodiscard]] std::uint64_t parse_count(std::string_view word);
  void parse_vertex();
  void parse_face();
  void report(std::uint64_t row);
  [[nodiscard]] std::string place() const { return fmt::format("line {}", words_.line()); }

  const ReadContext& context_;
  TextScanner words_;
  PolygonPartBuilder builder_;
  std::uint64_t vertices_ = 0, faces_ = 0;  // declared
  std::vector<std::uint32_t> corners_;
};

Part OffParser::parse() {
  parse_keyword();
  vertices_ = parse_count(words_.next());
  faces_ = parse_count(words_.next_on_line());
  words_.rest_of_line();
  // A vertex takes six bytes at least, a face eight.
  if (vertices_ > context_.bytes().size() / 6 || faces_ > context_.bytes().size() / 8) {
    context_.fail(
        place(),
        "declares {} vertices and {} faces, more than a file of {} bytes holds; export the part again",
        vertices_, faces_, context_.bytes().size());
  }
  for (std::uint64_t row = 0; row < vertices_; ++row) {
    report(row);
    parse_vertex();
  }
  for (std::uint64_t row = 0; row < faces_; ++row) {
    report(row);
    parse_face();
  }
  if (!words_.at_end()) builder_.warn("more lines follow the faces that the OFF header declares");
  return builder_.finish();
}

void OffParser::parse_keyword() {
  const std::string_view keyword = words_.next();
  if (!keyword.ends_with("OFF") || keyword.find_first_not_of("STCNOF") != std::string_view::npos) {
    context_.fail(place(), "expected 'OFF', found {}; export the part in three dimensions",
                  in_quotes(keyword));
  }
  const TextScanner before = words_;
  if (words_.next_on_line() == "BINARY") context_.fail(place(), "is binary OFF; export the part as text");
  words_ = before;
}

std::uint64_t OffParser::parse_count(std::string_view word) {
  const auto count = parse_integer(word);
  if (!count || *count < 0) {
    context_.fail(place(), "expected a count of vertices or faces, found {}; export the part again",
                  in_quotes(word));
  }
  return static_cast<std::uint64_t>(*count);
}

void OffParser::report(std::uint64_t row) {
  if (row % k_off_lines_between_reports != 0) return;
  const auto total = static_cast<double>(context_.bytes().size());
  context_.progress.report("reading lines", static_cast<double>(words_.offset()) / total);
}

void OffParser::parse_vertex() {
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = axis == 0 ? words_.next() : words_.next_on_line();
    const auto value = parse_number(word);
    if (!value) {
      context_.fail(place(), "expected three coordinates of vertex {}, found {}; export the part again",
                    builder_.vertex_count(), in_quotes(word));
    }
    point[axis] = *value;
  }
  if (!is_usable_point(point)) {
    context_.fail(place(), "vertex {} is ({}, {}, {}); export the part again", builder_.vertex_count(),
                  point.x, point.y, point.z);
  }
  builder_.add_vertex(point);
  words_.rest_of_line();
}

void OffParser::parse_face() {
  const std::string_view count_word = words_.next();
  const auto count = parse_integer(count_word);
  if (!count) {
    context_.fail(place(), "expected the corner count of face {}, found {}; export the part again",
                  builder_.polygon_count(), in_quotes(count_word));
  }
  if (*count < 3) {
    context_.fail(place(), "face {} has {} corners, it needs three; export the part again",
                  builder_.polygon_count(), *count);
  }
  corners_.clear();
  for (std::int64_t corner = 0; corner < *count; ++corner) {
    const std::string_view word = words_.next_on_line();
    const auto index = parse_integer(word);
    if (!index) {
      context_.fail(place(), "expected {} vertex numbers of face {}, found {}; export the part again", *count,
                    builder_.polygon_count(), in_quotes(word));
    }
    if (*index < 0 || static_cast<std::uint64_t>(*index) >= vertices_) {
      context_.fail(place(),
                    "face {} uses vertex {}, but there are {}, numbered from 0; export the part again",
                    builder_.polygon_count(), *index, vertices_);
    }
    corners_.push_back(static_cast<std::uint32_t>(*index));
  }
  builder_.add_polygon(corners_);
  words_.rest_of_line();
}

}  // namespace

Part read_off(const ReadContext& context) { return OffParser(context).parse(); }

}  // namespace moldlight
