#pragma once

#include <QFileInfo>
#include <QMainWindow>
#include <QToolButton>

#include "engine/base/diagnostic.h"
#include "widgets/controls/message_log.h"

namespace glissade {

/// Shows events to the user: errors in a dialog, others in the status bar. The log receives all of them.
class Messages final {
 public:
  explicit Messages(QMainWindow& window);

  /// Opens no dialogs, because no person can answer them (scripts, pictures).
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool isQuiet() const { return quiet_; }

  void showError(const QString& title, const Diagnostic& why);
  /// Asks which of two contradictory demands stays, and returns whether it is the new one. In quiet mode it reports an
  /// error, and nothing changes.
  bool isNewDemandPreferred(const QString& title, const Diagnostic& conflict);
  void showStatus(const QString& text);
  /// Shows that a document was saved, with a button that opens it.
  void showSaved(const QString& text, const QString& file);
  MessageLog& log() { return log_; }

 private:
  QMainWindow& window_;
  QFileInfo saved_;         ///< the document that the present message is about
  QToolButton* openSaved_;  ///< opens it; hidden where the message is about none
  MessageLog log_;
  bool quiet_ = false;
};

}  // namespace glissade
