// Files in the window: saving under another name, recent files.
#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

class FileWindow : public WindowTest {
 protected:
  void expectGood(const WindowResult& result) { EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString(); }
  QByteArray content(const QString& name) const {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll();
  }
};

TEST_F(FileWindow, AScenarioSavedIntoAnotherFolderOpensAndPlansTheSame) {
  ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("there")));
  const QString saved = folder.filePath(QStringLiteral("there/saved.json"));
  const QString plan = QStringLiteral("select-operator expert\naction run.start\nwait solved 20000\nexport %1\n");
  expectGood(run(QStringLiteral("environment-1"),
                 plan.arg(folder.filePath(QStringLiteral("here.path"))) + QStringLiteral("save %1\n").arg(saved)));
  expectGood(run(saved, plan.arg(folder.filePath(QStringLiteral("there.path")))));
  EXPECT_GT(content(QStringLiteral("here.path")).size(), 100);
  EXPECT_EQ(content(QStringLiteral("here.path")), content(QStringLiteral("there.path")));
}

TEST_F(FileWindow, ASecondFileIsAnErrorAndNotForgotten) {
  const WindowResult two = run(QStringLiteral("environment-1"), QString(), {QStringLiteral("another.json")});
  EXPECT_EQ(two.exitCode, 2) << two.errors.toStdString();
  EXPECT_TRUE(two.errors.contains(QStringLiteral("another.json"))) << two.errors.toStdString();
}

/// The product's name is not taken from the part that moves.
TEST_F(FileWindow, TheTitleNamesTheProduct) {
  const QString frame = kSource + QStringLiteral("/samples/pump/frame.obj");
  const QString pump = kSource + QStringLiteral("/samples/pump/pump.obj");
  const QString saved = folder.filePath(QStringLiteral("gearbox.json"));
  expectGood(run(QStringLiteral("environment-1"), QStringLiteral("new-scenario %1 1 Z\nadd-part %2 static 1 Z\n"
                                                                 "expect-title pump*\nexpect-modified yes\nsave %3\n"
                                                                 "expect-title gearbox.json*\nexpect-modified no\n")
                                                      .arg(frame, pump, saved)
                                                      .replace(QLatin1Char('*'), QStringLiteral("[*]"))));
}

TEST_F(FileWindow, AfterSavingElsewhereTheNewFileIsTheOneThatIsSaved) {
  const QString saved = folder.filePath(QStringLiteral("saved.json"));
  const QString original = kSource + QStringLiteral("/samples/environment-1/scenario.json");
  QFile before(original);
  ASSERT_TRUE(before.open(QIODevice::ReadOnly));
  const QByteArray untouched = before.readAll();
  expectGood(
      run(QStringLiteral("environment-1"),
          QStringLiteral("set contact_samples 7\nsave %1\nset contact_samples 10\naction file.save\n").arg(saved)));
  EXPECT_TRUE(content(QStringLiteral("saved.json")).contains("\"contact_samples\": 10"));
  QFile after(original);
  ASSERT_TRUE(after.open(QIODevice::ReadOnly));
  EXPECT_EQ(after.readAll(), untouched);
}

TEST_F(FileWindow, ThePathIsExportedInEveryFormatOfTheRegistryAndInNoOther) {
  const QString solve = QStringLiteral("select-operator expert\naction run.start\nwait solved 20000\n");
  QString exports;
  for (const char* name : {"a.csv", "a.json", "a.path", "a.glb"}) {
    exports += QStringLiteral("export %1\n").arg(folder.filePath(QLatin1String(name)));
  }
  expectGood(run(QStringLiteral("sliding-plane"), solve + exports));
  EXPECT_TRUE(content(QStringLiteral("a.csv")).startsWith("index,"));
  EXPECT_TRUE(content(QStringLiteral("a.json")).startsWith("{"));
  EXPECT_TRUE(content(QStringLiteral("a.glb")).startsWith("glTF"));
  const WindowResult refused = run(QStringLiteral("sliding-plane"), solve + QStringLiteral("export a.xyz\n"));
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_TRUE(refused.errors.contains(QStringLiteral("OMPL columns (.path), Animation (.glb)")))
      << refused.errors.toStdString();
}

}  // namespace
