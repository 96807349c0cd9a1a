#include "widgets/sequence/work_times_editor.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>
#include <QLocale>
#include <QShortcut>
#include <QSignalSpy>
#include <QtTest>

#include "widgets/sequence/work_time_texts.h"

namespace glissade {
namespace {

constexpr std::size_t kFetch = 4;
enum Column { kName, kValue, kUnit, kDefault };

class WorkTimesEditorTest : public ::testing::Test {
 protected:
  WorkTimesEditorTest() : editor(nullptr), table(editor.findChild<QTableWidget*>()) {
    QLocale::setDefault(QLocale(QStringLiteral("en")));
    QObject::connect(&editor, &WorkTimesEditor::edited, &editor, [this](const WorkTimes& times) {
      ++edits;
      editor.setTimes(times);
    });
  }

  QPushButton* button(const char* id) const { return editor.findChild<QPushButton*>(QLatin1String(id)); }
  QTableWidgetItem* cell(std::size_t row, int column) const { return table->item(static_cast<int>(row), column); }

  WorkTimesEditor editor;
  QTableWidget* table;
  int edits = 0;
};

TEST_F(WorkTimesEditorTest, HasNameUnitDefaultAndSourceOfEveryRow) {
  ASSERT_EQ(table->rowCount(), static_cast<int>(workTimeRows().size()));
  EXPECT_EQ(cell(kFetch, kName)->text(), QStringLiteral("Fetch a part"));
  EXPECT_EQ(cell(kFetch, kValue)->text(), QStringLiteral("1.95"));
  EXPECT_EQ(cell(kFetch, kUnit)->text(), QStringLiteral("s"));
  EXPECT_EQ(cell(0, kUnit)->text(), QStringLiteral("m"));
  EXPECT_EQ(cell(2, kUnit)->text(), QStringLiteral("kg"));
  for (int row = 0; row < table->rowCount(); ++row) {
    EXPECT_TRUE(table->item(row, kValue)->toolTip().contains(QStringLiteral("Boothroyd")));
    EXPECT_TRUE(table->item(row, kValue)->flags() & Qt::ItemIsEditable);
    EXPECT_FALSE(table->item(row, kDefault)->flags() & Qt::ItemIsEditable);
  }
  EXPECT_TRUE(cell(kFetch, kValue)->toolTip().contains(QStringLiteral("Default: 1.95 s")));
}

TEST_F(WorkTimesEditorTest, AValueIsEditedWithTheKeyboardAndSeenAsChanged) {
  editor.show();
  QApplication::setActiveWindow(&editor);
  table->setFocus();
  table->setCurrentCell(static_cast<int>(kFetch), kValue);
  QTest::keyClick(table, Qt::Key_F2);
  auto* field = table->findChild<QLineEdit*>();
  ASSERT_NE(field, nullptr);
  QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(field, QStringLiteral("3.5"));
  QTest::keyClick(field, Qt::Key_Return);
  QApplication::processEvents();  // the editor takes the value at this event
  EXPECT_EQ(edits, 1);
  EXPECT_EQ(editor.times().fetch, 3.5);
  EXPECT_TRUE(cell(kFetch, kValue)->font().bold());
  EXPECT_FALSE(cell(kFetch + 1, kValue)->font().bold());
  EXPECT_EQ(editor.findChild<QLabel*>(QStringLiteral("times-changed"))->text(),
            QStringLiteral("Changed values: 1 of 18"));
  editor.write(kFetch, QStringLiteral("1.95"));
  EXPECT_FALSE(cell(kFetch, kValue)->font().bold());
  EXPECT_EQ(editor.times(), WorkTimes());
}

TEST_F(WorkTimesEditorTest, WhatIsOutOfItsRangeOrNoNumberIsRefusedAsTheReaderDoes) {
  for (const char* wrong : {"3601", "-1", "inf", "nan"}) {
    editor.write(kFetch, QLatin1String(wrong));
    EXPECT_TRUE(editor.trouble().contains(QStringLiteral("is not from 0 to 3600"))) << editor.trouble().toStdString();
    EXPECT_TRUE(editor.trouble().contains(QLatin1String(wrong)));
    EXPECT_EQ(cell(kFetch, kValue)->text(), QStringLiteral("1.95"));
  }
  editor.write(kFetch, QStringLiteral("soon"));
  EXPECT_TRUE(editor.trouble().contains(QStringLiteral("is not a number"))) << editor.trouble().toStdString();
  EXPECT_EQ(edits, 0);
  editor.write(kFetch, QStringLiteral("2"));
  EXPECT_TRUE(editor.trouble().isEmpty());
  EXPECT_EQ(edits, 1);
}

TEST_F(WorkTimesEditorTest, SelectedOrAllValuesAreReset) {
  WorkTimes times;
  times.fetch = 3.0;
  times.hold = 4.0;
  editor.setTimes(times);
  table->selectRow(static_cast<int>(kFetch) + 1);
  EXPECT_FALSE(button("times-reset")->isEnabled());
  table->selectRow(static_cast<int>(kFetch));
  ASSERT_TRUE(button("times-reset")->isEnabled());
  button("times-reset")->click();
  times.fetch = WorkTimes().fetch;
  EXPECT_EQ(editor.times(), times);
  button("times-reset-all")->click();
  EXPECT_EQ(editor.times(), WorkTimes());
  EXPECT_FALSE(button("times-reset-all")->isEnabled());
}

TEST_F(WorkTimesEditorTest, FilesAndUndoAreAskedFor) {
  const QSignalSpy open(&editor, &WorkTimesEditor::openRequested);
  const QSignalSpy save(&editor, &WorkTimesEditor::saveRequested);
  const QSignalSpy undo(&editor, &WorkTimesEditor::undoRequested);
  const QSignalSpy redo(&editor, &WorkTimesEditor::redoRequested);
  button("times-open")->click();
  button("times-save")->click();
  button("times-undo")->click();
  EXPECT_EQ(undo.count(), 0) << "there is nothing to be undone";
  editor.setCanUndo(true);
  editor.setCanRedo(true);
  button("times-undo")->click();
  button("times-redo")->click();
  EXPECT_EQ(open.count() + save.count() + undo.count() + redo.count(), 4);
}

TEST_F(WorkTimesEditorTest, EveryButtonHasAnIdAToolTipAndAMnemonicOfItsOwn) {
  QString mnemonics;
  for (const QPushButton* one : editor.findChildren<QPushButton*>()) {
    EXPECT_TRUE(one->objectName().startsWith(QStringLiteral("times-")));
    EXPECT_FALSE(one->toolTip().isEmpty());
    const int mark = one->text().indexOf(QLatin1Char('&'));
    ASSERT_GE(mark, 0) << one->text().toStdString();
    const QChar letter = one->text()[mark + 1].toLower();
    EXPECT_FALSE(mnemonics.contains(letter)) << one->text().toStdString();
    mnemonics += letter;
  }
  EXPECT_EQ(mnemonics.size(), 6);
}

TEST_F(WorkTimesEditorTest, NumbersAreWrittenAndReadAsTheLanguageDoes) {
  EXPECT_EQ(workTimeIn(QStringLiteral("1,950")), std::nullopt) << "thousands are not separated";
  QLocale::setDefault(QLocale(QStringLiteral("fr")));
  EXPECT_EQ(workTimeText(1.95), QStringLiteral("1,95"));
  EXPECT_EQ(workTimeText(1234.5), QStringLiteral("1234,5"));
  EXPECT_EQ(workTimeIn(QStringLiteral(" 1,95 ")), 1.95);
  EXPECT_EQ(workTimeIn(QStringLiteral("1.95")), 1.95);
  EXPECT_EQ(workTimeIn(QStringLiteral("1,9,5")), std::nullopt);
  QLocale::setDefault(QLocale(QStringLiteral("en")));
}

}  // namespace
}  // namespace glissade
