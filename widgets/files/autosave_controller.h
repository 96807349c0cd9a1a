#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "engine/files/autosave.h"

namespace glissade {

/// Writes unsaved edits into a folder of the program's data every few seconds, on another thread, so that a crash loses
/// only the edits since then. It is used on the GUI thread.
class AutosaveController final : public QObject {
  Q_OBJECT

 public:
  /// The edits that are not saved now; nothing if all are saved.
  using Source = std::function<std::optional<UnsavedEdits>()>;

  AutosaveController(Source source, QObject* parent);
  ~AutosaveController() override;

  /// Seconds between two writings.
  void setInterval(int seconds);
  /// Begins to write edits into the folder. Errors are announced by failed().
  void start(const QString& folder);
  /// Writes changed edits now, and waits for the end if `wait` is true.
  void writeChanges(bool wait = false);

 signals:
  /// Automatic saving has ended because of this error.
  void failed(const glissade::Diagnostic& why);

 private:
  struct Written {
    Outcome outcome;
    double seconds;  ///< duration of the writing, with the text's
  };
  /// Writes on another thread. If the text equals the last one, it does not touch the disk.
  static Written write(AutosaveSlot& slot, const std::optional<UnsavedEdits>& edits, std::string& last);
  void takeOutcome();

  Source source_;
  QTimer timer_;
  std::shared_ptr<AutosaveSlot> slot_;  ///< null: not started, or it failed
  std::string written_;                 ///< text on the disk; empty: none. Only the writing thread uses it
  double pause_ = 0.0;                  ///< minimum seconds until the next writing
  QElapsedTimer sinceWritten_;
  std::future<Written> writing_;  ///< destroyed first, because it waits for the thread
};

}  // namespace glissade
