// The draft along the bottom, while the surface is coloured by it: how much surface has how much of it, and
// the walls that have too little, with what turning them would cost.
#pragma once

#include <memory>
#include <optional>

#include "gui/panels/table_bar.hpp"

namespace moldlight::gui {

class DraftPanel {
 public:
  void draw(const PanelContext& context);

 private:
  [[nodiscard]] BarNews news(const AppState& state) const;
  void draw_walls(const PanelContext& context, RowCursor& cursor) const;
  void draw_row(const PanelContext& context, std::size_t wall, bool marked) const;

  [[nodiscard]] const DraftCheck* check() const;

  // The last one of the part; kept, so that the chart stays while its limit is dragged.
  std::shared_ptr<const MoldLine> line_;
  std::shared_ptr<const PartModel> model_;
  TableBar bar_;
};

/// The chart's, as it is drawn: from which to which draft, and the areas' ends in it.
struct DraftChart {
  static constexpr double k_from_deg = -5.0, k_to_deg = 10.0;
  ScreenBox box;

  /// Pixels from the window's left.
  [[nodiscard]] float place_of(double draft_deg) const;
  /// The draft at a place, within the chart.
  [[nodiscard]] double draft_at(float x) const;
};

/// What is said of a face with too little draft; none where it has enough, or while that is not known.
/// `side`: the half that forms it, where that matters.
[[nodiscard]] const WallDraft* wall_of_face(const AppState& state, std::uint32_t face,
                                            std::optional<MoldSide> side = {});

/// The foot line of the wall under the cursor or chosen, in the scene.
void draw_foot_line(const PanelContext& context);

}  // namespace moldlight::gui
