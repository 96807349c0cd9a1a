#include "widgets/run/interaction_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

namespace glissade {
namespace {

class InteractionPanelTest : public testing::Test {
 protected:
  QComboBox& list() { return *panel.findChild<QComboBox*>(QStringLiteral("strategy")); }
  QStringList strategies() {
    QStringList ids;
    for (int i = 0; i < list().count(); ++i) {
      if (!list().itemData(i).toString().isEmpty()) ids << list().itemData(i).toString();
    }
    return ids;
  }
  void choose(int row) {
    list().setCurrentIndex(row);
    emit list().activated(row);
  }
  void showRunOf(const char* strategy) {
    SessionSnapshot snapshot;
    snapshot.plannerId = strategy;
    panel.setSnapshot(snapshot);
  }

  InteractionPanel panel;
};

TEST_F(InteractionPanelTest, ListsThreeStrategiesAndTheOthersUnderAdvanced) {
  showRunOf("gts");
  EXPECT_EQ(strategies(), (QStringList{"auto", "by-hand", "gts"}));
  EXPECT_EQ(list().currentText(), QStringLiteral("Layers"));
  QSignalSpy commanded(&panel, &InteractionPanel::commanded);
  choose(list().count() - 1);
  EXPECT_TRUE(commanded.isEmpty()) << "the row is no strategy";
  EXPECT_EQ(list().currentText(), QStringLiteral("Layers"));
  EXPECT_EQ(strategies().size(), static_cast<int>(makePlannerRegistry().entries().size()));
  choose(list().findData(QStringLiteral("gt")));
  EXPECT_EQ(commanded.size(), 1);
}

TEST_F(InteractionPanelTest, ShowsAnAdvancedStrategyThatIsInForce) {
  showRunOf("ompl-prm");
  EXPECT_EQ(list().currentData().toString(), QStringLiteral("ompl-prm"));
  EXPECT_EQ(strategies().size(), static_cast<int>(makePlannerRegistry().entries().size()));
}

}  // namespace
}  // namespace glissade
