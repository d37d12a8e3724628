// Input of the choice of the least set: undercuts, whole or in parts, and the actions that may release them.
#pragma once

#include <numeric>
#include <optional>
#include <vector>

#include "actions/core_pin.hpp"
#include "actions/pins.hpp"
#include "actions/pull.hpp"

namespace moldlight {

/// An undercut, or a part of one that nothing releases whole, while actions are looked for.
struct UndercutPart {
  std::size_t undercut = 0;
  std::vector<UndercutSample> samples;
  std::vector<Pull> pulls = {};
  std::vector<Pull> rejected = {};  // lifters that cannot be built, the shortest first
  bool whole = true;
  const ActionPin* pin = nullptr;       // of its undercut
  bool covered = false;                 // by another body of the part: nothing releases it
  std::optional<CorePin> thin = {};     // the pin that would form it, thinner than pins may be
  std::optional<Pull> steep = {};       // a slide that would release it, but leans more than slides may
  std::optional<glm::dvec3> axis = {};  // of the hole that it is of, unit
  bool shallow = false;                 // clear within the least travel: it needs no action

  [[nodiscard]] bool allows(ActionKind kind) const {
    return !covered && !shallow && !thin && (pin == nullptr || pin->allows(kind));
  }
  /// False where it is to be left as it is.
  [[nodiscard]] bool wanted() const { return !covered && !shallow && !thin && (pin == nullptr || pin->kind); }
  /// The kind that alone may release it.
  [[nodiscard]] std::optional<ActionKind> only() const { return pin == nullptr ? std::nullopt : pin->kind; }

  /// The part's unit squared.
  [[nodiscard]] double area() const {
    return std::accumulate(samples.begin(), samples.end(), 0.0,
                           [](double sum, const UndercutSample& sample) { return sum + sample.area; });
  }
};

/// Atoms that one action may release.
struct ActionOption {
  Pull pull;
  std::vector<std::size_t> undercut_parts;
};

/// Samples of several of them in one list.
[[nodiscard]] inline std::vector<UndercutSample> samples_of(const std::vector<UndercutPart>& undercut_parts,
                                                            const std::vector<std::size_t>& which) {
  std::vector<UndercutSample> samples;
  for (const std::size_t k : which)
    samples.insert(samples.end(), undercut_parts[k].samples.begin(), undercut_parts[k].samples.end());
  return samples;
}

}  // namespace moldlight
