#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "tests/engine/support/directories.h"
#include "widgets/controls/qt_texts.h"

namespace glissade {
namespace {

TEST(Translation, NothingIsLeftUntranslated) {
  QFile file(QString::fromStdString(test::sourceDirectory() + "/resources/i18n/glissade_fr.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  EXPECT_FALSE(text.contains(QStringLiteral("type=\"unfinished\"")));
  EXPECT_FALSE(text.contains(QStringLiteral("<translation></translation>")));
  EXPECT_GT(text.count(QStringLiteral("<message>")), 150);
}

/// A text of the sources that the catalogue has not is added by the script as an unfinished one.
TEST(Translation, HasEveryTextOfTheSources) {
  const QTemporaryDir folder;
  const QString copy = folder.filePath(QStringLiteral("copy.ts"));
  const QString root = QString::fromStdString(test::sourceDirectory());
  ASSERT_TRUE(QFile::copy(root + QStringLiteral("/resources/i18n/glissade_fr.ts"), copy));
  QProcess script;
  script.start(root + QStringLiteral("/packaging/translations.sh"), {copy});
  ASSERT_TRUE(script.waitForFinished(120000)) << script.errorString().toStdString();
  ASSERT_EQ(script.exitCode(), 0) << script.readAllStandardError().toStdString();
  QFile file(copy);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  const QRegularExpression unfinished(QStringLiteral("<source>([^<]*)</source>\\s*<translation type=\"unfinished\""));
  for (auto each = unfinished.globalMatch(text); each.hasNext();)
    ADD_FAILURE() << each.next().captured(1).toStdString();
}

/// French dialogs once had the English "Cancel".
TEST(Translation, QtsOwnButtonsAreInFrench) {
  QFile file(QString::fromStdString(test::sourceDirectory() + "/resources/i18n/glissade_fr.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  const QString context = text.mid(text.indexOf(QStringLiteral("<name>QPlatformTheme</name>")));
  for (const char* entry : kQtTexts) {
    EXPECT_TRUE(context.contains(QStringLiteral("<source>%1</source>").arg(QLatin1String(entry)))) << entry;
  }
  EXPECT_TRUE(context.contains(QStringLiteral("<translation>Annuler</translation>")));
}

/// French menus once had "Shift+F1" and French texts "Maj+F1".
TEST(Translation, NamesOfKeysAreInFrench) {
  QFile file(QString::fromStdString(test::sourceDirectory() + "/resources/i18n/glissade_fr.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  const QString context = text.mid(text.indexOf(QStringLiteral("<name>QShortcut</name>")));
  for (const char* key : kKeyTexts) {
    EXPECT_TRUE(context.contains(QStringLiteral("<source>%1</source>").arg(QLatin1String(key)))) << key;
  }
  EXPECT_TRUE(context.contains(QStringLiteral("<translation>Maj</translation>")));
}

}  // namespace
}  // namespace glissade
