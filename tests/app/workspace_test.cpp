// The workspaces of the window, and their panels.
#include <gtest/gtest.h>

#include <QToolBar>

#include <set>
#include <string>

#include "tests/app/whole_window.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

using Names = std::set<std::string>;
using WorkspaceTest = test::WholeWindowTest;

Names shownDocks(const MainWindow& window) {
  Names names;
  for (const QDockWidget* dock : docksInOrder(window)) {
    if (!dock->isHidden()) names.insert(dock->objectName().toStdString());
  }
  return names;
}

void trigger(const MainWindow& window, const char* action) { window.workbench().actions[action]->trigger(); }

const Names kAssembly{"product", "contacts", "sequence"};
const Names kPlanning{"interaction", "run", "path"};

TEST_P(WorkspaceTest, TheWindowHasSevenPanels) {
  const auto window = makeWindow();
  EXPECT_EQ(docksInOrder(*window).size(), 7);
}

TEST_P(WorkspaceTest, AProductOpensInAssemblyAndASampleOfThePapersInPathPlanning) {
  const auto window = makeWindow();
  window->show();
  ASSERT_EQ(window->openScenario(sample("bolted-brackets"), true), std::nullopt);
  EXPECT_EQ(shownDocks(*window), kAssembly);
  ASSERT_EQ(window->openScenario(sample("environment-1"), true), std::nullopt);
  EXPECT_EQ(shownDocks(*window), kPlanning);
}

/// Contacts are a page of their own beside the sequence, with the action that looks for them.
TEST_P(WorkspaceTest, ContactsAreBesideTheSequenceWhichAnotherProductBringsToTheFront) {
  const auto window = makeWindow();
  window->show();
  ASSERT_EQ(window->openScenario(sample("bolted-brackets"), true), std::nullopt);
  const auto* sequence = window->findChild<QDockWidget*>(QStringLiteral("sequence"));
  trigger(*window, "panel.joints");
  QApplication::processEvents();
  EXPECT_EQ(shownDocks(*window), kAssembly);
  EXPECT_TRUE(sequence->visibleRegion().isEmpty());
  ASSERT_EQ(window->openScenario(sample("roller-stand"), true), std::nullopt);
  QApplication::processEvents();
  EXPECT_FALSE(sequence->visibleRegion().isEmpty());
}

TEST_P(WorkspaceTest, EachRemembersItsPanels) {
  const auto window = makeWindow();
  window->show();
  ASSERT_EQ(window->openScenario(sample("environment-1"), true), std::nullopt);
  window->findChild<QDockWidget*>(QStringLiteral("path"))->hide();
  trigger(*window, "panel.log");
  trigger(*window, "workspace.assembly");
  EXPECT_EQ(shownDocks(*window), kAssembly);
  trigger(*window, "workspace.planning");
  EXPECT_EQ(shownDocks(*window), (Names{"interaction", "run", "log"}));
  trigger(*window, "view.reset-layout");
  EXPECT_EQ(shownDocks(*window), kPlanning);
}

TEST_P(WorkspaceTest, ATaskBringsItsPanelsToTheFront) {
  const auto window = makeWindow();
  window->show();
  ASSERT_EQ(window->openScenario(sample("bolted-brackets"), true), std::nullopt);
  trigger(*window, "run.start");
  EXPECT_EQ(shownDocks(*window), kPlanning);
  trigger(*window, "run.stop");
  trigger(*window, "sequence.plan");
  EXPECT_EQ(shownDocks(*window), kAssembly);
  trigger(*window, "workspace.study");
  trigger(*window, "run.start");
  EXPECT_TRUE(window->workbench().actions["workspace.study"]->isChecked());
}

TEST_P(WorkspaceTest, ToolBarsDoNotBelongToAWorkspace) {
  const auto window = makeWindow();
  window->show();
  ASSERT_EQ(window->openScenario(sample("bolted-brackets"), true), std::nullopt);
  const auto* bar = window->findChild<QToolBar*>(QStringLiteral("section"));
  EXPECT_TRUE(bar->isHidden());
  trigger(*window, "section.add-x");
  trigger(*window, "workspace.planning");
  EXPECT_FALSE(bar->isHidden());
  trigger(*window, "section.remove-all");
  trigger(*window, "workspace.assembly");
  EXPECT_TRUE(bar->isHidden());
}

TEST_P(WorkspaceTest, TheCameraIsNotThatOfTheSceneBefore) {
  const auto window = makeWindow();
  ASSERT_EQ(window->openScenario(sample("environment-1"), true), std::nullopt);
  const CameraController& camera = window->workbench().scene.view().camera();
  const Quaternion usual = camera.R_WV();
  trigger(*window, "view.bottom");
  ASSERT_GT(camera.R_WV().angularDistance(usual), 0.1);
  ASSERT_EQ(window->openScenario(sample("bolted-brackets"), true), std::nullopt);
  EXPECT_LT(camera.R_WV().angularDistance(usual), 1e-9);
  EXPECT_TRUE(camera.isFitted());
}

INSTANTIATE_TEST_SUITE_P(Languages, WorkspaceTest, testing::Values("en", "fr"));

}  // namespace
}  // namespace glissade
