// Page breaks: what they never cut, what stays together, what is said again.
#include <gtest/gtest.h>

#include "base/shown_text.hpp"
#include "report/pdf/blocks.hpp"
#include "report/pdf/text.hpp"
#include "support/hostile_names.hpp"
#include "support/random.hpp"

namespace moldlight::report {
namespace {

/// Numbers of the pieces on each page; -1 for what is none of them.
std::vector<std::vector<int>> numbers(const std::vector<Piece>& pieces, double height) {
  std::vector<std::vector<int>> found;
  for (const PlacedPage& page : paginated(pieces, height)) {
    found.emplace_back();
    for (const PlacedPiece& placed : page) {
      const bool own = placed.piece >= pieces.data() && placed.piece < pieces.data() + pieces.size();
      found.back().push_back(own ? static_cast<int>(placed.piece - pieces.data()) : -1);
    }
  }
  return found;
}

using Pages = std::vector<std::vector<int>>;

TEST(PdfFlow, NothingIsOnePage) { EXPECT_EQ(paginated({}, 100.0).size(), 1u); }

TEST(PdfFlow, BreaksWhereAPieceHasNoRoom) {
  const std::vector<Piece> pieces(5, Piece{.height = 40.0});
  EXPECT_EQ(numbers(pieces, 100.0), (Pages{{0, 1}, {2, 3}, {4}}));
  EXPECT_EQ(numbers(pieces, 120.0), (Pages{{0, 1, 2}, {3, 4}}));
}

TEST(PdfFlow, AGapIsNoneAtTheTopOfAPage) {
  const std::vector<Piece> pieces(3, Piece{.height = 50.0, .gap = 10.0});
  const std::vector<PlacedPage> pages = paginated(pieces, 115.0);
  ASSERT_EQ(pages.size(), 2u);
  EXPECT_EQ(pages[0][0].top, 0.0);
  EXPECT_EQ(pages[0][1].top, 60.0);
  EXPECT_EQ(pages[1][0].top, 0.0);
}

TEST(PdfFlow, AHeadingGoesWithWhatFollows) {
  std::vector<Piece> pieces(4, Piece{.height = 30.0});
  pieces[1].with_next = pieces[2].with_next = true;
  EXPECT_EQ(numbers(pieces, 100.0), (Pages{{0}, {1, 2, 3}}));
}

TEST(PdfFlow, WhatFitsStaysOnThePage) {
  std::vector<Piece> pieces = {
      {.height = 100.0}, {.height = 285.0, .gap = 8.0, .with_next = true}, {.height = 12.0, .gap = 3.0}};
  EXPECT_EQ(numbers(pieces, 408.0), (Pages{{0, 1, 2}}));
  EXPECT_EQ(numbers(pieces, 407.0), (Pages{{0}, {1, 2}}));
}

TEST(PdfFlow, WhatIsTooLongToStayTogetherComesApart) {
  std::vector<Piece> pieces(6, Piece{.height = 30.0, .with_next = true});
  EXPECT_EQ(numbers(pieces, 100.0), (Pages{{0, 1, 2}, {3, 4, 5}}));
}

TEST(PdfFlow, HeadingsOfATableAreRepeated) {
  std::vector<Piece> pieces = {{.height = 20.0, .with_next = true}};
  const auto heading = std::make_shared<const Piece>(pieces.front());
  for (int row = 0; row < 5; ++row) pieces.push_back({.height = 30.0, .repeated = heading});
  EXPECT_EQ(numbers(pieces, 90.0), (Pages{{0, 1, 2}, {-1, 3, 4}, {-1, 5}}));
}

TEST(PdfFlow, NothingIsCutLostOrDoubled) {
  test::Random random(5);
  for (int run = 0; run < 200; ++run) {
    std::vector<Piece> pieces;
    const auto heading = std::make_shared<const Piece>(Piece{.height = 20.0});
    for (int k = 0; k < 60; ++k) {
      Piece piece{.height = random.between(1.0, 60.0),
                  .gap = random.between(0.0, 5.0),
                  .with_next = random.chance(0.2)};
      if (random.chance(0.3)) piece.repeated = heading;
      pieces.push_back(std::move(piece));
    }
    std::size_t next = 0;
    for (const PlacedPage& page : paginated(pieces, 100.0)) {
      double at = 0.0;
      ASSERT_FALSE(page.empty());
      for (const PlacedPiece& placed : page) {
        EXPECT_GE(placed.top, at);
        at = placed.top + placed.piece->height;
        EXPECT_LE(at, 100.0 + 1e-9);
        if (placed.piece == heading.get()) continue;
        ASSERT_LT(next, pieces.size());
        EXPECT_EQ(placed.piece, &pieces[next++]);
      }
    }
    EXPECT_EQ(next, pieces.size());
  }
}

TEST(PdfText, BreaksAtSpacesAndInsideOfWordsThatAreTooLong) {
  Canvas canvas(10, 10);
  const TextStyle style{.size_px = 10.0};
  const double width = canvas.text_width("mmmmmmmmmm", style);
  EXPECT_EQ(lines_of(canvas, "one two", style, width), (std::vector<std::string>{"one two"}));
  EXPECT_EQ(lines_of(canvas, "  one \t two\nthree", style, width),
            (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(lines_of(canvas, "", style, width), (std::vector<std::string>{""}));
  const std::vector<std::string> lines =
      lines_of(canvas, "a " + std::string(25, 'm') + " b", style, width + 0.01);
  EXPECT_EQ(lines, (std::vector<std::string>{"a", std::string(10, 'm'), std::string(10, 'm'), "mmmmm b"}));
  for (const std::string& line : lines) EXPECT_LE(canvas.text_width(line, style), width + 0.01);
}

TEST(PdfText, ARoomlessLetterStillStands) {
  Canvas canvas(10, 10);
  EXPECT_EQ(lines_of(canvas, "ab", {.size_px = 10.0}, 0.5), (std::vector<std::string>{"a", "b"}));
}

TEST(PdfText, WhiteSpaceIsSpacesAndControlsAreShown) {
  EXPECT_EQ(one_line("a\nb\x1B[1m\x7F\xFF"), "a b\\u001B[1m\\u007F\\xFF");
  for (const std::string& name : test::hostile_names()) EXPECT_TRUE(test::is_harmless(one_line(name)));
}

}  // namespace
}  // namespace moldlight::report
