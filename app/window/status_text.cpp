#include "app/window/status_text.h"

#include <QCoreApplication>

namespace glissade {
namespace {

QString say(const char* text) { return QCoreApplication::translate("Status", text); }

}  // namespace

QString statusText(const SessionSnapshot& snapshot) {
  if (snapshot.problem) {
    QString text = QString::fromStdString(toString(*snapshot.problem));
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
  }
  switch (snapshot.state) {
    case SessionState::Idle:
      return say(
          QT_TRANSLATE_NOOP("Status", "Ready. Press Start (F5), or take the object with the keys over the view."));
    case SessionState::Planning:
      return snapshot.contactMode
                 ? say(QT_TRANSLATE_NOOP("Status", "Planning: sampling on the nearest obstacle's tangent plane"))
                 : say(QT_TRANSLATE_NOOP("Status", "Planning: two trees grow"));
    case SessionState::Paused: return say(QT_TRANSLATE_NOOP("Status", "Paused"));
    case SessionState::Solved:
      return say(QT_TRANSLATE_NOOP("Status", "Solved: the path is certified free of penetration"));
    case SessionState::Stopped: return say(QT_TRANSLATE_NOOP("Status", "Stopped: what was found stays shown"));
    case SessionState::Failed: return say(QT_TRANSLATE_NOOP("Status", "Failed"));
  }
  return {};
}

}  // namespace glissade
