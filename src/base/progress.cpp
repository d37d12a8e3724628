#include "base/progress.hpp"

#include "base/error.hpp"

namespace moldlight {

void Progress::report(std::string_view stage, double fraction) const {
  if (cancelled()) throw Cancelled();
  if (listener_) listener_(stage, fraction);
}

Progress silent(const Progress& parent) {
  return Progress([&parent](std::string_view, double) {
    if (parent.cancelled()) throw Cancelled();
  });
}

}  // namespace moldlight
