#pragma once

#include <QString>

#include "engine/model/body_id.h"

namespace glissade {

/// The id of a body in data and texts of Qt, and back.
inline QString toQString(const BodyId& id) { return QString::fromStdString(id.text()); }
inline BodyId toBodyId(const QString& text) { return BodyId(text.toStdString()); }

}  // namespace glissade
