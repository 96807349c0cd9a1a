// A scripted novice in the real window, in real time, with keys only: nothing but the line over the scene tells which
// keys to hold. Needs a display and xdotool, which sends the keys (xvfb_novice.sh).
//
// GLISSADE_NOVICES: number of the novices that solve each environment, each with a seed of its own. Without it a novice
// only begins environment 1. GLISSADE_NOVICE_STRATEGY: another strategy than "by-hand". GLISSADE_NOVICE_TRACE: the
// hints are written to standard error.
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include <cstdlib>
#include <functional>
#include <iostream>

#include "app/window/main_window.h"
#include "engine/base/random_stream.h"
#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

/// Keys through the X server, as a person's keyboard sends them.
class Keyboard {
 public:
  Keyboard() {
    xdotool_.setProcessChannelMode(QProcess::ForwardedChannels);
    xdotool_.start(QStringLiteral("xdotool"), {QStringLiteral("-")});
  }
  ~Keyboard() {
    hold({}, false);
    xdotool_.closeWriteChannel();
    xdotool_.waitForFinished(1000);
  }

  void focus(WId window) { send(QStringLiteral("windowfocus %1").arg(window)); }
  void tap(const QString& key) { send(QStringLiteral("key ") + key); }
  /// Holds these letters and no others.
  void hold(const QString& letters, bool slowly) {
    if (slowly != slow_)
      send((slowly ? QStringLiteral("keydown ") : QStringLiteral("keyup ")) + QStringLiteral("shift"));
    slow_ = slowly;
    for (const QChar letter : held_) {
      if (!letters.contains(letter)) send(QStringLiteral("keyup ") + letter.toLower());
    }
    for (const QChar letter : letters) {
      if (!held_.contains(letter)) send(QStringLiteral("keydown ") + letter.toLower());
    }
    held_ = letters;
  }

 private:
  void send(const QString& line) {
    xdotool_.write((line + QLatin1Char('\n')).toUtf8());
    xdotool_.waitForBytesWritten(100);
  }

  QProcess xdotool_;
  QString held_;
  bool slow_ = false;
};

/// A key that the line over the scene names, and how far: in units of its own kind.
struct NamedKey {
  QChar letter;
  double way = 0.0;  ///< metres or degrees
  bool turns = false;
};

/// Reads "Hold D: right 300 mm · O: roll right 8°".
std::vector<NamedKey> namedKeys(const QString& hint) {
  static const QRegularExpression pattern(QStringLiteral("([A-Z]): [a-z ]+ ([0-9.]+) ?(m|mm|µm|°)(?: ·|$)"),
                                          QRegularExpression::MultilineOption);
  std::vector<NamedKey> keys;
  const int line = hint.indexOf(QStringLiteral("Hold "));
  if (line < 0) return keys;
  auto found = pattern.globalMatch(hint.mid(line).section(QLatin1Char('\n'), 0, 0));
  while (found.hasNext()) {
    const auto match = found.next();
    const QString unit = match.captured(3);
    const double factor = unit == QStringLiteral("mm") ? 1e-3 : unit == QStringLiteral("µm") ? 1e-6 : 1.0;
    keys.push_back({match.captured(1)[0], factor * match.captured(2).toDouble(), unit == QStringLiteral("°")});
  }
  return keys;
}

/// A novice who holds the keys that the hint names, and lets the object be taken to the next place where it has not
/// come nearer for a while.
class Novice {
 public:
  Novice(MainWindow& window, std::uint64_t seed)
      : bench_(window.workbench()),
        lines_(window.findChildren<QLabel*>(QStringLiteral("scene-hint"))),
        random_(seed, "novice") {
    keyboard_.focus(window.winId());
    QTest::qWait(300);
  }

  /// Starts a run and follows the hints until it is as wanted, or the time (seconds) is over. Returns the time needed.
  double follow(double seconds, const std::function<bool(const SessionSnapshot&)>& isDone) {
    QElapsedTimer clock;
    clock.start();
    keyboard_.tap(QStringLiteral("F5"));
    while (!isDone(*bench_.session.snapshot()) && seconds_(clock) < seconds) {
      const double reaction = kReaction * random_.uniform(0.7, 1.5);
      look(seconds_(clock));
      QTest::qWait(static_cast<int>(1000.0 * kTap));
      keyboard_.hold(held_, slowly_);
      QTest::qWait(static_cast<int>(1000.0 * (reaction - kTap)));
    }
    keyboard_.hold({}, false);
    return seconds_(clock);
  }

 private:
  static constexpr double kReaction = 0.2;    ///< seconds between two looks at the hint
  static constexpr double kTap = 0.1;         ///< seconds for which a key is held for a small turn
  static constexpr double kSmallTurn = 6.0;   ///< degrees below which a key is tapped
  static constexpr double kPatience = 3.0;    ///< seconds of the same hint before another key is tried
  static constexpr double kGivesUp = 60.0;    ///< seconds at a place
  static constexpr double kSlowTurn = 15.0;   ///< degrees below which Shift is held
  static constexpr double kSlowShare = 0.35;  ///< share of the longest move below which Shift is held

  static double seconds_(const QElapsedTimer& clock) { return 1e-3 * static_cast<double>(clock.elapsed()); }

  QString shownLines() const {
    QStringList shown;
    for (const QLabel* line : lines_) {
      if (line->isVisible()) shown << line->text();
    }
    return shown.join(QLatin1Char('\n'));
  }

  void look(double now) {
    const QString text = shownLines();
    const bool isTrace = std::getenv("GLISSADE_NOVICE_TRACE") != nullptr;
    if (isTrace && text != seen_) std::cerr << now << "  " << text.section('\n', 0, 1).toStdString() << "\n";
    if (text != seen_) since_ = now;
    seen_ = text;
    const std::vector<NamedKey> named = namedKeys(text);
    held_.clear();
    slowly_ = false;
    if (named.empty() || now - taken_ > kGivesUp) {
      keyboard_.hold({}, false);
      if (text.contains(QStringLiteral("F12")) && now - taken_ > kPatience) {
        keyboard_.tap(QStringLiteral("F12"));
        taken_ = now;
        longest_ = 0.0;
      }
      return;
    }
    QString letters;
    slowly_ = true;
    for (const NamedKey& key : named) {
      letters += key.letter;
      if (!key.turns || key.way > kSmallTurn) held_ += key.letter;
      if (!key.turns) longest_ = std::max(longest_, key.way);
      slowly_ = slowly_ && key.way < (key.turns ? kSlowTurn : kSlowShare * longest_);
    }
    if (now - since_ > kPatience && random_.uniform() < 0.5) {
      const QChar any = QStringLiteral("ADWSQEJLIKUO")[static_cast<int>(random_.uniform(0.0, 11.999))];
      letters += any;
      held_ += any;
    }
    keyboard_.hold(letters, slowly_);
  }

  const Workbench& bench_;
  QList<QLabel*> lines_;  ///< over the scene, which several features write
  RandomStream random_;
  Keyboard keyboard_;
  QString seen_;
  QString held_;           ///< keys that are held until the next look; the others are tapped
  bool slowly_ = false;    ///< with Shift
  double since_ = 0.0;     ///< time at which the hint changed
  double taken_ = -100.0;  ///< time at which F12 was pressed
  double longest_ = 0.0;   ///< longest move that was named at this place
};

struct Task {
  const char* environment;
  double seconds;
};

/// The shares of the path by author; nothing: there is no path.
std::optional<PerAuthor<double>> sharesOf(const Workbench& bench) {
  const SnapshotPtr& snapshot = bench.session.snapshot();
  if (!snapshot || !snapshot->path) return std::nullopt;
  auto shares = snapshot->path->lengthByAuthor(bench.document.scenario()->problem.metric());
  const double length = shares[0] + shares[1] + shares[2];
  for (double& share : shares) share /= length;
  return shares;
}

/// The window on a sample, with a hand at the keys.
std::unique_ptr<MainWindow> openWindow(const std::string& environment, std::uint64_t seed) {
  auto window = std::make_unique<MainWindow>(makeOnscreenSceneWidget, SessionClock::RealTime);
  window->resize(1280, 720);
  const std::string scenario = test::sourceDirectory() + "/samples/" + environment + "/scenario.json";
  EXPECT_FALSE(window->openScenario(QString::fromStdString(scenario), true));
  window->show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  SessionBridge& session = window->workbench().session;
  session.setDevice("hand");
  const char* strategy = std::getenv("GLISSADE_NOVICE_STRATEGY");
  session.post(command::SetPlanner{strategy != nullptr ? strategy : "by-hand"});
  session.post(command::SetSeed{seed});
  return window;
}

TEST(NoviceAtTheKeys, LeavesAWayByTheHints) {
  const auto window = openWindow("environment-1", 1);
  Novice novice(*window, 1);
  const auto hasLed = [](const SessionSnapshot& snapshot) {
    return snapshot.nodesByAuthor[static_cast<std::size_t>(Author::Operator)] >= 20;
  };
  novice.follow(60.0, hasLed);
  EXPECT_TRUE(hasLed(*window->workbench().session.snapshot()));
}

class NoviceInTheWindow : public testing::TestWithParam<Task> {};

INSTANTIATE_TEST_SUITE_P(Environments, NoviceInTheWindow,
                         testing::Values(Task{"environment-1", 90.0}, Task{"environment-2", 240.0}));

TEST_P(NoviceInTheWindow, SolvesItByTheHints) {
  const char* asked = std::getenv("GLISSADE_NOVICES");
  if (asked == nullptr) GTEST_SKIP() << "set GLISSADE_NOVICES; it takes some minutes";
  const auto [environment, seconds] = GetParam();
  const int novices = std::atoi(asked);
  int solved = 0;
  for (int seed = 1; seed <= novices; ++seed) {
    const auto window = openWindow(environment, static_cast<std::uint64_t>(seed));
    Novice novice(*window, static_cast<std::uint64_t>(seed));
    const double needed =
        novice.follow(seconds, [](const SessionSnapshot& snapshot) { return snapshot.path != nullptr; });
    std::cout << environment << ", seed " << seed << ": ";
    if (const auto shares = sharesOf(window->workbench())) {
      const auto [computer, hand, contact] = *shares;
      std::cout << needed << " s, shares: hand " << hand << ", contact " << contact << ", computer " << computer;
      solved += hand >= 0.3 ? 1 : 0;
    } else {
      std::cout << "no path";
    }
    std::cout << std::endl;
    QTest::qWait(200);
  }
  EXPECT_GE(10 * solved, 8 * novices) << environment;
}

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
