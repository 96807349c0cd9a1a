#include "widgets/product/scene_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

class ScenePanelTest : public ::testing::Test {
 protected:
  ScenePanelTest() {
    scenario.problem = windowProblem();
    scenario.object = boxBody("peg", {0.1, 0.1, 0.1}, Pose::identity());
    scenario.objectBodies = {scenario.object};
    scenario.scenario.object.bodies.clear();  // it has no file
    for (const char* name : {"pump/cover/screw", "pump/cover/screw#2", "pump/housing", "plate"}) {
      scenario.obstacles.push_back(boxBody(name, {0.1, 0.1, 0.1}, Pose::identity()));
    }
    std::vector<ProductBody> bodies;
    for (const RigidBody& body : scenario.obstacles) bodies.push_back({body.id, {body.name}});
    scenario.product = Product(bodies);
    panel.setScenario(scenario);
  }

  QTreeWidgetItem* item(const QString& text) const {
    const auto found = panel.findItems(text, Qt::MatchExactly | Qt::MatchRecursive);
    return found.isEmpty() ? nullptr : found.front();
  }

  LoadedScenario scenario;
  ScenePanel panel;
};

TEST_F(ScenePanelTest, BodiesStandUnderTheirAssemblies) {
  ASSERT_NE(item(QStringLiteral("cover")), nullptr);
  EXPECT_EQ(item(QStringLiteral("cover"))->childCount(), 2);
  EXPECT_EQ(item(QStringLiteral("pump"))->childCount(), 2);
  EXPECT_EQ(item(QStringLiteral("screw#2"))->parent(), item(QStringLiteral("cover")));
  EXPECT_EQ(item(QStringLiteral("plate"))->parent(), item(QStringLiteral("pump"))->parent());
}

TEST_F(ScenePanelTest, UncheckingAnAssemblyHidesAllOfItsBodies) {
  QSignalSpy checked(&panel, &ScenePanel::bodyChecked);
  item(QStringLiteral("cover"))->setCheckState(0, Qt::Unchecked);
  QSet<QString> hidden;
  for (const auto& arguments : checked) {
    EXPECT_FALSE(arguments[1].toBool());
    hidden.insert(arguments[0].toString());
  }
  EXPECT_EQ(hidden, (QSet<QString>{QStringLiteral("pump/cover/screw"), QStringLiteral("pump/cover/screw#2")}));
}

TEST_F(ScenePanelTest, SelectingAnAssemblySelectsAllOfItsBodies) {
  QSignalSpy chosen(&panel, &ScenePanel::bodiesChosen);
  item(QStringLiteral("pump"))->setSelected(true);
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].value<QSet<QString>>().size(), 3);
}

/// The row of the start is selected with the moving part. Ctrl+click adds a body.
TEST_F(ScenePanelTest, ABodyIsAddedToTheMovingPart) {
  panel.showSelection({QStringLiteral("peg")}, AssemblyItem{AssemblyItem::Kind::Start, {}});
  QSignalSpy chosen(&panel, &ScenePanel::bodiesChosen);
  QSignalSpy end(&panel, &ScenePanel::endChosen);
  item(QStringLiteral("plate"))->setSelected(true);
  EXPECT_EQ(end.size(), 0);
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].value<QSet<QString>>(), (QSet<QString>{QStringLiteral("peg"), QStringLiteral("plate")}));
}

TEST_F(ScenePanelTest, AnAssemblyIsSelectedWhereAllOfItsBodiesAre) {
  panel.showSelection({QStringLiteral("pump/cover/screw"), QStringLiteral("pump/cover/screw#2")}, std::nullopt);
  EXPECT_TRUE(item(QStringLiteral("cover"))->isSelected());
  EXPECT_FALSE(item(QStringLiteral("pump"))->isSelected());
}

TEST_F(ScenePanelTest, WhatIsLeftOutHasAShortNameAndItsPathAsToolTip) {
  BodyDescription body;
  body.id = "motor.cover.cap";
  body.name = "motor/cover/cap";
  scenario.scenario.leftOut = {body};
  panel.setScenario(scenario);
  ASSERT_NE(item(QStringLiteral("cap")), nullptr);
  EXPECT_TRUE(item(QStringLiteral("cap"))->toolTip(0).contains(QStringLiteral("motor/cover/cap")));
}

TEST_F(ScenePanelTest, NamesAreThoseOfTheFileAndSiblingsOfOneNameAreNumbered) {
  scenario.product = Product({{"pump/cover/screw", {"pump/cover/screw", productNames({"Pump / 1", "", "M3"})}},
                              {"pump/cover/screw#2", {"pump/cover/screw#2", productNames({"Pump / 1", "", "M3"})}},
                              {"pump/housing", {"pump/housing", productNames({"Pump / 1", "H/7"})}}});
  panel.setScenario(scenario);
  EXPECT_NE(item(QStringLiteral("Pump / 1")), nullptr);
  EXPECT_NE(item(QStringLiteral("H/7")), nullptr);
  EXPECT_NE(item(QStringLiteral("cover")), nullptr) << "its name is empty";
  EXPECT_NE(item(QStringLiteral("M3#2")), nullptr);
  EXPECT_NE(item(QStringLiteral("plate")), nullptr) << "no node of the product";
}

TEST_F(ScenePanelTest, TheFilterLeavesWhatMatchesWithItsAssemblies) {
  panel.setFilter(QStringLiteral("HOUS"));
  EXPECT_FALSE(item(QStringLiteral("housing"))->isHidden());
  EXPECT_FALSE(item(QStringLiteral("pump"))->isHidden());
  EXPECT_TRUE(item(QStringLiteral("cover"))->isHidden());
  EXPECT_TRUE(item(QStringLiteral("plate"))->isHidden());
  panel.setFilter(QStringLiteral("cover"));
  EXPECT_FALSE(item(QStringLiteral("screw"))->isHidden());
  panel.setFilter(QString());
  EXPECT_FALSE(item(QStringLiteral("plate"))->isHidden());
}

}  // namespace
}  // namespace glissade
