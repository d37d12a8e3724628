#include "io/threemf_model.hpp"

#include <glm/geometric.hpp>
#include <zip.h>

#include "io/text_scanner.hpp"
#include "io/xml_parser.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight {

namespace {

// Meshes in XML shrink to a tenth or so; what shrinks to less than a hundredth is no mesh.
constexpr std::uint64_t k_free_bytes = std::uint64_t{100} << 20;
constexpr std::uint64_t k_max_expansion = 100;
constexpr std::size_t k_unpacked_bytes = std::size_t{64} << 10;

std::string zip_error_text(zip_error_t& error) {
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

constexpr std::string_view k_production = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view k_production_path =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
constexpr std::string_view k_materials = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::uint64_t k_elements_between_reports = 1 << 16;

/// Elements of other namespaces than the root's belong to extensions and are passed over.
class ModelParser : public XmlParser {
 public:
  using XmlParser::XmlParser;
  [[nodiscard]] ThreemfModel take() { return std::move(model_); }

 protected:
  void start_element(std::string_view name, const XmlAttributes& attributes) override;
  void end_element(std::string_view name) override;
  void start_namespace(std::string_view prefix, std::string_view name) override {
    namespaces_[std::string(prefix)] = name;
  }

 private:
  void start_model(std::string_view name, const XmlAttributes& attributes);
  void start_object(const XmlAttributes& attributes);
  void add_vertex(const XmlAttributes& attributes);
  void add_triangle(const XmlAttributes& attributes);
  [[nodiscard]] ThreemfUse parse_use(const XmlAttributes& attributes);
  [[nodiscard]] ThreemfTransform parse_transform(std::string_view text);
  [[nodiscard]] std::string_view attribute(const XmlAttributes& attributes, std::string_view name);
  [[nodiscard]] std::uint64_t identifier(const XmlAttributes& attributes, std::string_view name);

  ThreemfModel model_;
  std::string core_prefix_;  // of the names of core elements
  std::map<std::string, std::string> namespaces_;
  bool in_root_ = false;
  ThreemfObject* object_ = nullptr;  // in work
  std::uint64_t object_id_ = 0;
  std::uint64_t elements_ = 0, triangles_ = 0;
};

void ModelParser::start_element(std::string_view name, const XmlAttributes& attributes) {
  if (++elements_ % k_elements_between_reports == 0) context().progress.report("reading the model", 0.5);
  if (!in_root_) return start_model(name, attributes);
  if (!name.starts_with(core_prefix_)) return;
  name.remove_prefix(core_prefix_.size());
  if (name == "vertex") {
    add_vertex(attributes);
  } else if (name == "triangle") {
    add_triangle(attributes);
  } else if (name == "object") {
    start_object(attributes);
  } else if (name == "component") {
    if (object_ == nullptr)
      context().fail(place(), "a component stands outside any object; export the part again");
    object_->components.push_back(parse_use(attributes));
  } else if (name == "item") {
    model_.items.push_back(parse_use(attributes));
  }
}

void ModelParser::end_element(std::string_view name) {
  if (name.starts_with(core_prefix_) && name.substr(core_prefix_.size()) == "object") object_ = nullptr;
}

void ModelParser::start_model(std::string_view name, const XmlAttributes& attributes) {
  const std::size_t bar = name.rfind('|');
  core_prefix_ = name.substr(0, bar == std::string_view::npos ? 0 : bar + 1);
  if (name.substr(core_prefix_.size()) != "model") {
    context().fail(place(), "expected a 3MF model, found the element {}; export the part again",
                   in_quotes(name));
  }
  in_root_ = true;
  if (const auto word = attributes.find("unit")) {
    const auto unit = find_length_unit(*word);
    if (!unit) context().fail(place(), "the unit {} is unknown; export the part again", in_quotes(*word));
    model_.unit = unit->name;
    model_.unit_mm = unit->mm;
  }
  TextScanner prefixes(attributes.find("requiredextensions").value_or(""));
  for (std::string_view prefix = prefixes.next(); !prefix.empty(); prefix = prefixes.next()) {
    const std::string& extension = namespaces_[std::string(prefix)];
    if (extension != k_production && extension != k_materials) {
      model_.unread_extensions.push_back(
          clean_name(extension.empty() ? prefix : std::string_view(extension)));
    }
  }
}

void ModelParser::start_object(const XmlAttributes& attributes) {
  object_id_ = identifier(attributes, "id");
  const auto [place_of_object, is_new] = model_.objects.try_emplace(object_id_);
  if (!is_new)
    context().fail(place(), "a second object has the identifier {}; export the part again", object_id_);
  object_ = &place_of_object->second;
  object_->name = clean_name(attributes.find("name").value_or(""));
  const std::string_view type = attributes.find("type").value_or("model");
  object_->is_support = type == "support" || type == "solidsupport";
}

void ModelParser::add_vertex(const XmlAttributes& attributes) {
  if (object_ == nullptr)
    context().fail(place(), "a vertex stands outside any object; export the part again");
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word =
        attribute(attributes, std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1));
    const auto value = parse_number(word);
    if (!value)
      context().fail(place(), "expected a coordinate, found {}; export the part again", in_quotes(word));
    point[axis] = *value;
  }
  if (!is_usable_point(point)) {
    context().fail(place(), "vertex {} of object {} is ({}, {}, {}); export the part again",
                   object_->vertices.size(), object_id_, point.x, point.y, point.z);
  }
  object_->vertices.push_back(point);
}

void ModelParser::add_triangle(const XmlAttributes& attributes) {
  if (object_ == nullptr)
    context().fail(place(), "a triangle stands outside any object; export the part again");
  context().check_facet_count(++triangles_);
  std::array<std::uint32_t, 3> corners;
  static constexpr std::array<std::string_view, 3> k_names = {"v1", "v2", "v3"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t corner = identifier(attributes, k_names[i]);
    if (corner >= object_->vertices.size()) {
      context().fail(
          place(),
          "triangle {} of object {} uses vertex {}, but there are {}, numbered from 0; export the part again",
          object_->triangles.size(), object_id_, corner, object_->vertices.size());
    }
    corners[i] = static_cast<std::uint32_t>(corner);
  }
  object_->triangles.push_back(corners);
}

ThreemfUse ModelParser::parse_use(const XmlAttributes& attributes) {
  ThreemfUse use;
  use.object = identifier(attributes, "objectid");
  use.document = attributes.find(k_production_path).value_or("");
  use.place = place();
  if (const auto text = attributes.find("transform")) use.transform = parse_transform(*text);
  return use;
}

ThreemfTransform ModelParser::parse_transform(std::string_view text) {
  ThreemfTransform transform;
  TextScanner words(text);
  for (glm::dvec3& row : transform.rows) {
    for (int column = 0; column < 3; ++column) {
      const std::string_view word = words.next();
      const auto value = parse_number(word);
      if (!value || !is_usable_coordinate(*value)) {
        context().fail(place(), "expected twelve numbers of a transform, found {}; export the part again",
                       in_quotes(word));
      }
      row[column] = *value;
    }
  }
  return transform;
}

std::string_view ModelParser::attribute(const XmlAttributes& attributes, std::string_view name) {
  const auto value = attributes.find(name);
  if (!value) context().fail(place(), "the attribute {} is missing; export the part again", in_quotes(name));
  return *value;
}

std::uint64_t ModelParser::identifier(const XmlAttributes& attributes, std::string_view name) {
  const std::string_view word = attribute(attributes, name);
  const auto value = parse_integer(word);
  if (!value || *value < 0) {
    context().fail(place(), "expected a number from 0 as {}, found {}; export the part again",
                   in_quotes(name), in_quotes(word));
  }
  return static_cast<std::uint64_t>(*value);
}

}  // namespace

ZipArchive::ZipArchive(const ReadContext& context)
    : context_(context),
      archive_(nullptr, [](zip* archive) { zip_discard(archive); }),
      bytes_left_(k_free_bytes + k_max_expansion * context.bytes().size()) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(context.bytes().data(), context.bytes().size(), 0, &error);
  if (source == nullptr) context.fail("", "cannot be unpacked: {}", zip_error_text(error));
  archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
  if (archive_ == nullptr) {
    zip_source_free(source);
    context.fail("", "is a damaged or truncated zip archive ({}); export the part again",
                 zip_error_text(error));
  }
}

std::int64_t ZipArchive::find(const std::string& entry) const {
  const std::int64_t exact = zip_name_locate(archive_.get(), entry.c_str(), 0);
  return exact >= 0 ? exact : zip_name_locate(archive_.get(), entry.c_str(), ZIP_FL_NOCASE);
}

void ZipArchive::read(const std::string& entry, const std::function<void(std::string_view)>& sink) {
  const std::int64_t index = find(entry);
  if (index < 0) context_.fail("", "the archive holds no {}; export the part again", in_quotes(entry));
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen_index(archive_.get(), static_cast<zip_uint64_t>(index), 0), zip_fclose);
  if (file == nullptr) {
    context_.fail(in_quotes(entry), "cannot be unpacked: {}",
                  zip_error_strerror(zip_get_error(archive_.get())));
  }
  std::vector<char> chunk(k_unpacked_bytes);
  while (true) {
    const zip_int64_t got = zip_fread(file.get(), chunk.data(), chunk.size());
    if (got < 0) {
      context_.fail(in_quotes(entry), "is damaged: {}; export the part again",
                    zip_error_strerror(zip_file_get_error(file.get())));
    }
    if (got == 0) return;
    const auto size = static_cast<std::uint64_t>(got);
    if (size > bytes_left_) {
      context_.fail(in_quotes(entry), "expands to more than {} times the file's size, as no real part does",
                    k_max_expansion);
    }
    bytes_left_ -= size;
    sink({chunk.data(), static_cast<std::size_t>(size)});
  }
}

ThreemfTransform ThreemfTransform::then(const ThreemfTransform& next) const {
  const auto turn = [&](const glm::dvec3& row) {
    return row.x * next.rows[0] + row.y * next.rows[1] + row.z * next.rows[2];
  };
  return {{turn(rows[0]), turn(rows[1]), turn(rows[2]), turn(rows[3]) + next.rows[3]}};
}

bool ThreemfTransform::mirrors() const { return glm::dot(glm::cross(rows[0], rows[1]), rows[2]) < 0.0; }

ThreemfModel read_threemf_model(const ReadContext& context, ZipArchive& archive,
                                const std::string& document) {
  ModelParser parser(context, document);
  archive.read(document, [&](std::string_view chunk) { parser.feed(chunk); });
  parser.finish();
  return parser.take();
}

}  // namespace moldlight
