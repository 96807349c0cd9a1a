#pragma once

#include <QDialog>
#include <QImage>
#include <QPalette>

#include <string>

#include "engine/study/plan_graph.h"

namespace glissade {

/// An SVG picture of a plan's order in a window of its own, with scroll bars where it is larger.
class PlanGraphView final : public QDialog {
  Q_OBJECT

 public:
  explicit PlanGraphView(QWidget* parent);

  void setPicture(const std::string& svg);
};

/// Those of the window.
GraphColours graphColours(const QPalette& palette);

/// The SVG as pixels, so many for each of its units; smaller where it would have more than the side's most pixels.
QImage imageOfSvg(const std::string& svg, double scale);

}  // namespace glissade
