// The mold in the window: loops that are looked at, halves that open, sections through steel, the parting
// height and faces by hand, and files that are those of `mold`.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "actions/actions_files.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/mold_view.hpp"
#include "gui/view/side_actions.hpp"
#include "gui/window_with_part.hpp"
#include "io/mesh_writer.hpp"
#include "parting/make_halves.hpp"
#include "parting/mold_report.hpp"
#include "parting/planar_line.hpp"
#include "support/solid_builder.hpp"

namespace moldlight::gui::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_box_part =
    "OFF\n8 6 0\n0 0 0\n30 0 0\n30 20 0\n0 20 0\n0 0 10\n30 0 10\n30 20 10\n0 20 10\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
constexpr const char* k_open_box =
    "OFF\n8 5 0\n0 0 0\n30 0 0\n30 20 0\n0 20 0\n0 0 10\n30 0 10\n30 20 10\n0 20 10\n"
    "4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

constexpr const char* k_frame =
    "OFF\n16 16 0\n0 0 0\n30 0 0\n30 30 0\n0 30 0\n10 10 0\n20 10 0\n20 20 0\n10 20 0\n"
    "0 0 4\n30 0 4\n30 30 4\n0 30 4\n10 10 4\n20 10 4\n20 20 4\n10 20 4\n"
    "4 0 4 5 1\n4 1 5 6 2\n4 2 6 7 3\n4 3 7 4 0\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n"
    "4 0 1 9 8\n4 1 2 10 9\n4 2 3 11 10\n4 3 0 8 11\n4 5 4 12 13\n4 6 5 13 14\n4 7 6 14 15\n4 4 7 15 12\n";

class Mold : public WindowWithPart {
 protected:
  void open(const char* off) {
    window.app().open(part.folder().write("box.off", off));
    window.wait_until_loaded();
    window.wait_until_measured();
    window.settle();
  }
  void unfold(Step step = Step::mold) {
    enter(step);
    window.wait_until_measured();
    window.settle();
  }
  [[nodiscard]] const MoldState& mold() const { return state().mold; }
  [[nodiscard]] const MoldSettings& asked() const { return state().settings.mold; }
  [[nodiscard]] glm::vec2 pixel_of(const glm::dvec3& point) const {
    return glm::vec2(project(state().camera, window.size(), glm::dvec3(state().model->frame.to_unit(point)))
                         .value_or(glm::dvec2(-1.0)));
  }
  [[nodiscard]] std::array<int, 3> colour_at(const glm::vec2& at) const {
    const auto pixels = window.pixels();
    const glm::ivec2 pixel(at);
    const std::size_t first = 4 * static_cast<std::size_t>(pixel.y * window.size().x + pixel.x);
    return {pixels[first], pixels[first + 1], pixels[first + 2]};
  }
  [[nodiscard]] Assignment same_assignment() const {
    return assign_sides(*state().model, state().settings, asked(), Progress{});
  }
};

TEST_F(Mold, ShowsMoldsOfSeveralPiecesAndRemovesThem) {
  // A cube with blind holes in three sides.
  moldlight::test::SolidBuilder builder;
  builder.box(glm::dvec3(-15.0), glm::dvec3(15.0), {1, 3, 5});
  for (const int side : {1, 3, 5}) {
    glm::dvec3 low(-3.0), high(3.0);
    low[side / 2] = 6.0;
    high[side / 2] = 15.0;
    builder.face(moldlight::test::box_face(glm::dvec3(-15.0), glm::dvec3(15.0), side),
                 {moldlight::test::box_face(low, high, side)});
    builder.box(low, high, {side}, true);
  }
  const TriangleMesh mesh = builder.mesh();
  const std::vector<Region> regions(mesh.facets.size(), Region::both);
  const std::string path = part.folder().file("cube.stl");
  write_coloured_mesh(path, {.mesh = mesh, .regions = regions});
  window.app().open(path);
  window.wait_until_loaded();
  unfold();
  click("Several pieces");
  window.settle();
  window.wait_until_measured();
  window.settle();
  ASSERT_EQ(mold().pieces.size(), 2U);
  const MoldOfPieces* shown = shown_pieces(state());
  ASSERT_TRUE(shown != nullptr);
  EXPECT_EQ(shown->result->count(), 3U) << "as many as are enough";
  EXPECT_TRUE(shown->result->enough);
  ASSERT_TRUE(shown->has_solids());
  EXPECT_EQ(shown->bodies->size(), 3U + shown->solids->solids.size());
  EXPECT_EQ(mold().pieces[0].solids, nullptr) << "too few directions";
  EXPECT_GT(mold().pieces[0].result->left_area, 100.0);
  const auto closed = window.pixels();
  click("2 pieces");
  window.settle();
  EXPECT_EQ(shown_pieces(state())->result->count(), 2U);
  click("3 pieces");
  key({.key = 'O'});
  window.settle();
  EXPECT_FALSE(closed == window.pixels()) << "pieces are removed";
  click("Several pieces");
  window.settle();
  EXPECT_TRUE(shown_pieces(state()) == nullptr);
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(Mold, TellsTheLineAsTheCommandDoes) {
  open(k_box_part);
  ASSERT_TRUE(mold().line);
  const Assignment assignment = same_assignment();
  const PartingLine line = parting_line(assignment);
  EXPECT_EQ(mold().line->verdict, parting_verdict(assignment, line, *state().model));
  ASSERT_EQ(mold().line->line.loops.size(), 1U);
  EXPECT_NEAR(mold().line->line.loops[0].length, 100.0, 1e-9);
  EXPECT_FALSE(mold().solids) << "not before they are looked at";
  key({.key = 'G'});
  window.wait_until_measured();
  window.settle();
  ASSERT_TRUE(mold().solids);
  unfold(Step::parting_line);
  std::string said;  // in some lines
  for (const DrawnText& each : window.app().texts()) said += each.text + " ";
  EXPECT_NE(said.find(mold().line->verdict), std::string::npos) << said;
}

TEST_F(Mold, DrawsTheLineAndFliesToALoop) {
  open(k_box_part);
  const auto bare = window.pixels();
  unfold(Step::parting_line);
  window.move_mouse({640, 60});
  window.settle();
  const glm::dvec3 rim(15, 0, mold().line->line.loops[0].low);
  const auto lit = colour_at(pixel_of(rim));
  EXPECT_GT(lit[0], 200) << "the tube is bright";
  EXPECT_GT(lit[0], lit[2] + 60);
  window.move_mouse({640, 360});
  window.turn_wheel(2.0F);
  window.settle();
  const double before = state().camera.height;
  click("loop 1");
  window.settle();
  EXPECT_EQ(state().mold_choices.loop, 0U);
  EXPECT_NE(state().camera.height, before);
  const auto chosen = colour_at(pixel_of(rim));
  EXPECT_GT(chosen[2], lit[2] + 60) << "and brighter where it is looked at";
  key({.key = k_escape});
  EXPECT_FALSE(state().mold_choices.loop);
  enter(Step::direction);
  window.settle();
  key({.key = 'F'});
  window.move_mouse({640, 60});
  window.settle();
  EXPECT_FALSE(looks_at_line(state()));
}

TEST_F(Mold, ALoopIsChosenOnThePart) {
  open(k_frame);
  unfold(Step::parting_line);
  ASSERT_EQ(mold().line->line.loops.size(), 2U);
  for (std::size_t number = 0; number < 2; ++number) {
    // Somewhere it is not hidden.
    const std::vector<glm::dvec3>& points = mold().line->line.loops[number].points;
    const double height = state().camera.height;
    bool chosen = false;
    for (std::size_t k = 0; k < points.size() && !chosen; ++k) {
      move_to(pixel_of(0.5 * (points[k] + points[(k + 1) % points.size()])));
      press();
      window.settle();
      chosen = state().mold_choices.loop == number;
      if (chosen) break;
      key({.key = k_escape});
      window.frames(24);  // the next click is no double click
    }
    EXPECT_TRUE(chosen) << number;
    EXPECT_FALSE(state().face) << "it is no choice of a face";
    EXPECT_EQ(state().camera.height, height) << "what is under the hand stays there";
    const std::string begin = fmt::format("Loop {}: {}", number + 1, number == 0 ? "outer" : "shut-off");
    const auto texts = window.app().texts();
    EXPECT_TRUE(std::ranges::any_of(texts, [&](const DrawnText& each) {
      return each.text.starts_with(begin) && each.text.find("long") != std::string::npos;
    }));
    window.frames(24);
    press();
    window.settle();
    EXPECT_FALSE(state().mold_choices.loop) << "and a click more leaves it";
    window.frames(24);
  }
  move_to(pixel_of({25, 15, 4}));
  press();
  window.settle();
  EXPECT_FALSE(state().mold_choices.loop) << "beside the line a click is for the face";
  EXPECT_TRUE(state().face);
}

TEST_F(Mold, OpensAsSolidsThatFitThePart) {
  open(k_box_part);
  key({.key = 'O'});
  window.wait_until_measured();
  window.settle();
  ASSERT_TRUE(mold().solids) << mold().error;
  const MoldHalves& halves = mold().solids->halves();
  ASSERT_TRUE(halves.made()) << halves.refusal;
  EXPECT_LT(std::abs(halves.volume_gap), 1e-9);
  ASSERT_EQ(mold().solids->shown.size(), 2U);
  key({.key = 'F'});
  window.settle();
  // Beside the part and above it there is steel now.
  const double diagonal = state().model->frame.diagonal, way = k_mold_travel * diagonal;
  const double margin = block_margin(asked(), diagonal);
  const glm::vec2 steel = pixel_of({30 + 0.5 * margin, 10, 10 + margin + way});
  const auto solid = colour_at(steel);
  click("settings");
  click("Halves=surface");
  key({.key = k_escape});
  window.move_mouse({640, 60});
  window.settle();
  EXPECT_NE(solid, colour_at(steel));
  const auto surface = window.pixels();
  click("settings");
  click("Halves=clear");
  key({.key = k_escape});
  window.move_mouse({640, 60});
  window.settle();
  EXPECT_NE(window.pixels(), surface);
  EXPECT_NE(colour_at(steel), solid);
  EXPECT_FALSE(state().settings.look.open_mold == 0.0);
}

TEST_F(Mold, IsCutClosed) {
  open(k_box_part);
  const double margin = block_margin(asked(), state().model->frame.diagonal);
  click("Section=x");
  window.move_mouse({640, 60});
  window.settle();
  const glm::dvec3 in_steel(15, 20 + 0.5 * margin, 8);
  const auto without = colour_at(pixel_of(in_steel));
  unfold();
  window.move_mouse({640, 60});
  window.settle();
  EXPECT_NE(colour_at(pixel_of(in_steel)), without) << "the mold is cut, too, while its panel is open";
  const auto core = colour_at(pixel_of({15, 20 + 0.5 * margin, 10 + 0.5 * margin}));
  const auto cavity = colour_at(pixel_of({15, 20 + 0.5 * margin, -0.5 * margin}));
  EXPECT_GT(core[2], core[1]) << "blue";
  EXPECT_GT(cavity[1], cavity[2]) << "green";
}

TEST_F(Mold, ShowsTheHeightThatItsPlanarLineHas) {
  unfold(Step::parting_line);
  const PartingLine& line = mold().line->line;
  ASSERT_TRUE(line.is_planar(state().model->frame.diagonal)) << mold().line->verdict;
  EXPECT_NE(mold().line->assignment.height, line.outer_low) << "of its walls";
  EXPECT_EQ(parting_height(state()), line.outer_low);
}

TEST_F(Mold, TakesAHeightByHand) {
  open(k_box_part);
  unfold();
  const double found = parting_height(state());
  const glm::vec2 grip = window.control("parting height handle").centre();
  const double wanted = 4.0;
  const glm::dvec3 up(0, 0, (wanted - found) / state().model->frame.diagonal);
  const auto pixel = [&](const glm::dvec3& at) {
    return glm::vec2(*project(state().camera, window.size(), at));
  };
  drag(grip, grip + pixel(up) - pixel(glm::dvec3(0.0)));
  window.wait_until_measured();
  ASSERT_TRUE(asked().parting_height);
  EXPECT_NEAR(*asked().parting_height, wanted, 0.15);
  EXPECT_NEAR(mold().line->line.loops[0].low, *asked().parting_height, 1e-9);
  // All that the halves share with the block's sides lies at that height: the cavity's ends there.
  const Bounds cavity = bounds(mold().solids->halves().cavity.mesh);
  EXPECT_NEAR(state().model->frame.center.z + cavity.max.z, *asked().parting_height, 1e-3);
  undo();
  EXPECT_FALSE(asked().parting_height) << "a drag is one step";
  window.wait_until_measured();
  EXPECT_NEAR(parting_height(state()), found, 1e-12);

  enter(Step::parting_line);
  click("parting_height");
  window.frames(3);
  window.type("2.5");
  window.frames(2);
  key({.key = k_enter});
  EXPECT_EQ(asked().parting_height, 2.5);
  window.wait_until_measured();
  EXPECT_NEAR(mold().line->line.loops[0].low, 2.5, 1e-9);
  click("find the height");
  EXPECT_FALSE(asked().parting_height);
  click("parting_height");
  window.frames(3);
  window.type("25");
  window.frames(2);
  key({.key = k_enter});
  EXPECT_FALSE(asked().parting_height) << "the part is not that high";
  EXPECT_FALSE(state().toasts.empty());
}

TEST_F(Mold, ItsHeightIsHeldBesideThePanels) {
  open(k_box_part);
  unfold();
  for (const char view : {'1', '3', '7'}) {
    key({.key = view, .shift = true});
    window.settle();
    EXPECT_LT(window.control("parting height handle").max.x, window.control("Palette=paper").min.x) << view;
  }
}

TEST_F(Mold, MovesAFaceToTheOtherHalf) {
  open(k_box_part);
  const glm::vec2 wall = pixel_of({15, 0, 5});  // as the usual view shows it
  move_to(wall);
  ASSERT_TRUE(state().hover);
  ASSERT_EQ(state().hover->point.region, Region::both);
  const double before = mold().line->assignment.area(MoldSide::core);
  const std::uint32_t face = state().faces->of_facet[state().hover->point.facet];
  const FaceHalves first = halves_of_face(state(), face);
  EXPECT_NEAR(first.core + first.cavity, 300.0, 1e-9) << "one of them forms it";
  key({.key = 'V'});
  ASSERT_FALSE(asked().cosmetic.empty());
  window.wait_until_measured();
  // The other walls may follow, so that the line stays level.
  EXPECT_GE(std::abs(mold().line->assignment.area(MoldSide::core) - before), 300.0 - 1e-6);
  const FaceHalves after = halves_of_face(state(), face);
  EXPECT_NEAR(first.core, after.cavity, 1e-9);
  EXPECT_NEAR(first.cavity, after.core, 1e-9);
  EXPECT_NEAR(same_assignment().area(MoldSide::core), mold().line->assignment.area(MoldSide::core), 1e-9);
  const PartNotes notes{state().settings, {}};
  EXPECT_EQ(parse_part_notes(part_notes_json(notes, "box.off"), {}).settings.mold, asked());
  undo();
  EXPECT_TRUE(asked().cosmetic.empty());
  window.wait_until_measured();
  EXPECT_NEAR(mold().line->assignment.area(MoldSide::core), before, 1e-9);

  window.hold_modifiers(true, false, false);
  press();
  window.hold_modifiers(false, false, false);
  window.frames(2);
  ASSERT_FALSE(asked().cosmetic.empty());
  EXPECT_FALSE(state().face) << "it is no choice of a face";
  window.wait_until_measured();
  unfold(Step::parting_line);
  click("Move faces");
  move_to(pixel_of({15, 0, 5}));
  press();
  window.wait_until_measured();
  EXPECT_NEAR(mold().line->assignment.area(MoldSide::core), before, 1e-6) << "and back";
  EXPECT_FALSE(asked().cosmetic.empty()) << "as it was asked";
  const bool core = !cosmetic_faces(asked().cosmetic, true).empty();
  click(core ? "faces to the core" : "faces to the cavity");
  EXPECT_TRUE(asked().cosmetic.empty());
  // What one half alone can form stays there.
  move_to(pixel_of({15, 10, 10}));
  press();
  EXPECT_TRUE(asked().cosmetic.empty());
  EXPECT_FALSE(state().toasts.empty());
}

TEST_F(Mold, SaysWhichFacesTheHalvesCannotFormAsAsked) {
  // Two walls that meet: where one climbs to its half and the other down to its own, neither can be whole.
  PartNotes notes;
  notes.settings.mold.cosmetic = cosmetic_with(cosmetic_with("", 3, true), 2, false);
  window.app().set_notes(notes);
  open(k_box_part);
  unfold();
  ASSERT_TRUE(mold().solids) << mold().error;
  const auto missed = missed_lines(*state().model, mold().solids->halves());
  ASSERT_EQ(missed.size(), 1U);
  const auto lines = halves_lines(state());
  EXPECT_TRUE(std::ranges::any_of(
      lines, [&](const HalvesLine& line) { return line.doubt && line.text == missed.front(); }));
}

TEST_F(Mold, HalvesThatCrossThemselvesAreInDoubt) {
  open(k_box_part);
  unfold();
  ASSERT_TRUE(mold().solids) << mold().error;
  AppState doubtful = state();
  MoldHalves halves = mold().solids->halves();
  halves.cavity.nonmanifold_edges = 3;
  EXPECT_FALSE(halves.certified());
  MoldSolids solids{.plain = std::make_shared<const MoldHalves>(halves), .pieces = nullptr, .shown = {}};
  doubtful.mold.solids = std::make_shared<const MoldSolids>(solids);
  const auto doubts = [](const AppState& shown) {
    return std::ranges::count_if(halves_lines(shown), &HalvesLine::doubt);
  };
  EXPECT_EQ(doubts(doubtful), doubts(state()) + 1);
}

TEST_F(Mold, IsExportedAsTheCommandWritesIt) {
  open(k_box_part);
  unfold();
  click("export mold");
  click("svg");
  click("Export");
  const fs::path folder = fs::path(state().path).parent_path() / "box-mold";
  for (int k = 0; k < 600 && state().toasts.empty(); ++k) window.frame();
  ASSERT_FALSE(state().toasts.empty());
  ASSERT_FALSE(state().toasts.back().failure) << state().toasts.back().text;
  for (const char* name : {"core.stl", "cavity.stl", "parting-line.dxf", "parting-line.svg", "mold.json"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  const moldlight::MoldLine line = find_mold_line(*state().model, state().settings, asked(), Progress{});
  WrittenMold written = written_mold(
      make_halves(*state().model, line.assignment.direction, meeting_place(line), asked(), Progress{}));
  const fs::path other = folder.parent_path() / "other";
  write_mold(other.string(), {}, state().model->part.unit, written);
  for (const char* name : {"core.stl", "cavity.stl"})
    EXPECT_EQ(bytes_of(folder / name), bytes_of(other / name)) << name;
  const auto json = nlohmann::json::parse(bytes_of(folder / "mold.json"));
  EXPECT_EQ(json["schema"], "moldlight.mold/2");
  EXPECT_EQ(json["parting_line"], mold().line->verdict);
  EXPECT_EQ(json["loops"].size(), 1U);
}

TEST_F(Mold, OpensWithItsSlidesAsSolids) {
  window.app().open((moldlight::test::asset_folder() / "parts" / "enclosure_lid.stl").string());
  window.wait_until_loaded();
  key({.key = 'O'});
  window.wait_until_measured();
  window.settle();
  ASSERT_TRUE(mold().solids) << mold().error;
  ASSERT_TRUE(mold().solids->pieces) << "made in the background";
  const MoldHalves& halves = mold().solids->halves();
  ASSERT_EQ(halves.count(PieceKind::slide), 1U);
  EXPECT_LT(halves.core.volume + halves.cavity.volume,
            mold().solids->plain->core.volume + mold().solids->plain->cavity.volume)
      << "its room is taken out of the halves";
  const auto& shown = mold().solids->shown;
  const auto slide = std::ranges::find(shown, Steel::moved, &ViewSolid::steel);
  ASSERT_NE(slide, shown.end());
  const SteelLook opened{.opened = 1.0, .first = 1.0, .last = 1.0};
  const glm::dvec3 shift = slide->motion.shift(opened, state().settings.direction.unit());
  const SideAction& action = state().actions.plan->actions[halves.inserts.front().action];
  EXPECT_NEAR(glm::dot(shift, action.direction) * state().model->frame.diagonal, action.travel, 1e-6);
  EXPECT_NEAR(glm::dot(shift, state().settings.direction.unit()),
              action.core_side ? k_mold_travel : -k_mold_travel, 1e-6)
      << "with its half";
  const auto places = body_places(state(), 1.0, 1.0, true);
  ASSERT_FALSE(places.empty());
  EXPECT_EQ(places[0][0][0], 0.0) << "the steel is there in place of what shows its way";
  EXPECT_EQ(body_places(state(), 1.0, 1.0, false)[0][0][0], 1.0);
  // Its face beside the part is where the picture has its colour.
  glm::vec3 middle(0.0F);
  for (const ViewVertex& vertex : slide->body.vertices)
    middle += vertex.position / static_cast<float>(slide->body.vertices.size());
  const auto pixel = project(state().camera, window.size(), glm::dvec3(middle) + shift);
  const Colour own = action_colour(halves.inserts.front().action);
  const auto seen = colour_at(glm::vec2(pixel.value_or(glm::dvec2(-1.0))));
  const auto most = [](int r, int g, int b) { return r >= g && r >= b ? 0 : g >= b ? 1 : 2; };
  EXPECT_EQ(most(seen[0], seen[1], seen[2]), most(own.r, own.g, own.b));
}

TEST_F(Mold, IsRefusedWithWhatStandsInTheWay) {
  unfold();
  open(k_open_box);
  window.wait_until_measured();
  ASSERT_EQ(halves_lines(state()).size(), 1U);
  EXPECT_TRUE(halves_lines(state()).front().doubt);
  EXPECT_NE(halves_lines(state()).front().text.find("not closed"), std::string::npos);
  key({.key = 'O'});
  window.settle();
  EXPECT_GT(state().settings.look.open_mold, 0.0) << "its surface opens";
}

TEST_F(Mold, LoopsGoByKeys) {
  open(k_box_part);
  unfold(Step::parting_line);
  for (int k = 0; k < 120 && window.app().focused() != "loops"; ++k) key({.key = k_tab});
  ASSERT_EQ(window.app().focused(), "loops");
  key({.key = k_enter});
  EXPECT_EQ(state().mold_choices.loop, 0U);
}

}  // namespace
}  // namespace moldlight::gui::test
