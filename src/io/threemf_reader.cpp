#include <set>
#include <vector>

#include "io/file_contents.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"
#include "io/threemf_model.hpp"
#include "io/xml_parser.hpp"
#include "mesh/weld.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_max_depth = 64;
/// A few hundred bytes can place an object a million times.
constexpr std::size_t k_max_bodies = 20'000;
constexpr std::size_t k_max_uses = 1'000'000;
constexpr std::string_view k_model_relationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// A name in the archive for a reference such as "/3D/3dmodel.model".
std::string entry_name(std::string_view reference) {
  while (reference.starts_with('/')) reference.remove_prefix(1);
  return std::string(reference);
}

/// Finds the root model in the package's list of relationships.
class RelationshipParser : public XmlParser {
 public:
  using XmlParser::XmlParser;
  [[nodiscard]] const std::string& root_model() const { return root_model_; }

 protected:
  void start_element(std::string_view name, const XmlAttributes& attributes) override {
    if (!name.ends_with("|Relationship") || attributes.find("Type") != k_model_relationship) return;
    if (root_model_.empty()) root_model_ = entry_name(attributes.find("Target").value_or(""));
  }
  void end_element(std::string_view) override {}

 private:
  std::string root_model_;
};

/// Reads the documents of a package and joins what is to be built into one mesh.
class ThreemfAssembler {
 public:
  explicit ThreemfAssembler(const ReadContext& context) : context_(context), archive_(context) {}

  [[nodiscard]] Part assemble();

 private:
  /// An object in use, with all transforms from it to the build.
  struct Visit {
    const ThreemfUse* use = nullptr;
    std::string document;  // that the use stands in
    ThreemfTransform to_parent;
    std::string parent_name;
    std::size_t depth = 0;
  };

  [[nodiscard]] std::string find_root();
  void load_documents(const std::string& root);
  void add_uses_of_all_objects(ThreemfModel& root);
  void visit(const Visit& visit, std::vector<Visit>& pending);
  void add_mesh(const ThreemfObject& object, const ThreemfTransform& transform, const std::string& name);

  const ReadContext& context_;
  ZipArchive archive_;
  std::map<std::string, ThreemfModel> models_;  // by entry name
  double root_unit_mm_ = 1.0;
  std::size_t supports_ = 0;
  std::uint64_t facets_with_memory_ = 0;
  Part part_;
};

Part ThreemfAssembler::assemble() {
  const std::string root_name = find_root();
  load_documents(root_name);
  ThreemfModel& root = models_.at(root_name);
  part_.unit = root.unit;
  root_unit_mm_ = root.unit_mm;
  if (root.items.empty()) add_uses_of_all_objects(root);
  // Depth first, on a stack of our own, so that bodies come in the order of the file.
  std::vector<Visit> pending;
  for (auto item = root.items.rbegin(); item != root.items.rend(); ++item)
    pending.push_back({&*item, root_name, {}, "", 0});
  for (std::size_t uses = 0; !pending.empty(); ++uses) {
    if (uses == k_max_uses) context_.fail("", "uses more than {} objects, as no real part does", k_max_uses);
    const Visit next = std::move(pending.back());
    pending.pop_back();
    visit(next, pending);
  }
  if (part_.mesh.facets.empty()) context_.fail("", "holds no facets; export the part again");
  if (supports_ > 0) part_.warnings.push_back(fmt::format("{} support structures were left out", supports_));
  models_.clear();
  part_.mesh = weld_vertices(part_.mesh);
  return std::move(part_);
}

std::string ThreemfAssembler::find_root() {
  const std::string usual = "3D/3dmodel.model";
  const std::string relationships = "_rels/.rels";
  if (!archive_.contains(relationships)) {
    if (!archive_.contains(usual))
      context_.fail("", "is a zip archive, but not a 3MF package; export the part again");
    part_.warnings.push_back("the 3MF package does not name its model; the usual one was taken");
    return usual;
  }
  RelationshipParser parser(context_, relationships);
  archive_.read(relationships, [&](std::string_view chunk) { parser.feed(chunk); });
  parser.finish();
  if (parser.root_model().empty()) {
    context_.fail(in_quotes(relationships),
                  "names no 3D model: the archive is not a 3MF package; export the part again");
  }
  return parser.root_model();
}

void ThreemfAssembler::load_documents(const std::string& root) {
  std::vector<std::string> pending = {root};
  std::set<std::string> extensions;
  while (!pending.empty()) {
    const std::string name = std::move(pending.back());
    pending.pop_back();
    if (models_.contains(name)) continue;
    const ThreemfModel& model =
        models_.emplace(name, read_threemf_model(context_, archive_, name)).first->second;
    extensions.insert(model.unread_extensions.begin(), model.unread_extensions.end());
    const auto add_document = [&](const ThreemfUse& use) {
      if (!use.document.empty()) pending.push_back(entry_name(use.document));
    };
    for (const ThreemfUse& item : model.items) add_document(item);
    for (const auto& [id, object] : model.objects)
      for (const ThreemfUse& component : object.components) add_document(component);
  }
  for (const std::string& extension : extensions) {
    part_.warnings.push_back(
        fmt::format("the 3MF extension '{}' is not read; some of the part may be missing", extension));
  }
}

void ThreemfAssembler::add_uses_of_all_objects(ThreemfModel& root) {
  std::set<std::uint64_t> used;
  for (const auto& [id, object] : root.objects) {
    for (const ThreemfUse& component : object.components)
      if (component.document.empty()) used.insert(component.object);
  }
  for (const auto& [id, object] : root.objects)
    if (!used.contains(id)) root.items.push_back({"", id, {}, ""});
  part_.warnings.push_back("the 3MF file has no build items; all its objects were read");
}

void ThreemfAssembler::visit(const Visit& visit, std::vector<Visit>& pending) {
  const ThreemfUse& use = *visit.use;
  const std::string document = use.document.empty() ? visit.document : entry_name(use.document);
  const ThreemfModel& model = models_.at(document);
  const auto found = model.objects.find(use.object);
  if (found == model.objects.end()) {
    context_.fail(use.place, "there is no object {} in {}; export the part again", use.object,
                  in_quotes(document));
  }
  if (visit.depth > k_max_depth) {
    context_.fail(use.place, "objects are nested more than {} deep, or in a ring; export the part again",
                  k_max_depth);
  }
  const ThreemfObject& object = found->second;
  if (object.is_support) {
    ++supports_;
    return;
  }
  const ThreemfTransform to_root = use.transform.then(visit.to_parent);
  const std::string& name = object.name.empty() ? visit.parent_name : object.name;
  if (!object.triangles.empty()) {
    ThreemfTransform scaled;
    for (glm::dvec3& row : scaled.rows) row *= model.unit_mm / root_unit_mm_;
    add_mesh(object, model.unit_mm == root_unit_mm_ ? to_root : scaled.then(to_root), name);
  }
  for (auto component = object.components.rbegin(); component != object.components.rend(); ++component)
    pending.push_back({&*component, document, to_root, name, visit.depth + 1});
}

void ThreemfAssembler::add_mesh(const ThreemfObject& object, const ThreemfTransform& transform,
                                const std::string& name) {
  TriangleMesh& mesh = part_.mesh;
  const std::uint64_t facets = mesh.facets.size() + object.triangles.size();
  context_.check_facet_count(facets);
  if (part_.bodies.size() == k_max_bodies)
    context_.fail("", "places more than {} bodies; save those that matter", k_max_bodies);
  if (facets > facets_with_memory_) {
    // Vectors grow by doubling, and welding copies them.
    facets_with_memory_ = 2 * facets;
    check_memory(context_.path, 2 * facets * (sizeof(std::array<VertexIndex, 3>) + sizeof(glm::dvec3) / 2));
  }
  context_.progress.report("assembling", 0.5);
  const std::size_t first_vertex = mesh.vertices.size();
  if (first_vertex + object.vertices.size() > k_max_vertices)
    context_.fail("", "holds more than {} vertices; split the part", k_max_vertices);
  for (const glm::dvec3& vertex : object.vertices) {
    const glm::dvec3 point = transform.apply(vertex);
    if (!is_usable_point(point)) {
      context_.fail("", "a transform puts a vertex of the object {} at ({}, {}, {}); export the part again",
                    in_quotes(name), point.x, point.y, point.z);
    }
    mesh.vertices.push_back(point);
  }
  const auto first_facet = static_cast<FacetIndex>(mesh.facets.size());
  const bool mirrors = transform.mirrors();
  for (const auto& [a, b, c] : object.triangles) {
    const auto base = static_cast<VertexIndex>(first_vertex);
    mesh.facets.push_back({base + a, base + (mirrors ? c : b), base + (mirrors ? b : c)});
  }
  part_.bodies.push_back({name, first_facet, static_cast<FacetIndex>(object.triangles.size())});
}

}  // namespace

Part read_threemf(const ReadContext& context) { return ThreemfAssembler(context).assemble(); }

}  // namespace moldlight
