#include "widgets/film/film_job.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

#include "app/window/window_actions.h"

namespace glissade {
namespace {

constexpr int kPictures = 36;  // of 0.2 s, and 0.6 s of repeated pictures before and after

/// Films with a program in place of ffmpeg, which writes the file that it is given.
class FilmJobTest : public testing::Test {
 protected:
  void SetUp() override { qputenv("PATH", folder.path().toUtf8() + ":" + path); }
  void TearDown() override { qputenv("PATH", path); }

  /// `body`: text of a shell script; $out is the file to write.
  void install(const char* body) {
    const QString file = folder.filePath(QStringLiteral("ffmpeg"));
    std::ofstream(file.toStdString()) << "#!/bin/sh\nfor out; do :; done\nout=${out#file:}\n" << body << "\n";
    QFile::setPermissions(file, QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner);
  }

  void film(const QString& name) {
    job.start({0.2, [this](double share) { shares.push_back(share); }, [this] { restored = true; }},
              folder.filePath(name), [this](const SaveResult& saved) { result = saved; });
  }

  bool ends() {
    return QTest::qWaitFor([this] { return result.has_value(); }, 30'000);
  }

  QByteArray contentOf(const QString& name) const {
    QFile file(folder.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  QByteArray path = qgetenv("PATH");
  QTemporaryDir folder;
  QStatusBar bar;
  ActionCatalogue actions{windowActions(), nullptr};
  SessionBridge bridge{SessionClock::RealTime};
  WorkController works{bridge, actions, bar};
  QImage picture{41, 30, QImage::Format_RGB32};
  CameraController camera;
  int taken = 0;
  FilmJob job{works,
              [this] {
                ++taken;
                return picture;
              },
              camera};
  std::vector<double> shares;
  bool restored = false;
  std::optional<SaveResult> result;
};

TEST_F(FilmJobTest, AllPicturesReachTheProgramWithAnEvenSize) {
  install("wc -c >\"$out\"; echo \"$@\" >>\"$out\"");
  film(QStringLiteral("path.mp4"));
  ASSERT_TRUE(ends());
  ASSERT_TRUE(*result) << toString(result->why);
  const QList<QByteArray> lines = contentOf(QStringLiteral("path.mp4")).split('\n');
  EXPECT_EQ(lines[0].trimmed().toInt(), kPictures * 40 * 30 * 4);
  EXPECT_TRUE(lines[1].contains("-s 40x30 -r 25"));
  EXPECT_TRUE(lines[1].contains("libx264"));
  EXPECT_TRUE(restored);
  EXPECT_LT(taken, kPictures / 2) << "what stands still is drawn once";
  EXPECT_EQ(shares.size(), static_cast<std::size_t>(taken));
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_FALSE(actions[QStringLiteral("work.cancel")]->isEnabled());
}

TEST_F(FilmJobTest, ScriptsHaveTheFilmAtOnce) {
  install("cat >\"$out\"");
  works.setAtOnce(true);
  film(QStringLiteral("path.webm"));
  ASSERT_TRUE(result.has_value());
  ASSERT_TRUE(*result) << toString(result->why);
  EXPECT_EQ(contentOf(QStringLiteral("path.webm")).size(), kPictures * 40 * 30 * 4);
}

TEST_F(FilmJobTest, WhatTheProgramSaysIsTheError) {
  install("echo half >\"$out\"; echo 'Unknown encoder libx264' >&2; exit 1");
  film(QStringLiteral("path.mp4"));
  ASSERT_TRUE(ends());
  EXPECT_FALSE(*result);
  EXPECT_NE(toString(result->why.reason).find("Unknown encoder libx264"), std::string::npos)
      << toString(result->why.reason);
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList{QStringLiteral("ffmpeg")});
  EXPECT_TRUE(restored);
}

TEST_F(FilmJobTest, ACancelledFilmLeavesTheOldFile) {
  install("echo new >\"$out\"; cat >/dev/null; sleep 60");
  std::ofstream(folder.filePath(QStringLiteral("path.mp4")).toStdString()) << "old";
  film(QStringLiteral("path.mp4"));
  ASSERT_FALSE(result.has_value());
  EXPECT_FALSE(works.endangered().isEmpty()) << "a person is asked before another scenario is opened";
  actions[QStringLiteral("work.cancel")]->trigger();
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->why.kind, ErrorKind::Interrupted);
  EXPECT_FALSE(job.isFilming());
  EXPECT_TRUE(works.endangered().isEmpty());
  EXPECT_TRUE(restored);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  QTest::qWait(1);
  EXPECT_EQ(contentOf(QStringLiteral("path.mp4")), "old");
}

TEST_F(FilmJobTest, APersonLooksFromElsewhereMeanwhile) {
  install("cat >/dev/null; echo film >\"$out\"");
  camera.lookFrom(Vector3::UnitX());
  const Vector3 filmed = camera.eye();
  std::vector<Vector3> eyes;
  job.start({0.2, [&](double) { eyes.push_back(camera.eye()); }, [this] { restored = true; }},
            folder.filePath(QStringLiteral("path.mp4")), [this](const SaveResult& saved) { result = saved; });
  camera.lookFrom(Vector3::UnitZ());
  const Vector3 mine = camera.eye();
  ASSERT_TRUE(ends());
  ASSERT_GT(eyes.size(), 3U);
  for (const Vector3& eye : eyes) EXPECT_EQ(eye, filmed);
  EXPECT_EQ(camera.eye(), mine);
}

TEST_F(FilmJobTest, WithoutTheProgramOrWithAnotherEndingTheErrorSaysWhatToDo) {
  qputenv("PATH", folder.path().toUtf8());
  film(QStringLiteral("path.mp4"));
  ASSERT_TRUE(result.has_value());
  EXPECT_NE(toString(result->why.advice).find("Install the package ffmpeg"), std::string::npos);
  EXPECT_FALSE(restored);
  film(QStringLiteral("path.avi"));
  EXPECT_NE(toString(result->why.advice).find(".webm"), std::string::npos);
}

TEST_F(FilmJobTest, ASeriesOfPicturesIsNumbered) {
  film(QStringLiteral("path.png"));
  ASSERT_TRUE(ends());
  ASSERT_TRUE(*result) << toString(result->why);
  const QStringList files = QDir(folder.path()).entryList({QStringLiteral("path-*.png")});
  EXPECT_EQ(files.size(), kPictures);
  EXPECT_EQ(files.front(), QStringLiteral("path-0001.png"));
}

TEST_F(FilmJobTest, FfmpegItselfMakesAFilm) {
  if (QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).isEmpty()) GTEST_SKIP() << "ffmpeg is not installed";
  picture.fill(Qt::darkCyan);
  film(QStringLiteral("path.mp4"));
  ASSERT_TRUE(ends());
  ASSERT_TRUE(*result) << toString(result->why);
  EXPECT_EQ(contentOf(QStringLiteral("path.mp4")).mid(4, 4), "ftyp");
}

}  // namespace
}  // namespace glissade
