#include "gui/panels/workspace.hpp"

namespace moldlight::gui {

void Workspace::draw(const PanelContext& context, const Textures& textures) {
  const Dialogs& dialogs = context.state.dialogs;
  if (!dialogs.panels_hidden) {
    draw_top_bar(context);
    if (context.state.model) {
      draw_direction_panel(context, ball_);
      draw_part_panel(context);
      draw_maps_panel(context, textures.maps);
      draw_regions_panel(context);
      draw_look_panel(context);
      sweep_.draw(context, textures.candidates);
      draw_actions_bar(context, actions_);
      draw_mold_bar(context, mold_);
      draft_.draw(context);
      draw_revisions_bar(context, revisions_);
      draw_large_ball(context, large_ball_);
      draw_comparison(context);
    }
  }
  if (context.state.model) {
    draw_view_cube(context);
    draw_chosen_face(context);
    draw_measuring(context);
    draw_foot_line(context);
    draw_cursor_readout(context);
  }
  draw_start_page(context, textures.shipped_parts);
  draw_loading(context);
  draw_large_map(context, textures.maps);
  batch_.draw(context, textures.batch);
  browser_.draw(context);
  draw_dropped(context);
  export_.draw(context);
  mold_export_.draw(context);
  picture_.draw(context);
  draw_settings(context);
  help_.draw(context);
  draw_toasts(context);
}

}  // namespace moldlight::gui
