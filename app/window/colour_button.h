#pragma once

#include <QToolButton>

#include <optional>

#include "engine/environment/rigid_body.h"

namespace glissade {

/// A button that shows a colour, or that none is chosen, and asks for another one.
class ColourButton final : public QToolButton {
  Q_OBJECT

 public:
  ColourButton(const QString& name, const std::optional<Colour>& colour, QWidget* parent);

  /// Nothing: the colour of the theme.
  const std::optional<Colour>& colour() const { return colour_; }
  void setColour(const std::optional<Colour>& colour);

 private:
  void ask();

  QString name_;
  std::optional<Colour> colour_;
};

}  // namespace glissade
