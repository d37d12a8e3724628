// Writing what was measured, on a thread of its own.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "session/classification.hpp"
#include "session/part_model.hpp"
#include "session/write_outputs.hpp"

namespace moldlight::gui {

class ExportJob {
 public:
  /// Starts at once. `wake` is called when it is done.
  ExportJob(OutputPaths files, Palette palette, std::shared_ptr<const PartModel> model, Classification result,
            std::function<void()> wake);
  ~ExportJob();
  ExportJob(const ExportJob&) = delete;
  ExportJob& operator=(const ExportJob&) = delete;

  [[nodiscard]] bool done() const { return done_.load(std::memory_order_acquire); }
  /// Once done: why it failed; empty if all was written.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  void run();

  const OutputPaths files_;
  const Palette palette_;
  const std::shared_ptr<const PartModel> model_;
  const Classification result_;
  const std::function<void()> wake_;
  std::string error_;
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

}  // namespace moldlight::gui
