#include "widgets/product/parts_dialog.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QTest>

#include <cerrno>
#include <set>

#include "tests/engine/support/part_fixture.h"
#include "tests/engine/support/step_files.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

using Purpose = PartsDialog::Purpose;

QString text(const std::string& value) { return QString::fromStdString(value); }

class PartsPage : public testing::Test {
 protected:
  QStringList files() const { return {text(product.tray), text(product.block)}; }
  QString write(const std::string& name, const std::string& content) const {
    return text(product.folder.write(name, content));
  }
  QString pin() const { return text(product.writeBlock("pin.obj", {0, 0, 200})); }

  static QTableWidget& table(const PartsDialog& dialog) { return *dialog.findChild<QTableWidget*>(); }
  static QComboBox& combo(const PartsDialog& dialog, int row, PartsDialog::Column column) {
    return *table(dialog).cellWidget(row, column)->findChild<QComboBox*>();
  }
  /// Chooses an entry of a box as a person does.
  static void choose(const PartsDialog& dialog, int row, PartsDialog::Column column, const char* label) {
    QComboBox& box = combo(dialog, row, column);
    const int index = box.findText(QLatin1String(label));
    ASSERT_GE(index, 0) << label;
    box.setCurrentIndex(index);
    emit box.activated(index);
  }
  static QString size(const PartsDialog& dialog, int row) {
    return table(dialog).item(row, PartsDialog::kSize)->text();
  }
  static QString hint(const PartsDialog& dialog) { return dialog.findChild<QLabel*>(QStringLiteral("hint"))->text(); }
  static bool mayAccept(const PartsDialog& dialog) {
    const bool enabled = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled();
    EXPECT_EQ(enabled, dialog.isComplete());
    return enabled;
  }
  static std::vector<PartRole> roles(const PartsDialog& dialog) {
    std::vector<PartRole> roles;
    for (const PartFile& part : dialog.parts()) roles.push_back(part.role);
    for (std::size_t row = 0; row < roles.size(); ++row) {
      EXPECT_EQ(combo(dialog, static_cast<int>(row), PartsDialog::kRole).currentData().toInt(),
                static_cast<int>(roles[row]));
    }
    return roles;
  }

  static constexpr PartRole kMoves = PartRole::Moves;
  static constexpr PartRole kStatic = PartRole::Static;
  static constexpr PartRole kMobile = PartRole::Mobile;
  test::TrayProduct product;
};

TEST_F(PartsPage, TheSmallestPartMovesUntilSomebodyChooses) {
  PartsDialog dialog(Purpose::NewScenario, files(), true);
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kStatic, kMoves}));
  EXPECT_TRUE(mayAccept(dialog));
  choose(dialog, 0, PartsDialog::kUnit, "mm");
  choose(dialog, 1, PartsDialog::kUnit, "m");
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kMoves, kStatic})) << "a block of 60 m is not the smallest";
  choose(dialog, 0, PartsDialog::kRole, "Stays");
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kStatic, kStatic}));
  EXPECT_FALSE(mayAccept(dialog));
  EXPECT_TRUE(hint(dialog).contains(QStringLiteral("moving part"))) << hint(dialog).toStdString();
  dialog.addFiles({pin()});
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kStatic, kStatic, kStatic}));
}

std::string tetrahedron(double edge) {
  const std::string e = std::to_string(edge);
  return "v 0 0 0\nv " + e + " 0 0\nv 0 " + e + " 0\nv 0 0 " + e + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
}

TEST_F(PartsPage, UnitsAreGuessedAndAskedForWhereTheSizeDoesNotTell) {
  PartsDialog small(Purpose::NewScenario, {write("small.obj", tetrahedron(0.024))}, true);
  EXPECT_EQ(combo(small, 0, PartsDialog::kUnit).currentText(), QStringLiteral("m"));
  EXPECT_EQ(small.parts()[0].unit, 1.0);
  EXPECT_TRUE(hint(small).contains(QStringLiteral("metre"))) << hint(small).toStdString();
  choose(small, 0, PartsDialog::kUnit, "inch");
  EXPECT_EQ(small.parts()[0].unit, 0.0254) << "what a person chooses stays";
  EXPECT_EQ(hint(small), QString());

  PartsDialog doubtful(Purpose::NewScenario, {write("two.obj", tetrahedron(2.0))}, true);
  EXPECT_TRUE(hint(doubtful).contains(QStringLiteral("Is the unit right?"))) << hint(doubtful).toStdString();
  choose(doubtful, 0, PartsDialog::kUnit, "mm");
  EXPECT_EQ(hint(doubtful), QString());
}

TEST_F(PartsPage, PlanarHolesAreClosedOnDemand) {
  const PartsDialog dialog(Purpose::NewScenario, files(), true);
  EXPECT_FALSE(dialog.parts()[0].closeHoles);
  auto* box = dialog.findChild<QCheckBox*>(QStringLiteral("close-holes"));
  ASSERT_NE(box, nullptr);
  box->setChecked(true);
  EXPECT_TRUE(dialog.parts()[0].closeHoles);
  EXPECT_TRUE(dialog.parts()[1].closeHoles);
}

TEST_F(PartsPage, AFinenessIsThatOfStepFiles) {
  const PartsDialog dialog(Purpose::NewScenario, {files()[0], text(test::stepFile("box.step"))}, true);
  EXPECT_EQ(dialog.parts().back().deflection, 0.0) << "by the size of each part";
  auto* box = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("fineness"));
  ASSERT_NE(box, nullptr);
  box->setValue(0.05);
  EXPECT_DOUBLE_EQ(dialog.parts().back().deflection, 5e-5);
  EXPECT_EQ(dialog.parts().front().deflection, 0.0) << "of a mesh";
}

TEST_F(PartsPage, GroupsOfAnObjFileAreRowsOnDemand) {
  const QString file = write("two.obj", "g a\n" + tetrahedron(20.0) + "g b\nv 90 0 0\nv 99 0 0\nv 90 9 0\nv 90 0 9\n" +
                                            "f 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n");
  PartsDialog dialog(Purpose::NewScenario, {file, text(product.tray)}, true);
  EXPECT_EQ(table(dialog).rowCount(), 2);
  auto* groups = dialog.findChild<QCheckBox*>(QStringLiteral("apart"));
  groups->setChecked(true);
  ASSERT_EQ(table(dialog).rowCount(), 3);
  EXPECT_EQ(table(dialog).item(0, PartsDialog::kPart)->text(), QStringLiteral("two.obj: a"));
  EXPECT_EQ(table(dialog).item(1, PartsDialog::kPart)->text(), QStringLiteral("two.obj: b"));
  EXPECT_EQ(dialog.parts()[1].part, "b");
  EXPECT_TRUE(mayAccept(dialog));
  groups->setChecked(false);
  EXPECT_EQ(table(dialog).rowCount(), 2);
  EXPECT_EQ(dialog.parts()[0].part, "");
  EXPECT_TRUE(mayAccept(dialog));
}

TEST_F(PartsPage, SolidsOfACadPartAreRowsOnDemand) {
  PartsDialog dialog(Purpose::NewScenario, {text(test::stepFile("frames.step"))}, true);
  EXPECT_EQ(table(dialog).rowCount(), 3);
  auto* apart = dialog.findChild<QCheckBox*>(QStringLiteral("apart"));
  apart->setChecked(true);
  ASSERT_EQ(table(dialog).rowCount(), 5);
  EXPECT_EQ(dialog.parts()[1].part, "frame/solid#2");
  EXPECT_TRUE(mayAccept(dialog));
  apart->setChecked(false);
  EXPECT_EQ(table(dialog).rowCount(), 3);
  EXPECT_EQ(dialog.parts()[0].part, "frame");
}

TEST_F(PartsPage, ARowHasItsBoxesFromWhenItIsSeen) {
  QStringList many;
  for (int i = 0; i < 60; ++i) many << write("part" + std::to_string(i) + ".obj", tetrahedron(20.0 + i));
  PartsDialog dialog(Purpose::NewScenario, many, true);
  EXPECT_EQ(dialog.parts().size(), 60U);
  EXPECT_NE(table(dialog).cellWidget(0, PartsDialog::kRole), nullptr);
  EXPECT_EQ(table(dialog).cellWidget(59, PartsDialog::kRole), nullptr);
  dialog.show();
  table(dialog).scrollToBottom();
  ASSERT_NE(table(dialog).cellWidget(59, PartsDialog::kRole), nullptr);
  EXPECT_EQ(combo(dialog, 59, PartsDialog::kRole).currentText(), QStringLiteral("Stays"));
}

TEST_F(PartsPage, ChoosingThePartThatMovesTakesItFromTheOther) {
  PartsDialog dialog(Purpose::NewScenario, files(), true);
  choose(dialog, 0, PartsDialog::kRole, "Moves: its path is planned");
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kMoves, kStatic}));
  choose(dialog, 1, PartsDialog::kRole, "Stays, could be moved aside");
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kMoves, kMobile}));
  EXPECT_TRUE(mayAccept(dialog));
}

TEST_F(PartsPage, WhatItGivesIsAScenario) {
  const PartsDialog dialog(Purpose::NewScenario, files(), true);
  const auto scenario = scenarioOfParts(dialog.parts());
  ASSERT_TRUE(scenario) << toString(scenario.error());
  EXPECT_EQ(scenario->object.first().id, "block");
}

TEST_F(PartsPage, AddedPartsDoNotMove) {
  PartsDialog dialog(Purpose::AddParts, files(), true);
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kStatic, kStatic}));
  EXPECT_EQ(combo(dialog, 0, PartsDialog::kRole).count(), 2);
  EXPECT_TRUE(mayAccept(dialog));
  choose(dialog, 1, PartsDialog::kRole, "Stays, could be moved aside");
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kStatic, kMobile}));
}

/// The scenario that is open is another one.
TEST_F(PartsPage, TheSizeOfANewScenarioIsInTheUnitOfItsFile) {
  setLengthUnit(LengthUnit::Metres);
  const PartsDialog dialog(Purpose::NewScenario, {text(test::stepFile("box.step"))}, true);
  EXPECT_TRUE(size(dialog, 0).endsWith(QStringLiteral(" mm"))) << size(dialog, 0).toStdString();
  setPreferredLengthUnit(LengthUnit::Metres);
  const PartsDialog preferred(Purpose::NewScenario, {text(test::stepFile("box.step"))}, true);
  EXPECT_TRUE(size(preferred, 0).endsWith(QStringLiteral(" m"))) << size(preferred, 0).toStdString();
  setPreferredLengthUnit(std::nullopt);
  setLengthUnit(LengthUnit::Millimetres);
}

TEST_F(PartsPage, TheSizeFollowsUnitAndAxis) {
  const QLocale before;
  QLocale::setDefault(QLocale::c());
  PartsDialog dialog(Purpose::NewScenario, files(), true);
  EXPECT_EQ(size(dialog, 1), QStringLiteral("60.0 × 40.0 × 30.0 mm"));
  choose(dialog, 1, PartsDialog::kUp, "Y");
  EXPECT_EQ(size(dialog, 1), QStringLiteral("60.0 × 30.0 × 40.0 mm"));
  choose(dialog, 1, PartsDialog::kUnit, "inch");
  EXPECT_EQ(size(dialog, 1), QStringLiteral("1524 × 762 × 1016 mm"));
  EXPECT_EQ(dialog.parts()[1].unit, 0.0254);
  EXPECT_EQ(dialog.parts()[1].up, UpAxis::Y);
  EXPECT_EQ(dialog.parts()[0].unit, 0.001);
  QLocale::setDefault(before);
}

TEST_F(PartsPage, AUnitIsOfAllSelectedRows) {
  PartsDialog dialog(Purpose::NewScenario, files() << pin(), true);
  table(dialog).setRangeSelected({0, 0, 1, PartsDialog::kSize}, true);
  choose(dialog, 1, PartsDialog::kUnit, "cm");
  choose(dialog, 0, PartsDialog::kUp, "Y");
  choose(dialog, 2, PartsDialog::kUnit, "inch");
  const std::vector<PartFile> parts = dialog.parts();
  EXPECT_EQ(parts[0].unit, 0.01);
  EXPECT_EQ(parts[1].unit, 0.01);
  EXPECT_EQ(parts[2].unit, 0.0254) << "not one of those selected";
  EXPECT_EQ(parts[0].up, UpAxis::Y);
  EXPECT_EQ(parts[1].up, UpAxis::Y);
  EXPECT_EQ(parts[2].up, UpAxis::Z);
}

TEST_F(PartsPage, AUrdfFileIsInMetresWhateverIsSelected) {
  const QString post = write("post.urdf",
                             "<robot name=\"r\"><link name=\"post\"><collision><geometry><box size=\"1 1 3\"/>"
                             "</geometry></collision></link></robot>");
  PartsDialog dialog(Purpose::NewScenario, files() << post, true);
  EXPECT_FALSE(combo(dialog, 2, PartsDialog::kUnit).isEnabled());
  EXPECT_FALSE(combo(dialog, 2, PartsDialog::kUp).isEnabled());
  table(dialog).selectAll();
  choose(dialog, 0, PartsDialog::kUnit, "inch");
  EXPECT_EQ(dialog.parts()[2].unit, 1.0);
  EXPECT_EQ(combo(dialog, 2, PartsDialog::kUnit).currentText(), QStringLiteral("m"));
  EXPECT_TRUE(scenarioOfParts(dialog.parts()));
}

TEST_F(PartsPage, EveryPartOfAStepFileIsARow) {
  PartsDialog dialog(Purpose::NewScenario, {files()[0], text(test::stepFile("unit.step")), files()[1]}, true);
  std::vector<std::string> names;
  for (const PartFile& part : dialog.parts()) names.push_back(part.part);
  EXPECT_EQ(names, (std::vector<std::string>{"", "plate", "pin", "pin#2", "pump/housing", "pump/Läufer", ""}));
  EXPECT_EQ(table(dialog).item(5, PartsDialog::kPart)->text(), QStringLiteral("unit.step: pump/Läufer"));
  EXPECT_EQ(roles(dialog)[5], kMoves) << "the smallest";
  EXPECT_FALSE(combo(dialog, 1, PartsDialog::kUnit).isEnabled());
  choose(dialog, 2, PartsDialog::kRole, "Moves: its path is planned");
  table(dialog).selectAll();
  choose(dialog, 0, PartsDialog::kUnit, "inch");
  EXPECT_EQ(dialog.parts()[0].unit, 0.0254);
  EXPECT_EQ(dialog.parts()[1].unit, 1.0);
  EXPECT_TRUE(mayAccept(dialog));
  table(dialog).clearSelection();
  table(dialog).selectRow(1);
  dialog.findChild<QPushButton*>(QStringLiteral("remove"))->click();
  GeometryCache read = dialog.read();
  const auto scenario = scenarioOfParts(dialog.parts(), &read);
  ASSERT_TRUE(scenario) << toString(scenario.error());
  EXPECT_EQ(scenario->object.first().id, "pin");
  EXPECT_EQ(scenario->bodies.size(), 5U);
}

TEST_F(PartsPage, AStepFileOfOnePartIsOneRow) {
  const PartsDialog dialog(Purpose::NewScenario, {text(test::stepFile("box.step"))}, true);
  ASSERT_EQ(dialog.parts().size(), 1U);
  EXPECT_EQ(dialog.parts()[0].part, "");
  EXPECT_TRUE(mayAccept(dialog));
}

TEST_F(PartsPage, ARoleIsOfAllSelectedRows) {
  PartsDialog dialog(Purpose::NewScenario, files() << pin(), true);
  choose(dialog, 1, PartsDialog::kRole, "Moves: its path is planned");
  table(dialog).setRangeSelected({0, 0, 2, PartsDialog::kSize}, true);
  choose(dialog, 2, PartsDialog::kRole, "Stays, could be moved aside");
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kMobile, kMobile, kMobile}));
  choose(dialog, 0, PartsDialog::kRole, "Moves: its path is planned");
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kMoves, kMoves, kMoves})) << "as one";
  table(dialog).clearSelection();
  choose(dialog, 1, PartsDialog::kRole, "Moves: its path is planned");
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kStatic, kMoves, kStatic})) << "what has moved before does not";
}

TEST_F(PartsPage, WhatCannotBeReadIsSaidAndHoldsUpTheRest) {
  const QString broken = write("broken.stl", "solid a\nfacet");
  PartsDialog dialog(Purpose::NewScenario, files() << broken, true);
  EXPECT_FALSE(mayAccept(dialog));
  EXPECT_EQ(roles(dialog), (std::vector<PartRole>{kStatic, kMoves, kStatic}));
  EXPECT_TRUE(table(dialog).item(2, PartsDialog::kSize)->toolTip().contains(QStringLiteral("endsolid")));
  EXPECT_TRUE(hint(dialog).contains(QStringLiteral("broken.stl"))) << hint(dialog).toStdString();
  table(dialog).selectRow(2);
  dialog.findChild<QPushButton*>(QStringLiteral("remove"))->click();
  EXPECT_EQ(dialog.parts().size(), 2U);
  EXPECT_TRUE(mayAccept(dialog));
}

TEST_F(PartsPage, DeleteTakesTheSelectedRowsOut) {
  PartsDialog dialog(Purpose::NewScenario, files() << pin(), true);
  dialog.show();
  dialog.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
  table(dialog).setFocus();
  table(dialog).setRangeSelected({0, 0, 1, PartsDialog::kSize}, true);
  QTest::keyClick(&table(dialog), Qt::Key_Delete);
  ASSERT_EQ(dialog.parts().size(), 1U);
  EXPECT_EQ(dialog.parts()[0].path, pin().toStdString());
  EXPECT_EQ(table(dialog).rowCount(), 1);
  choose(dialog, 0, PartsDialog::kUnit, "m");
  EXPECT_EQ(dialog.parts()[0].unit, 1.0);
}

TEST_F(PartsPage, AFileIsListedOnce) {
  PartsDialog dialog(Purpose::NewScenario, files(), true);
  dialog.addFiles(files() << QFileInfo(files().front()).path() + QStringLiteral("/../") +
                                 QFileInfo(text(product.folder.path())).fileName() + QStringLiteral("/tray.obj"));
  EXPECT_EQ(dialog.parts().size(), 2U);
}

TEST_F(PartsPage, WithoutFilesItAsksForThem) {
  const PartsDialog dialog(Purpose::NewScenario, {}, true);
  EXPECT_FALSE(mayAccept(dialog));
  EXPECT_TRUE(hint(dialog).contains(QStringLiteral("files"))) << hint(dialog).toStdString();
  EXPECT_FALSE(dialog.findChild<QPushButton*>(QStringLiteral("remove"))->isEnabled());
}

TEST_F(PartsPage, FilesAreMeasuredOneAfterTheOtherInTheBackground) {
  PartsDialog dialog(Purpose::NewScenario, files() << pin(), false);
  EXPECT_FALSE(mayAccept(dialog));
  EXPECT_EQ(size(dialog, 0), QStringLiteral("…"));
  table(dialog).selectRow(0);  // the file that is being read
  dialog.findChild<QPushButton*>(QStringLiteral("remove"))->click();
  dialog.addFiles({write("broken.stl", "solid a\nfacet")});
  ASSERT_TRUE(QTest::qWaitFor([&] { return size(dialog, 2) == QStringLiteral("cannot be read"); }, 20000));
  EXPECT_TRUE(size(dialog, 0).endsWith(QStringLiteral("mm"))) << size(dialog, 0).toStdString();
  EXPECT_TRUE(size(dialog, 1).endsWith(QStringLiteral("mm"))) << size(dialog, 1).toStdString();
}

TEST_F(PartsPage, ClosingDoesNotWaitForTheRest) {
  for (int i = 0; i < 5; ++i) PartsDialog(Purpose::NewScenario, files(), false).reject();
  // No import process is left behind.
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST_F(PartsPage, EveryChoiceIsReachedByTab) {
  PartsDialog dialog(Purpose::NewScenario, files(), true);
  dialog.show();
  dialog.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
  table(dialog).setFocus();
  std::set<const QWidget*> reached;
  for (int i = 0; i < 20; ++i) {
    reached.insert(QApplication::focusWidget());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  for (const QComboBox* box : dialog.findChildren<QComboBox*>()) {
    EXPECT_TRUE(reached.count(box)) << box->accessibleName().toStdString();
    EXPECT_FALSE(box->toolTip().isEmpty());
  }
  for (const QPushButton* button : dialog.findChildren<QPushButton*>()) {
    EXPECT_TRUE(reached.count(button) || !button->isEnabled()) << button->text().toStdString();
  }
}

}  // namespace
}  // namespace glissade
