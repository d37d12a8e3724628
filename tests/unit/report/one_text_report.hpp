// A report that has a block of each kind.
#pragma once

#include <string>

#include "report/report.hpp"

namespace moldlight::report {

inline Image small_picture() {
  Image image = empty_image(4, 3);
  image.at(1, 1)[3] = 255;
  return image;
}

/// With the same text everywhere.
inline Report report_of(const std::string& text) {
  Report report;
  report.kind = report.part = report.subject = report.sentence = text;
  report.lead = {text};
  const Picture picture{small_picture(), small_picture(), text, text};
  report.still = picture;
  ModelView view;
  view.groups = {{.name = text, .aside = text}};
  view.opens = text;
  report.view = std::move(view);
  Section section{text, {}};
  section.blocks.emplace_back(FigureGrid{{{text, {text, text, 1.5}, text, text, text}}});
  section.blocks.emplace_back(ShareBar{{{{{1, 2, 3}, true}, 0.5, text}}});
  section.blocks.emplace_back(
      Table{{{text, true}}, {{{{text}}, Mark{{9, 9, 9}}, small_picture(), text}}, text});
  section.blocks.emplace_back(Pictures{{picture}});
  section.blocks.emplace_back(DraftBars{
      .bars = {{-1.0, 1.0, 2.0, 3.0}}, .required_deg = 0.5, .core = {}, .cavity = {}, .unit = text});
  for (const TextLook look : {TextLook::normal, TextLook::quiet, TextLook::notice, TextLook::command})
    section.blocks.emplace_back(Text{text, look});
  section.blocks.emplace_back(Facts{{{text, text}}});
  report.sections.push_back(std::move(section));
  return report;
}

}  // namespace moldlight::report
