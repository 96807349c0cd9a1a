#pragma once

#include <QMainWindow>

#include "engine/base/diagnostic.h"
#include "widgets/controls/message_log.h"

namespace glissade {

/// Shows events to the user: errors in a dialog, others in the status bar. The log receives all of them.
class Messages final {
 public:
  explicit Messages(QMainWindow& window) : window_(window) {}

  /// Opens no dialogs, because no person can answer them (scripts, pictures).
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool isQuiet() const { return quiet_; }

  void showError(const QString& title, const Diagnostic& why);
  /// Asks which of two contradictory demands stays, and returns whether it is the new one. In quiet mode it reports an
  /// error, and nothing changes.
  bool isNewDemandPreferred(const QString& title, const Diagnostic& conflict);
  void showStatus(const QString& text);
  MessageLog& log() { return log_; }

 private:
  QMainWindow& window_;
  MessageLog log_;
  bool quiet_ = false;
};

}  // namespace glissade
