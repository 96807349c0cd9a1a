#include "widgets/help/shortcuts_dialog.h"

#include <gtest/gtest.h>

#include <QTest>

#include "app/window/window_actions.h"

namespace glissade {
namespace {

class ShortcutsDialogTest : public testing::Test {
 protected:
  /// Chooses the command's row.
  void choose(const QString& id) {
    for (int row = 0; row < table().rowCount(); ++row) {
      if (table().item(row, 0)->data(Qt::UserRole).toString() == id) table().selectRow(row);
    }
  }
  void press(const QString& button) {
    for (auto* each : dialog_.findChildren<QPushButton*>()) {
      if (each->text() == button && each->isEnabled()) each->click();
    }
  }
  void type(const QString& keys) { dialog_.findChild<QKeySequenceEdit*>()->setKeySequence(QKeySequence(keys)); }
  QTableWidget& table() { return *dialog_.findChild<QTableWidget*>(); }

  QWidget window_;
  ActionCatalogue actions_{windowActions(), &window_};
  ShortcutsDialog dialog_{actions_, &window_};
};

TEST_F(ShortcutsDialogTest, AShortcutIsTakenFromTheCommandThatHasIt) {
  choose("view.fit");
  type("Ctrl+O");
  press("&Assign");
  EXPECT_EQ(dialog_.shortcuts()["view.fit"], QKeySequence("Ctrl+O"));
  EXPECT_TRUE(dialog_.shortcuts()["file.open"].isEmpty());
  EXPECT_EQ(actions_["file.open"]->shortcut(), QKeySequence("Ctrl+O"));  // the dialog itself changes nothing
  choose("file.open");
  press("&Default");
  EXPECT_EQ(dialog_.shortcuts()["file.open"], QKeySequence("Ctrl+O"));
  EXPECT_TRUE(dialog_.shortcuts()["view.fit"].isEmpty());
}

TEST_F(ShortcutsDialogTest, KeysThatSteerAreRefused) {
  choose("view.fit");
  const QKeySequence before = dialog_.shortcuts()["view.fit"];
  for (const char* keys : {"A", "Shift+W", "3"}) {
    type(keys);
    press("&Assign");
    EXPECT_EQ(dialog_.shortcuts()["view.fit"], before) << keys;
  }
  type("F12");
  press("&Assign");
  EXPECT_EQ(dialog_.shortcuts()["view.fit"], QKeySequence("F12"));
}

TEST_F(ShortcutsDialogTest, AShortcutIsRemovedAndCommandsAreFiltered) {
  choose("file.open");
  press("&Remove");
  EXPECT_TRUE(dialog_.shortcuts()["file.open"].isEmpty());
  dialog_.findChild<QLineEdit*>()->setText("ctrl+s");
  int shown = 0;
  for (int row = 0; row < table().rowCount(); ++row) shown += table().isRowHidden(row) ? 0 : 1;
  EXPECT_GT(shown, 0);
  EXPECT_LT(shown, table().rowCount());
}

}  // namespace
}  // namespace glissade
