// A batch's parts as a table over the window: filtered by typing, sorted by a click on a heading; a click on
// a row opens the part with its settings.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "gui/jobs/batch_table.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

/// The texture of a part's picture; 0 where there is none yet.
using BatchPicture = std::function<unsigned(const Digest&)>;

class BatchPanel {
 public:
  /// Draws the dialog while it is open.
  void draw(const PanelContext& context, const BatchPicture& picture);

 private:
  void draw_headings(const PanelContext& context);
  void draw_rows(const PanelContext& context, const BatchPicture& picture);
  void draw_row(const PanelContext& context, std::size_t index, const BatchPicture& picture);
  [[nodiscard]] float right_of(const Ui& ui, std::size_t column, float width) const;

  std::shared_ptr<const BatchTable> table_;  // of the rows; kept, so that no later one has its address
  BatchOrder order_;
  std::vector<BatchColumn> columns_;
  std::vector<std::size_t> rows_;  // in the order of the table
  std::array<char, 128> filter_{};
  int selected_ = -1;  // by the keyboard; its place among rows_
  bool pictures_ = false, open_ = false;
};

}  // namespace moldlight::gui
