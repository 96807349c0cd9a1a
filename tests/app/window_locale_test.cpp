// In French, numbers have a decimal comma on screen, but a decimal point in files.
#include <clocale>

#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

class WindowLocale : public WindowTest {
 protected:
  void TearDown() override { qunsetenv("LC_ALL"); }

  QByteArray fileOf(const char* locale, const QString& ending) {
    QFile file(folder.filePath(QLatin1String(locale) + ending));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
    return file.readAll();
  }

  void planAndSave(const char* locale, const QString& language) {
    qputenv("LC_ALL", locale);
    const QString files = folder.filePath(QLatin1String(locale));
    const WindowResult outcome = run(QStringLiteral("sliding-plane"),
                                     QStringLiteral("set alpha 0.9\nplace wall 10,0,600 0,0,0\naction run.start\n"
                                                    "wait solved 20000\nexport %1.csv\nexport %1.json\n"
                                                    "save %1.scenario.json\nopen %1.scenario.json\n"
                                                    "open-path %1.csv\nexpect-path certified\n")
                                         .arg(files),
                                     {QStringLiteral("--language"), language});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  }
};

TEST_F(WindowLocale, FilesAreTheSameInAnyLanguage) {
  constexpr const char* kFrench = "fr_FR.UTF-8";
  if (std::setlocale(LC_ALL, kFrench) == nullptr) GTEST_SKIP() << "the locale fr_FR.UTF-8 is not installed";
  std::setlocale(LC_ALL, "C");
  planAndSave("C.UTF-8", QStringLiteral("en"));
  planAndSave(kFrench, QStringLiteral("fr"));
  for (const char* ending : {".csv", ".json", ".scenario.json"}) {
    EXPECT_FALSE(fileOf("C.UTF-8", QLatin1String(ending)).isEmpty()) << ending;
    EXPECT_EQ(fileOf("C.UTF-8", QLatin1String(ending)), fileOf(kFrench, QLatin1String(ending))) << ending;
  }
}

}  // namespace
