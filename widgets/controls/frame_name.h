#pragma once

#include <QCoreApplication>

#include "engine/operator/device_shaping.h"

namespace glissade {

/// Name of the axes along which a person steers.
inline QString frameName(MotionFrame frame) {
  switch (frame) {
    case MotionFrame::View: return QCoreApplication::translate("FrameName", "axes of the view");
    case MotionFrame::World: return QCoreApplication::translate("FrameName", "axes of the world");
    case MotionFrame::Object: return QCoreApplication::translate("FrameName", "axes of the object");
  }
  return {};
}

}  // namespace glissade
