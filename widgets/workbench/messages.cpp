#include "widgets/workbench/messages.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QPushButton>
#include <QStatusBar>
#include <QUrl>

#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/plain_message_box.h"

namespace glissade {
namespace {

constexpr int kStatusMilliseconds = 10000;

/// Opens the file in the desktop's program, or its folder if no program opens it.
void openOnDesktop(const QFileInfo& file) {
  if (QDesktopServices::openUrl(QUrl::fromLocalFile(file.absoluteFilePath()))) return;
  QDesktopServices::openUrl(QUrl::fromLocalFile(file.absolutePath()));
}

}  // namespace

// The button is in the bar from the start: a widget that comes later makes Qt show again what the message hides.
Messages::Messages(QMainWindow& window) : window_(window), openSaved_(new QToolButton(window.statusBar())) {
  openSaved_->setObjectName(QStringLiteral("open-saved"));
  openSaved_->setText(QCoreApplication::translate("Messages", "Open"));
  openSaved_->setFocusPolicy(Qt::TabFocus);
  openSaved_->hide();
  window.statusBar()->addPermanentWidget(openSaved_);
  QObject::connect(openSaved_, &QToolButton::clicked, [this] { openOnDesktop(saved_); });
  QObject::connect(window.statusBar(), &QStatusBar::messageChanged, openSaved_, &QWidget::hide);
}

void Messages::showError(const QString& title, const Diagnostic& why) {
  const QString file = why.file.empty() ? QString() : QString::fromStdString(why.file) + QStringLiteral(": ");
  log_.add(LogLevel::Error, title + QStringLiteral(": ") + file + diagnosticText(why));
  if (quiet_) return;
  QString details;
  for (const QString& part : {QString::fromStdString(why.file), engineText(why.location), engineText(why.reason)}) {
    if (!part.isEmpty()) details += (details.isEmpty() ? "" : "\n") + part;
  }
  if (!why.advice.empty()) details += QStringLiteral("\n\n") + engineText(why.advice);
  PlainMessageBox box(QMessageBox::Warning, title, title, details, &window_);
  box.setStandardButtons(QMessageBox::Ok);
  box.exec();
}

bool Messages::isNewDemandPreferred(const QString& title, const Diagnostic& conflict) {
  if (quiet_) {
    showError(title, conflict);
    return false;
  }
  PlainMessageBox box(QMessageBox::Question, title, title, engineText(conflict.reason), &window_);
  box.addButton(QCoreApplication::translate("Messages", "&Keep the earlier constraint"), QMessageBox::RejectRole);
  const QPushButton* newer = box.addButton(QCoreApplication::translate("Messages", "&Remove it and take the new one"),
                                           QMessageBox::AcceptRole);
  box.exec();
  return box.clickedButton() == newer;
}

void Messages::showStatus(const QString& text) {
  log_.add(LogLevel::Information, text);
  window_.statusBar()->showMessage(text, kStatusMilliseconds);
}

void Messages::showSaved(const QString& text, const QString& file) {
  showStatus(text);
  if (quiet_) return;
  saved_.setFile(file);
  openSaved_->setToolTip(QCoreApplication::translate("Messages", "Open %1").arg(saved_.absoluteFilePath()));
  openSaved_->setAccessibleName(openSaved_->toolTip());
  openSaved_->show();
}

}  // namespace glissade
