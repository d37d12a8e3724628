#include "gui/jobs/export_job.hpp"

#include <exception>
#include <utility>

namespace moldlight::gui {

ExportJob::ExportJob(OutputPaths files, Palette palette, std::shared_ptr<const PartModel> model,
                     Classification result, std::function<void()> wake)
    : files_(std::move(files)),
      palette_(palette),
      model_(std::move(model)),
      result_(std::move(result)),
      wake_(std::move(wake)),
      thread_([this] { run(); }) {}

ExportJob::~ExportJob() { thread_.join(); }

void ExportJob::run() {
  try {
    write_outputs(files_, *model_, result_, palette_);
  } catch (const std::exception& error) {
    error_ = error.what();
  }
  done_.store(true, std::memory_order_release);
  wake_();
}

}  // namespace moldlight::gui
