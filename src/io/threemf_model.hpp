// One model document of a 3MF package, as it stands there: objects, and what is to be built of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "io/readers.hpp"

struct zip;

namespace moldlight {

class ZipArchive {
 public:
  /// The context's bytes are the archive; they stay in memory as long as it lives. Throws FileError for a
  /// damaged one.
  explicit ZipArchive(const ReadContext& context);

  /// Names are compared exactly first, then without regard to case.
  [[nodiscard]] bool contains(const std::string& entry) const { return find(entry) >= 0; }

  /// Hands the entry's bytes to `sink`, chunk by chunk. Throws FileError for a missing or damaged entry, and
  /// once all entries read together expand to far more than any real part of the archive's size does.
  void read(const std::string& entry, const std::function<void(std::string_view)>& sink);

 private:
  [[nodiscard]] std::int64_t find(const std::string& entry) const;

  const ReadContext& context_;
  std::unique_ptr<zip, void (*)(zip*)> archive_;
  std::uint64_t bytes_left_;  // that may still come out
};

/// A point p goes to p.x * rows[0] + p.y * rows[1] + p.z * rows[2] + rows[3].
struct ThreemfTransform {
  std::array<glm::dvec3, 4> rows = {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
                                    glm::dvec3(0)};

  [[nodiscard]] glm::dvec3 apply(const glm::dvec3& point) const {
    return point.x * rows[0] + point.y * rows[1] + point.z * rows[2] + rows[3];
  }
  /// This transform first, then `next`.
  [[nodiscard]] ThreemfTransform then(const ThreemfTransform& next) const;
  /// It turns outsides into insides.
  [[nodiscard]] bool mirrors() const;
};

/// A use of an object, by a build item or by another object.
struct ThreemfUse {
  std::string document;  // that holds the object; empty: the one of the use
  std::uint64_t object = 0;
  ThreemfTransform transform;
  std::string place;  // for messages
};

struct ThreemfObject {
  std::string name;
  bool is_support = false;  // material that only helps printing
  std::vector<glm::dvec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<ThreemfUse> components;
};

struct ThreemfModel {
  std::string unit = "mm";
  double unit_mm = 1.0;
  std::map<std::uint64_t, ThreemfObject> objects;  // by identifier
  std::vector<ThreemfUse> items;
  std::vector<std::string> unread_extensions;  // required by the document, but unknown here
};

/// Throws FileError with entry and line for a document that breaks the format.
[[nodiscard]] ThreemfModel read_threemf_model(const ReadContext& context, ZipArchive& archive,
                                              const std::string& document);

}  // namespace moldlight
