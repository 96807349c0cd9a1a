#pragma once

#include <QDialog>
#include <QImage>
#include <QPalette>

#include <string>

#include "engine/documents/plan_graph.h"

namespace glissade {

/// Shows an SVG picture of a plan's order in a separate window, with scroll bars if it is larger.
class PlanGraphView final : public QDialog {
  Q_OBJECT

 public:
  explicit PlanGraphView(QWidget* parent);

  void setPicture(const std::string& svg);
};

/// The colours of the window.
GraphColours graphColours(const QPalette& palette);

/// The SVG as an image with `scale` pixels for each of its units. It is smaller if a side would exceed the largest
/// size.
QImage imageOfSvg(const std::string& svg, double scale);

}  // namespace glissade
