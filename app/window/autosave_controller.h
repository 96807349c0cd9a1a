#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "engine/scenario/autosave.h"

namespace glissade {

/// Writes unsaved edits into a folder of the program's data every few seconds, on another thread, so that a crash
/// loses only the last of them. Used on the GUI thread.
class AutosaveController final : public QObject {
  Q_OBJECT

 public:
  /// What is not saved at the moment; nothing where everything is.
  using Source = std::function<std::optional<UnsavedEdits>()>;

  AutosaveController(Source source, QObject* parent);
  ~AutosaveController() override;

  /// Seconds between two writings.
  void setInterval(int seconds);
  /// From now on edits are written there. Errors are announced by failed().
  void start(const QString& folder);
  /// Writes now what has changed. Waits for it where `wait` is true.
  void writeChanges(bool wait = false);

 signals:
  /// Edits are not saved automatically any more.
  void failed(const glissade::Diagnostic& why);

 private:
  struct Written {
    Outcome outcome;
    double seconds;  ///< that it took, the text included
  };
  /// On another thread. Where the text is the one that was written last, the disk is left alone.
  static Written write(AutosaveSlot& slot, const std::optional<UnsavedEdits>& edits, std::string& last);
  void takeOutcome();

  Source source_;
  QTimer timer_;
  std::shared_ptr<AutosaveSlot> slot_;  ///< null: not started, or it failed
  std::string written_;                 ///< what the disk holds; empty: nothing. Of the thread that writes
  double pause_ = 0.0;                  ///< seconds to the next writing, at least
  QElapsedTimer sinceWritten_;
  std::future<Written> writing_;  ///< destroyed first: waits
};

}  // namespace glissade
