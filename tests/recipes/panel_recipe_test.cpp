// Carries out the recipe "Add a panel".
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>

#include "engine/files/scenario_io.h"
#include "tests/engine/support/directories.h"
#include "widgets/document/workbench_document.h"
#include "widgets/help/manual_controller.h"
#include "widgets/help/manual_terms.h"
#include "widgets/workbench/panel_docks.h"

namespace glissade {
namespace {

/// The volume of the workspace, litres.
class VolumePanel final : public QLabel {
 public:
  VolumePanel(WorkbenchDocument& document, QWidget* parent) : QLabel(parent), document_(document) {
    connect(&document, &WorkbenchDocument::changed, this, [this](Changes what) {
      if (what & (Change::Scenario | Change::Arrangement)) showVolume();
    });
  }

  int updates = 0;

 private:
  void showVolume() {
    ++updates;
    setText(QString::number(1000.0 * document_.scenario()->problem.bounds.volume()));
  }

  WorkbenchDocument& document_;
};

class PanelRecipe : public testing::Test {
 protected:
  PanelRecipe() {
    window.setCentralWidget(new QWidget(&window));
    docks.addDock({QStringLiteral("Figures"), "figures", DockPlace::LowerRight, {Workspace::Assembly}});
    docks.add({"figures", QStringLiteral("Volume"), "volume", panel});
    docks.orderTabStops();
    docks.arrange();
  }

  QMainWindow window;
  ActionCatalogue actions{{}, &window};
  PanelDocks docks{window, actions};
  WorkbenchDocument document;
  VolumePanel* panel = new VolumePanel(document, &window);
};

TEST_F(PanelRecipe, TheNewPanelIsADockAtItsPlace) {
  const QList<QDockWidget*> all = docksInOrder(window);
  ASSERT_EQ(all.size(), 1);
  EXPECT_EQ(all.back()->objectName(), QStringLiteral("figures"));
  EXPECT_EQ(window.dockWidgetArea(all.back()), Qt::RightDockWidgetArea);
  EXPECT_TRUE(all.back()->isAncestorOf(panel));
}

TEST_F(PanelRecipe, TheNewPanelReadsTheDocumentWhenItsFlagsAreAnnounced) {
  auto loaded = loadScenario(test::sourceDirectory() + "/samples/teaching/scenario.json");
  ASSERT_TRUE(loaded.ok());
  document.open(std::make_shared<const LoadedScenario>(std::move(*loaded)));
  EXPECT_EQ(panel->updates, 1);
  const double litres = 1000.0 * document.scenario()->problem.bounds.volume();
  EXPECT_EQ(panel->text(), QString::number(litres));
  document.setDemands(QStringLiteral("Demands"), [] {
    SequenceDemands demands;
    demands.stay = {"O1"};
    return demands;
  }());
  EXPECT_EQ(panel->updates, 1);
}

TEST_F(PanelRecipe, TheManualKnowsTheNewPanelByItsTerm) {
  const ManualFacts facts = manualFacts(window, actions);
  ManualTerms terms(facts);
  EXPECT_TRUE(terms.html(QStringLiteral("panel"), QStringLiteral("volume")).contains(QStringLiteral("#panel-volume")));
  EXPECT_TRUE(terms.problems().isEmpty());
}

}  // namespace
}  // namespace glissade
