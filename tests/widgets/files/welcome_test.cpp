#include <gtest/gtest.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeyEvent>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <filesystem>

#include "tests/app/window_fixture.h"
#include "widgets/files/card_grid.h"
#include "widgets/files/sample_scenarios.h"
#include "widgets/workbench/file_dialogs.h"
#include "widgets/workbench/scenario_pictures.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {
namespace {

using test::kSource;

TEST(SampleScenarios, HaveTheNamesAndDescriptionsOfTheirFilesAndPictures) {
  const QString folder = samplesFolder(QString::fromStdString(test::programDirectory()));
  ASSERT_FALSE(folder.isEmpty());
  for (const SampleScenario& sample : sampleScenarios()) {
    QFile file(folder + QLatin1Char('/') + QLatin1String(sample.file));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << sample.file;
    const QJsonObject content = QJsonDocument::fromJson(file.readAll()).object();
    EXPECT_EQ(content.value(QStringLiteral("name")).toString(), QLatin1String(sample.name));
    EXPECT_TRUE(content.value(QStringLiteral("description")).toString().startsWith(QLatin1String(sample.summary)))
        << sample.file;
    QString name = QLatin1String(sample.file);
    name.replace(QLatin1Char('/'), QLatin1Char('-')).remove(QStringLiteral(".json"));
    for (const char* ground : {"light", "dark"}) {
      const QString picture =
          QStringLiteral("%1/resources/welcome/%2-%3.png").arg(kSource, name, QLatin1String(ground));
      EXPECT_EQ(QImage(picture).size(), kScenarioPictureSize) << picture.toStdString();
      EXPECT_LT(QFileInfo(picture).size(), 60000) << "the programs hold all pictures: " << picture.toStdString();
    }
  }
}

TEST(SampleScenarios, AreFoundWhereTheyAreInstalled) {
  const QTemporaryDir root;
  const std::filesystem::path prefix = root.path().toStdString();
  std::filesystem::create_directories(prefix / "libexec/glissade");
  const QString programs = QString::fromStdString((prefix / "libexec/glissade").string());
  EXPECT_TRUE(samplesFolder(programs).isEmpty());
  std::filesystem::create_directories(prefix / "share/glissade/samples/teaching");
  QFile file(root.filePath(QStringLiteral("share/glissade/samples/teaching/scenario.json")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  EXPECT_EQ(samplesFolder(programs), root.filePath(QStringLiteral("share/glissade/samples")));
}

TEST(SampleScenarios, TheFoldersOfTheSearchAreNamedWhereThereAreNone) {
  const QTemporaryDir root;
  ASSERT_TRUE(QDir(root.path()).mkpath(QStringLiteral("build/bin")));
  const QStringList folders = foldersOfSamples(root.filePath(QStringLiteral("build/bin")));
  EXPECT_EQ(folders.front(), root.filePath(QStringLiteral("share/glissade/samples")));
  EXPECT_TRUE(folders.contains(root.filePath(QStringLiteral("samples"))));
}

QImage pictureIn(const QColor& colour) {
  QImage picture(kScenarioPictureSize, QImage::Format_RGB32);
  picture.fill(colour);
  return picture;
}

TEST(PicturesOfScenarios, AreKeptByPathAndRemovedTogether) {
  const QTemporaryDir root;
  const ScenarioPictures pictures(root.filePath(QStringLiteral("pictures")));
  EXPECT_TRUE(pictures.find(QStringLiteral("/a.json")).isNull());
  pictures.keep(QStringLiteral("/a.json"), pictureIn(Qt::red));
  pictures.keep(QStringLiteral("/b.json"), pictureIn(Qt::blue));
  EXPECT_EQ(pictures.find(QStringLiteral("/a.json")).pixelColor(3, 3), QColor(Qt::red));
  EXPECT_EQ(pictures.find(QStringLiteral("/b.json")).pixelColor(3, 3), QColor(Qt::blue));
  pictures.removeAll();
  EXPECT_TRUE(pictures.find(QStringLiteral("/a.json")).isNull());
}

TEST(PicturesOfScenarios, AreNotMoreThanForty) {
  const QTemporaryDir root;
  const ScenarioPictures pictures(root.path());
  for (int i = 0; i < 45; ++i) pictures.keep(QStringLiteral("/%1.json").arg(i), pictureIn(Qt::red));
  EXPECT_EQ(QDir(root.path()).entryList({QStringLiteral("*.png")}).size(), 40);
}

WelcomeEntry entryOf(const QString& file, bool isThere = true) {
  WelcomeEntry entry;
  entry.file = entry.name = file;
  entry.isThere = isThere;
  return entry;
}

void press(QWidget* card, int key) {
  QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
  QCoreApplication::sendEvent(card, &event);
}

TEST(Cards, AreOpenedByEnterAndReachedByArrows) {
  QWidget window;
  CardGrid grid(&window);
  grid.setEntries({entryOf("a"), entryOf("away", false), entryOf("c"), entryOf("d")});
  grid.resize(10000, 400);
  window.show();
  window.activateWindow();
  const auto& cards = grid.cards();
  EXPECT_EQ(cards[0]->accessibleName(), QStringLiteral("a"));
  EXPECT_FALSE(cards[1]->isEnabled());
  cards[0]->setFocus();
  press(cards[0], Qt::Key_Right);
  EXPECT_EQ(window.focusWidget(), cards[2]) << "what is away is passed over";
  press(cards[2], Qt::Key_Left);
  EXPECT_EQ(window.focusWidget(), cards[0]);
  QSignalSpy chosen(&grid, &CardGrid::chosen);
  press(cards[2], Qt::Key_Return);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen.front().front().toString(), QStringLiteral("c"));
}

TEST(Cards, GrowWithTheirTexts) {
  QWidget window;
  CardGrid grid(&window);
  grid.setEntries({entryOf("a"), entryOf("b")});
  const int oneLine = grid.heightForWidth(grid.widest());
  WelcomeEntry large = entryOf("b");
  large.text = QStringLiteral("A cluttered environment of the first paper that needs some lines to be described here");
  grid.setEntries({entryOf("a"), large});
  EXPECT_GT(grid.heightForWidth(grid.widest()), oneLine) << "all cards of a grid have the height of the largest one";
}

TEST(Cards, AreInFewerColumnsWhereThereIsLessRoom) {
  QWidget window;
  CardGrid grid(&window);
  grid.setEntries({entryOf("a"), entryOf("b"), entryOf("c")});
  window.show();
  grid.resize(grid.widest(), 400);
  EXPECT_EQ(grid.cards()[0]->y(), grid.cards()[2]->y());
  grid.resize(200, 400);
  EXPECT_GT(grid.cards()[2]->y(), grid.cards()[1]->y());
  EXPECT_GT(grid.heightForWidth(200), grid.heightForWidth(grid.widest()));
  EXPECT_LE(grid.cards()[2]->geometry().bottom(), grid.heightForWidth(200));
}

TEST(FoldersOfDialogs, AreRememberedByPurposeAcrossSessions) {
  const QTemporaryDir root;
  ASSERT_TRUE(QDir(root.path()).mkdir(QStringLiteral("films")));
  const QString films = root.filePath(QStringLiteral("films"));
  const QString settings = root.filePath(QStringLiteral("window.ini"));
  QWidget window;
  const auto ofScenario = [] { return QStringLiteral("/of-scenario"); };
  {
    WindowMemory memory(settings);
    FileDialogs dialogs(window, ofScenario);
    dialogs.setMemory(&memory);
    EXPECT_EQ(dialogs.folderOf(FilePurpose::Film), QStringLiteral("/of-scenario"));
    dialogs.noteFile(FilePurpose::Film, films + QStringLiteral("/a.mp4"));
    dialogs.noteFile(FilePurpose::Film, QString());
    EXPECT_EQ(dialogs.folderOf(FilePurpose::Film), films);
    EXPECT_EQ(dialogs.folderOf(FilePurpose::Export), QStringLiteral("/of-scenario"));
  }
  WindowMemory memory(settings);
  FileDialogs dialogs(window, ofScenario);
  dialogs.setMemory(&memory);
  EXPECT_EQ(dialogs.folderOf(FilePurpose::Film), films);
  ASSERT_TRUE(QDir(films).removeRecursively());
  EXPECT_EQ(dialogs.folderOf(FilePurpose::Film), QStringLiteral("/of-scenario")) << "the folder is away";
}

}  // namespace
}  // namespace glissade
