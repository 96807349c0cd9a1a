// Small widgets of daily use: view cube, scale bar, pace, strategies, commands, log, notices, kept paths.
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest/QTest>

#include <algorithm>
#include <map>

#include "app/window/window_actions.h"
#include "engine/planning/planner.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/notice_bar.h"
#include "widgets/document/path_shelf.h"
#include "widgets/help/command_palette.h"
#include "widgets/help/log_panel.h"
#include "widgets/run/pace_box.h"
#include "widgets/run/strategy_use.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/scale_bar.h"
#include "widgets/scene3d/scene_pick.h"
#include "widgets/scene3d/view_cube.h"

namespace glissade {
namespace {

TEST(ViewCube, LooksFromTheFaceTheEdgeOrTheCornerThatIsClicked) {
  SceneView view;
  QWidget scene;
  scene.resize(640, 480);
  ViewCube cube(view, &scene);
  view.camera().setStandardView(StandardView::Front);
  EXPECT_EQ(*cube.directionAt({46, 46}), -Vector3::UnitY());
  EXPECT_EQ(*cube.directionAt({46, 22}), Vector3(0, -1, 1));
  EXPECT_EQ(*cube.directionAt({70, 22}), Vector3(1, -1, 1));
  EXPECT_FALSE(cube.directionAt({3, 3}));
  Vector3 asked = Vector3::Zero();
  QObject::connect(&cube, &ViewCube::lookFrom, [&](const Vector3& from) { asked = from; });
  QTest::mouseClick(&cube, Qt::LeftButton, {}, {70, 46});
  EXPECT_EQ(asked, Vector3(1, -1, 0));
  view.camera().lookFrom(asked);
  EXPECT_LT((view.camera().R_WV() * Vector3::UnitZ() - asked.normalized()).norm(), 1e-12);
  EXPECT_GT((view.camera().R_WV() * Vector3::UnitY()).z(), 0.99) << "the horizon is level";
  QTest::keyClick(&cube, Qt::Key_Up);
  EXPECT_NEAR(asked.z(), std::sqrt(0.5), 1e-9);
}

TEST(ScaleBar, IsTheLongestRoundLengthThatFits) {
  for (const double unit : {1.0, 0.0254}) {
    for (double perPixel = 1e-7; perPixel < 10.0; perPixel *= 1.37) {
      const ScaleLength scale = roundScale(perPixel, 130.0, unit);
      EXPECT_LE(scale.pixels, 130.0 * (1.0 + 1e-12));
      EXPECT_GT(scale.pixels, 130.0 / 2.51);
      EXPECT_NEAR(scale.metres / perPixel, scale.pixels, 1e-9);
      const double units = scale.metres / unit;
      const double leading = units / std::pow(10.0, std::floor(std::log10(units) + 1e-9));
      EXPECT_TRUE(std::abs(leading - 1) < 1e-6 || std::abs(leading - 2) < 1e-6 || std::abs(leading - 5) < 1e-6);
    }
  }
  EXPECT_EQ(roundScale(0.0, 130.0).metres, 0.0);
}

TEST(CameraProjection, TheRayThroughAPixelMeetsThePointThatIsDrawnThere) {
  const Box3 box(Vector3(-1, -2, 0), Vector3(3, 1, 2));
  for (const bool orthographic : {false, true}) {
    CameraController camera;
    camera.setStandardView(StandardView::Isometric);
    camera.setOrthographic(orthographic);
    camera.fit(box);
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 p = box.corner(static_cast<Box3::CornerType>(corner));
      const auto at = camera.project(p);
      ASSERT_TRUE(at.has_value());
      EXPECT_LE(std::abs(at->y()), 0.5);
      EXPECT_LE(std::abs(at->x()), 0.5 * camera.aspect());
      const Ray ray = rayThrough(camera, at->x(), at->y());
      EXPECT_LT((p - ray.origin).cross(ray.direction).norm(), 1e-9);
    }
    camera.zoomTo(Box3(Vector3(0, 0, 0), Vector3(0.1, 0.1, 0.1)));
    EXPECT_LT(camera.viewHeight(), 0.5);
    EXPECT_LT(camera.nearPlane(), camera.farPlane());
  }
}

TEST(PaceBox, TakesUsualAndTypedPaces) {
  PaceBox box;
  double chosen = -1.0;
  QObject::connect(&box, &PaceBox::paceChosen, [&](double pace) { chosen = pace; });
  const auto type = [&box](const char* text) {
    box.lineEdit()->setText(QLatin1String(text));
    emit box.lineEdit()->editingFinished();
  };
  type("25");
  EXPECT_EQ(chosen, 25.0);
  type("12.5 steps");
  EXPECT_EQ(chosen, 12.5);
  type("fast");
  EXPECT_EQ(box.pace(), 12.5) << "what is no number changes nothing";
  type("1e9999");
  EXPECT_LE(box.pace(), 10000.0);
  type("");
  box.setPace(0.0);
  EXPECT_EQ(box.currentText(), QStringLiteral("Full speed"));
  EXPECT_GT(box.findData(40.0), 0);
}

TEST(StrategyUse, EveryStrategyHasItsGroupAndItsParameters) {
  const PlannerRegistry planners = makePlannerRegistry();
  int main = 0;
  for (const PlannerEntry& entry : planners.entries()) {
    const auto used = parametersInUse(entry, "hand");
    EXPECT_TRUE(used.count(ParameterId::RequiredClearance)) << entry.id;
    EXPECT_EQ(used.count(ParameterId::Alpha) != 0, entry.usesOperator) << entry.id;
    main += isMainStrategy(entry.id) ? 1 : 0;
  }
  EXPECT_EQ(main, 3);
  EXPECT_EQ(parametersInUse(*planners.find("auto"), "hand").size(), 1U);
  EXPECT_EQ(parametersInUse(*planners.find("contact-birrt"), "expert").count(ParameterId::GuidanceRepulsion), 0U);
  EXPECT_EQ(parametersInUse(*planners.find("contact-birrt"), "hand").count(ParameterId::GuidanceRepulsion), 1U);
  EXPECT_EQ(parametersInUse(*planners.find("interactive-birrt"), "expert").count(ParameterId::ContactSamples), 0U);
}

TEST(StrategyUse, AHandTakesPartInTheAutomaticStrategy) {
  EXPECT_EQ(strategyWithHand("auto", "hand"), "by-hand");
  EXPECT_EQ(strategyWithHand("auto", "expert"), "by-hand");
  EXPECT_EQ(strategyWithHand("auto", "none"), "auto");
  for (const char* chosen : {"interactive", "contact-birrt", "gts"})
    EXPECT_EQ(strategyWithHand(chosen, "hand"), chosen);
}

TEST(StrategyUse, APersonLeadsWhereTheStrategyFollowsTheirHand) {
  for (const char* led : {"by-hand", "contact-birrt", "interactive-birrt", "interactive"}) {
    EXPECT_TRUE(isLedByPerson(led, "hand")) << led;
    EXPECT_TRUE(isLedByPerson(led, "keyboard")) << led;
    for (const char* simulated : {"expert", "simulated-haptic", "none"})
      EXPECT_FALSE(isLedByPerson(led, simulated)) << led;
  }
  for (const char* computer : {"auto", "birrt", "gt", "gts"}) EXPECT_FALSE(isLedByPerson(computer, "hand")) << computer;
}

TEST(CommandPalette, FindsByPartsOfANameAndCarriesOut) {
  QObject parent;
  ActionCatalogue actions(windowActions(), &parent);
  EXPECT_EQ(matchingActions(actions, {}).size(), actions.specs().size());
  ASSERT_FALSE(matchingActions(actions, QStringLiteral("export pa")).empty());
  EXPECT_EQ(matchingActions(actions, QStringLiteral("export pa")).front(), actions["file.export"]);
  EXPECT_TRUE(matchingActions(actions, QStringLiteral("zzz")).empty());
  CommandPalette palette(actions, nullptr);
  int triggered = 0;
  QObject::connect(actions["view.top"], &QAction::triggered, [&] { ++triggered; });
  QTest::keyClicks(&palette.field(), QStringLiteral("view.top"));
  QTest::keyClick(&palette.field(), Qt::Key_Return);
  EXPECT_EQ(triggered, 1);
  EXPECT_EQ(palette.result(), QDialog::Accepted);
}

/// A person who comes from another CAD program types its words.
TEST(CommandPalette, FindsBySynonyms) {
  QObject parent;
  const ActionCatalogue actions(windowActions(), &parent);
  const std::map<const char*, const char*> searched{
      {"explode", "panel.sequence"},       {"disassemble", "sequence.plan"},   {"BOM", "sequence.instruction"},
      {"precedence", "sequence.graph"},    {"base", "sequence.stays"},         {"interference", "fits.find"},
      {"undock", "view.reset-layout"},     {"suppress", "assembly.leave-out"}, {"ergonomics", "access.sequence"},
      {"clipping plane", "section.add-x"}, {"mate", "assembly.align"},         {"x-ray", "display.see-through"},
      {"ground", "sequence.stays"},        {"takt", "sequence.times"}};
  for (const auto& [text, id] : searched) {
    const std::vector<QAction*> found = matchingActions(actions, QLatin1String(text));
    EXPECT_EQ(std::count(found.begin(), found.end(), actions[QLatin1String(id)]), 1) << text;
  }
  const std::vector<QAction*> base = matchingActions(actions, QStringLiteral("fix base"));
  ASSERT_FALSE(base.empty());
  EXPECT_EQ(base.front(), actions["sequence.stays"]) << "a name comes before descriptions";
}

TEST(CommandPalette, SaysThatItFindsNothing) {
  QObject parent;
  ActionCatalogue actions(windowActions(), &parent);
  CommandPalette palette(actions, nullptr);
  QTest::keyClicks(&palette.field(), QStringLiteral("zzz"));
  ASSERT_EQ(palette.list().topLevelItemCount(), 1);
  EXPECT_TRUE(palette.list().topLevelItem(0)->text(0).contains(QStringLiteral("zzz")));
  QTest::keyClick(&palette.field(), Qt::Key_Return);
  EXPECT_NE(palette.result(), QDialog::Accepted);
}

TEST(CommandPalette, DoesNotTriggerWhatCannotBeDone) {
  QObject parent;
  ActionCatalogue actions(windowActions(), &parent);
  actions["view.top"]->setEnabled(false);
  CommandPalette palette(actions, nullptr);
  QTest::keyClicks(&palette.field(), QStringLiteral("view.top"));
  EXPECT_EQ(palette.list().currentItem(), nullptr);
  QTest::keyClick(&palette.field(), Qt::Key_Return);
  EXPECT_NE(palette.result(), QDialog::Accepted);
}

TEST(LogPanel, ShowsMessagesFromALevelOn) {
  QObject parent;
  ActionCatalogue actions(windowActions(), &parent);
  MessageLog log;
  LogPanel panel(log, actions);
  log.add(LogLevel::Information, QStringLiteral("one\ntwo"));
  log.add(LogLevel::Error, QStringLiteral("bad"));
  log.add(LogLevel::Error, QStringLiteral("bad"));
  log.add(LogLevel::Warning, QString());
  EXPECT_EQ(panel.lines(), QStringList({"Information: one two", "Error: bad"}));
  panel.setLevel(LogLevel::Warning);
  EXPECT_EQ(panel.lines(), QStringList({"Error: bad"}));
  for (int i = 0; i < 2500; ++i) log.add(LogLevel::Information, QString::number(i));
  EXPECT_EQ(log.entries().size(), 2000U);
}

TEST(DiagnosticText, IsASentence) {
  const Diagnostic why{ErrorKind::InCollision,
                       "",
                       "start",
                       {GLISSADE_TEXT("the object penetrates '%1'"), {"a bolt"}},
                       Message("Move it")};
  EXPECT_EQ(diagnosticText(why), QStringLiteral("The object penetrates 'a bolt'. Move it."));
  EXPECT_EQ(engineText(Message("nobody says this %1")), QStringLiteral("nobody says this %1"));
}

TEST(NoticeBar, HasNamedButtonsThatTabReaches) {
  QObject parent;
  ActionCatalogue actions(windowActions(), &parent);
  QWidget scene;
  scene.resize(500, 400);
  NoticeBar bar(actions, &scene, 100);
  bar.showNotice({QStringLiteral("Title"), QStringLiteral("Details\nof it"), {"refusal.show", "run.start"}});
  EXPECT_FALSE(bar.isHidden());
  EXPECT_LE(bar.geometry().right(), 400);
  EXPECT_EQ(bar.accessibleName(), QStringLiteral("Title"));
  int reached = 0;
  for (const QToolButton* button : bar.findChildren<QToolButton*>()) {
    EXPECT_TRUE(button->focusPolicy() & Qt::TabFocus);
    EXPECT_FALSE((button->accessibleName() + button->text()).isEmpty());
    ++reached;
  }
  EXPECT_EQ(reached, 3);
  QSignalSpy closed(&bar, &NoticeBar::closed);
  QTest::keyClick(&bar, Qt::Key_Escape);
  EXPECT_EQ(closed.count(), 1);
  EXPECT_TRUE(bar.isHidden());
}

KeptPath somePath(const std::string& name, double x) {
  KeptPath path;
  path.name = name;
  path.object = "object";
  path.points = {{Pose::translation({x, 0.0, 0.0})}};
  return path;
}

TEST(PathShelf, EveryChangeIsOneStepBackAndForth) {
  QUndoStack undo;
  PathShelf shelf(undo);
  const auto names = [&shelf] {
    std::string all;
    for (const KeptPathPtr& path : shelf.paths()) all += path->name + (path->pinned ? "* " : " ");
    return all;
  };
  shelf.keep(somePath("a", 1));
  shelf.keep(somePath("a", 2));
  EXPECT_EQ(names(), "a a 2 ");
  EXPECT_TRUE(shelf.holds(somePath("", 2).points));
  EXPECT_FALSE(shelf.holds(somePath("", 3).points));
  EXPECT_TRUE(shelf.pin("a 2", true).ok());
  EXPECT_EQ(names(), "a 2* a ");
  EXPECT_FALSE(shelf.rename("a", "a 2").ok());
  EXPECT_FALSE(shelf.rename("a", "").ok());
  EXPECT_FALSE(shelf.remove("b").ok());
  EXPECT_TRUE(shelf.rename("a", "b").ok());
  EXPECT_TRUE(shelf.remove("a 2").ok());
  EXPECT_EQ(names(), "b ");
  const int steps = undo.count();
  EXPECT_EQ(steps, 5);
  for (int i = 0; i < steps; ++i) undo.undo();
  EXPECT_EQ(names(), "");
  for (int i = 0; i < steps; ++i) undo.redo();
  EXPECT_EQ(names(), "b ");
}

}  // namespace
}  // namespace glissade
