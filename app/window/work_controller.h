#pragma once

#include <QStatusBar>

#include <optional>

#include "widgets/bridge/background_task.h"
#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/busy_bar.h"

namespace glissade {

/// What takes its time: done in the background, one thing at a time, shown in the status bar and
/// cancelled from there. In scripts and without a display it is done at once. Part of the main window.
class WorkController final : public QObject {
  Q_OBJECT

 public:
  WorkController(SessionBridge& bridge, const ActionCatalogue& actions, QStatusBar& bar);

  void setAtOnce(bool atOnce) { atOnce_ = atOnce; }
  /// Another work that is under way is cancelled, unless it is one to be finished: then this one waits,
  /// in place of another that did.
  void run(const QString& what, const BackgroundTask::Work& work) { run({what, work, false}); }
  /// Only the user ends it early.
  void runToEnd(const QString& what, const BackgroundTask::Work& work) { run({what, work, true}); }
  /// Ends what need not be finished.
  void cancel();
  /// What is done with a path goes on in the session; it is shown and cancelled here like all else.
  void showSnapshot(const SessionSnapshot& snapshot);

 private:
  struct Job {
    QString what;
    BackgroundTask::Work work;
    bool toTheEnd;
  };

  void run(const Job& job);
  void begin(const Job& job);
  void cancelAll();
  void enable();

  SessionBridge& bridge_;
  QAction* cancel_;
  BusyBar* busy_;
  BackgroundTask task_;
  bool atOnce_;
  bool pathWork_ = false;
  bool toTheEnd_ = false;  ///< what is under way
  std::optional<Job> waiting_;
};

}  // namespace glissade
