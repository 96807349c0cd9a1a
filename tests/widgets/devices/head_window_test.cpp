// Pictures of the tracked head, with a tracker of scripts.
#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

class HeadWindow : public WindowTest {};

TEST_F(HeadWindow, TheViewFollowsTheHeadAndIsBackAfterASilence) {
  const QString script = QStringLiteral(
                             "action operator.head\nscreenshot %1/rest.png\nhead 12 5 -10 0 0 8\n"
                             "screenshot %1/moved.png\nhead-silent 30\nscreenshot %1/back.png\n"
                             "head 0 0 0 0 0 0\nscreenshot %1/rest-again.png\n"
                             "action operator.head\nscreenshot %1/off.png\n")
                             .arg(folder.path());
  const WindowResult outcome = run(QStringLiteral("teaching"), script);
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  const auto picture = [this](const char* name) { return QImage(folder.filePath(QLatin1String(name))); };
  EXPECT_GT(difference(picture("rest.png"), picture("moved.png")).mean, 1.0);
  // The pictures differ only by the sign of a silent tracker.
  EXPECT_NE(picture("back.png"), picture("rest.png"));
  EXPECT_LT(difference(picture("back.png"), picture("rest.png")).share, 0.01);
  const auto expectSame = [](const QImage& a, const QImage& b) { EXPECT_LT(difference(a, b).mean, 0.01); };
  expectSame(picture("rest-again.png"), picture("rest.png"));
  const QString usual = folder.filePath(QStringLiteral("usual.png"));
  ASSERT_EQ(run(QStringLiteral("teaching"), QStringLiteral("screenshot ") + usual).exitCode, 0);
  expectSame(picture("off.png"), QImage(usual));
}

TEST_F(HeadWindow, ItsPageShowsWhatComesInStereoToo) {
  const QString file = folder.filePath(QStringLiteral("head.png"));
  const WindowResult outcome =
      run(QStringLiteral("teaching"),
          QStringLiteral("action operator.head\naction operator.head-page\nhead 12 5 -10 5 0 8\nscreenshot ") + file,
          {QStringLiteral("--stereo"), QStringLiteral("anaglyph")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  expectLike(file, QStringLiteral("head"));
}

TEST_F(HeadWindow, AHeadThatIsNotFollowedIsAnErrorOfTheScript) {
  const WindowResult outcome = run(QStringLiteral("teaching"), QStringLiteral("head 1 2 3 4 5 6\n"));
  EXPECT_EQ(outcome.exitCode, 3);
}

}  // namespace
