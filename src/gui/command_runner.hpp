// Carries out what panels and keys asked for.
#pragma once

#include "gui/app.hpp"

namespace moldlight::gui {

/// One overload a command, for std::visit.
struct App::CommandRunner {
  App& app;

  void operator()(const OpenPart& command) const;
  void operator()(const CancelLoading&) const;
  void operator()(const Undo&) const;
  void operator()(const Redo&) const;
  void operator()(const FitView&) const;
  void operator()(const LookFrom& command) const;
  void operator()(const LookAlongDirection&) const;
  void operator()(const ToggleProjection&) const;
  void operator()(const TakeNormal&) const;
  void operator()(const TakeAxis&) const;
  void operator()(const TakePicture&) const;
  void operator()(const SaveNotesBeside& command) const;
  void operator()(const ResetLayout&) const;
  void operator()(const DismissToasts&) const;
  void operator()(const Say& command) const;
  void operator()(const Export& command) const;
  void operator()(const StartSweep&) const;
  void operator()(const CancelSweep&) const;
  void operator()(const FlyToDirection& command) const;
  void operator()(const ChooseFace& command) const;
  void operator()(const Quit&) const;
};

}  // namespace moldlight::gui
