#include "widgets/workbench/window_memory.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QTemporaryDir>

#include "app/window/window_actions.h"

namespace glissade {
namespace {

class Memory : public testing::Test {
 protected:
  QString file() const { return folder.filePath(QStringLiteral("window.ini")); }
  QTemporaryDir folder;
};

TEST_F(Memory, KeepsTheLastTenFilesTheLatestFirst) {
  {
    WindowMemory memory(file());
    for (int i = 0; i < 12; ++i) memory.noteFile(QStringLiteral("/tmp/%1.json").arg(i));
    memory.noteFile(QStringLiteral("/tmp/5.json"));
  }
  const QStringList files = WindowMemory(file()).recentFiles();
  ASSERT_EQ(files.size(), 10);
  EXPECT_EQ(files[0], QStringLiteral("/tmp/5.json"));
  EXPECT_EQ(files[1], QStringLiteral("/tmp/11.json"));
  EXPECT_EQ(files.count(QStringLiteral("/tmp/5.json")), 1);
}

TEST_F(Memory, FilesAreAbsoluteAndCanBeForgotten) {
  WindowMemory memory(file());
  memory.noteFile(QStringLiteral("near.json"));
  EXPECT_EQ(memory.recentFiles(), QStringList(QDir::current().absoluteFilePath(QStringLiteral("near.json"))));
  memory.forgetFiles();
  EXPECT_TRUE(memory.recentFiles().isEmpty());
}

TEST_F(Memory, KeepsWhereGhostsAreDrawn) {
  PathSpacing spacing;
  EXPECT_EQ(WindowMemory(file()).ghosts(), spacing);
  spacing = {PathSpacing::By::Distance, 12, 0.025};
  WindowMemory(file()).saveGhosts(spacing);
  EXPECT_EQ(WindowMemory(file()).ghosts(), spacing);
  QSettings(file(), QSettings::IniFormat).setValue(QStringLiteral("path/ghosts-number"), -3);
  EXPECT_EQ(WindowMemory(file()).ghosts().number, PathSpacing().number);
}

TEST_F(Memory, KeepsStereoAndIgnoresWhatIsOutOfItsRange) {
  StereoSettings settings;
  settings.mode = StereoMode::Checkerboard;
  settings.swapped = true;
  settings.convergence = Convergence::Pointer;
  settings.screen = {0.6, 0.8, 0.06};
  settings.display = QStringLiteral("HDMI-1");
  WindowMemory(file()).saveStereo(settings);
  const StereoSettings kept = WindowMemory(file()).stereo();
  EXPECT_EQ(kept.mode, settings.mode);
  EXPECT_TRUE(kept.swapped);
  EXPECT_EQ(kept.convergence, settings.convergence);
  EXPECT_EQ(kept.screen, settings.screen);
  EXPECT_EQ(kept.display, settings.display);
  QSettings(file(), QSettings::IniFormat).setValue(QStringLiteral("stereo/distance"), -1.0);
  QSettings(file(), QSettings::IniFormat).setValue(QStringLiteral("stereo/mode"), QStringLiteral("holography"));
  EXPECT_EQ(WindowMemory(file()).stereo().screen.distance, ScreenGeometry().distance);
  EXPECT_EQ(WindowMemory(file()).stereo().mode, StereoMode::Off);
}

TEST_F(Memory, KeepsWorkTimesAndIgnoresThoseOutOfTheirRange) {
  EXPECT_EQ(WindowMemory(file()).workTimes(), WorkTimes());
  WorkTimes times;
  times.fetch = 4.25;
  times.aidAbove = 0.0;
  WindowMemory(file()).saveWorkTimes(times);
  EXPECT_EQ(WindowMemory(file()).workTimes(), times);
  QSettings(file(), QSettings::IniFormat).setValue(QStringLiteral("work-times/fetch_s"), -3);
  EXPECT_EQ(WindowMemory(file()).workTimes().fetch, WorkTimes().fetch);
  WindowMemory(file()).saveWorkTimes(WorkTimes());
  EXPECT_TRUE(QSettings(file(), QSettings::IniFormat).allKeys().isEmpty()) << "defaults may change";
}

TEST_F(Memory, KeepsTheTemplateOfWorkInstructions) {
  EXPECT_TRUE(WindowMemory(file()).instructionTemplate().isEmpty());
  WindowMemory(file()).saveInstructionTemplate(QStringLiteral("/somewhere/look.json"));
  EXPECT_EQ(WindowMemory(file()).instructionTemplate(), QStringLiteral("/somewhere/look.json"));
}

TEST_F(Memory, KeepsPreferencesAndIgnoresSizesThatNobodyCouldRead) {
  EXPECT_EQ(WindowMemory(file()).preferences().language, QString());
  WindowMemory(file()).savePreferences({QStringLiteral("fr"), 12.5});
  EXPECT_EQ(WindowMemory(file()).preferences().language, QStringLiteral("fr"));
  EXPECT_EQ(WindowMemory(file()).preferences().fontPoints, 12.5);
  Preferences chosen;
  chosen.lengthUnit = LengthUnit::Inches;
  chosen.autosaveSeconds = 30;
  chosen.colours.goal = Colour{0.0, 1.0, 0.0};
  WindowMemory(file()).savePreferences(chosen);
  EXPECT_EQ(WindowMemory(file()).preferences().lengthUnit, LengthUnit::Inches);
  EXPECT_EQ(WindowMemory(file()).preferences().autosaveSeconds, 30);
  EXPECT_EQ(WindowMemory(file()).preferences().colours, chosen.colours);
  WindowMemory(file()).savePreferences({QString(), 0.1});
  EXPECT_EQ(WindowMemory(file()).preferences().fontPoints, Preferences{}.fontPoints);
}

TEST(Language, IsThatOfTheCommandLineThenOfThePreferencesThenOfTheDesktop) {
  const QString fr = QStringLiteral("fr");
  EXPECT_EQ(languageOf(fr, {QStringLiteral("en"), 9.0}, QStringLiteral("de")), fr);
  EXPECT_EQ(languageOf(QString(), {fr, 9.0}, QStringLiteral("en")), fr);
  EXPECT_EQ(languageOf(QString(), {}, fr), fr);
  EXPECT_EQ(languageOf(QString(), {}, QStringLiteral("de")), QStringLiteral("en"));
}

TEST_F(Memory, TheLayoutOfEachWorkspaceComesBack) {
  EXPECT_TRUE(WindowMemory(file()).layouts().isEmpty());
  const PanelDocks::Layouts layouts{{Workspace::Assembly, "a"}, {Workspace::Study, "s"}};
  WindowMemory(file()).saveLayouts(layouts, "size");
  EXPECT_EQ(WindowMemory(file()).layouts(), layouts);
  EXPECT_EQ(WindowMemory(file()).windowGeometry(), QByteArray("size"));
}

TEST_F(Memory, TheThemeIsTheDesktopsUntilOneIsChosen) {
  EXPECT_EQ(WindowMemory(file()).preferences().theme, ThemeChoice::Desktop);
  QSettings(file(), QSettings::IniFormat)
      .setValue(QStringLiteral("choices/view.dark"), true);  // the setting of an older version
  EXPECT_EQ(WindowMemory(file()).preferences().theme, ThemeChoice::Dark);
  Preferences chosen;
  chosen.theme = ThemeChoice::Light;
  WindowMemory(file()).savePreferences(chosen);
  EXPECT_EQ(WindowMemory(file()).preferences().theme, ThemeChoice::Light);
}

TEST_F(Memory, ChoicesComeBack) {
  QWidget window;
  {
    ActionCatalogue actions(windowActions(), &window);
    actions["navigation.blender"]->setChecked(true);
    actions["view.orthographic"]->setChecked(true);
    actions.setShortcut("view.fit", QKeySequence("Ctrl+Alt+F"));
    actions.setShortcut("run.start", {});
    WindowMemory(file()).saveChoices(actions);
  }
  QWidget another;
  ActionCatalogue actions(windowActions(), &another);
  WindowMemory(file()).restoreChoices(actions);
  EXPECT_TRUE(actions["navigation.blender"]->isChecked());
  EXPECT_FALSE(actions["navigation.cad"]->isChecked());
  EXPECT_TRUE(actions["view.orthographic"]->isChecked());
  EXPECT_EQ(actions["view.fit"]->shortcut(), QKeySequence("Ctrl+Alt+F"));
  EXPECT_TRUE(actions["run.start"]->shortcut().isEmpty());
  EXPECT_EQ(actions["file.open"]->shortcut(), actions.usualShortcut("file.open"));
}

}  // namespace
}  // namespace glissade
