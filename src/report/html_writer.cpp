#include "report/html_writer.hpp"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "io/atomic_file.hpp"
#include "page/html.hpp"
#include "page/page.hpp"
#include "report/html_blocks.hpp"

namespace moldlight::report {

using page::html_text;

namespace {

constexpr std::string_view tone_class(Tone tone) {
  constexpr std::array<std::string_view, 3> k_classes = {"good", "attention", "bad"};
  return k_classes[static_cast<std::size_t>(tone)];
}

std::string legend_html(const ModelView& view) {
  std::string html = "<ul class=\"legend\">\n";
  for (std::size_t k = 0; k < view.groups.size(); ++k) {
    const ViewGroup& group = view.groups[k];
    if (group.name.empty()) continue;
    html += fmt::format(
        "<li><label><input type=\"checkbox\" data-group=\"{}\"{} disabled>{}<span>{}</span> "
        "<i>{}</i></label></li>\n",
        k, group.hidden ? "" : " checked", mark_html({group.colour, group.hatched}), html_text(group.name),
        html_text(group.aside));
  }
  return html + "</ul>\n";
}

constexpr std::string_view k_controls = R"(<div class="controls" hidden>
<label>{opens}<input id="open" type="range" min="0" max="1" step="0.005" value="{opened}"></label>
<label>Transparency<input id="clear" type="range" min="0" max="0.9" step="0.01" value="0"></label>
<label>Section<span><select id="plane" aria-label="Section plane"><option value="">off</option>
<option value="d">across the direction</option><option value="x">across x</option><option value="y">across y</option>
<option value="z">across z</option></select><input id="cut" type="range" min="0" max="1" step="0.002" value="0.5"
aria-label="Place of the section" disabled></span></label>
<button id="home" type="button">Reset view</button>
</div>
)";

std::string controls_html(const ModelView& view) {
  std::string html(k_controls);
  const auto put = [&html](std::string_view name, const std::string& text) {
    html.replace(html.find(name), name.size(), text);
  };
  put("{opens}", html_text(view.opens));
  put("{opened}", fmt::format("{}", view.opened));
  return html;
}

/// The picture, over which the script puts what it draws.
std::string view_html(const Report& report) {
  std::string html =
      "<figure class=\"view\" id=\"view\">\n<div class=\"stage\">" + picture_html(report.still);
  if (report.view) {
    html +=
        "<canvas tabindex=\"0\" hidden aria-label=\"The part in three dimensions: drag or arrow keys turn "
        "it, "
        "the wheel zooms once it is clicked\"></canvas><div class=\"tags\" hidden></div>";
  }
  html += "</div>\n";
  if (report.view) html += legend_html(*report.view) + controls_html(*report.view);
  html += fmt::format("<figcaption>{}</figcaption>\n</figure>\n", html_text(report.still.caption));
  return html;
}

}  // namespace

std::string html_page(const Report& report) {
  const page::PageFrame frame{
      report.part + " · moldlight", "report.css", {"model.js", "view.js", "report.js"}};
  std::string html = page::page_begin(frame);
  html += fmt::format(
      "<main>\n<header>\n<p class=\"kind\">{}</p>\n<h1>{} <span>{}</span></h1>\n<p class=\"verdict "
      "{}\">{}</p>\n",
      html_text(report.kind), html_text(report.part), html_text(report.subject), tone_class(report.tone),
      html_text(report.sentence));
  if (!report.lead.empty()) html += fmt::format("<p class=\"lead\">{}</p>\n", html_text(report.paragraph()));
  html += "</header>\n" + view_html(report);
  for (const Section& section : report.sections) {
    html += fmt::format("<section>\n<h2>{}</h2>\n", html_text(section.title));
    for (const Block& block : section.blocks) html += block_html(block);
    html += "</section>\n";
  }
  html += "</main>\n";
  if (report.view) html += page::data_block("model", packed(*report.view));
  return html + page::page_end(frame);
}

void write_html(const std::string& path, const Report& report) { write_file(path, html_page(report)); }

}  // namespace moldlight::report
