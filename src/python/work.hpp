// Long work for a Python caller: on a thread of its own, without Python's lock, watched by the caller.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <pybind11/pybind11.h>

#include "base/progress.hpp"

namespace moldlight::python {

namespace py = pybind11;

/// Runs the work on another thread with Python's lock released, and returns when it has ended. Meanwhile the
/// calling thread calls `listener(stage, share)`, unless it is None, some times a second; if that returns
/// False, or raises, or Ctrl-C was pressed, the work is cancelled, and what was raised is thrown once the
/// work has ended. Throws what the work throws. The lock must be held.
void watch(const py::object& listener, const std::function<void(const Progress&)>& work);

/// The same for work that has a result.
template <typename Work>
auto watched(const py::object& listener, const Work& work) {
  std::optional<decltype(work(std::declval<const Progress&>()))> result;
  watch(listener, [&](const Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

/// Throws UsageError unless it is None or can be called.
void check_listener(const py::object& listener);

}  // namespace moldlight::python
