// Files of polygons in words and numbers: Wavefront OBJ and OFF.
#include <algorithm>
#include <array>
#include <vector>

#include "io/polygon_part_builder.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

namespace {

constexpr std::uint64_t k_lines_between_reports = 1 << 16;

/// Statements of the format that say nothing of vertices and polygons.
constexpr std::array<std::string_view, 40> k_passed_over = {
    "vt",   "vn",   "vp",    "s",        "l",        "p",          "mtllib",    "usemtl", "maplib", "usemap",
    "mg",   "lod",  "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "cstype", "deg",    "bmat",
    "step", "curv", "curv2", "surf",     "parm",     "trim",       "hole",      "scrv",   "sp",     "end",
    "con",  "bsp",  "bzp",   "cdc",      "cdp",      "res",        "ctech",     "stech",  "call",   "csh"};

class PolygonTextParser {
 public:
  PolygonTextParser(const ReadContext& context, TextRules rules)
      : context_(context), words_(context.bytes(), rules), builder_(context) {}

  [[nodiscard]] Part parse_obj();
  [[nodiscard]] Part parse_off();

 private:
  /// A corner that names a vertex not yet seen: right only if the vertex follows.
  struct Promise {
    std::int64_t index = 0;
    std::size_t line = 0;
  };

  void parse_obj_statement(std::string_view keyword);
  void parse_obj_vertex();
  void parse_obj_face();
  [[nodiscard]] std::uint32_t parse_obj_corner(std::string_view word);
  void parse_off_keyword();
  [[nodiscard]] std::uint64_t parse_off_count(std::string_view word);
  void parse_off_vertex();
  void parse_off_face();
  /// The point's numbers from `first` are the file's.
  void add_vertex(const glm::dvec3& point, std::size_t first);
  void report(std::uint64_t row);
  [[nodiscard]] std::string place() const { return fmt::format("line {}", words_.line()); }

  const ReadContext& context_;
  TextScanner words_;
  PolygonPartBuilder builder_;
  std::vector<std::uint32_t> corners_;
  // Of an OBJ file:
  std::vector<BodyStart> objects_, groups_;
  std::vector<Promise> promises_;  // each greater than those before it
  std::size_t surfaces_ = 0;
  // Of an OFF file, as declared:
  std::uint64_t vertices_ = 0, faces_ = 0;
};

void PolygonTextParser::report(std::uint64_t row) {
  if (row % k_lines_between_reports != 0) return;
  const auto total = static_cast<double>(context_.bytes().size());
  context_.progress.report("reading lines", static_cast<double>(words_.offset()) / total);
}

/// Weights and colours may follow the coordinates; they say nothing of the shape of polygons.
void PolygonTextParser::add_vertex(const glm::dvec3& point, std::size_t first) {
  if (!is_usable_point(point)) {
    context_.fail(place(), "vertex {} is ({}, {}, {}); export the part again",
                  builder_.vertex_count() + first, point.x, point.y, point.z);
  }
  builder_.add_vertex(point);
  words_.rest_of_line();
}

Part PolygonTextParser::parse_obj() {
  for (std::size_t count = 0; !words_.at_end(); ++count) {
    report(count);
    parse_obj_statement(words_.next());
  }
  const auto broken = std::find_if(promises_.begin(), promises_.end(), [&](const Promise& promise) {
    return promise.index > static_cast<std::int64_t>(builder_.vertex_count());
  });
  if (broken != promises_.end()) {
    context_.fail(fmt::format("line {}", broken->line),
                  "a face uses vertex {}, but there are {}; export the part again", broken->index,
                  builder_.vertex_count());
  }
  if (surfaces_ > 0)
    builder_.warn(fmt::format("{} free-form surfaces were left out; export the part as polygons", surfaces_));
  return builder_.finish(objects_.empty() ? groups_ : objects_);
}

void PolygonTextParser::parse_obj_statement(std::string_view keyword) {
  if (keyword == "v") {
    parse_obj_vertex();
  } else if (keyword == "f" || keyword == "fo") {
    parse_obj_face();
  } else if (keyword == "o") {
    objects_.push_back({clean_name(words_.rest_of_line()), builder_.polygon_count()});
  } else if (keyword == "g") {
    groups_.push_back({clean_name(words_.rest_of_line()), builder_.polygon_count()});
  } else if (std::find(k_passed_over.begin(), k_passed_over.end(), keyword) != k_passed_over.end()) {
    if (keyword == "surf") ++surfaces_;
    words_.rest_of_line();
  } else {
    context_.fail(place(), "{} is not a line of an OBJ file; export the part again", in_quotes(keyword));
  }
}

void PolygonTextParser::parse_obj_vertex() {
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words_.next_on_line();
    if (word.empty())
      context_.fail(place(), "a vertex has {} coordinates, not three; export the part again", axis);
    const auto value = parse_number(word);
    if (!value)
      context_.fail(place(), "expected a coordinate, found {}; export the part again", in_quotes(word));
    point[axis] = *value;
  }
  add_vertex(point, 1);
}

void PolygonTextParser::parse_obj_face() {
  corners_.clear();
  while (true) {
    const std::string_view word = words_.next_on_line();
    if (word.empty()) break;
    corners_.push_back(parse_obj_corner(word));
  }
  if (corners_.size() < 3)
    context_.fail(place(), "a face has {} corners, it needs three; export the part again", corners_.size());
  builder_.add_polygon(corners_);
}

/// 'v', 'v/vt', 'v//vn' or 'v/vt/vn': the vertex number from 0. The others are only checked to be numbers.
std::uint32_t PolygonTextParser::parse_obj_corner(std::string_view word) {
  std::int64_t index = 0;
  std::string_view rest = word;
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = rest.find('/');
    const std::string_view number = rest.substr(0, slash);
    const auto value = parse_integer(number);
    const bool left_out = number.empty() && part > 0;
    if ((!value && !left_out) || (part == 2 && slash != std::string_view::npos)) {
      context_.fail(place(), "expected a corner such as 7 or 7/1/3, found {}; export the part again",
                    in_quotes(word));
    }
    if (part == 0) index = *value;
    if (slash == std::string_view::npos) break;
    rest.remove_prefix(slash + 1);
  }
  const auto count = static_cast<std::int64_t>(builder_.vertex_count());
  if (index < 0 && index >= -count) return static_cast<std::uint32_t>(count + index);
  if (index <= 0 || index > std::int64_t{k_max_vertices}) {
    context_.fail(place(),
                  "a face uses vertex {}, but there are {} so far, numbered from 1; export the part again",
                  index, count);
  }
  if (index > count && (promises_.empty() || index > promises_.back().index))
    promises_.push_back({index, words_.line()});
  return static_cast<std::uint32_t>(index - 1);
}

Part PolygonTextParser::parse_off() {
  parse_off_keyword();
  vertices_ = parse_off_count(words_.next());
  faces_ = parse_off_count(words_.next_on_line());
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
    parse_off_vertex();
  }
  for (std::uint64_t row = 0; row < faces_; ++row) {
    report(row);
    parse_off_face();
  }
  if (!words_.at_end()) builder_.warn("more lines follow the faces that the OFF header declares");
  return builder_.finish();
}

void PolygonTextParser::parse_off_keyword() {
  const std::string_view keyword = words_.next();
  if (!keyword.ends_with("OFF") || keyword.find_first_not_of("STCNOF") != std::string_view::npos) {
    context_.fail(place(), "expected 'OFF', found {}; export the part in three dimensions",
                  in_quotes(keyword));
  }
  const TextScanner before = words_;
  if (words_.next_on_line() == "BINARY") context_.fail(place(), "is binary OFF; export the part as text");
  words_ = before;
}

std::uint64_t PolygonTextParser::parse_off_count(std::string_view word) {
  const auto count = parse_integer(word);
  if (!count || *count < 0) {
    context_.fail(place(), "expected a count of vertices or faces, found {}; export the part again",
                  in_quotes(word));
  }
  return static_cast<std::uint64_t>(*count);
}

void PolygonTextParser::parse_off_vertex() {
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
  add_vertex(point, 0);
}

void PolygonTextParser::parse_off_face() {
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

Part read_obj(const ReadContext& context) {
  return PolygonTextParser(context, {.has_comments = true, .continuation = true}).parse_obj();
}

Part read_off(const ReadContext& context) {
  return PolygonTextParser(context, {.has_comments = true}).parse_off();
}

}  // namespace moldlight
