// The bytes that moldlight hands to moldlight-step to have a part written with its faces split and named, and
// what comes back.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/step_result.hpp"

namespace moldlight {

/// File descriptor that moldlight-step finds its StepLabels at.
inline constexpr int k_step_labels_descriptor = 5;

/// A straight piece of a border between two labels on one CAD face.
struct StepBorder {
  std::array<double, 3> from{}, to{};              // mm; both in the facet
  std::array<std::uint32_t, 2> vertices{};         // equal numbers are one point
  std::uint32_t facet = 0;                         // of the StepResult
  std::uint32_t left = 0, right = 0, padding = 0;  // labels, left of the walk as seen from outside
  double contour = k_no_contour;                   // n . d where the surface itself has the border

  static constexpr double k_no_contour = 2.0;
  [[nodiscard]] bool on_contour() const { return contour < k_no_contour; }
};

/// A line beside the part, such as a loop of the parting line.
struct StepLine {
  std::string name;
  std::vector<std::array<double, 3>> points;  // mm; a closed one ends at its first point
};

/// A surface of plane faces beside the part, such as one between the halves of a mold.
struct StepSurface {
  using Point = std::array<double, 3>;
  struct Face {
    Point point{}, normal{};                // mm; unit
    std::vector<std::vector<Point>> loops;  // the outer one first, each with its first point once; a point
                                            // that faces share is equal to the bit
  };
  std::string name;
  std::vector<Face> faces;
  double tolerance = 0.0;  // mm, by which points may be beside the planes
};

struct StepLabels {
  static constexpr std::uint32_t k_none = ~0U;

  std::vector<std::string> names;          // of the labels
  std::vector<std::uint32_t> colours;      // of the labels, 0xRRGGBB
  std::vector<std::uint32_t> of_face;      // label of the most of each CAD face; k_none: it is left out
  std::vector<std::uint32_t> split_faces;  // with borders, rising
  std::vector<StepBorder> borders;         // on these
  double tolerance = 0.0;                  // mm, by which borders may be simplified
  std::array<double, 3> direction{};       // d of the contours; unit
  std::vector<StepLine> lines;
  std::vector<StepSurface> surfaces;

  [[nodiscard]] std::string to_bytes() const {
    ByteWriter out;
    out.number<std::uint64_t>(names.size());
    for (const std::string& name : names) out.text(name);
    out.array(colours);
    out.array(of_face);
    out.array(split_faces);
    out.array(borders);
    out.number(tolerance);
    out.array(std::vector{direction});
    out.number<std::uint64_t>(lines.size());
    for (const StepLine& line : lines) {
      out.text(line.name);
      out.array(line.points);
    }
    out.number<std::uint64_t>(surfaces.size());
    for (const StepSurface& surface : surfaces) {
      out.text(surface.name);
      out.number(surface.tolerance);
      out.number<std::uint64_t>(surface.faces.size());
      for (const StepSurface::Face& face : surface.faces) {
        out.array(std::vector{face.point, face.normal});
        out.number<std::uint64_t>(face.loops.size());
        for (const auto& loop : face.loops) out.array(loop);
      }
    }
    return out.bytes();
  }

  /// Throws std::out_of_range for bytes cut short.
  [[nodiscard]] static StepLabels from_bytes(std::string_view bytes) {
    ByteReader in(bytes);
    StepLabels labels;
    for (auto count = in.number<std::uint64_t>(); count > 0; --count) labels.names.push_back(in.text());
    labels.colours = in.array<std::uint32_t>();
    labels.of_face = in.array<std::uint32_t>();
    labels.split_faces = in.array<std::uint32_t>();
    labels.borders = in.array<StepBorder>();
    labels.tolerance = in.number<double>();
    labels.direction = in.array<std::array<double, 3>>().at(0);
    for (auto count = in.number<std::uint64_t>(); count > 0; --count) {
      std::string name = in.text();
      labels.lines.push_back({std::move(name), in.array<std::array<double, 3>>()});
    }
    for (auto count = in.number<std::uint64_t>(); count > 0; --count) {
      StepSurface& surface = labels.surfaces.emplace_back();
      surface.name = in.text();
      surface.tolerance = in.number<double>();
      for (auto faces = in.number<std::uint64_t>(); faces > 0; --faces) {
        StepSurface::Face& face = surface.faces.emplace_back();
        const auto plane = in.array<StepSurface::Point>();
        face.point = plane.at(0);
        face.normal = plane.at(1);
        for (auto loops = in.number<std::uint64_t>(); loops > 0; --loops)
          face.loops.push_back(in.array<StepSurface::Point>());
      }
    }
    return labels;
  }
};

struct StepWritten {
  std::string error;                        // one sentence; the rest is empty then
  std::vector<std::uint32_t> failed_faces;  // could not be split, rising
  std::vector<double> areas;                // mm², of the exact faces of each label
  std::string file;

  [[nodiscard]] std::string to_bytes() const {
    ByteWriter out;
    out.text(error);
    out.array(failed_faces);
    out.array(areas);
    out.text(file);
    return out.bytes();
  }

  /// Throws std::out_of_range for bytes cut short.
  [[nodiscard]] static StepWritten from_bytes(std::string_view bytes) {
    ByteReader in(bytes);
    StepWritten written;
    written.error = in.text();
    written.failed_faces = in.array<std::uint32_t>();
    written.areas = in.array<double>();
    written.file = in.text();
    return written;
  }
};

}  // namespace moldlight
