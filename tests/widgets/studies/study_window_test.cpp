// Studies in the window: the page, a run shown again, pictures, PDF, and the page that the command line writes.
#include "tests/app/window_fixture.h"
#include "tests/engine/support/directories.h"

namespace glissade::test {
namespace {

/// A small study of interactive runs, carried out once for all tests.
class StudyWindow : public WindowTest {
 protected:
  static void SetUpTestSuite() {
    results = new QTemporaryDir;
    const QString study = results->filePath(QStringLiteral("study.json"));
    QFile file(study);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QStringLiteral(R"({
      "format": "glissade-study", "version": 1, "name": "small", "title": "Small study", "citation": "A & B",
      "scenarios": ["%1/samples/sliding-plane/scenario.json"], "strategies": ["contact-birrt"],
      "operators": ["expert"], "limits": {"max_steps": 800}, "seeds": {"first": 1, "count": 2},
      "rows": [{"label": "α = 0.2", "parameters": {"alpha": 0.2}}, {"label": "α = 0.8", "parameters": {"alpha": 0.8}}]})")
                   .arg(kSource)
                   .toUtf8());
    file.close();
    const CliResult ran = cli({QStringLiteral("study"), study, QStringLiteral("--out"), out()});
    ASSERT_EQ(ran.exitCode, 0) << ran.errors.toStdString();
  }
  static void TearDownTestSuite() { delete results; }

  struct CliResult {
    int exitCode;
    QByteArray errors;
  };
  static CliResult cli(const QStringList& arguments) {
    QProcess process;
    process.start(QString::fromStdString(test::programDirectory() + "/glissade-cli"), arguments);
    if (!process.waitForFinished(120000)) return {-1, "not finished"};
    return {process.exitCode(), process.readAllStandardError()};
  }
  static QString out() { return results->filePath(QStringLiteral("out")); }
  static QString runFile() { return out() + QStringLiteral("/runs/cell2-seed2.json"); }
  static QByteArray content(const QString& name) {
    QFile file(out() + QLatin1Char('/') + name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll();
  }

  static inline QTemporaryDir* results = nullptr;
};

TEST_F(StudyWindow, ThePageIsWrittenAndARunOfItIsShownAgain) {
  const WindowResult result = run({}, QStringLiteral("study %1\nstudy-run 2 2\nwait ended 1000\n").arg(out()));
  EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString();
  EXPECT_TRUE(content(QStringLiteral("report.html")).contains("runs/cell2-seed2.json"));
}

TEST_F(StudyWindow, TheFileOfARunIsOpenedAsAScenarioIs) {
  const WindowResult result = run(runFile(), QStringLiteral("wait ended 1000\n"));
  EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString();
  const QString lost = folder.filePath(QStringLiteral("cell2-seed2.json"));
  QFile::copy(runFile(), lost);
  const WindowResult refused = run(lost, QString());
  EXPECT_EQ(refused.exitCode, 3);
  EXPECT_TRUE(refused.errors.contains(QStringLiteral("plan.json"))) << refused.errors.toStdString();
}

TEST_F(StudyWindow, WhatIsNotThereIsSaid) {
  EXPECT_NE(run({}, QStringLiteral("study /nowhere\n")).exitCode, 0);
  EXPECT_NE(run({}, QStringLiteral("study-run 1 1\n")).exitCode, 0);
  for (const char* wrong : {"study-run 1 99", "study-run 0 1", "study-run x 1"}) {
    const WindowResult result = run({}, QStringLiteral("study %1\n%2\n").arg(out(), QLatin1String(wrong)));
    EXPECT_EQ(result.exitCode, 3) << wrong;
    EXPECT_TRUE(result.errors.contains(QStringLiteral("line 2"))) << result.errors.toStdString();
  }
}

TEST_F(StudyWindow, PicturesOfTypicalRunsComeIntoThePages) {
  // The command refuses a run that ends otherwise than in the study, so the pictures prove the run of each cell.
  const WindowResult taken =
      run({}, {}, {QStringLiteral("--study-pictures"), out(), QStringLiteral("--report-pdf"), out()});
  EXPECT_EQ(taken.exitCode, 0) << taken.errors.toStdString();
  const QStringList pictures = QDir(out() + QStringLiteral("/pictures")).entryList({QStringLiteral("*.png")});
  ASSERT_FALSE(pictures.isEmpty());
  EXPECT_GT(QImage(out() + QStringLiteral("/pictures/") + pictures.front()).width(), 300);
  EXPECT_TRUE(content(QStringLiteral("report.pdf")).startsWith("%PDF-"));
  EXPECT_EQ(cli({QStringLiteral("report"), out()}).exitCode, 0);
  EXPECT_EQ(content(QStringLiteral("report.html")).count("data:image/png;base64,"), pictures.size());
}

}  // namespace
}  // namespace glissade::test
