// Keeps the legend's figures and the split mesh up with the settings: measures on a thread of its own, by the
// classifier that every other output uses, so that its figures are theirs to the bit.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "base/job.hpp"
#include "gl/context.hpp"
#include "gui/app_state.hpp"

namespace moldlight::gui {

/// Figures by exact regions follow settings that move; the split mesh with its samples, and figures by
/// another readout, come once they rest.
class Measurer {
 public:
  /// Makes a context without a window and makes it current on the calling thread (the measurer's).
  using MakeContext = std::function<std::unique_ptr<gl::Context>(Backend)>;

  /// `wake` is called from the measurer's thread when there is something new.
  Measurer(MakeContext make_context, std::function<void()> wake);

  /// Call it every frame. `moving`: a hand is at settings whose split mesh is not wanted yet, or a flight.
  void update(const AppState& state, Figures& figures, double now_s, bool moving);
  /// Gives up what runs.
  void cancel() { job_.give_up(); }
  /// When update() wants to be called next without any input; infinity for not at all.
  [[nodiscard]] double wake_s() const { return wake_s_; }

 private:
  struct Request {
    std::shared_ptr<const PartModel> model;
    Query query;
    bool with_split = false;

    /// Whether its outcome is that of the other one too.
    [[nodiscard]] bool covers(const Request& other) const {
      return model == other.model && query == other.query && (with_split || !other.with_split);
    }
  };
  struct Outcome {
    Request request;
    Classification classification;
    std::optional<UndercutTotals> undercuts = {};      // of the split mesh
    std::shared_ptr<const PieceSamples> samples = {};  // with a split mesh
  };
  class Worker;
  void take(Outcome outcome, Figures& figures);

  Worker* worker_;  // lives on the job's thread
  Job<Outcome> job_;
  Request wanted_;  // of the settings that were seen last
  std::optional<Request> requested_;
  ExactQuery split_of_;  // for which there is a split mesh
  double changed_s_ = 0.0, fresh_s_ = 0.0, wake_s_ = 0.0;
};

}  // namespace moldlight::gui
