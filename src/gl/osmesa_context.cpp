// OSMesa: Mesa's software renderer in one library, for machines without EGL. Mesa 25.1 no longer has it, so
// its few entries are declared here and the library is opened at run time.
#include <array>

#include "base/error.hpp"
#include "gl/headless_backends.hpp"

namespace moldlight::gl {

namespace {

using OsmesaContextHandle = struct osmesa_context*;

// The values of <GL/osmesa.h>, which are part of the library's binary interface.
enum OsmesaAttribute : int {
  k_osmesa_format = 0x22,
  k_osmesa_depth_bits = 0x30,
  k_osmesa_stencil_bits = 0x31,
  k_osmesa_accum_bits = 0x32,
  k_osmesa_profile = 0x33,
  k_osmesa_core_profile = 0x34,
  k_osmesa_major_version = 0x36,
  k_osmesa_minor_version = 0x37,
};

struct Osmesa {
  OsmesaContextHandle (*create_context)(const int* attributes, OsmesaContextHandle shared);
  void (*destroy_context)(OsmesaContextHandle);
  GLboolean (*make_current)(OsmesaContextHandle, void* buffer, GLenum type, GLsizei width, GLsizei height);
  void* (*proc_address)(const char* name);

  explicit Osmesa(const std::vector<std::string>& names) {
    const DynamicLibrary library(names);
    library.load(create_context, "OSMesaCreateContextAttribs");
    library.load(destroy_context, "OSMesaDestroyContext");
    library.load(make_current, "OSMesaMakeCurrent");
    library.load(proc_address, "OSMesaGetProcAddress");
  }
};

class OsmesaContext final : public Context {
 public:
  explicit OsmesaContext(const std::vector<std::string>& names) : osmesa_(names) {
    for (const auto& [major, minor] : {std::pair{4, 5}, std::pair{3, 3}}) {
      // Ends with a pair of zeros.
      const std::array<std::array<int, 2>, 8> attributes = {{{k_osmesa_format, GL_RGBA},
                                                             {k_osmesa_depth_bits, 0},
                                                             {k_osmesa_stencil_bits, 0},
                                                             {k_osmesa_accum_bits, 0},
                                                             {k_osmesa_profile, k_osmesa_core_profile},
                                                             {k_osmesa_major_version, major},
                                                             {k_osmesa_minor_version, minor}}};
      handle_ = osmesa_.create_context(attributes.front().data(), nullptr);
      if (handle_ != nullptr) break;
    }
    if (handle_ == nullptr) throw Error("OSMesaCreateContextAttribs gives no core context");
    try {
      initialise("OSMesa", osmesa_.proc_address);
    } catch (...) {
      osmesa_.destroy_context(handle_);
      throw;
    }
  }
  ~OsmesaContext() override {
    release_current();
    const SoftwareGlLock turn(draws_on_cpu());
    osmesa_.destroy_context(handle_);
  }

 private:
  void bind() override {
    // The library insists on a default framebuffer; nobody draws to it.
    if (osmesa_.make_current(handle_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == 0)
      throw Error("OSMesaMakeCurrent fails");
  }
  void unbind() noexcept override { osmesa_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

  Osmesa osmesa_;
  OsmesaContextHandle handle_ = nullptr;
  std::array<unsigned char, 4> pixel_ = {};
};

}  // namespace

std::unique_ptr<Context> create_osmesa_context(const std::vector<std::string>& libraries) {
  return std::make_unique<OsmesaContext>(libraries);
}

}  // namespace moldlight::gl
