#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QMessageBox>

namespace glissade {

/// A message box that shows its texts as they are. Names and reasons come from files, and Qt takes a text that looks
/// like HTML for HTML, pictures included. Its buttons have no icons: Qt has them for its standard buttons only.
class PlainMessageBox final : public QMessageBox {
 public:
  PlainMessageBox(Icon icon, const QString& title, const QString& text, const QString& details, QWidget* parent)
      : QMessageBox(icon, title, {}, NoButton, parent) {
    setTextFormat(Qt::PlainText);
    setText(text);
    if (details.isEmpty()) return;
    setInformativeText(details);
    // setTextFormat() does not count for this label.
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
