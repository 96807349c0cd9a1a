// Stereo in the whole window, run as its user would.
#include "tests/app/window_fixture.h"
#include "widgets/scene3d/stereo_mode.h"

namespace {

using namespace glissade;
using namespace glissade::test;

/// With a section and its arrow, labels, the gizmo of arranging, view cube, legend and scale.
const QString kScene =
    QStringLiteral("action layer.graph\nsection x 0.55\naction layer.grid\naction assembly.arrange\nselect body O1\n");

class StereoWindow : public WindowTest {
 protected:
  QImage pictureOf(const char* mode, const QString& more = {}, const QStringList& options = {}) {
    const QString file = folder.filePath(QLatin1String(mode) + QStringLiteral(".png"));
    const WindowResult outcome = run(QStringLiteral("teaching"), kScene + more + QStringLiteral("screenshot ") + file,
                                     options + QStringList{QStringLiteral("--stereo"), QLatin1String(mode)});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
    return QImage(file);
  }

  /// Holds all pixels that differ.
  static QRect differing(const QImage& a, const QImage& b) {
    QRect box;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        if (a.pixel(x, y) != b.pixel(x, y)) box |= QRect(x, y, 1, 1);
      }
    }
    return box;
  }
};

/// What `mode` shows is made of the single pictures of both eyes: pixel by pixel where it takes pixels as they are.
TEST_F(StereoWindow, EveryModeIsMadeOfTheSinglePicturesOfBothEyes) {
  const QImage left = pictureOf("left-eye");
  const QImage right = pictureOf("right-eye");
  const QRect scene = differing(left, right);
  ASSERT_GT(scene.width(), 300);
  const auto expectMade = [&](const QImage& picture, const std::string& mode, auto pixel) {
    int differ = 0;
    for (int y = scene.top(); y <= scene.bottom(); ++y) {
      for (int x = scene.left(); x <= scene.right(); ++x) {
        if ((picture.pixel(x, y) ^ pixel(left.pixel(x, y), right.pixel(x, y), x, y)) & 0xffffff) ++differ;
      }
    }
    EXPECT_EQ(differ, 0) << mode;
  };
  expectMade(pictureOf("anaglyph"), "anaglyph",
             [](QRgb l, QRgb r, int, int) { return qRgb(qRed(l), qGreen(r), qBlue(r)); });
  expectMade(pictureOf("interlaced"), "interlaced", [](QRgb l, QRgb r, int, int y) { return y % 2 == 0 ? l : r; });
  expectMade(pictureOf("checkerboard"), "checkerboard",
             [](QRgb l, QRgb r, int x, int y) { return (x + y) % 2 == 0 ? l : r; });
  expectMade(pictureOf("anaglyph", QStringLiteral("action stereo.swap\n")), "swapped",
             [](QRgb l, QRgb r, int, int) { return qRgb(qRed(r), qGreen(l), qBlue(l)); });
}

/// On a full screen the picture is the scene alone: its halves are the single pictures, made smaller.
TEST_F(StereoWindow, HalvesAreThePicturesOfTheEyes) {
  const QString fullScreen = QStringLiteral("action view.full-screen\n");
  const QImage left = pictureOf("left-eye", fullScreen);
  const QImage right = pictureOf("right-eye", fullScreen);
  for (const bool beside : {true, false}) {
    const QImage both = pictureOf(beside ? "side-by-side" : "top-bottom", fullScreen);
    ASSERT_EQ(both.size(), left.size());
    const QSize half(beside ? both.width() / 2 : both.width(), beside ? both.height() : both.height() / 2);
    const QPoint second = beside ? QPoint(half.width(), 0) : QPoint(0, half.height());
    const auto smaller = [&](const QImage& eye) {
      return eye.scaled(half, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    EXPECT_LT(difference(both.copy(QRect(QPoint(), half)), smaller(left)).mean, 1.0);
    EXPECT_LT(difference(both.copy(QRect(second, half)), smaller(right)).mean, 1.0);
    EXPECT_GT(difference(both.copy(QRect(second, half)), smaller(left)).mean, 3.0);
  }
}

TEST_F(StereoWindow, PicturesOfAllModes) {
  for (const StereoModeEntry& entry : kStereoModes) {
    if (entry.mode == StereoMode::Off || entry.mode == StereoMode::QuadBuffer) continue;
    const bool isDark = entry.mode == StereoMode::SideBySide;
    const QImage picture = pictureOf(entry.name, isDark ? QStringLiteral("action view.dark\n") : QString(),
                                     {QStringLiteral("--size"), QStringLiteral("960x540")});
    EXPECT_FALSE(picture.isNull()) << entry.name;
    expectLike(folder.filePath(QLatin1String(entry.name) + QStringLiteral(".png")),
               QStringLiteral("stereo-") + QLatin1String(entry.name));
  }
}

TEST_F(StereoWindow, WithoutStereoThePictureIsTheUsualOne) {
  const QString file = folder.filePath(QStringLiteral("usual.png"));
  ASSERT_EQ(run(QStringLiteral("teaching"), kScene + QStringLiteral("screenshot ") + file).exitCode, 0);
  EXPECT_EQ(pictureOf("off"), QImage(file));
  EXPECT_EQ(pictureOf("anaglyph", QStringLiteral("action stereo.off\n")), QImage(file));
}

TEST_F(StereoWindow, UnknownAndImpossibleModesAreRefused) {
  for (const char* mode : {"mono", "quad-buffer"}) {
    const WindowResult outcome =
        run(QStringLiteral("teaching"), QStringLiteral("steps 1\n"), {QStringLiteral("--stereo"), QLatin1String(mode)});
    EXPECT_EQ(outcome.exitCode, 2) << mode;
    EXPECT_TRUE(outcome.errors.contains(QStringLiteral("--stereo"))) << mode;
  }
}

}  // namespace
