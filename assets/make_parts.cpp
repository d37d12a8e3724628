// Writes the demo parts into their folders below another: make_parts ASSETS. The same parts to the bit in
// every run with the same modeller.
#include <exception>
#include <filesystem>
#include <iostream>

#include <Standard_Failure.hxx>

#include "demo_parts.hpp"
#include "tessellation.hpp"

namespace {

struct DemoPart {
  const char* name;
  TopoDS_Shape (*make)();
  moldlight::demo::Tessellation tessellation;
};

constexpr DemoPart k_parts[] = {{"parts/enclosure_lid", moldlight::demo::enclosure_lid, {0.03, 15.0}},
                                {"revisions/enclosure_lid_b", moldlight::demo::enclosure_lid_b, {0.03, 15.0}},
                                {"parts/bottle_cap", moldlight::demo::bottle_cap, {0.03, 13.0}},
                                {"parts/cable_clip", moldlight::demo::cable_clip, {0.02, 7.5}},
                                {"parts/tilted_bracket", moldlight::demo::tilted_bracket, {0.02, 12.0}}};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_parts ASSETS\n";
    return 2;
  }
  try {
    for (const DemoPart& part : k_parts) {
      const auto path = std::filesystem::path(argv[1]) / (std::string(part.name) + ".stl");
      const moldlight::TriangleMesh mesh = moldlight::demo::tessellated(part.make(), part.tessellation);
      moldlight::demo::write_stl(path.string(), mesh);
      std::cout << path.string() << ": " << mesh.facets.size() << " facets\n";
    }
  } catch (const Standard_Failure& failure) {
    std::cerr << "make_parts: " << failure.GetMessageString() << '\n';
    return 1;
  } catch (const std::exception& error) {
    std::cerr << "make_parts: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
