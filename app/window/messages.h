#pragma once

#include <QMainWindow>

#include "engine/base/diagnostic.h"
#include "widgets/commands/message_log.h"

namespace glissade {

/// Tells the user what happened: errors in a dialog, the rest in the status bar, and all of it in the log.
class Messages final {
 public:
  explicit Messages(QMainWindow& window) : window_(window) {}

  /// Nobody is there to read or answer a dialog (scripts, pictures): none is opened.
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool isQuiet() const { return quiet_; }

  void showError(const QString& title, const Diagnostic& why);
  /// Asks which of two demands that exclude each other is to stay; whether it is the new one. Where nobody is there to
  /// answer it is an error, and nothing changes.
  bool isNewDemandPreferred(const QString& title, const Diagnostic& conflict);
  void showStatus(const QString& text);
  MessageLog& log() { return log_; }

 private:
  QMainWindow& window_;
  MessageLog log_;
  bool quiet_ = false;
};

}  // namespace glissade
