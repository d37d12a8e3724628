#include "picture/callouts.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "picture/design_space.hpp"

namespace moldlight {

namespace {

// Lengths at scale 1.
constexpr double k_disc_radius = 15.0, k_leader = 42.0, k_spot_radius = 4.0, k_between = 4.0;
constexpr double k_number_px = 18.0, k_bar_text_px = 18.0;
constexpr int k_rounds = 60;  // in which discs move apart; more change nothing

/// Where the discs stand, clear of each other as far as `rounds` of moving apart have it.
std::vector<glm::dvec2> disc_places(std::span<const Callout> callouts, const glm::dvec2& middle,
                                    const glm::dvec2& size, double scale) {
  std::vector<glm::dvec2> places;
  for (const Callout& callout : callouts) {
    const glm::dvec2 away = callout.at - middle;
    const double far = glm::length(away);
    places.push_back(callout.at + k_leader * scale * (far > 1.0 ? away / far : glm::dvec2(0.0, -1.0)));
  }
  const double apart = (2.0 * k_disc_radius + k_between) * scale;
  const glm::dvec2 margin((k_disc_radius + k_between) * scale);
  for (int round = 0; round < k_rounds; ++round) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (std::size_t other = 0; other < k; ++other) {
        const glm::dvec2 between = places[k] - places[other];
        const double far = glm::length(between);
        if (far >= apart) continue;
        const glm::dvec2 way = far > 1e-6 ? between / far : glm::dvec2(1.0, 0.0);
        places[k] += 0.5 * (apart - far) * way;
        places[other] -= 0.5 * (apart - far) * way;
      }
    }
    for (glm::dvec2& place : places) place = glm::clamp(place, margin, glm::max(margin, size - margin));
  }
  return places;
}

/// The greatest of 1, 2, 5, 10, … that is no more than `most`.
double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  const double share = most / power;
  return power * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

}  // namespace

void draw_callouts(Canvas& canvas, std::span<const Callout> callouts, const glm::dvec2& middle,
                   const LegendStyle& style) {
  const double scale = style.scale;
  const PictureInks inks = picture_inks(style.dark);
  const std::vector<glm::dvec2> places = disc_places(callouts, middle, canvas.size(), scale);
  for (std::size_t k = 0; k < callouts.size(); ++k) {
    const Callout& callout = callouts[k];
    for (const auto& [ink, width] : {std::pair(inks.card, 3.5), std::pair(inks.strong, 1.5)}) {
      canvas.line(callout.at, places[k], ink, width * scale);
      if (callout.hidden)
        canvas.ring(callout.at, k_spot_radius * scale, ink, width * scale);
      else
        canvas.disc(callout.at, (k_spot_radius + 0.5 * (width - 1.5)) * scale, ink);
    }
  }
  for (std::size_t k = 0; k < callouts.size(); ++k) {
    canvas.disc(places[k], k_disc_radius * scale, {inks.card.colour, 1.0});
    canvas.ring(places[k], k_disc_radius * scale, inks.strong, 1.5 * scale);
    const TextStyle text{
        .size_px = 12.0 * scale, .weight = FontWeight::semibold, .ink = inks.strong, .align = Align::centre};
    canvas.text(places[k] + glm::dvec2(0.0, 0.36 * text.size_px), callouts[k].text, text);
  }
}

void draw_scale_bar(Canvas& canvas, double pixel_length, std::string_view unit, const LegendStyle& style) {
  const double scale = style.scale;
  const glm::dvec2 size = canvas.size();
  const double length = round_length(0.25 * size.x * pixel_length), width = length / pixel_length;
  const std::string label = fmt::format("{:g} {}", length, unit);
  const PictureInks inks = picture_inks(style.dark);
  const double margin = 24.0 * scale, tick = 5.0 * scale;
  const glm::dvec2 right = size - margin, left = right - glm::dvec2(width, 0.0);
  Ink card = inks.card;
  card.opacity *= 0.85;
  canvas.fill_box({left - glm::dvec2(12.0, 30.0) * scale, {width + 24.0 * scale, 42.0 * scale}}, card,
                  6.0 * scale);
  canvas.line(left, right, inks.strong, 1.5 * scale);
  for (const glm::dvec2& end : {left, right})
    canvas.line(end - glm::dvec2(0.0, tick), end + glm::dvec2(0.0, tick), inks.strong, 1.5 * scale);
  canvas.text(0.5 * (left + right) - glm::dvec2(0.0, 10.0 * scale), label,
              {.size_px = k_bar_text_px * scale,
               .weight = FontWeight::medium,
               .ink = inks.strong,
               .align = Align::centre,
               .tabular = true});
}

}  // namespace moldlight
