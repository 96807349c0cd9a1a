#include "app/window/colour_button.h"

#include <QColorDialog>

#include "widgets/commands/colour_swatch.h"

namespace glissade {
namespace {

QColor toQt(const Colour& colour) { return QColor::fromRgbF(colour[0], colour[1], colour[2]); }

}  // namespace

ColourButton::ColourButton(const QString& name, const std::optional<Colour>& colour, QWidget* parent)
    : QToolButton(parent), name_(name) {
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setFocusPolicy(Qt::StrongFocus);
  setColour(colour);
  connect(this, &QToolButton::clicked, this, [this] { ask(); });
}

void ColourButton::setColour(const std::optional<Colour>& colour) {
  colour_ = colour;
  setIcon(colour ? colourSwatch(toQt(*colour)) : QIcon());
  setText(colour ? toQt(*colour).name() : tr("As the theme"));
  setAccessibleName(name_ + QStringLiteral(": ") + text());
}

void ColourButton::ask() {
  auto* dialog = new QColorDialog(colour_ ? toQt(*colour_) : QColor(Qt::gray), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(name_);
  connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& chosen) {
    setColour(Colour{chosen.redF(), chosen.greenF(), chosen.blueF()});
  });
  dialog->open();
}

}  // namespace glissade
