#include "base/progress.hpp"

#include "base/error.hpp"

namespace moldlight {

void Progress::report(std::string_view stage, double fraction) const {
  if (cancelled()) throw Cancelled();
  if (listener_) listener_(stage, fraction);
}

}  // namespace moldlight
