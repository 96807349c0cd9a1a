#include "widgets/places/rules_dialog.h"

#include <gtest/gtest.h>

#include <QDialogButtonBox>

namespace glissade {
namespace {

class RulesDialogTest : public testing::Test {
 protected:
  RulesDialogTest() : dialog(presetRules("gts2"), AttributeTable()) {}

  template <class Widget>
  Widget& find(const char* name) {
    return *dialog.findChild<Widget*>(QLatin1String(name));
  }
  QString trouble() { return find<QLabel>("trouble").text(); }

  RulesDialog dialog;
};

TEST_F(RulesDialogTest, ShowsRulesAndGivesThemBackAsTheyWere) {
  EXPECT_TRUE(dialog.rules() == presetRules("gts2"));
  EXPECT_TRUE(dialog.isSound());
  EXPECT_TRUE(trouble().isEmpty());
}

TEST_F(RulesDialogTest, EveryPresetCanBeReadAndBegunWith) {
  auto& preset = find<QComboBox>("preset");
  for (int i = 1; i < preset.count(); ++i) {
    emit preset.activated(i);
    EXPECT_TRUE(dialog.rules() == presetRules(preset.itemData(i).toString().toStdString())) << i;
  }
  EXPECT_EQ(preset.count(), 5);
}

TEST_F(RulesDialogTest, SaysWhatIsWrongWhileOneWrites) {
  auto& accept = *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  find<QPlainTextEdit>("rule-edge").setPlainText(QStringLiteral("distance * place.hazard"));
  EXPECT_FALSE(dialog.isSound());
  EXPECT_FALSE(accept.isEnabled());
  EXPECT_TRUE(trouble().contains(QStringLiteral("place.hazard"))) << trouble().toStdString();
  find<QPlainTextEdit>("rule-edge").setPlainText(QStringLiteral("distance * \n place.complexity"));
  EXPECT_TRUE(dialog.isSound());
  EXPECT_TRUE(accept.isEnabled());
  EXPECT_EQ(dialog.rules().edge, "distance * place.complexity");
}

TEST_F(RulesDialogTest, PlannersAreChosenByRowsAndTheLastAlwaysHolds) {
  auto& fine = find<QTableWidget>("fine-rules");
  ASSERT_EQ(fine.rowCount(), 2);
  fine.item(0, 0)->setText(QStringLiteral("place.cluttered"));
  fine.item(0, 1)->setCheckState(Qt::Unchecked);
  qobject_cast<QComboBox*>(fine.cellWidget(0, 2))->setCurrentText(QStringLiteral("birrt"));
  EXPECT_TRUE(dialog.rules().fine.front() == (FineRule{"place.cluttered", false, "birrt"}));
  fine.removeRow(1);
  EXPECT_FALSE(dialog.isSound());
}

}  // namespace
}  // namespace glissade
