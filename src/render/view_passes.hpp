// The passes of a picture, each a function of the sample; part_view.cpp puts them together.
#pragma once

#include "render/view_frame.hpp"
#include "render/view_tools.hpp"

namespace moldlight {

// surface_passes.cpp: what is seen of the part.
/// Facet, normal and depth of each visible fragment.
void draw_surface(ViewTools& tools, const ViewFrame& frame);
/// How much of the sky each sees, by so many taps; all of it for none.
void draw_openness(ViewTools& tools, const ViewFrame& frame, int taps);

// shading_passes.cpp: its colours.
/// True if the shading wants more than regions, light and hatches.
[[nodiscard]] bool needs_detail(const ViewSettings& settings);
void draw_background(ViewTools& tools, const ViewFrame& frame);
/// The backdrop alone, as it lies behind a part: for a window without one.
void draw_backdrop(gl::Tools& tools, const ViewTarget& target, Theme theme);
/// A shadow map as a picture: near facets light, far ones dark, alpha 0 where there is none; for thumbnails.
void draw_map(gl::Tools& tools, const ViewTarget& target, const ShadowMaps& maps, bool plus);
/// Accessibility bits and colour of each fragment. A subject with neither maps nor a split surface is plain.
void shade(ViewTools& tools, const ViewFrame& frame);

// line_passes.cpp: what is drawn over it.
void draw_lines(ViewTools& tools, const ViewFrame& frame);
/// The edges of a mold's steel.
void draw_steel_edges(ViewTools& tools, const ViewFrame& frame);
void draw_arrows(ViewTools& tools, const ViewFrame& frame);
/// The mold's parting line over the finished picture, round as a tube, faint where surface hides it.
void draw_tube(ViewTools& tools, const ViewFrame& frame, GLuint framebuffer);
/// Over the finished picture; surface that hides them makes them paler.
void draw_marked_lines(ViewTools& tools, const ViewFrame& frame, GLuint framebuffer);

// finishing_passes.cpp: from samples to the picture.
/// Adds the finished sample to the sum.
void accumulate(ViewTools& tools, bool first);
/// Puts the picture of `samples` samples into `framebuffer`; a single one comes straight from the colours.
void present(ViewTools& tools, int samples, GLuint framebuffer);
/// Over the finished picture, the surface that is marked.
void draw_marks(ViewTools& tools, const ViewMarks& marks, GLuint framebuffer);
/// And surface that is marked, where other surface hides it; not in an opened mold, whose pieces are
/// elsewhere. Body k stands where `motions[k]` (unit frame) moves it from where it was made; those without
/// one are not drawn.
void draw_bodies(ViewTools& tools, const ViewFrame& frame, std::span<const glm::dmat4> motions,
                 GLuint framebuffer);
void draw_veil(ViewTools& tools, const ViewFrame& frame, GLuint framebuffer);

}  // namespace moldlight
