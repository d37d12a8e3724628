// The sweep along the bottom: its options, how far it is, and the best directions as a table to sort and
// click.
#pragma once

#include <span>

#include "gui/panels/panels.hpp"
#include "gui/panels/sweep_columns.hpp"

namespace moldlight::gui {

/// Size of a candidate's small picture, pixels; `scale`: pixels per layout unit.
[[nodiscard]] glm::ivec2 candidate_picture_size(float scale);

class SweepPanel {
 public:
  /// `pictures`: a texture a candidate of the result; 0, or too few of them, where there is none yet.
  void draw(const PanelContext& context, std::span<const unsigned> pictures);

 private:
  void draw_header(const PanelContext& context, bool open);
  void draw_table(const PanelContext& context, std::span<const unsigned> pictures);
  void draw_row(const PanelContext& context, std::size_t index, unsigned picture);
  void draw_footer(const PanelContext& context, std::size_t shown);

  SweepOrder order_;
  std::size_t first_ = 0;  // row on top
  bool options_ = false, expanded_ = false;
};

}  // namespace moldlight::gui
