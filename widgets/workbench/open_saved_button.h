#pragma once

#include <QStatusBar>
#include <QToolButton>

namespace glissade {

/// A button beside the message in the status bar that a file was saved. It opens the file in the desktop's program, and
/// is hidden with the message.
class OpenSavedButton final : public QToolButton {
  Q_OBJECT

 public:
  explicit OpenSavedButton(QStatusBar& bar);

  /// Precondition: the status bar shows a message about the file.
  void offer(const QString& file);

 private:
  void openFile();

  QString message_;
  QString file_;
  QStatusBar& bar_;
};

}  // namespace glissade
