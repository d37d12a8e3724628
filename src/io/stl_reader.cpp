// STL, in words and as bytes.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "io/file_contents.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"
#include "mesh/weld.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_header_bytes = 84;
constexpr std::size_t k_facet_bytes = 50;
constexpr std::size_t k_normal_bytes = 12;
constexpr std::size_t k_binary_facets_between_reports = 1 << 18;

static_assert(std::endian::native == std::endian::little, "binary STL is read as it lies in memory");

std::uint32_t declared_facets(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

constexpr std::size_t k_facets_between_reports = 1 << 16;

/// Solids that break a rule, of which a file may hold millions.
struct SolidsAtFault {
  std::size_t count = 0, first_line = 0;

  void add(std::size_t line) {
    if (count++ == 0) first_line = line;
  }
  void warn(std::string_view what, std::vector<std::string>& warnings) const {
    if (count > 0)
      warnings.push_back(fmt::format("{} solids {} (the first at line {})", count, what, first_line));
  }
};

/// Walks the words once; a word that does not fit the grammar ends the reading with its line.
class AsciiStlParser {
 public:
  explicit AsciiStlParser(const ReadContext& context) : context_(context), words_(context.bytes()) {}

  [[nodiscard]] Part parse();

 private:
  void parse_solid(const std::string& name);
  void parse_facet();
  void parse_vertex();
  std::string parse_name();
  void expect(std::string_view keyword);
  void expect_end(std::string_view joined, std::string_view keyword);
  [[noreturn]] void fail_expected(std::string_view expected, std::string_view found) const;

  [[nodiscard]] std::string place() const { return fmt::format("line {}", words_.line()); }

  const ReadContext& context_;
  TextScanner words_;
  std::vector<glm::dvec3> corners_;
  std::vector<Body> bodies_;
  SolidsAtFault without_begin_, without_end_;
  std::size_t facet_ = 0;  // the one being read
};

Part AsciiStlParser::parse() {
  while (!words_.at_end()) {
    const TextScanner before = words_;
    const std::string_view word = words_.next();
    if (equals_ignoring_case(word, "solid")) {
      parse_solid(parse_name());
    } else if (equals_ignoring_case(word, "facet")) {
      without_begin_.add(words_.line());
      words_ = before;
      parse_solid("");
    } else if (corners_.empty()) {
      context_.fail(place(), "is text, but no STL, which begins with 'solid'; export the part again");
    } else {
      fail_expected("'solid'", word);
    }
  }
  if (corners_.empty()) context_.fail(place(), "holds no facets; export the part again");

  Part part;
  part.bodies = std::move(bodies_);
  without_begin_.warn("begin without the word 'solid'", part.warnings);
  without_end_.warn("end without 'endsolid'; the file may be cut short", part.warnings);
  context_.contents.release();
  part.mesh = weld_corners(corners_);
  return part;
}

/// The facets of a solid, and its closing word.
void AsciiStlParser::parse_solid(const std::string& name) {
  const std::size_t first = facet_;
  while (true) {
    const TextScanner before = words_;
    const std::string_view word = words_.next();
    if (equals_ignoring_case(word, "facet")) {
      parse_facet();
      continue;
    }
    if (word.empty() || equals_ignoring_case(word, "solid")) {
      if (word.empty() && facet_ == first) fail_expected("'facet' or 'endsolid'", word);
      without_end_.add(words_.line());
      words_ = before;
      break;
    }
    if (equals_ignoring_case(word, "endsolid")) {
      parse_name();
      break;
    }
    if (equals_ignoring_case(word, "end") && equals_ignoring_case(words_.next_on_line(), "solid")) {
      parse_name();
      break;
    }
    fail_expected("'facet' or 'endsolid'", word);
  }
  if (facet_ > first)
    bodies_.push_back({name, static_cast<FacetIndex>(first), static_cast<FacetIndex>(facet_ - first)});
}

/// A name runs to the end of its line, or to the first facet where the whole file is one line.
std::string AsciiStlParser::parse_name() {
  TextScanner ahead = words_;
  while (true) {
    const TextScanner before = ahead;
    const std::string_view word = ahead.next_on_line();
    if (word.empty()) break;
    if (!equals_ignoring_case(word, "facet")) continue;
    TextScanner after = ahead;
    if (!equals_ignoring_case(after.next_on_line(), "normal") || !parse_number(after.next_on_line()))
      continue;
    const std::string_view name = context_.bytes().substr(words_.offset(), before.offset() - words_.offset());
    words_ = before;
    return clean_name(name.substr(std::min(name.size(), name.find_first_not_of(" \t\v\f"))));
  }
  return clean_name(words_.rest_of_line());
}

void AsciiStlParser::parse_facet() {
  if (facet_ % k_facets_between_reports == 0) {
    const auto total = static_cast<double>(context_.bytes().size());
    context_.progress.report("reading facets", static_cast<double>(words_.offset()) / total);
  }
  context_.check_facet_count(facet_ + 1);
  expect("normal");
  // Normals are often no numbers ("-1.#IND") where a facet has no area, and nothing is taken from them.
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = words_.next();
    if (word.empty() || equals_ignoring_case(word, "outer")) fail_expected("three numbers of a normal", word);
  }
  expect("outer");
  expect("loop");
  for (int i = 0; i < 3; ++i) parse_vertex();
  const TextScanner before = words_;
  if (equals_ignoring_case(words_.next(), "vertex"))
    context_.fail(place(), "facet {} has more than three vertices; export the part as triangles", facet_);
  words_ = before;
  expect_end("endloop", "loop");
  expect_end("endfacet", "facet");
  ++facet_;
}

void AsciiStlParser::parse_vertex() {
  expect("vertex");
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words_.next();
    const auto value = parse_number(word);
    if (!value) fail_expected("a number", word);
    if (!is_usable_coordinate(*value)) {
      context_.fail(place(), "a coordinate of facet {} is {}; export the part again", facet_,
                    in_quotes(word));
    }
    point[axis] = *value;
  }
  corners_.push_back(point);
}

void AsciiStlParser::expect(std::string_view keyword) {
  const std::string_view word = words_.next();
  if (!equals_ignoring_case(word, keyword)) fail_expected(fmt::format("'{}'", keyword), word);
}

/// 'endloop' or 'end loop'.
void AsciiStlParser::expect_end(std::string_view joined, std::string_view keyword) {
  const std::string_view word = words_.next();
  if (equals_ignoring_case(word, joined)) return;
  if (equals_ignoring_case(word, "end") && equals_ignoring_case(words_.next(), keyword)) return;
  fail_expected(fmt::format("'{}'", joined), word);
}

void AsciiStlParser::fail_expected(std::string_view expected, std::string_view found) const {
  if (found.empty()) {
    context_.fail(place(), "the file ends where {} should follow (facet {}); export the part again", expected,
                  facet_);
  }
  context_.fail(place(), "expected {}, found {} (facet {}); export the part again", expected,
                in_quotes(found), facet_);
}

}  // namespace

bool binary_stl_size_fits(const FileBeginning& file) {
  if (file.bytes.size() < k_header_bytes) return false;
  return file.size == k_header_bytes + std::uint64_t{declared_facets(file.bytes)} * k_facet_bytes;
}

void refuse_binary_stl(const std::string& path, const FileBeginning& file) {
  if (file.size < k_header_bytes) {
    throw FileError(path, fmt::format("byte {}", file.size),
                    fmt::format("ends inside the {} bytes of the binary STL header; export the part again",
                                k_header_bytes));
  }
  const std::uint64_t declared = declared_facets(file.bytes);
  const std::uint64_t held = (file.size - k_header_bytes) / k_facet_bytes;
  const std::uint64_t rest = (file.size - k_header_bytes) % k_facet_bytes;
  if (rest == 0) {
    throw FileError(
        path, "byte 80",
        fmt::format("the header declares {} facets, but the file's size is that of {}; export the part again",
                    declared, held));
  }
  if (declared > held) {
    throw FileError(
        path, fmt::format("facet {}", held),
        fmt::format("the file ends inside this facet, {} are declared; export the part again", declared));
  }
  throw FileError(path, fmt::format("byte {}", k_header_bytes + declared * k_facet_bytes),
                  fmt::format("{} bytes follow the {} facets that the header declares; export the part again",
                              file.size - k_header_bytes - declared * k_facet_bytes, declared));
}

Part read_binary_stl(const ReadContext& context) {
  const std::string_view bytes = context.bytes();
  if (const FileBeginning whole{bytes, bytes.size()}; !binary_stl_size_fits(whole))
    refuse_binary_stl(context.path, whole);
  const std::size_t count = declared_facets(bytes);
  if (count == 0) context.fail("byte 80", "holds no facets; export the part again");
  context.check_facet_count(count);
  check_memory(context.path, count * (3 * sizeof(glm::dvec3) + sizeof(std::array<VertexIndex, 3>)));

  std::vector<glm::dvec3> corners;
  corners.reserve(3 * count);
  for (std::size_t facet = 0; facet < count; ++facet) {
    if (facet % k_binary_facets_between_reports == 0)
      context.progress.report("reading facets", static_cast<double>(facet) / static_cast<double>(count));
    float xyz[9];
    std::memcpy(xyz, bytes.data() + k_header_bytes + facet * k_facet_bytes + k_normal_bytes, sizeof xyz);
    for (const float value : xyz) {
      if (!is_usable_coordinate(static_cast<double>(value)))
        context.fail(fmt::format("facet {}", facet), "a coordinate is {}; export the part again", value);
    }
    for (int corner = 0; corner < 3; ++corner)
      corners.emplace_back(xyz[3 * corner], xyz[3 * corner + 1], xyz[3 * corner + 2]);
  }
  context.contents.release();

  Part part;
  part.mesh = weld_corners(corners);
  part.bodies = {{"", 0, static_cast<FacetIndex>(count)}};
  return part;
}

Part read_ascii_stl(const ReadContext& context) { return AsciiStlParser(context).parse(); }

}  // namespace moldlight
