#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "page/page.hpp"
#include "report/writers.hpp"

namespace moldlight::report {

using page::html_text;

namespace {

std::string colour_text(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

/// Stripes over a box of a drawing.
std::string stripes(double x, double y, double width, double height) {
  constexpr double k_pitch = 5.0;
  std::string path;
  for (double at = k_pitch; at < width + height; at += k_pitch) {
    const double x0 = std::min(at, width), y0 = at - x0, y1 = std::min(at, height), x1 = at - y1;
    path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", x + x0, y + y0, x + x1, y + y1);
  }
  return fmt::format("<path d=\"{}\" stroke=\"#fff\" stroke-opacity=\".55\" stroke-width=\"1.3\"/>", path);
}

std::string box_html(double x, double y, double width, double height, const Mark& mark) {
  if (width <= 0.0 || height <= 0.0) return {};
  return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>", x, y,
                     width, height, colour_text(mark.colour)) +
         (mark.hatched ? stripes(x, y, width, height) : "");
}

std::string mark_html(const Mark& mark) {
  return "<svg class=\"mark\" viewBox=\"0 0 14 14\" aria-hidden=\"true\">" + box_html(0, 0, 14, 14, mark) +
         "</svg>";
}

std::string picture_html(const Picture& picture) {
  const std::string light =
      fmt::format("<img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\">", page::picture_url(picture.light),
                  html_text(picture.text), picture.light.width, picture.light.height);
  if (picture.dark.rgba.empty()) return light;
  return fmt::format(
      "<picture><source srcset=\"{}\" media=\"screen and (prefers-color-scheme: dark)\">{}</picture>",
      page::picture_url(picture.dark), light);
}

std::string value_html(const Value& value) {
  if (value.key.empty()) return html_text(value.text);
  return fmt::format("<data data-key=\"{}\" value=\"{}\">{}</data>", html_text(value.key), value.number,
                     html_text(value.text));
}

std::string to_html(const FigureGrid& grid) {
  std::string html = "<dl class=\"figures\">\n";
  for (const Figure& figure : grid.figures) {
    html += fmt::format("<div><dt>{}</dt><dd><b>{}</b>{}{}", html_text(figure.name), value_html(figure.value),
                        figure.unit.empty() ? "" : " <span>" + html_text(figure.unit) + "</span>",
                        figure.error.empty() ? "" : " <i>± " + html_text(figure.error) + "</i>");
    if (!figure.note.empty()) html += fmt::format("<small>{}</small>", html_text(figure.note));
    html += "</dd></div>\n";
  }
  return html + "</dl>\n";
}

std::string to_html(const ShareBar& bar) {
  constexpr double k_width = 1000.0, k_height = 18.0;
  std::string html, text;
  double at = 0.0;
  for (const ShareBar::Share& share : bar.shares) {
    html += box_html(at, 0.0, share.share * k_width, k_height, share.mark);
    at += share.share * k_width;
    text += fmt::format("{}{} {:.1f} %", text.empty() ? "" : ", ", share.name, 100.0 * share.share);
  }
  return fmt::format(
      "<svg class=\"shares\" viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\" role=\"img\" "
      "aria-label=\"{}\">{}</svg>\n",
      k_width, k_height, html_text(text), html);
}

std::string cell_html(const TableColumn& column, const Row& row, std::size_t k, const char* tag) {
  const std::string mark = k == 0 && row.mark ? mark_html(*row.mark) : "";
  return fmt::format("<{0}{1}>{2}{3}</{0}>", tag, column.text ? " class=\"text\"" : "", mark,
                     value_html(row.cells[k]));
}

std::string to_html(const Table& table) {
  const bool pictured =
      std::ranges::any_of(table.rows, [](const Row& row) { return !row.picture.rgba.empty(); });
  std::string html = "<div class=\"wide\"><table><thead><tr>";
  if (pictured) html += "<th></th>";
  for (const TableColumn& column : table.columns)
    html += fmt::format("<th{}>{}</th>", column.text ? " class=\"text\"" : "", html_text(column.heading));
  html += "</tr></thead><tbody>\n";
  for (const Row& row : table.rows) {
    html += "<tr>";
    if (pictured && row.picture.rgba.empty()) html += "<td></td>";
    if (!row.picture.rgba.empty()) {
      html += fmt::format("<td class=\"text\"><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\"></td>",
                          page::picture_url(row.picture), html_text(row.picture_text), row.picture.width / 2,
                          row.picture.height / 2);
    }
    for (std::size_t k = 0; k < row.cells.size(); ++k) html += cell_html(table.columns[k], row, k, "td");
    html += "</tr>\n";
  }
  html += "</tbody></table></div>\n";
  for (const std::string& below : {table.rest, table.tiny})
    if (!below.empty()) html += fmt::format("<p class=\"quiet\">{}</p>\n", html_text(below));
  return html;
}

std::string to_html(const Pictures& pictures) {
  std::string html = "<div class=\"pictures\">\n";
  for (const Picture& picture : pictures.pictures) {
    html += fmt::format("<figure>{}", picture_html(picture));
    if (!picture.caption.empty())
      html += fmt::format("<figcaption>{}</figcaption>", html_text(picture.caption));
    html += "</figure>\n";
  }
  return html + "</div>\n";
}

std::string to_html(const DraftBars& bars) {
  constexpr double k_width = 720.0, k_top = 12.0, k_foot = 152.0, k_height = 178.0, k_side = 12.0;
  if (bars.bars.empty()) return {};
  const double from = bars.bars.front().from_deg, to = bars.bars.back().to_deg;
  const auto place = [&](double deg) {
    return k_side + (deg - from) / (to - from) * (k_width - 2.0 * k_side);
  };
  double tallest = 0.0;
  for (const DraftBars::Bar& bar : bars.bars) tallest = std::max(tallest, bar.core + bar.cavity);
  std::string html = fmt::format(
      "<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Area by draft angle\">\n",
      k_width, k_height);
  for (const DraftBars::Bar& bar : bars.bars) {
    if (tallest <= 0.0) break;
    double foot = k_foot;
    const double left = place(bar.from_deg) + 0.75, width = place(bar.to_deg) - left - 0.75;
    for (const auto& [area, mark] : {std::pair(bar.core, bars.core), std::pair(bar.cavity, bars.cavity)}) {
      const double height = (k_foot - k_top) * area / tallest;
      foot -= height;
      html += box_html(left, foot, width, height, mark);
    }
    html += fmt::format(
        "<rect class=\"hover\" x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"{}\"><title>{:g} to {:g}°: "
        "core {:.4g}, cavity {:.4g} {}</title></rect>\n",
        left, k_top, width, k_foot - k_top, bar.from_deg, bar.to_deg, bar.core, bar.cavity,
        html_text(bars.unit));
  }
  html += fmt::format("<path class=\"axis\" d=\"M{} {}H{}\"/>", k_side, k_foot, k_width - k_side);
  if (bars.required_deg && *bars.required_deg >= from && *bars.required_deg <= to)
    html += fmt::format(
        "<path class=\"limit\" d=\"M{0:.2f} {1}V{2}\"/><text x=\"{3:.2f}\" y=\"{4}\">{5:g}° asked for</text>",
        place(*bars.required_deg), k_top - 6.0, k_foot, place(*bars.required_deg) + 6.0, k_top + 4.0,
        *bars.required_deg);
  for (double deg = std::ceil(from / 5.0) * 5.0; deg <= to; deg += 5.0)
    html += fmt::format("<text class=\"tick\" x=\"{:.2f}\" y=\"{}\">{:g}°</text>", place(deg), k_foot + 18.0,
                        deg);
  return html + "</svg>\n";
}

std::string to_html(const Text& text) {
  constexpr std::string_view k_classes[] = {"", "quiet", "notice", "command"};
  const std::string_view name = k_classes[static_cast<std::size_t>(text.look)];
  const char* tag = text.look == TextLook::command ? "pre" : "p";
  return fmt::format("<{0} class=\"{1}\">{2}</{0}>\n", tag, name, html_text(text.text));
}

std::string to_html(const Facts& facts) {
  std::string html = "<dl class=\"facts\">\n";
  for (const auto& [name, value] : facts.facts)
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html_text(name), html_text(value));
  return html + "</dl>\n";
}

std::string block_html(const Block& block) {
  return std::visit([](const auto& each) { return to_html(each); }, block);
}

/// As the corner of a drawing has it.
std::string title_html(const TitleBlock& title) {
  std::string html = "<div class=\"title\">\n";
  if (!title.logo.rgba.empty())
    html += fmt::format("<img src=\"{}\" alt=\"\">\n", page::picture_url(title.logo));
  for (const Block& block : title.blocks) html += block_html(block);
  return html + "</div>\n";
}

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
        "it, the wheel zooms once it is clicked\"></canvas>"
        "<div class=\"tags\" hidden><span>+d · core</span><span>−d · cavity</span>";
    for (const ViewCallout& callout : report.view->callouts)
      html += fmt::format("<span class=\"number\">{}</span>", html_text(callout.text));
    html += "</div>";
    if (report.live) html += live_stage_html(*report.live);
  }
  html += "</div>\n";
  if (report.view) html += legend_html(*report.view);
  if (report.view && report.live) html += live_controls_html(*report.live);
  if (report.view) html += controls_html(*report.view);
  if (!report.live_notice.empty()) html += to_html(Text{report.live_notice, TextLook::notice});
  html += fmt::format("<figcaption>{}</figcaption>\n</figure>\n", html_text(report.still.caption));
  return html;
}

// Styles in attributes are what the page's policy forbids; colours stand in attributes of SVG.
}  // namespace

std::string html_page(const Report& report) {
  page::PageFrame frame{report.part + " · moldlight", "report.css", {"model.js", "draw.js", "view.js"}};
  const bool live = report.view && report.live;
  if (live) frame.scripts.insert(frame.scripts.end(), {"live_maps.js", "live_rays.js", "live.js"});
  frame.scripts.push_back("report.js");
  std::string html = page::page_begin(frame);
  html += fmt::format(
      "<main>\n<header>\n<p class=\"kind\">{}</p>\n<h1>{} <span>{}</span></h1>\n<p class=\"verdict "
      "{}\">{}</p>\n",
      html_text(report.kind), html_text(report.part), html_text(report.subject), tone_class(report.tone),
      html_text(report.sentence));
  if (!report.lead.empty()) html += fmt::format("<p class=\"lead\">{}</p>\n", html_text(report.paragraph()));
  html += "</header>\n";
  if (report.title) html += title_html(*report.title);
  html += view_html(report);
  for (const Section& section : report.sections) {
    html += fmt::format("<section>\n<h2>{}</h2>\n", html_text(section.title));
    for (const Block& block : section.blocks) html += block_html(block);
    html += "</section>\n";
  }
  html += "</main>\n";
  if (report.view)
    html += page::data_block("shaders", page_shaders(live)) + page::data_block("model", packed(*report.view));
  if (live) html += page::data_block("live", packed(*report.live));
  return html + page::page_end(frame);
}

void write_html(const std::string& path, const Report& report) { write_file(path, html_page(report)); }

}  // namespace moldlight::report
