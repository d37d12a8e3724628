// Handles of C libraries as values: given back once, where their owner ends.
#pragma once

#include <memory>

namespace moldlight {

template <auto k_free>
struct FreedBy {
  template <typename Handle>
  void operator()(Handle* handle) const {
    static_cast<void>(k_free(handle));
  }
};

/// What a library has made and takes back by this function.
template <typename Handle, auto k_free>
using Owned = std::unique_ptr<Handle, FreedBy<k_free>>;

}  // namespace moldlight
