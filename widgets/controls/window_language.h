#pragma once

#include <QLocale>

#include "engine/base/message.h"

namespace glissade {

/// The language of the window, for texts that the engine writes.
inline Language windowLanguage() {
  return QLocale().language() == QLocale::French ? Language::French : Language::English;
}

}  // namespace glissade
