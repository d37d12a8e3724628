// Measures regions on a thread of its own, with a GL context of its own and the classifier that every other
// output uses, so that its figures are theirs to the bit.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "gl/context.hpp"
#include "gui/jobs/load_job.hpp"
#include "session/classification.hpp"
#include "session/part_model.hpp"

namespace moldlight::gui {

class Measurer {
 public:
  /// Makes a context without a window and makes it current on the calling thread (the measurer's).
  using MakeContext = std::function<std::unique_ptr<gl::Context>(Backend)>;

  struct Outcome {
    std::shared_ptr<const PartModel> model;
    MethodSettings settings;
    std::optional<Classification> classification;
    std::string error;  // one line, where there is no classification
  };

  /// `wake` is called from the measurer's thread when an outcome is there.
  Measurer(MakeContext make_context, std::function<void()> wake);
  ~Measurer();
  Measurer(const Measurer&) = delete;
  Measurer& operator=(const Measurer&) = delete;

  /// Asks for this measurement next; what runs or waits is given up.
  void request(std::shared_ptr<const PartModel> model, const MethodSettings& settings);
  /// Gives up what runs or waits.
  void cancel();
  [[nodiscard]] bool busy() const;
  [[nodiscard]] JobStatus status() const;
  /// The outcome of the latest request, once, if it is there.
  [[nodiscard]] std::optional<Outcome> take();

 private:
  struct Request {
    std::shared_ptr<const PartModel> model;
    MethodSettings settings;
  };
  class Worker;
  void run();

  const MakeContext make_context_;
  const std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Request> waiting_;
  std::shared_ptr<Progress> running_;
  std::optional<Outcome> outcome_;
  JobStatus status_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace moldlight::gui
