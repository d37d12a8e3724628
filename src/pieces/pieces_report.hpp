// The report of molds of several pieces for programs, what is said first for people, and its files.
#pragma once

#include <string>

#include "classify/json.hpp"
#include "classify/part_model.hpp"
#include "classify/still_picture.hpp"
#include "pieces/find_pieces.hpp"
#include "pieces/piece_solids.hpp"
#include "pieces/piece_words.hpp"

namespace moldlight {

/// "two-piece" (an opposite pair), "pieces" (any other number that releases all), "left-over", or, of a
/// flexible mold, "stretched".
[[nodiscard]] std::string pieces_state(const PiecesResult& result);
/// One sentence or two, with full stops: how many pieces, and whether fewer are possible.
[[nodiscard]] std::string pieces_sentence(const PartModel& model, const PiecesResult& result);
/// Colour of a piece on the part: the first two are those of core and cavity.
[[nodiscard]] Colour piece_colour(std::size_t direction, Palette palette);

/// "no pieces are written: …, near 1, 2, 3"; empty where there are solids.
[[nodiscard]] std::string solids_refusal(const PartModel& model, const PieceSolids& solids);

/// Schema `moldlight.pieces/1`; `solids` null where they were not asked for. Lengths, areas and volumes are
/// in the part's unit.
[[nodiscard]] Json pieces_json(const PartModel& model, const PiecesResult& result,
                               const PieceSolids* solids = nullptr, const MoldSettings& mold = {});

/// The part in the colours of core, cavity and undercut: what the first two directions and the others form.
[[nodiscard]] Classification formed_part(const PartModel& model, const PiecesResult& result);
/// By how much a solid moves until it is beside the part, in the part's coordinates.
[[nodiscard]] glm::dvec3 pulled_by(const PartModel& model, const PieceSolids& solids, std::size_t body);
/// The solids there, without the shrinkage; none where there are none.
[[nodiscard]] std::vector<StillBody> pulled_pieces(const PartModel& model, const PieceSolids& solids,
                                                   Palette palette);

/// The part with each facet in the colour of the piece that forms it, by the extension (write_grouped_mesh).
void write_pieces_mesh(const std::string& path, const PartModel& model, const PiecesResult& result,
                       Palette palette);
/// The seams as polylines, by the extension (write_lines); an SVG sees them along the first direction.
void write_seams(const std::string& path, const PartModel& model, const PiecesResult& result);

}  // namespace moldlight
