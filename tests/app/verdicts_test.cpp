// No text of the window states a result that the present scenario would not give: random edits, undo and redo, and
// runs. After each, the texts are compared with those of a window that opens the present scenario anew.
// GLISSADE_VERDICT_SESSIONS is the number of sessions (default 1), GLISSADE_VERDICT_FIRST the seed of the first one.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTemporaryDir>
#include <QTreeWidget>

#include <cstdlib>
#include <map>
#include <random>
#include <string>

#include "engine/files/scenario_io.h"
#include "tests/app/whole_window.h"
#include "widgets/workbench/status_text.h"

namespace glissade {
namespace {

class VerdictsTest : public test::WholeWindowTest {
 protected:
  using Words = std::vector<std::string>;

  static std::string label(const MainWindow& window, const char* name) {
    const auto* found = window.findChild<QLabel*>(QLatin1String(name));
    return found == nullptr || found->isHidden() ? std::string() : found->text().toStdString();
  }

  /// The kept paths by name, with what the table says of them.
  static std::map<std::string, std::string> keptPaths(const MainWindow& window) {
    std::map<std::string, std::string> rows;
    const auto* table = window.findChild<QTreeWidget*>(QStringLiteral("kept-paths"));
    for (int i = 0; i < table->topLevelItemCount(); ++i) {
      rows[table->topLevelItem(i)->text(0).toStdString()] = table->topLevelItem(i)->text(1).toStdString();
    }
    return rows;
  }

  static const SnapshotPtr& snapshotOf(const MainWindow& window) { return window.workbench().session.snapshot(); }

  bool carryOut(const Words& line) {
    log_ += line[0];
    for (std::size_t i = 1; i < line.size(); ++i) log_ += " " + line[i];
    log_ += "\n";
    return window_->workbench().scripts.carryOut(line[0], {line.begin() + 1, line.end()}).ok();
  }

  Words randomLine() {
    const auto one = [this](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); };
    switch (one(10)) {
      case 0:
      case 1: return {"action", "edit.undo"};
      case 2: return {"action", "edit.redo"};
      case 3: carryOut({"select", "place", "P" + std::to_string(1 + one(8))}); return {"action", "place.forbid"};
      case 4: return {"place", "O" + std::to_string(1 + one(3)), std::to_string(100 * one(16)) + ",400,300", "0,0,0"};
      case 5: return {"action", "paths.keep"};
      case 6: return {"action", "run.stop"};
      case 7: return {"steps", std::to_string(1 + one(40))};
      default: carryOut({"action", "run.start"}); return {"wait", "ended", "4000"};
    }
  }

  /// Opens the present scenario in the other window, with the path that is shown.
  void openAnew() {
    const WorkbenchDocument& document = window_->workbench().document;
    const std::string file = folder_.filePath(QStringLiteral("anew.json")).toStdString();
    ASSERT_TRUE(saveScenario(document.contentFor(file), file));
    ASSERT_EQ(anew_->openScenario(QString::fromStdString(file), true), std::nullopt);
    const RunResults& results = document.results();
    SessionBridge& session = anew_->workbench().session;
    if (results.path) session.givePath({results.path->points, results.provenance});
    if (results.refused) session.givePath({results.refused->path.points, results.provenance});
    session.advance(0);
  }

  void expectAsMadeAnew() {
    const SnapshotPtr live = snapshotOf(*window_);
    EXPECT_EQ(label(*window_, "status"), statusText(*live).toStdString());
    if (isRunning(*live)) return;
    openAnew();
    if (live->path || live->refused) {
      EXPECT_EQ(snapshotOf(*anew_)->path != nullptr, live->path != nullptr);
      EXPECT_EQ(snapshotOf(*anew_)->refused != nullptr, live->refused != nullptr);
      EXPECT_EQ(label(*window_, "certificate"), label(*anew_, "certificate"));
    } else {  // a scenario that is opened shows a kept path
      EXPECT_EQ(label(*window_, "certificate"), "No path yet.");
    }
    const auto made = keptPaths(*anew_);
    for (const auto& [name, state] : keptPaths(*window_)) {
      EXPECT_EQ(made.count(name) == 1 ? made.at(name) : "none", state) << name;
    }
    if (live->state != SessionState::Failed) return;
    (void)anew_->workbench().scripts.carryOut("action", {"run.start"});
    (void)anew_->workbench().scripts.carryOut("wait", {"ended", "4000"});
    EXPECT_EQ(statusText(*snapshotOf(*anew_)).toStdString(), statusText(*live).toStdString());
  }

  std::unique_ptr<MainWindow> window_ = makeWindow();
  std::unique_ptr<MainWindow> anew_ = makeWindow();
  std::mt19937 random_;
  QTemporaryDir folder_;
  std::string log_;
};

TEST_P(VerdictsTest, AreThoseOfThePresentScenarioInRandomSessions) {
  constexpr int kEdits = 6;
  const auto number = [](const char* name, int usual) {
    const char* asked = std::getenv(name);
    return asked != nullptr ? std::atoi(asked) : usual;
  };
  const int first = number("GLISSADE_VERDICT_FIRST", 0);
  const int last = first + number("GLISSADE_VERDICT_SESSIONS", 1);
  for (int session = first; session < last && !HasFailure(); ++session) {
    random_.seed(static_cast<unsigned>(session));
    log_.clear();
    ASSERT_EQ(window_->openScenario(sample("teaching"), true), std::nullopt);
    carryOut({"action", "environment.build"});
    carryOut({"action", "run.start"});
    carryOut({"wait", "ended", "4000"});
    for (int edit = 0; edit < kEdits && !HasFailure(); ++edit) {
      carryOut(randomLine());
      expectAsMadeAnew();
    }
    EXPECT_FALSE(HasFailure()) << "session " << session << ":\n" << log_;
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, VerdictsTest, testing::Values("en"));

}  // namespace
}  // namespace glissade
