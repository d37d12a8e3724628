// Rows of figures: what JSON gets, and what people read.
#include "classify/figure_table.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"

namespace moldlight {
namespace {

struct Thing {
  double length = 0.0;
  std::size_t count = 0;
};

constexpr FigureRow<Thing> k_rows[] = {
    {"size/length", "length", FigureKind::length,
     [](const Thing& t) -> std::optional<double> { return t.length; }},
    {"count",
     {},
     FigureKind::count,
     [](const Thing& t) -> std::optional<double> { return static_cast<double>(t.count); }},
    {"unknown", "unknown", FigureKind::area,
     [](const Thing&) -> std::optional<double> { return std::nullopt; }},
    {{}, "for people", FigureKind::share, [](const Thing&) -> std::optional<double> { return 0.25; }},
};

TEST(FigureTable, PutsEveryKeyIntoJsonWithAllDigits) {
  nlohmann::ordered_json json;
  put_figures(found_figures(std::span<const FigureRow<Thing>>(k_rows), {1.0 / 3.0, 7}), json);
  EXPECT_EQ(json["size"]["length"], 1.0 / 3.0);
  EXPECT_TRUE(json["count"].is_number_integer());
  EXPECT_EQ(json["count"], 7);
  EXPECT_TRUE(json["unknown"].is_null());
  EXPECT_EQ(json.size(), 3U) << "without a key it is for people alone: " << json;
}

TEST(FigureTable, WritesDigitsByKind) {
  const auto model = test::model_of(test::box_mesh({0, 0, 0}, {3, 4, 12}));  // diagonal 13
  const FigureStyle style(*model);
  EXPECT_EQ(style.text(FigureKind::length, 2.31628e-06), "< 0.00002");
  EXPECT_EQ(style.text(FigureKind::length, 12.34567), "12.35");
  EXPECT_EQ(style.text(FigureKind::length, 0.0), "0");
  EXPECT_EQ(style.with_unit(FigureKind::share, 0.256), "25.6 %");
  EXPECT_EQ(style.with_unit(FigureKind::angle, 64.02), "64.0°");
  EXPECT_EQ(style.heading("climb", FigureKind::length), "climb unit");
  EXPECT_EQ(style.change(FigureKind::area, 1e-9), "0");
  EXPECT_EQ(style.change(FigureKind::area, 1.5), "+1.5");
  EXPECT_EQ(style.text(FigureKind::volume, 1'627'411.0), "1627000") << "four digits of what has many";
  EXPECT_EQ(style.text(FigureKind::area, 98'765.0), "98765");
  EXPECT_EQ(style.text(FigureKind::length, 1'627'411.0), "1627411") << "which may say where something is";
  EXPECT_EQ(style.point({1e-12, -2.0, 3.14159}), "0, -2, 3.142");
}

}  // namespace
}  // namespace moldlight
