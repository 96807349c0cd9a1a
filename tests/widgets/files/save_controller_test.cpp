#include "widgets/files/save_controller.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QApplication>
#include <QDir>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <QtTest/QTest>

#include <csignal>

#include "engine/base/file.h"
#include "engine/base/file_versions.h"
#include "engine/files/assembly_edits.h"
#include "engine/files/scenario_file.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/temporary_folder.h"
#include "widgets/document/workbench_document.h"
#include "widgets/files/save_conflict.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

/// Presses a button of the next dialog, and keeps the dialog's text.
class NextDialog {
 public:
  explicit NextDialog(const char* button) {
    QTimer::singleShot(0, qApp, [this, button = QString::fromLatin1(button)] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      said_ = box->text() + QLatin1Char('\n') + box->informativeText();
      for (QAbstractButton* each : box->buttons()) {
        if (each->text().remove(QLatin1Char('&')) == button) return each->click();
      }
      box->reject();
      ADD_FAILURE() << "no button " << button.toStdString();
    });
  }
  const QString& said() const { return said_; }

 private:
  QString said_;
};

/// A window that holds one scenario.
class SaveControllerTest : public testing::Test {
 protected:
  SaveControllerTest() {
    SaveHost host;
    host.scenario = [this] { return open_; };
    host.isModified = [this] { return modified_; };
    host.contentFor = [this](const std::string&) { return open_->scenario; };
    host.openModified = [this](const ScenarioPtr& scenario) {
      open_ = scenario;
      modified_ = true;
    };
    host.mayDiscard = [] { return true; };
    host.showError = [this](const QString&, const Diagnostic& why) { errors_.push_back(why); };
    saves_ = new SaveController(std::move(host), &window_);
  }

  Scenario named(const std::string& name) const {
    Scenario scenario = test::boxScenario();
    scenario.name = name;
    return scenario;
  }
  std::string nameIn(const std::string& file) const { return parseScenario(test::readWhole(file), file)->name; }
  void open(const std::string& file) {
    auto opened = openScenarioFile(file);
    ASSERT_TRUE(opened.ok()) << toString(opened.error());
    saves_->noteContent(file, opened->sha256);
    open_ = std::make_shared<const LoadedScenario>(std::move(opened->scenario));
  }
  /// Leaves the edits of a killed program in the folder.
  void leaveEdits(const std::string& data, const UnsavedEdits& edits) const {
    const pid_t child = ::fork();
    if (child == 0) {
      auto slot = AutosaveSlot::make(data);
      if (!slot || !(*slot)->write(edits)) ::_exit(1);
      ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
  void offer(const std::string& data) { saves_->keepUnsavedEdits(QString::fromStdString(data)); }

  TemporaryFolder folder_;
  QWidget window_;
  SaveController* saves_;
  ScenarioPtr open_;
  bool modified_ = false;
  std::vector<Diagnostic> errors_;
};

TEST_F(SaveControllerTest, NoticesThatSomebodyElseHasChangedTheFile) {
  const std::string file = folder_.write("a.json", writeScenario(named("opened")));
  open(file);
  ASSERT_TRUE(saves_->save(named("mine"), file));
  ASSERT_TRUE(saves_->save(named("mine again"), file));
  folder_.write("a.json", writeScenario(named("theirs")));
  EXPECT_EQ(saves_->save(named("mine at last"), file).status, SaveStatus::ChangedByOthers);
  EXPECT_EQ(nameIn(file), "theirs");
  EXPECT_TRUE(saves_->save(named("elsewhere"), folder_ / "b.json"));
  open(file);
  saves_->allowReplacing();
  folder_.write("a.json", writeScenario(named("theirs again")));
  EXPECT_TRUE(saves_->save(named("mine at last"), file));
  EXPECT_EQ(nameIn(earlierVersions(file).front().path), "theirs again");
}

TEST_F(SaveControllerTest, AsksWhoseVersionCounts) {
  SaveResult changed;
  changed.status = SaveStatus::ChangedByOthers;
  changed.why.file = "/home/a.json";
  const std::vector<std::pair<const char*, ConflictAnswer>> answers{
      {"Overwrite", ConflictAnswer::KeepMine},
      {"Open the other version", ConflictAnswer::TakeTheirs},
      {"Save as...", ConflictAnswer::SaveAs},
      {"Cancel", ConflictAnswer::Cancel}};
  for (const auto& [button, answer] : answers) {
    const NextDialog dialog(button);
    EXPECT_EQ(askAboutConflict(changed, &window_), answer) << button;
    EXPECT_TRUE(dialog.said().contains(QStringLiteral("/home/a.json")));
  }
  SaveResult removed = changed;
  removed.status = SaveStatus::RemovedByOthers;
  const NextDialog dialog("Save again");
  EXPECT_EQ(askAboutConflict(removed, &window_), ConflictAnswer::KeepMine);
}

TEST_F(SaveControllerTest, OpensEarlierVersions) {
  const std::string file = folder_.write("a.json", writeScenario(named("first")));
  open(file);
  ASSERT_TRUE(saves_->save(named("second"), file));
  ASSERT_TRUE(saves_->save(named("third"), file));
  emit saves_->versionsMenu()->aboutToShow();
  const QList<QAction*> actions = saves_->versionsMenu()->actions();
  ASSERT_EQ(actions.size(), 2);
  EXPECT_TRUE(actions[0]->text().startsWith(QStringLiteral("Version 2")));
  actions[1]->trigger();
  EXPECT_EQ(open_->scenario.name, "first");
  EXPECT_EQ(open_->file, file);
  EXPECT_TRUE(modified_);
  EXPECT_EQ(nameIn(file), "third");
  EXPECT_TRUE(saves_->save(open_->scenario, file));  // no other program has changed the file
}

TEST_F(SaveControllerTest, OffersTheEditsOfAKilledProgram) {
  const std::string file = folder_.write("a.json", writeScenario(named("opened")));
  const std::string data = folder_ / "data";
  leaveEdits(data, {file, sha256(test::readWhole(file)), named("edited")});
  const NextDialog dialog("Open them");
  offer(data);
  EXPECT_TRUE(dialog.said().contains(QStringLiteral("as it was before these edits"))) << dialog.said().toStdString();
  ASSERT_TRUE(open_);
  EXPECT_EQ(open_->scenario.name, "edited");
  EXPECT_EQ(open_->file, file);
  EXPECT_EQ(nameIn(file), "opened");  // only a save changes the file
  EXPECT_TRUE(saves_->save(open_->scenario, file));
}

TEST_F(SaveControllerTest, EditsOfAFileThatHasChangedDoNotReplaceIt) {
  const std::string file = folder_.write("a.json", writeScenario(named("changed since")));
  leaveEdits(folder_ / "data", {file, sha256("as it was"), named("edited")});
  const NextDialog dialog("Open them");
  offer(folder_ / "data");
  EXPECT_TRUE(dialog.said().contains(QStringLiteral("has changed since"))) << dialog.said().toStdString();
  ASSERT_TRUE(open_);
  EXPECT_EQ(saves_->save(open_->scenario, file).status, SaveStatus::ChangedByOthers);
}

TEST_F(SaveControllerTest, AsksAgainLaterAndForgetsWhatIsDiscardedOrSaved) {
  const std::string data = folder_ / "data";
  leaveEdits(data, {"", "", named("never saved")});
  {
    const NextDialog dialog("Ask later");
    offer(data);
    EXPECT_TRUE(dialog.said().contains(QStringLiteral("never saved")));
    EXPECT_FALSE(open_);
  }
  EXPECT_EQ(findAbandonedEdits(data).size(), 1U);
  {
    const NextDialog dialog("Discard them");
    offer(data);
  }
  EXPECT_TRUE(findAbandonedEdits(data).empty());
  const std::string file = folder_.write("a.json", writeScenario(named("saved")));
  leaveEdits(data, {file, "", named("saved")});
  offer(data);  // no question, because the file holds the edits
  EXPECT_TRUE(findAbandonedEdits(data).empty());
  EXPECT_TRUE(errors_.empty());
}

/// During a step by hand the scenario is temporary and lacks the removed parts.
TEST(SaveControllerOfADocument, WritesThePersonsScenarioWhileTheScenarioIsATemporaryOne) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", writeScenario(test::boxScenario()));
  WorkbenchDocument document;
  document.open(std::make_shared<const LoadedScenario>(std::move(openScenarioFile(file)->scenario)));
  const BodyId body = document.current().bodies.front().id;
  SaveHost host;
  host.scenario = [&] { return document.scenario(); };
  host.isModified = [&] { return document.isModified(); };
  host.contentFor = [&](const std::string& to) { return document.contentFor(to); };
  QWidget window;
  auto* saves = new SaveController(std::move(host), &window);
  ASSERT_TRUE(document.place({AssemblyItem::Kind::Body, body}, Pose::translation({5, 5, 5})));
  const auto without = [body](Scenario& scenario) { return removeBody(body, scenario); };
  ASSERT_TRUE(document.editTemporarily(QStringLiteral("by hand"), without));

  saves->setAutosaveSeconds(1);
  saves->keepUnsavedEdits(QString::fromStdString(folder / "data"));
  QStringList written;
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const QDir data(QString::fromStdString(folder / "data"));
        written = data.entryList({QStringLiteral("*.edits")}, QDir::Files);
        return !written.isEmpty();
      },
      20'000));
  const std::string text = test::readWhole(folder / ("data/" + written.front().toStdString()));
  EXPECT_NE(text.find('"' + body.text() + '"'), std::string::npos) << text;
}

}  // namespace
}  // namespace glissade
