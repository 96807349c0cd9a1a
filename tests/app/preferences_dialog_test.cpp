#include "app/window/preferences_dialog.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QtTest>

#include "app/window/window_actions.h"

namespace glissade {
namespace {

class PreferencesDialogTest : public testing::Test {
 protected:
  QComboBox* boxWith(const QString& item) {
    for (QComboBox* box : dialog.findChildren<QComboBox*>()) {
      if (box->findText(item) >= 0) return box;
    }
    return nullptr;
  }

  ActionCatalogue actions{windowActions(), nullptr};
  PreferencesDialog dialog{
      actions,
      {QStringLiteral("fr"), 11.0, LengthUnit::Inches, 20, SceneColours{Colour{1.0, 0.0, 0.0}, {}, {}, {}}},
      nullptr};
};

TEST_F(PreferencesDialogTest, ShowsWhatIsChosen) {
  EXPECT_EQ(dialog.preferences().language, QStringLiteral("fr"));
  EXPECT_EQ(dialog.preferences().fontPoints, 11.0);
  EXPECT_EQ(boxWith(QStringLiteral("Dark"))->currentText(), QStringLiteral("As the desktop"));
}

TEST_F(PreferencesDialogTest, NothingChangesBeforeItIsAccepted) {
  boxWith(QStringLiteral("Dark"))->setCurrentText(QStringLiteral("Dark"));
  boxWith(QStringLiteral("Blender"))->setCurrentText(QStringLiteral("Blender"));
  boxWith(QStringLiteral("English"))->setCurrentText(QStringLiteral("English"));
  EXPECT_FALSE(actions["navigation.blender"]->isChecked());
  dialog.accept();
  EXPECT_EQ(dialog.preferences().theme, ThemeChoice::Dark);
  EXPECT_TRUE(actions["navigation.blender"]->isChecked());
  EXPECT_EQ(dialog.preferences().language, QStringLiteral("en"));
}

TEST_F(PreferencesDialogTest, UnitAutosaveAndColoursAreKeptAndColoursReset) {
  EXPECT_EQ(dialog.preferences().lengthUnit, LengthUnit::Inches);
  EXPECT_EQ(dialog.preferences().autosaveSeconds, 20);
  EXPECT_EQ(dialog.preferences().colours.background, (Colour{1.0, 0.0, 0.0}));
  EXPECT_EQ(dialog.preferences().colours.goal, std::nullopt);
  boxWith(QStringLiteral("Metres"))->setCurrentText(QStringLiteral("Metres"));
  for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
    if (button->text().contains(QStringLiteral("colours"))) button->click();
  }
  EXPECT_EQ(dialog.preferences().lengthUnit, LengthUnit::Metres);
  EXPECT_EQ(dialog.preferences().colours, SceneColours{});
}

}  // namespace
}  // namespace glissade
