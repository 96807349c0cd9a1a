#include "app/window/headset_questions.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QEvent>
#include <QMessageBox>

#include <algorithm>

#include "widgets/bridge/queued_once.h"
#include "widgets/commands/action_catalogue.h"

namespace glissade {

HeadsetQuestions::HeadsetQuestions(HeadsetPage& page) : page_(page), showSoon_(queuedOnce(this, [this] { show(); })) {
  connect(&page, &HeadsetPage::answered, this, &HeadsetQuestions::answer);
  qApp->installEventFilter(this);
}

bool HeadsetQuestions::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show || event->type() == QEvent::Hide) {
    auto* dialog = qobject_cast<QDialog*>(watched);
    if (dialog != nullptr && dialog->isModal()) {
      open_.erase(std::remove(open_.begin(), open_.end(), dialog), open_.end());
      if (event->type() == QEvent::Show) open_.emplace_back(dialog);
      showSoon_();
    }
  }
  return QObject::eventFilter(watched, event);
}

void HeadsetQuestions::show() {
  open_.erase(std::remove(open_.begin(), open_.end(), nullptr), open_.end());
  if (open_.empty()) {
    page_.ask({}, {}, {});
    return;
  }
  const auto* message = qobject_cast<QMessageBox*>(open_.back().data());
  if (message == nullptr) {
    page_.ask(open_.back()->windowTitle(),
              QCoreApplication::translate("HeadsetQuestions",
                                          "This dialog is in the window. Take the headset off to answer it."),
              {QCoreApplication::translate("HeadsetQuestions", "Close it")});
    return;
  }
  QStringList answers;
  for (const QAbstractButton* button : message->buttons()) answers << withoutMnemonic(button->text());
  page_.ask(message->text(), message->informativeText(), answers);
}

void HeadsetQuestions::answer(int chosen) const {
  if (open_.empty() || !open_.back()) return;
  if (const auto* message = qobject_cast<QMessageBox*>(open_.back().data())) {
    const QList<QAbstractButton*> buttons = message->buttons();
    if (chosen < buttons.size()) buttons[chosen]->click();
  } else {
    open_.back()->reject();
  }
}

}  // namespace glissade
