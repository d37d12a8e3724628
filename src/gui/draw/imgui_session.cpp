#include "gui/draw/imgui_session.hpp"

#include <backends/imgui_impl_opengl3.h>

#include "base/error.hpp"
#include "gl/software_gl_lock.hpp"

namespace moldlight::gui {

ImguiSession::ImguiSession() : context_(ImGui::CreateContext()) {
  IMGUI_CHECKVERSION();
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.UserData = &memory_;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would draw twice a second
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  const gl::SoftwareGlLock turn(true);
  if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
    ImGui::DestroyContext(context_);
    throw Error("the OpenGL driver cannot draw the window's panels");
  }
  ui_.memory = &memory_;
}

ImguiSession::~ImguiSession() {
  ImGui::SetCurrentContext(context_);
  const gl::SoftwareGlLock turn(true);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void ImguiSession::prepare(Theme theme, float scale) {
  const gl::SoftwareGlLock turn(true);
  ImGui::SetCurrentContext(context_);
  const bool new_scale = ui_.fonts.body.font == nullptr || scale != ui_.scale;
  if (new_scale) {
    // Only the fonts' texture: the renderer's program may be the one in use, and goes with the other objects.
    const bool again = ui_.fonts.body.font != nullptr;
    if (again) ImGui_ImplOpenGL3_DestroyFontsTexture();
    ui_.fonts = load_fonts(*ImGui::GetIO().Fonts, scale, font_bytes_);
    if (again) ImGui_ImplOpenGL3_CreateFontsTexture();
    ImGui::GetIO().FontDefault = ui_.fonts.body.font;
    ui_.scale = scale;
  }
  if (new_scale || theme_ != theme) apply_style(theme, scale);
  theme_ = theme;
  ui_.colours = &theme_colours(theme);
  ImGui_ImplOpenGL3_NewFrame();
}

const Ui& ImguiSession::begin_frame(double now_s, ControlKey key) {
  memory_.wake_s = std::numeric_limits<double>::infinity();
  memory_.controls.clear();
  memory_.texts.clear();
  ui_.now_s = now_s;
  ImGui::NewFrame();
  // A text into which is typed would go on taking letters.
  const bool leaves = key == ControlKey::next || key == ControlKey::former;
  if (leaves && ImGui::GetIO().WantTextInput && memory_.typing_id == 0) ImGui::SetWindowFocus(nullptr);
  memory_.keyboard.begin_frame(key, ImGui::IsMouseClicked(0) && memory_.typing_id == 0);
  memory_.popups.begin_frame();
  memory_.scrim_clicked = false;
  if (!memory_.keyboard.focused()) memory_.focused.clear();
  return ui_;
}

void ImguiSession::draw() {
  ImGui::Render();
  const gl::SoftwareGlLock turn(true);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace moldlight::gui
