// Studies in the window: the browser, a run shown again, pictures, PDF, and the page that the command line writes.
#include <QMouseEvent>
#include <QTest>
#include <QTreeWidget>
#include <QXmlStreamReader>

#include "tests/app/window_fixture.h"
#include "tests/engine/support/directories.h"
#include "widgets/plots/plot_view.h"
#include "widgets/studies/study_browser.h"

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
      "format": "glissade-study", "version": 1, "name": "small", "title": "Small <study> of α", "citation": "A & B",
      "paper": [{"key": "nodes", "title": "Nodes", "measure": "nodes", "statistic": "median", "over": "solved"}],
      "scenarios": ["%1/samples/sliding-plane/scenario.json"], "strategies": ["contact-birrt"],
      "operators": ["expert", "none"], "limits": {"max_steps": 800}, "seeds": {"first": 1, "count": 2},
      "rows": [{"label": "α = 0.2", "parameters": {"alpha": 0.2}, "paper": {"nodes": 40}},
               {"label": "α = 0.8", "parameters": {"alpha": 0.8}}],
      "findings": [{"text": "Nobody needs a thousand nodes.", "measure": "nodes", "statistic": "median",
                    "over": "all", "cells": {}, "is": "below", "than": 1000}]})")
                   .arg(kSource)
                   .toUtf8());
    file.close();
    QProcess process;
    process.start(QString::fromStdString(test::programDirectory() + "/glissade-cli"),
                  {QStringLiteral("study"), study, QStringLiteral("--out"), out()});
    ASSERT_TRUE(process.waitForFinished(120000));
    ASSERT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
  }
  static void TearDownTestSuite() { delete results; }

  static QString out() { return results->filePath(QStringLiteral("out")); }
  static QByteArray content(const QString& name) {
    QFile file(out() + QLatin1Char('/') + name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll();
  }

  static inline QTemporaryDir* results = nullptr;
};

TEST_F(StudyWindow, ThePageIsWellFormedAndHasAPlotForEachQuantity) {
  QXmlStreamReader page(content(QStringLiteral("report.html")));
  int plots = 0;
  while (!page.atEnd()) {
    if (page.readNext() == QXmlStreamReader::StartElement && page.name() == QLatin1String("svg")) ++plots;
  }
  EXPECT_FALSE(page.hasError()) << page.errorString().toStdString() << " in line " << page.lineNumber();
  EXPECT_EQ(plots, 2);
}

TEST_F(StudyWindow, ARunIsShownAgainAndEndsAsInTheStudy) {
  const QString picture = folder.filePath(QStringLiteral("browser.png"));
  const WindowResult result = run({}, QStringLiteral("study %1\nstudy-cell 3\nstudy-run 3 2\nwait ended 1000\n"
                                                     "study-plot 3\nstudy-screenshot %2\n")
                                          .arg(out(), picture));
  EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString();
  EXPECT_EQ(QImage(picture).size(), QSize(1280, 720));
}

TEST_F(StudyWindow, TheBrowserHasEveryCellAndAsksForTheRunThatIsDoubleClicked) {
  const auto study = StudyFolder::open(out().toStdString());
  ASSERT_TRUE(study.ok());
  Warnings warnings;
  StudyBrowser browser(nullptr);
  browser.show(*study, study->results(warnings));
  EXPECT_EQ(browser.findChild<QTreeWidget*>(QStringLiteral("cells"))->topLevelItemCount(), 4);
  ASSERT_TRUE(browser.selectCell(2));
  EXPECT_FALSE(browser.selectCell(4));
  auto* runs = browser.findChild<QTreeWidget*>(QStringLiteral("runs"));
  ASSERT_EQ(runs->topLevelItemCount(), 2);
  std::vector<StudyRun> wanted;
  QObject::connect(&browser, &StudyBrowser::runRequested, [&](const StudyRun& run) { wanted.push_back(run); });
  browser.resize(1100, 700);
  runs->scrollToItem(runs->topLevelItem(1));
  QCoreApplication::processEvents();
  const QPoint second = runs->visualItemRect(runs->topLevelItem(1)).topLeft() + QPoint(6, 6);
  QTest::mouseClick(runs->viewport(), Qt::LeftButton, {}, second);
  QTest::mouseDClick(runs->viewport(), Qt::LeftButton, {}, second);
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(wanted.front().cell, 2U);
  EXPECT_EQ(wanted.front().seed, 2U);
}

TEST_F(StudyWindow, AClickOnAPointOfAPlotPicksItsCell) {
  Plot plot;
  plot.x = PlotScale::linear("x", {0.0, 10.0});
  plot.y = PlotScale::linear("y", {0.0, 10.0});
  plot.series = {{"ours", false, 0, 0.0, {{5.0, 5.0, 5.0, 5.0, "", "a point", 7}}}};
  PlotView view(plot);
  view.resize(400, 300);
  view.show();
  QCoreApplication::processEvents();
  std::vector<int> picked;
  QObject::connect(&view, &PlotView::cellPicked, [&](int cell) { picked.push_back(cell); });
  auto* canvas = view.findChild<QFrame*>(QStringLiteral("canvas"));
  ASSERT_NE(canvas, nullptr);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, {5, 5});
  EXPECT_TRUE(picked.empty());
  QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->rect().center());
  EXPECT_EQ(picked, std::vector<int>{7});
}

TEST_F(StudyWindow, APartOfAPlotIsShownAndLeftAgain) {
  Plot plot;
  plot.x = PlotScale::linear("x", {0.0, 10.0});
  plot.y = PlotScale::linear("y", {0.0, 10.0});
  plot.series = {{"ours", false, 0, 0.0, {{5.0, 5.0, 5.0, 5.0, "", "a point", 7}}}};
  PlotView view(plot);
  view.resize(500, 400);
  view.show();
  QCoreApplication::processEvents();
  auto* canvas = view.findChild<QFrame*>(QStringLiteral("canvas"));
  const QPoint centre = canvas->rect().center();
  QTest::mousePress(canvas, Qt::LeftButton, {}, centre + QPoint(30, 30));
  // QTest::mouseMove only moves the cursor, which sends no event to a widget without a display.
  QMouseEvent dragged(QEvent::MouseMove, centre + QPoint(90, 90), Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(canvas, &dragged);
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, centre + QPoint(90, 90));
  EXPECT_TRUE(view.isZoomed());
  QTest::keyClick(canvas, Qt::Key_Escape);
  EXPECT_FALSE(view.isZoomed());
  QTest::keyClick(canvas, Qt::Key_Plus);
  EXPECT_TRUE(view.isZoomed());
  QTest::keyClick(canvas, Qt::Key_Left);
  QTest::keyClick(canvas, Qt::Key_Minus);
  QTest::keyClick(canvas, Qt::Key_Minus);
  EXPECT_FALSE(view.isZoomed());
}

TEST_F(StudyWindow, APlotIsSavedAsItIsSeen) {
  const QString drawing = folder.filePath(QStringLiteral("plot.svg"));
  const QString picture = folder.filePath(QStringLiteral("plot.png"));
  const QString part = folder.filePath(QStringLiteral("part.png"));
  const WindowResult result =
      run({}, QStringLiteral("study %1\nstudy-save-plot %2\nstudy-save-plot %3\nstudy-zoom 0.5 0.5 1 1\n"
                             "study-save-plot %4\naction study.zoom-out\naction study.copy-plot\n")
                  .arg(out(), drawing, picture, part));
  EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString();
  QFile file(drawing);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(file.readAll());
  while (!xml.atEnd()) xml.readNext();
  EXPECT_FALSE(xml.hasError());
  EXPECT_GT(difference(QImage(picture), QImage(part)).share, 0.001);
  EXPECT_EQ(run({}, QStringLiteral("study %1\nstudy-save-plot /nowhere/plot.svg\n").arg(out())).exitCode, 3);
}

TEST_F(StudyWindow, WhatIsNotThereIsSaid) {
  EXPECT_NE(run({}, QStringLiteral("study /nowhere\n")).exitCode, 0);
  EXPECT_NE(run({}, QStringLiteral("study-cell 1\n")).exitCode, 0);
  for (const char* wrong : {"study-cell 5", "study-cell x", "study-plot 9", "study-run 1 99", "study-run 0 1"}) {
    const WindowResult result = run({}, QStringLiteral("study %1\n%2\n").arg(out(), QLatin1String(wrong)));
    EXPECT_EQ(result.exitCode, 3) << wrong;
    EXPECT_TRUE(result.errors.contains(QStringLiteral("line 2"))) << result.errors.toStdString();
  }
}

TEST_F(StudyWindow, PicturesOfTypicalRunsComeIntoTheReports) {
  // The command refuses a run that ends otherwise than in the study, so the pictures prove the run of each cell.
  const WindowResult taken =
      run({}, {}, {QStringLiteral("--study-pictures"), out(), QStringLiteral("--report-pdf"), out()});
  EXPECT_EQ(taken.exitCode, 0) << taken.errors.toStdString();
  const QStringList pictures = QDir(out() + QStringLiteral("/pictures")).entryList({QStringLiteral("*.png")});
  ASSERT_FALSE(pictures.isEmpty());
  EXPECT_GT(QImage(out() + QStringLiteral("/pictures/") + pictures.front()).width(), 300);

  const QByteArray pdf = content(QStringLiteral("report.pdf"));
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_GE(pdf.count("/Type /Page\n"), 3);

  QProcess process;
  process.start(QString::fromStdString(test::programDirectory() + "/glissade-cli"), {QStringLiteral("report"), out()});
  ASSERT_TRUE(process.waitForFinished(60000));
  EXPECT_EQ(content(QStringLiteral("report.html")).count("data:image/png;base64,"), pictures.size());
}

}  // namespace
}  // namespace glissade::test
