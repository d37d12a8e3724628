#include "classify/number_format.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/check.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

std::string grouped(std::string_view number) {
  constexpr std::string_view k_gap = "\u2009";
  const std::size_t start = std::min(number.find_first_of("0123456789"), number.size());
  const std::size_t end = std::min(number.find_first_not_of("0123456789", start), number.size());
  std::string result(number.substr(0, start));
  for (std::size_t k = start; k < end; ++k) {
    if (k > start && (end - k) % 3 == 0 && end - start > 3) result += k_gap;
    result += number[k];
  }
  return result + std::string(number.substr(end));
}

double share(double value, double whole) { return whole > 0.0 ? value / whole : 0.0; }

std::string share_text(double value, double whole) {
  return fmt::format("{:.2f} %", 100.0 * share(value, whole));
}

std::string rounded_area(double area, double whole) { return rounded(area, 1e-6 * whole); }

std::string error_text(double error, double least) { return rounded(error, least, 2); }

std::string figure(double value) { return fmt::format("{:.6g}", value); }

std::string component_text(double value, int decimals) {
  const bool is_zero = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}", is_zero ? 0.0 : value, decimals);
}

std::string direction_text(const glm::dvec3& direction, int decimals) {
  return fmt::format("{}, {}, {}", component_text(direction.x, decimals),
                     component_text(direction.y, decimals), component_text(direction.z, decimals));
}

std::string sentence_of(std::string text) {
  if (text.empty()) return text;
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text + ".";
}

std::string with_minus(std::string text) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at + 1)) {
    const bool joins = at > 0 && at + 1 < text.size() && is_letter(text[at - 1]) && is_letter(text[at + 1]);
    if (!joins) text.replace(at, 1, "−");
  }
  return text;
}

std::string length_unit(const Part& part) { return part.unit.empty() ? "unit" : part.unit; }

std::string powered_unit(const Part& part, int power) {
  CHECK(power == 2 || power == 3);
  return length_unit(part) + (power == 2 ? "²" : "³");
}

std::string tiny_text(std::size_t count) {
  return count == 0 ? std::string() : fmt::format("{} tiny, ignored", count);
}

std::string part_name(const Part& part) {
  return clean_name(std::filesystem::path(part.file).filename().string());
}

}  // namespace moldlight
