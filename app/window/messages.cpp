#include "app/window/messages.h"

#include <QMessageBox>
#include <QStatusBar>

namespace glissade {
namespace {

constexpr int kStatusMilliseconds = 10000;

}  // namespace

void Messages::showError(const QString& title, const Diagnostic& why) {
  if (quiet_) return;
  QMessageBox box(QMessageBox::Warning, title, title, QMessageBox::Ok, &window_);
  QString text = QString::fromStdString(why.reason);
  if (!why.advice.empty()) text += QStringLiteral("\n\n") + QString::fromStdString(why.advice);
  box.setInformativeText(QString::fromStdString(why.file + (why.location.empty() ? "" : "\n" + why.location)) +
                         QStringLiteral("\n") + text);
  box.exec();
}

void Messages::showStatus(const QString& text) { window_.statusBar()->showMessage(text, kStatusMilliseconds); }

}  // namespace glissade
