#include "widgets/workbench/messages.h"

#include <QApplication>
#include <QDesktopServices>
#include <QEvent>
#include <QFileInfo>
#include <QPushButton>
#include <QStatusBar>
#include <QUrl>

#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/plain_message_box.h"

namespace glissade {
namespace {

/// Opens the file in the desktop's program, or its folder if no program opens it.
void openOnDesktop(const QFileInfo& file) {
  if (QDesktopServices::openUrl(QUrl::fromLocalFile(file.absoluteFilePath()))) return;
  QDesktopServices::openUrl(QUrl::fromLocalFile(file.absolutePath()));
}

}  // namespace

// The button is in the bar from the start: a widget that comes later makes Qt show again what the message hides.
Messages::Messages(QMainWindow& window, int shownAtLeast)
    : window_(window), shownAtLeast_(shownAtLeast), openSaved_(new QToolButton(window.statusBar())) {
  openSaved_->setObjectName(QStringLiteral("open-saved"));
  openSaved_->setText(QCoreApplication::translate("Messages", "Open"));
  openSaved_->setFocusPolicy(Qt::TabFocus);
  openSaved_->hide();
  window.statusBar()->addPermanentWidget(openSaved_);
  connect(openSaved_, &QToolButton::clicked, this, [this] { openOnDesktop(saved_); });
  connect(window.statusBar(), &QStatusBar::messageChanged, openSaved_, &QWidget::hide);
  connect(window.statusBar(), &QStatusBar::messageChanged, this, [this] { kept_.invalidate(); });
  qApp->installEventFilter(this);
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

bool Messages::isWanted(const QString& title, const QString& text, const QString& accept) {
  log_.add(LogLevel::Information, title + QStringLiteral(": ") + text);
  if (quiet_) return false;
  PlainMessageBox box(QMessageBox::Information, title, title, text, &window_);
  const QPushButton* wanted = box.addButton(accept, QMessageBox::ActionRole);
  box.setDefaultButton(box.addButton(QMessageBox::Close));
  box.exec();
  return box.clickedButton() == wanted;
}

void Messages::showStatus(const QString& text) {
  log_.add(LogLevel::Information, text);
  window_.statusBar()->showMessage(text, shownAtLeast_);
}

void Messages::showUntilAction(const QString& text) {
  log_.add(LogLevel::Information, text);
  window_.statusBar()->showMessage(text);
  kept_.start();
}

bool Messages::eventFilter(QObject* watched, QEvent* event) {
  const bool isAction = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::KeyPress;
  if (isAction && watched != openSaved_ && kept_.isValid() && kept_.elapsed() >= shownAtLeast_) {
    window_.statusBar()->clearMessage();
  }
  return QObject::eventFilter(watched, event);
}

void Messages::showSaved(const QString& text, const QString& file) {
  showUntilAction(text);
  if (quiet_) return;
  saved_.setFile(file);
  openSaved_->setToolTip(QCoreApplication::translate("Messages", "Open %1").arg(saved_.absoluteFilePath()));
  openSaved_->setAccessibleName(openSaved_->toolTip());
  openSaved_->show();
}

}  // namespace glissade
