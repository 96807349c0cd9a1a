#include "widgets/run/interaction_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QSignalSpy>
#include <QStyleOptionComboBox>
#include <QTest>

namespace glissade {
namespace {

class InteractionPanelTest : public testing::Test {
 protected:
  ResearchBox& list(const char* name = "strategy") { return *panel.findChild<ResearchBox*>(QLatin1String(name)); }
  QStringList listed(const char* name = "strategy") {
    QStringList ids;
    for (int i = 0; i < list(name).count(); ++i) {
      if (!list(name).itemData(i).toString().isEmpty()) ids << list(name).itemData(i).toString();
    }
    return ids;
  }
  void choose(int row, const char* name = "strategy") {
    list(name).setCurrentIndex(row);
    emit list(name).activated(row);
  }
  void showRunOf(const char* strategy) {
    SessionSnapshot snapshot;
    snapshot.plannerId = strategy;
    panel.setSnapshot(snapshot);
  }

  InteractionPanel panel;
};

TEST_F(InteractionPanelTest, ListsThreeStrategiesAndTheOthersUnderResearch) {
  showRunOf("gts");
  EXPECT_EQ(listed(), (QStringList{"auto", "by-hand", "gts"}));
  EXPECT_EQ(list().currentText(), QStringLiteral("Layers"));
  QSignalSpy commanded(&panel, &InteractionPanel::commanded);
  choose(list().count() - 1);
  EXPECT_TRUE(commanded.isEmpty()) << "the row is no strategy";
  EXPECT_EQ(list().currentText(), QStringLiteral("Layers"));
  EXPECT_EQ(listed().size(), static_cast<int>(makePlannerRegistry().entries().size()));
  choose(list().findData(QStringLiteral("gt")));
  EXPECT_EQ(commanded.size(), 1);
}

TEST_F(InteractionPanelTest, ShowsAStrategyOfResearchThatIsInForce) {
  showRunOf("ompl-prm");
  EXPECT_EQ(list().chosen(), QStringLiteral("ompl-prm"));
  EXPECT_EQ(listed().size(), static_cast<int>(makePlannerRegistry().entries().size()));
}

TEST_F(InteractionPanelTest, TheNameOfTheStrategyIsNotCut) {
  panel.show();
  const PlannerRegistry planners = makePlannerRegistry();
  for (const int width : {300, 315, 330, 360}) {
    panel.resize(width, 800);
    for (const PlannerEntry& entry : planners.entries()) {
      showRunOf(entry.id.c_str());
      QApplication::processEvents();
      QStyleOptionComboBox option;
      option.initFrom(&list());
      const QRect room =
          list().style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &list());
      EXPECT_GE(room.width(), list().fontMetrics().horizontalAdvance(list().currentText())) << entry.id << width;
    }
  }
}

TEST_F(InteractionPanelTest, ADeviceThatIsNotThereIsGreyAndSaysWhy) {
  const auto hand = std::make_shared<HandInputs>();
  panel.setHand(hand);
  panel.setDevice(kAnyDevice);
  EXPECT_EQ(listed("operator"), QStringList{kAnyDevice});
  choose(list("operator").count() - 1, "operator");
  const auto isGrey = [this](const char* id) {
    const int row = list("operator").findData(QLatin1String(id));
    return !(list("operator").model()->flags(list("operator").model()->index(row, 0)) & Qt::ItemIsEnabled) &&
           list("operator").itemText(row).contains(QStringLiteral("not connected"));
  };
  for (const char* id : {"mouse6d", "gamepad", "left-controller", "right-controller"}) EXPECT_TRUE(isGrey(id)) << id;
  for (const char* id : {kAnyDevice, "keyboard", "expert"}) EXPECT_FALSE(isGrey(id)) << id;
  hand->gamepad.mailbox.connect("Pad");
  list("operator").showPopup();
  EXPECT_FALSE(isGrey("gamepad"));
  EXPECT_EQ(list("operator").itemText(list("operator").findData(QStringLiteral("gamepad"))), QStringLiteral("Gamepad"));
}

}  // namespace
}  // namespace glissade
