// What people look at shows every letter and obeys none.
#include "base/shown_text.hpp"

#include <gtest/gtest.h>

#include "support/hostile_names.hpp"

namespace moldlight {
namespace {

TEST(ShownText, OrdinaryNamesStay) {
  for (const char* name : {"", "part.stl", "Müller 月 🙂", "a\\b (1) – 50 %", "שלום", "é"})
    EXPECT_EQ(shown_text(name), name);
}

TEST(ShownText, WhatWouldBeObeyedStandsAsItsNumber) {
  EXPECT_EQ(shown_text("a\x1B[31m\x7F"), "a\\u001B[31m\\u007F");
  EXPECT_EQ(shown_text("\u009B1m"), "\\u009B1m");
  EXPECT_EQ(shown_text("exe\u202Elts"), "exe\\u202Elts");
  EXPECT_EQ(shown_text("a\u2028b\nc"), "a\\u2028b\\u000Ac");
  EXPECT_EQ(shown_text("\x9B\xC3"), "\\x9B\\xC3");
  EXPECT_EQ(shown_text(std::string_view("\0", 1)), "\\u0000");
}

TEST(ShownText, NoHostileNameIsObeyed) {
  for (const std::string& name : test::hostile_names()) {
    EXPECT_TRUE(test::is_harmless(shown_text(name))) << shown_text(name);
    EXPECT_EQ(shown_text(shown_text(name)), shown_text(name)) << "shown once more it stays";
  }
}

TEST(ShownText, IsCutBetweenLetters) {
  EXPECT_EQ(shown_text("abcdef", 3), "abc...");
  EXPECT_EQ(shown_text("abc", 3), "abc");
  EXPECT_EQ(shown_text("ab\u6708", 4), "ab...");
  EXPECT_EQ(shown_text("ab\x1B", 7), "ab...") << "an escape is whole, too";
}

TEST(ShownText, HasWordsInAnyOrderAndSize) {
  EXPECT_TRUE(has_words("Cover plate, 2 slides", "SLIDES cover"));
  EXPECT_TRUE(has_words("Cover", ""));
  EXPECT_TRUE(has_words("Cover", "  "));
  EXPECT_FALSE(has_words("Cover plate", "cover lid"));
}

}  // namespace
}  // namespace moldlight
