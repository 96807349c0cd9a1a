// Runs stereo in the whole window as a user would.
#include <map>
#include <vector>

#include "tests/app/window_fixture.h"
#include "widgets/scene3d/stereo_mode.h"

namespace {

using namespace glissade;
using namespace glissade::test;

/// The scene has a section and its arrow, labels, the gizmo of arranging, view cube, legend and scale.
const QString kScene =
    QStringLiteral("action layer.graph\nsection x 0.55\naction layer.grid\naction assembly.arrange\nselect body O1\n");

class StereoWindow : public WindowTest {
 protected:
  QImage pictureOf(const char* mode, const QString& more = {}, const QStringList& options = {}) {
    const QString file = fileOf(mode);
    const WindowResult outcome = run(QStringLiteral("teaching"), kScene + more + QStringLiteral("screenshot ") + file,
                                     options + QStringList{QStringLiteral("--stereo"), QLatin1String(mode)});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
    return QImage(file);
  }

  /// The pictures of several modes by one run of the program; `more` is carried out before each picture.
  std::map<std::string, QImage> picturesOf(const std::vector<const char*>& modes, const QString& more = {},
                                           const QStringList& options = {}) {
    QString script = kScene;
    for (const char* mode : modes) {
      script += QStringLiteral("action stereo.%1\n%2screenshot %3\n").arg(QLatin1String(mode), more, fileOf(mode));
    }
    const WindowResult outcome = run(QStringLiteral("teaching"), script, options);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
    std::map<std::string, QImage> pictures;
    for (const char* mode : modes) pictures[mode] = QImage(fileOf(mode));
    return pictures;
  }

  QString fileOf(const char* mode) const { return folder.filePath(QLatin1String(mode) + QStringLiteral(".png")); }

  /// The smallest rectangle that contains all different pixels.
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

/// The picture of each of these modes is composed pixel by pixel of the single pictures of both eyes.
TEST_F(StereoWindow, EveryModeIsMadeOfTheSinglePicturesOfBothEyes) {
  auto pictures = picturesOf({"left-eye", "right-eye", "anaglyph", "interlaced", "checkerboard"});
  const QImage left = pictures["left-eye"];
  const QImage right = pictures["right-eye"];
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
  expectMade(pictures["anaglyph"], "anaglyph",
             [](QRgb l, QRgb r, int, int) { return qRgb(qRed(l), qGreen(r), qBlue(r)); });
  expectMade(pictures["interlaced"], "interlaced", [](QRgb l, QRgb r, int, int y) { return y % 2 == 0 ? l : r; });
  expectMade(pictures["checkerboard"], "checkerboard",
             [](QRgb l, QRgb r, int x, int y) { return (x + y) % 2 == 0 ? l : r; });
  expectMade(pictureOf("anaglyph", QStringLiteral("action stereo.swap\n")), "swapped",
             [](QRgb l, QRgb r, int, int) { return qRgb(qRed(r), qGreen(l), qBlue(l)); });
}

/// In full screen the picture is the scene alone: its halves are the single pictures, made smaller.
TEST_F(StereoWindow, HalvesAreThePicturesOfTheEyes) {
  // The full screen is entered once, before the first picture.
  const QString script = kScene + QStringLiteral("action view.full-screen\n");
  QString modes;
  for (const char* mode : {"left-eye", "right-eye", "side-by-side", "top-bottom"}) {
    modes += QStringLiteral("action stereo.%1\nscreenshot %2\n").arg(QLatin1String(mode), fileOf(mode));
  }
  ASSERT_EQ(run(QStringLiteral("teaching"), script + modes).exitCode, 0);
  const QImage left(fileOf("left-eye"));
  const QImage right(fileOf("right-eye"));
  for (const bool beside : {true, false}) {
    const QImage both(fileOf(beside ? "side-by-side" : "top-bottom"));
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
  const QStringList size{QStringLiteral("--size"), QStringLiteral("960x540")};
  picturesOf({"anaglyph", "top-bottom", "interlaced", "checkerboard", "left-eye", "right-eye"}, {}, size);
  picturesOf({"side-by-side"}, QStringLiteral("action view.dark\n"), size);
  for (const StereoModeEntry& entry : kStereoModes) {
    if (entry.mode == StereoMode::Off || entry.mode == StereoMode::QuadBuffer) continue;
    expectLike(fileOf(entry.name), QStringLiteral("stereo-") + QLatin1String(entry.name));
  }
}

TEST_F(StereoWindow, WithoutStereoThePictureIsTheUsualOne) {
  const QString file = folder.filePath(QStringLiteral("usual.png"));
  ASSERT_EQ(run(QStringLiteral("teaching"), kScene + QStringLiteral("screenshot ") + file).exitCode, 0);
  EXPECT_EQ(pictureOf("off"), QImage(file));
  // The bar of the sections changes the height of the window's docks, which depends on the order of events.
  const QRect view(330, 170, 590, 440);
  EXPECT_EQ(pictureOf("anaglyph", QStringLiteral("action stereo.off\n")).copy(view), QImage(file).copy(view));
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
