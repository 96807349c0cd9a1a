#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QMessageBox>

namespace glissade {

/// A message box that shows its texts as plain text. Names and reasons come from files, and Qt interprets a text that
/// looks like HTML, with its pictures. The buttons have no icons, because Qt has icons only for its standard buttons.
class PlainMessageBox final : public QMessageBox {
 public:
  PlainMessageBox(Icon icon, const QString& title, const QString& text, const QString& details, QWidget* parent)
      : QMessageBox(icon, title, {}, NoButton, parent) {
    setTextFormat(Qt::PlainText);
    setText(text);
    if (details.isEmpty()) return;
    setInformativeText(details);
    // setTextFormat() has no effect on this label.
    if (auto* label = findChild<QLabel*>(QStringLiteral("qt_msgbox_informativelabel"))) {
      label->setTextFormat(Qt::PlainText);
    }
  }

 protected:
  void showEvent(QShowEvent* event) override {
    for (QAbstractButton* button : buttons()) button->setIcon({});
    QMessageBox::showEvent(event);
  }
};

}  // namespace glissade
