#include "report/pdf/text.hpp"

#include <algorithm>

#include "base/shown_text.hpp"

namespace moldlight::report {

namespace {

constexpr std::size_t k_few_lines = 12;

bool is_space(char32_t letter) { return letter == U' ' || (letter >= U'\t' && letter <= U'\r'); }

/// Words and line ends of a text, in order; a line end is an empty word.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) words.push_back(std::move(word));
    word.clear();
  };
  for (const char32_t letter : letters_of(text)) {
    if (is_space(letter)) end_word();
    if (letter == U'\n') words.emplace_back();
    if (is_space(letter)) continue;
    word += is_command_letter(letter) ? letter_escape(letter) : utf8_of(std::u32string(1, letter));
  }
  end_word();
  return words;
}

class LineBreaker {
 public:
  LineBreaker(Canvas& canvas, const TextStyle& style, double width_pt)
      : canvas_(&canvas), style_(&style), width_(width_pt), space_(canvas.text_width(" ", style)) {}

  void add(const std::string& word) {
    const double width = canvas_->text_width(word, *style_);
    if (!line_.empty() && at_ + space_ + width <= width_) {
      line_ += " " + word;
      at_ += space_ + width;
      return;
    }
    if (!line_.empty()) end_line();
    if (width <= width_) {
      line_ = word;
      at_ = width;
      return;
    }
    for (const char32_t letter : letters_of(word)) add(letter);
  }
  void end_line() {
    lines_.push_back(std::move(line_));
    line_.clear();
    at_ = 0.0;
  }
  [[nodiscard]] std::vector<std::string> lines() && {
    if (!line_.empty() || lines_.empty()) end_line();
    return std::move(lines_);
  }

 private:
  void add(char32_t letter) {
    const std::string text = utf8_of(std::u32string(1, letter));
    const double width = canvas_->text_width(text, *style_);
    if (!line_.empty() && at_ + width > width_) end_line();
    line_ += text;
    at_ += width;
  }

  Canvas* canvas_;
  const TextStyle* style_;
  double width_, space_, at_ = 0.0;
  std::string line_;
  std::vector<std::string> lines_;
};

constexpr double k_stripes_pt = 2.6;
constexpr Ink k_stripe{{255, 255, 255}, 0.55};

}  // namespace

std::vector<std::string> lines_of(Canvas& canvas, std::string_view text, const TextStyle& style,
                                  double width_pt) {
  LineBreaker breaker(canvas, style, width_pt);
  for (const std::string& word : words_of(text)) word.empty() ? breaker.end_line() : breaker.add(word);
  return std::move(breaker).lines();
}

std::vector<std::string> few_lines_of(Canvas& canvas, std::string_view text, const TextStyle& style,
                                      double width_pt) {
  std::vector<std::string> lines = lines_of(canvas, text, style, width_pt);
  if (lines.size() <= k_few_lines) return lines;
  lines.resize(k_few_lines);
  lines.back() = "…";
  return lines;
}

double word_width(Canvas& canvas, std::string_view text, const TextStyle& style) {
  double widest = 0.0;
  for (const std::string& word : words_of(text)) widest = std::max(widest, canvas.text_width(word, style));
  return widest;
}

void draw_lines(Canvas& canvas, const glm::dvec2& at, const std::vector<std::string>& lines,
                const TextStyle& style) {
  double top = at.y;
  for (const std::string& line : lines) {
    canvas.text({at.x, top + k_baseline * style.size_px}, line, style);
    top += line_pt(style);
  }
}

void draw_box(Canvas& canvas, const Mark& mark, const Box& box) {
  if (box.size.x <= 0.0 || box.size.y <= 0.0) return;
  canvas.fill_box(box, {mark.colour});
  if (mark.hatched) canvas.hatch_box(box, k_stripe, 0.0, k_stripes_pt);
}

void draw_mark(Canvas& canvas, const Mark& mark, const glm::dvec2& corner, double size_pt) {
  const Box box{corner, glm::dvec2(size_pt)};
  canvas.fill_box(box, {mark.colour}, 0.15 * size_pt);
  if (mark.hatched) canvas.hatch_box(box, k_stripe, 0.15 * size_pt, k_stripes_pt);
}

}  // namespace moldlight::report
