#include "python/pages.hpp"

#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace moldlight::python {

namespace {

std::span<const Option<LookSettings>> page_looks() { return picture_looks().first(1); }

const CallSettings k_html_settings("to_html", report::title_options(), page_looks());
const CallSettings k_pdf_settings("to_pdf", report::title_options(), report::paper_options(), page_looks());

}  // namespace

PageCall::PageCall(bool pdf, bool can_live, const py::kwargs& keywords) : pdf_(pdf) {
  Given given(pdf ? "to_pdf" : "to_html", keywords);
  given.take(report::title_options(), title_);
  if (pdf) given.take(report::paper_options(), paper_);
  LookSettings look;
  given.take(page_looks(), look);
  palette_ = look.palette;
  if (can_live && !pdf) live_ = given.take_switch("live");
  listener_ = given.take("progress");
  given.end();
}

report::ReportContext PageCall::context(std::shared_ptr<const PartModel> model, const Recall& recall,
                                        const gl::Context& gl, const Progress& progress) const {
  return {.model = std::move(model),
          .progress = progress,
          .gl = &gl,
          .palette = palette_,
          .live = live_,
          .version = MOLDLIGHT_VERSION,
          .command = recall.text,
          .title = title_};
}

std::string PageCall::text(const report::Report& report) const {
  return pdf_ ? report::pdf_document(report, paper_.paper) : report::html_page(report);
}

py::object put_page(const std::string& text, bool pdf, const py::object& file) {
  const auto bytes = [&] { return py::object(py::bytes(text)); };
  const auto content = [&] { return pdf ? bytes() : py::object(py::str(text)); };
  if (file.is_none()) return content();
  if (py::hasattr(file, "write")) {
    // Only what takes text has an encoding; temporary files are of no class that says so.
    file.attr("write")(py::hasattr(file, "encoding") ? content() : bytes());
  } else {
    write_file(path_of(file, "file"), text);
  }
  return py::none();
}

py::object reduced(const Recall& recall) {
  if (!recall.reduced)
    throw Error("work that was ended early cannot be found again, so it is not pickled; keep its to_dict()");
  return recall.reduced;
}

const char* page_doc(bool pdf, bool can_live) {
  static const std::string k_to =
      "\n\nfile: a name, or what has write(). Without it, the {} returned.\nprogress: as for Part().";
  const std::string live =
      can_live && !pdf ? "\nlive: the page finds the regions of any direction by itself, on the reader's "
                         "graphics card."
                       : "";
  const std::string text =
      (pdf ? "Makes the report on pages of paper, as --pdf does. Needs OpenGL, no display."
           : "Makes the report for any browser, as --html does. Needs OpenGL, no display.") +
      fmt::format(fmt::runtime(k_to), pdf ? "bytes are" : "page's text is") + live;
  return call_doc({.name = pdf ? "to_pdf" : "to_html",
                   .arguments = "self, file=None",
                   .more = can_live && !pdf ? "live=False, progress=None" : "progress=None",
                   .text = text,
                   .settings = pdf ? "to_pdf" : "to_html"});
}

Recall recalled(const char* call, const PythonPart& part, const py::tuple& arguments,
                const py::kwargs& keywords) {
  py::dict settings;
  for (const auto& [name, value] : keywords)
    if (std::string(py::str(name)) != "progress") settings[name] = value;
  std::string text;
  for (const py::handle& value : arguments) text += (text.empty() ? "" : ", ") + std::string(py::repr(value));
  for (const auto& [name, value] : settings)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", std::string(py::str(name)),
                        std::string(py::repr(value)));
  const auto again =
      py::module_::import("operator").attr("methodcaller")(call, *arguments, **py::kwargs(settings));
  return {py::make_tuple(again, py::make_tuple(PythonPart(part))), fmt::format("part.{}({})", call, text)};
}

}  // namespace moldlight::python
