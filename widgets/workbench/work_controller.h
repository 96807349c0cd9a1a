#pragma once

#include <QElapsedTimer>
#include <QStatusBar>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/background_task.h"
#include "widgets/controls/busy_bar.h"
#include "widgets/document/session_bridge.h"

namespace glissade {

/// Runs long work in the background, one at a time, shows it in the status bar, and cancels it from there. In scripts
/// and without a display the work runs at once.
class WorkController final : public QObject {
  Q_OBJECT

 public:
  WorkController(SessionBridge& bridge, const ActionCatalogue& actions, QStatusBar& bar);

  void setAtOnce(bool atOnce) { atOnce_ = atOnce; }
  bool isAtOnce() const { return atOnce_; }
  /// Runs work and cancels the running one. If that was started by runToEnd(), the new one waits for its end, and
  /// replaces another waiting one.
  void run(const QString& what, const BackgroundTask::Work& work) { run({what, work, false}); }
  /// Runs work that only the user can cancel.
  void runToEnd(const QString& what, const BackgroundTask::Work& work) { run({what, work, true}); }
  /// Shows another task in the status bar while no work of this object runs. `what` is called when the task begins.
  void show(const BackgroundTask& task, const std::function<QString()>& what, const std::function<void()>& cancel);
  /// Whether a person is asked before another action ends the work.
  enum class Loss { Accepted, Asked };
  /// Shows work that the GUI thread does piece by piece: its begin, its share (from 0 to 1), its end. Of several works,
  /// the one that began last is shown, and the user can cancel it.
  void beginOther(const QObject& owner, const QString& what, const std::function<void()>& cancel,
                  Loss loss = Loss::Accepted);
  /// The running work whose loss needs a question; empty: none.
  QString endangered() const;
  void showShare(const QObject& owner, double share);
  void endOther(const QObject& owner);
  /// Cancels the running work, unless runToEnd() started it, and the waiting one.
  void cancel();
  /// Cancels the work that the bar shows, as the user does.
  void cancelShown();
  /// Whether the bar shows work.
  bool isBusy() const { return task_.isBusy() || !others_.empty() || pathWork_; }

  /// Announces an exception by failed(), but a repeated one only once (an error in drawing comes with every picture).
  void reportFailure(const Diagnostic& why);
  /// The last failure since the last call; a script ends with it.
  std::optional<Diagnostic> takeFailure() { return std::exchange(failure_, std::nullopt); }

 signals:
  /// An exception ended work or an event handler.
  void failed(const glissade::Diagnostic& why);
  /// Work has begun or ended.
  void busyChanged();

 private:
  /// Shows the work of the session on paths, which can be cancelled here too.
  void followRun(const SessionSnapshot& snapshot);
  struct Job {
    QString what;
    BackgroundTask::Work work;
    bool toTheEnd;
  };
  /// Work beside the own task.
  struct Other {
    const QObject* owner;
    QString what;
    std::function<void()> cancel;
    Loss loss;
    QElapsedTimer since;
  };

  void run(const Job& job);
  void begin(const Job& job);
  void enable();
  /// Shows this work in the bar from now on.
  void beginBar(const QString& what, const QElapsedTimer& since = startedNow());
  static QElapsedTimer startedNow();
  /// Shows which work ended after how long, and whether the user cancelled it. Then it shows the work beside it again.
  void endBar();

  SessionBridge& bridge_;
  QAction* cancel_;
  BusyBar* busy_;
  QStatusBar* bar_;
  QString shown_;           ///< text of the work in the bar
  bool cancelled_ = false;  ///< whether the user cancelled it
  BackgroundTask task_;
  bool atOnce_;
  bool pathWork_ = false;
  bool toTheEnd_ = false;  ///< whether runToEnd() started the running work
  std::optional<Job> waiting_;
  std::vector<Other> others_;          ///< in the order in which they began
  std::optional<Diagnostic> failure_;  ///< the last failure that takeFailure() has not taken
  std::string reportedFailure_;        ///< text of the last failure
};

}  // namespace glissade
