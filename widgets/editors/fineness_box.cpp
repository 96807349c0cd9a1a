#include "widgets/editors/fineness_box.h"

namespace glissade {

FinenessBox::FinenessBox(QWidget* parent) : QDoubleSpinBox(parent) {
  constexpr double kMostMillimetres = 5.0;
  setObjectName(QStringLiteral("fineness"));
  setAccessibleName(tr("Fineness of STEP surfaces"));
  setToolTip(
      tr("By how much triangles may be off the surfaces of STEP files. Finer ones allow smaller gaps and take longer; "
         "by its size, a part has a thousandth of its diagonal, from 0.01 to 0.5 mm"));
  setRange(0.0, kMostMillimetres);
  setDecimals(3);
  setSingleStep(0.01);
  setSuffix(tr(" mm"));
  setPrefix(tr("STEP within "));
  setSpecialValueText(tr("STEP by size"));
}

}  // namespace glissade
