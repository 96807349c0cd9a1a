#pragma once

#include <QElapsedTimer>
#include <QFileInfo>
#include <QMainWindow>
#include <QToolButton>

#include "engine/base/diagnostic.h"
#include "widgets/controls/message_log.h"

namespace glissade {

/// Shows events to the user: errors in a dialog, others in the status bar. The log receives all of them.
class Messages final : public QObject {
 public:
  /// `shownAtLeast`: the least time, milliseconds, that a message is shown.
  explicit Messages(QMainWindow& window, int shownAtLeast = 10'000);

  /// Opens no dialogs, because no person can answer them (scripts, pictures).
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool isQuiet() const { return quiet_; }

  void showError(const QString& title, const Diagnostic& why);
  /// Asks which of two contradictory demands stays, and returns whether it is the new one. In quiet mode it reports an
  /// error, and nothing changes.
  bool isNewDemandPreferred(const QString& title, const Diagnostic& conflict);
  /// Says why something is not done, and offers to do `accept` instead; returns whether the person wants it. In quiet
  /// mode nobody does.
  bool isWanted(const QString& title, const QString& text, const QString& accept);
  void showStatus(const QString& text);
  /// Shows the text until a click or a key after its least time, so that a person who was away can read it.
  void showUntilAction(const QString& text);
  /// Shows that a document was saved, until the next action, with a button that opens it.
  void showSaved(const QString& text, const QString& file);
  MessageLog& log() { return log_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QMainWindow& window_;
  int shownAtLeast_;
  QElapsedTimer kept_;      ///< since the message was shown that an action ends; invalid: there is none
  QFileInfo saved_;         ///< the document that the present message is about
  QToolButton* openSaved_;  ///< opens it; hidden where the message is about none
  MessageLog log_;
  bool quiet_ = false;
};

}  // namespace glissade
