// Which action forms which piece of the split mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "actions/chosen_action.hpp"

namespace moldlight {

/// Pieces of an undercut that was split go with the undercut part that has the nearest sample, but rather
/// with an action that frees their middles and corners, if there is one.
class PieceActions {
 public:
  /// References must outlive it.
  PieceActions(const ChosenContext& context, const std::vector<UndercutPart>& undercut_parts);

  /// For every piece of the split mesh an action, or k_no_action_of_piece or k_unreleased_piece; `of_atom`
  /// has such a number for each undercut part.
  [[nodiscard]] std::vector<std::int32_t> of(std::span<const std::int32_t> of_atom,
                                             const std::vector<SideAction>& actions);

 private:
  const ChosenContext& context_;
  std::vector<std::vector<std::size_t>> parts_;  // of each undercut
  std::vector<std::size_t> nearest_;             // by piece, where an undercut has several parts
  /// Of divisions that were found: for each piece of an undercut the part that it goes with.
  std::map<std::vector<double>, std::vector<std::size_t>> known_;
};

}  // namespace moldlight
