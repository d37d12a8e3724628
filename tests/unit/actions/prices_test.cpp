// What kinds of action cost, what an action forms, and which changes of the part save most.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "actions/action_prices.hpp"
#include "actions/actions_report.hpp"
#include "actions/best_changes.hpp"
#include "base/error.hpp"
#include "support/scratch_folder.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

TEST(Prices, AreReadFromTextAndFromAFile) {
  const ActionPrices prices = parse_prices("lifter=2,insert=5.5");
  EXPECT_EQ(prices[static_cast<std::size_t>(ActionKind::lifter)], 2.0);
  EXPECT_EQ(prices[static_cast<std::size_t>(ActionKind::insert)], 5.5);
  EXPECT_EQ(prices[static_cast<std::size_t>(ActionKind::slide)], 1.0);
  EXPECT_EQ(prices_text(prices), "lifter=2,insert=5.5");
  EXPECT_EQ(prices_text(default_prices()), "");
  const test::ScratchFolder folder;
  const std::string file = (folder.path() / "prices.json").string();
  std::ofstream(file) << R"({"lifter": 2, "insert": 5.5})";
  EXPECT_EQ(parse_prices(file), prices);
  std::ofstream(file) << R"({"lifter": "dear"})";
  EXPECT_THROW(static_cast<void>(parse_prices(file)), FileError);
  for (const char* wrong : {"lifter", "lifter=0", "lifter=-1", "magnet=2", "lifter=two"})
    EXPECT_THROW(static_cast<void>(parse_prices(wrong)), UsageError) << wrong;
}

TEST(Prices, DecideWhatIsChangedFirst) {
  const Planned planned = plan_of(box_with_vents({60, 90}));
  ASSERT_EQ(planned.plan.actions.size(), 4U);
  const auto changes = best_changes(planned.plan, default_prices());
  ASSERT_EQ(changes.size(), 3U) << "no more than three";
  for (const SavingChange& change : changes) {
    EXPECT_EQ(change.actions.size(), 1U);
    EXPECT_EQ(change.undercuts, planned.plan.actions[change.actions[0]].undercuts);
    EXPECT_EQ(change.saves, 1.0);
  }
}

TEST(Feature, IsNamedAsAToolmakerDoes) {
  const Planned box = plan_of(box_with_vents({60, 90}));
  for (const SideAction& action : box.plan.actions)
    EXPECT_TRUE(action.feature == "window" || action.feature == "slot") << action.feature;
  const ActionSettings settings;
  const auto json = actions_json({*box.model, box.result, settings, box.plan});
  EXPECT_EQ(json["actions"][0]["sequence"], 1);
  EXPECT_EQ(json["actions"][0]["feature"], box.plan.actions[0].feature);
  EXPECT_EQ(json["changes"].size(), 3U);
}

}  // namespace
}  // namespace moldlight
