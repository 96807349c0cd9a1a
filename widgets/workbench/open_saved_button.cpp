#include "widgets/workbench/open_saved_button.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

namespace glissade {

OpenSavedButton::OpenSavedButton(QStatusBar& bar) : QToolButton(&bar), bar_(bar) {
  setObjectName(QStringLiteral("open-saved"));
  setText(tr("Open"));
  setFocusPolicy(Qt::TabFocus);
  bar.addPermanentWidget(this);
  hide();
  connect(this, &QToolButton::clicked, this, &OpenSavedButton::openFile);
  connect(&bar, &QStatusBar::messageChanged, this, [this](const QString& message) {
    if (message != message_) hide();
  });
}

void OpenSavedButton::offer(const QString& file) {
  file_ = QFileInfo(file).absoluteFilePath();
  message_ = bar_.currentMessage();
  setToolTip(tr("Open %1").arg(file_));
  setAccessibleName(toolTip());
  show();
}

/// Opens the folder if no program opens the file.
void OpenSavedButton::openFile() {
  if (QDesktopServices::openUrl(QUrl::fromLocalFile(file_))) return;
  QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file_).absolutePath()));
}

}  // namespace glissade
