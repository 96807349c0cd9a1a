#pragma once

#include <QElapsedTimer>
#include <QStatusBar>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "widgets/bridge/background_task.h"
#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/busy_bar.h"

namespace glissade {

/// What takes its time: done in the background, one thing at a time, shown in the status bar and
/// cancelled from there. In scripts and without a display it is done at once.
class WorkController final : public QObject {
  Q_OBJECT

 public:
  WorkController(SessionBridge& bridge, const ActionCatalogue& actions, QStatusBar& bar);

  void setAtOnce(bool atOnce) { atOnce_ = atOnce; }
  bool isAtOnce() const { return atOnce_; }
  /// Another work that is under way is cancelled, unless it is one to be finished: then this one waits,
  /// in place of another that did.
  void run(const QString& what, const BackgroundTask::Work& work) { run({what, work, false}); }
  /// Only the user ends it early.
  void runToEnd(const QString& what, const BackgroundTask::Work& work) { run({what, work, true}); }
  /// Shows another task in the status bar, too, while none of its own is under way.
  /// `what` is asked when it begins.
  void show(const BackgroundTask& task, const std::function<QString()>& what, const std::function<void()>& cancel);
  /// Whether a person is asked before something else ends the work.
  enum class Loss { Accepted, Asked };
  /// Shows what the GUI thread does piece by piece, in the same way: its begin, its share (from 0 to 1), its end. Of
  /// several the one that began last is shown, and is what the user cancels.
  void beginOther(const QObject& owner, const QString& what, const std::function<void()>& cancel,
                  Loss loss = Loss::Accepted);
  /// What is under way and would be lost, for the question about it; empty: nothing.
  QString endangered() const;
  void showShare(const QObject& owner, double share);
  void endOther(const QObject& owner);
  /// Ends what need not be finished.
  void cancel();

  /// Tells the user of an exception: by failed(), and once only where the same comes again and again (an error in
  /// drawing comes with every picture).
  void reportFailure(const Diagnostic& why);
  /// What was reported since the last call; scripts end with it.
  std::optional<Diagnostic> takeFailure() { return std::exchange(failure_, std::nullopt); }

 signals:
  /// An exception has ended a work or an event handler.
  void failed(const glissade::Diagnostic& why);

 private:
  /// The session works on paths itself; that is shown and cancelled here, too.
  void followRun(const SessionSnapshot& snapshot);
  struct Job {
    QString what;
    BackgroundTask::Work work;
    bool toTheEnd;
  };
  /// What is under way beside the own task.
  struct Other {
    const QObject* owner;
    QString what;
    std::function<void()> cancel;
    Loss loss;
    QElapsedTimer since;
  };

  void run(const Job& job);
  void begin(const Job& job);
  void cancelAll();
  void enable();
  /// The bar is about this from now on.
  void beginBar(const QString& what, const QElapsedTimer& since = startedNow());
  static QElapsedTimer startedNow();
  /// Says what has ended after how long, and whether the user ended it. What is under way beside it is shown again.
  void endBar();

  SessionBridge& bridge_;
  QAction* cancel_;
  BusyBar* busy_;
  QStatusBar* bar_;
  QString shown_;           ///< what the bar is about
  bool cancelled_ = false;  ///< by the user
  BackgroundTask task_;
  bool atOnce_;
  bool pathWork_ = false;
  bool toTheEnd_ = false;  ///< what is under way
  std::optional<Job> waiting_;
  std::vector<Other> others_;          ///< in the order of their begin
  std::optional<Diagnostic> failure_;  ///< the last one that nobody has taken
  std::string reportedFailure_;        ///< the last one
};

}  // namespace glissade
