// Reports go to terminals, too.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "support/hostile_names.hpp"

namespace moldlight {
namespace {

TEST(JsonText, NoNameIsObeyedAndEachReadsBack) {
  for (const std::string& name : test::hostile_names()) {
    const std::string text = json_text({{"file", name}, {"area", 0.1}});
    EXPECT_TRUE(test::is_harmless(text, U"\n")) << text;
    const auto back = nlohmann::ordered_json::parse(text);
    EXPECT_EQ(back["area"], 0.1);
    if (utf8_of(letters_of(name)) == name) {
      EXPECT_EQ(back["file"], name);
    }
  }
  EXPECT_EQ(json_text("Müller – 月"), "\"Müller – 月\"\n");
}

}  // namespace
}  // namespace moldlight
