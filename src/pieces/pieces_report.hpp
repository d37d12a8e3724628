// The report of molds of several pieces for programs, what is said first for people, and its files.
#pragma once

#include <string>

#include "classify/json.hpp"
#include "classify/part_model.hpp"
#include "pieces/find_pieces.hpp"

namespace moldlight {

/// "two-piece" (an opposite pair), "pieces" (any other number that releases all), "left-over".
[[nodiscard]] std::string pieces_state(const PiecesResult& result);
/// As direction_words(); "45° off z (towards +x)" where it lies between two axes at whole degrees.
[[nodiscard]] std::string pull_words(const glm::dvec3& direction);
/// One sentence or two, with full stops: how many pieces, and whether fewer are possible.
[[nodiscard]] std::string pieces_sentence(const PartModel& model, const PiecesResult& result);
/// "piece_1", in the order of removal.
[[nodiscard]] std::string piece_name(std::size_t direction);
/// Colour of a piece on the part: the first two are those of core and cavity.
[[nodiscard]] Colour piece_colour(std::size_t direction, Palette palette);

/// Schema `moldlight.pieces/1`. Lengths, areas and volumes are in the part's unit.
[[nodiscard]] Json pieces_json(const PartModel& model, const PiecesResult& result);

/// The part with each facet in the colour of the piece that forms it, by the extension (write_grouped_mesh).
void write_pieces_mesh(const std::string& path, const PartModel& model, const PiecesResult& result,
                       Palette palette);
/// The seams as polylines, by the extension (write_lines); an SVG sees them along the first direction.
void write_seams(const std::string& path, const PartModel& model, const PiecesResult& result);

}  // namespace moldlight
