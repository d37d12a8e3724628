// to_html() and to_pdf() of a result, and the call that found it, by which it is pickled.
#pragma once

#include <memory>
#include <string>

#include "classify/headless.hpp"
#include "python/bindings.hpp"
#include "report/page_options.hpp"

namespace moldlight::python {

/// What a call for a page asks for.
class PageCall {
 public:
  PageCall(bool pdf, bool can_live, const py::kwargs& keywords);

  [[nodiscard]] const py::object& listener() const { return listener_; }
  /// Of the result with a script's line that finds it; `progress` and `gl` outlive it.
  [[nodiscard]] report::ReportContext context(std::shared_ptr<const PartModel> model, const Recall& recall,
                                              const gl::Context& gl, const Progress& progress) const;
  [[nodiscard]] std::string text(const report::Report& report) const;

 private:
  bool pdf_, live_ = false;
  Palette palette_ = Palette::paper;
  report::TitleFacts title_ = report::usual_title();
  report::PaperSettings paper_;
  py::object listener_;
};

/// Text or bytes where `file` is None; else they go into this file, named or open, and None comes back.
[[nodiscard]] py::object put_page(const std::string& text, bool pdf, const py::object& file);
/// What pickle keeps; throws Error where the call would not find the same again.
[[nodiscard]] py::object reduced(const Recall& recall);
[[nodiscard]] const char* page_doc(bool pdf, bool can_live);

/// Adds to_html() and to_pdf(), as --html and --pdf make them. `can_live`: the page may find the regions of
/// any direction.
template <typename Bound>
void add_pages(Bound& bound, bool can_live = false) {
  using Type = typename Bound::type;
  for (const bool pdf : {false, true}) {
    bound.def(
        pdf ? "to_pdf" : "to_html",
        [pdf, can_live](const Type& self, const py::object& file, const py::kwargs& keywords) {
          const PageCall call(pdf, can_live, keywords);
          const std::string text = watched(call.listener(), [&](const Progress& progress) {
            const auto gl = create_context(self.backend());
            return call.text(self.report(call.context(self.shared_model(), self.recall, *gl, progress)));
          });
          return put_page(text, pdf, file);
        },
        py::arg("file") = py::none(), page_doc(pdf, can_live));
  }
}

/// Adds to_json() and to_dict() as add_report() does, pickling and copying.
template <typename Bound>
void add_result(Bound& bound, const std::string& command) {
  using Type = typename Bound::type;
  add_report(bound, "The report", command);
  bound.def("__reduce__", [](const Type& self) { return reduced(self.recall); })
      .def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::object&) { return self; });
}

}  // namespace moldlight::python
