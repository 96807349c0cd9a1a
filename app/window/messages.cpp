#include "app/window/messages.h"

#include <QStatusBar>

#include "app/window/plain_message_box.h"

namespace glissade {
namespace {

constexpr int kStatusMilliseconds = 10000;

}  // namespace

void Messages::showError(const QString& title, const Diagnostic& why) {
  if (quiet_) return;
  QString details;
  for (const std::string& part : {why.file, why.location, why.reason}) {
    if (!part.empty()) details += (details.isEmpty() ? "" : "\n") + QString::fromStdString(part);
  }
  if (!why.advice.empty()) details += QStringLiteral("\n\n") + QString::fromStdString(why.advice);
  PlainMessageBox box(QMessageBox::Warning, title, title, details, &window_);
  box.setStandardButtons(QMessageBox::Ok);
  box.exec();
}

void Messages::showStatus(const QString& text) { window_.statusBar()->showMessage(text, kStatusMilliseconds); }

}  // namespace glissade
