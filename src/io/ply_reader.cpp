#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "io/ply_header.hpp"
#include "io/polygon_part_builder.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

namespace {

constexpr std::uint64_t k_rows_between_reports = 1 << 16;

template <typename T>
double value_of(const char* raw) {
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return static_cast<double>(value);
}
/// By PlyType.
constexpr std::array<double (*)(const char*), 8> k_values = {
    value_of<std::int8_t>,  value_of<std::uint8_t>,  value_of<std::int16_t>, value_of<std::uint16_t>,
    value_of<std::int32_t>, value_of<std::uint32_t>, value_of<float>,        value_of<double>};

/// Values of the data, one after the other, whatever the encoding. Every PLY type fits a double exactly.
class PlyValues {
 public:
  PlyValues(const ReadContext& context, const PlyHeader& header)
      : context_(context),
        header_(header),
        position_(header.bytes),
        words_(context.bytes().substr(header.bytes)) {}

  [[nodiscard]] double next(PlyType type) { return is_text() ? next_word() : next_bytes(type); }
  /// Length of the list that follows; the file is long enough for it.
  [[nodiscard]] std::size_t next_count(const PlyProperty& list);
  /// Says where the row in work is.
  void begin_row(std::string_view element, std::uint64_t row) {
    element_ = element;
    row_ = row;
  }
  template <typename... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> what, Args&&... args) const {
    const std::size_t at = is_text() ? header_.lines + words_.line() : position_;
    context_.fail(fmt::format("{} {} ({} {})", element_, row_, is_text() ? "line" : "byte", at),
                  "{}; export the part again", fmt::format(what, std::forward<Args>(args)...));
  }
  [[nodiscard]] bool at_end() { return is_text() ? words_.at_end() : position_ == context_.bytes().size(); }
  [[nodiscard]] double done_share() const {
    const std::size_t done = is_text() ? header_.bytes + words_.offset() : position_;
    return static_cast<double>(done) / static_cast<double>(context_.bytes().size());
  }

 private:
  [[nodiscard]] bool is_text() const { return header_.encoding == PlyEncoding::ascii; }
  [[nodiscard]] double next_word();
  [[nodiscard]] double next_bytes(PlyType type);

  const ReadContext& context_;
  const PlyHeader& header_;
  std::size_t position_;
  TextScanner words_;
  std::string_view element_;
  std::uint64_t row_ = 0;
};

double PlyValues::next_word() {
  const std::string_view word = words_.next();
  if (word.empty()) fail("the file ends inside it");
  const auto value = parse_number(word);
  if (!value) fail("expected a number, found {}", in_quotes(word));
  return *value;
}

double PlyValues::next_bytes(PlyType type) {
  const std::size_t size = ply_type_size(type);
  if (context_.bytes().size() - position_ < size) fail("the file ends inside it");
  std::array<char, 8> raw;
  std::memcpy(raw.data(), context_.bytes().data() + position_, size);
  constexpr bool k_little = std::endian::native == std::endian::little;
  if ((header_.encoding == PlyEncoding::little_endian) != k_little)
    std::reverse(raw.begin(), raw.begin() + size);
  position_ += size;
  return k_values[static_cast<std::size_t>(type)](raw.data());
}

std::size_t PlyValues::next_count(const PlyProperty& list) {
  const double count = next(*list.count_type);
  const std::size_t left = is_text() ? context_.bytes().size() - header_.bytes - words_.offset()
                                     : (context_.bytes().size() - position_) / ply_type_size(list.type);
  if (!(count >= 0.0) || count != std::floor(count)) fail("a list has the length {}", count);
  if (count > static_cast<double>(left)) fail("the file ends inside a list of {} values", count);
  return static_cast<std::size_t>(count);
}

class PlyParser {
 public:
  explicit PlyParser(const ReadContext& context)
      : context_(context), header_(read_ply_header(context)), values_(context, header_), builder_(context) {}

  [[nodiscard]] Part parse();

 private:
  void read_vertices(const PlyElement& element);
  void read_faces(const PlyElement& element);
  void pass_over(const PlyProperty& property);
  void begin_row(const PlyElement& element, std::uint64_t row);

  const ReadContext& context_;
  PlyHeader header_;
  PlyValues values_;
  PolygonPartBuilder builder_;
  std::uint64_t vertices_ = 0;  // declared
};

Part PlyParser::parse() {
  for (const PlyElement& element : header_.elements)
    if (element.name == "vertex") vertices_ = element.count;
  for (const PlyElement& element : header_.elements) {
    if (element.name == "vertex") {
      read_vertices(element);
    } else if (element.name == "face") {
      read_faces(element);
    } else {
      for (std::uint64_t row = 0; row < element.count; ++row) {
        begin_row(element, row);
        for (const PlyProperty& property : element.properties) pass_over(property);
      }
    }
  }
  if (!values_.at_end()) builder_.warn("more data follow the elements that the PLY header declares");
  return builder_.finish();
}

void PlyParser::begin_row(const PlyElement& element, std::uint64_t row) {
  values_.begin_row(element.name, row);
  if (row % k_rows_between_reports == 0) context_.progress.report("reading elements", values_.done_share());
}

void PlyParser::pass_over(const PlyProperty& property) {
  const std::size_t count = property.count_type ? values_.next_count(property) : 1;
  for (std::size_t i = 0; i < count; ++i) static_cast<void>(values_.next(property.type));
}

void PlyParser::read_vertices(const PlyElement& element) {
  std::vector<int> axis_of(element.properties.size(), -1);
  for (int axis = 0; axis < 3; ++axis) {
    const auto found = element.find(std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1));
    if (!found || element.properties[*found].count_type)
      context_.fail("", "the vertices have no coordinate {}; export the part again", "xyz"[axis]);
    axis_of[*found] = axis;
  }
  for (std::uint64_t row = 0; row < element.count; ++row) {
    begin_row(element, row);
    glm::dvec3 point(0.0);
    for (std::size_t i = 0; i < axis_of.size(); ++i) {
      if (axis_of[i] < 0) {
        pass_over(element.properties[i]);
      } else {
        point[axis_of[i]] = values_.next(element.properties[i].type);
      }
    }
    if (!is_usable_point(point)) values_.fail("its coordinates are ({}, {}, {})", point.x, point.y, point.z);
    builder_.add_vertex(point);
  }
}

void PlyParser::read_faces(const PlyElement& element) {
  auto list = element.find("vertex_indices");
  if (!list) list = element.find("vertex_index");
  if (!list || !element.properties[*list].count_type)
    context_.fail("", "the faces have no list 'vertex_indices'; export the part again");
  std::vector<std::uint32_t> corners;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    begin_row(element, row);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (i != *list) {
        pass_over(property);
        continue;
      }
      const std::size_t count = values_.next_count(property);
      if (count < 3) values_.fail("it has {} corners, it needs three", count);
      corners.clear();
      for (std::size_t corner = 0; corner < count; ++corner) {
        const double index = values_.next(property.type);
        if (!(index >= 0.0 && index < static_cast<double>(vertices_)) || index != std::floor(index))
          values_.fail("it uses vertex {}, but there are {}, numbered from 0", index, vertices_);
        corners.push_back(static_cast<std::uint32_t>(index));
      }
      builder_.add_polygon(corners);
    }
  }
}

}  // namespace

Part read_ply(const ReadContext& context) { return PlyParser(context).parse(); }

}  // namespace moldlight
