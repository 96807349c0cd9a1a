#include "widgets/controls/menu_mnemonics.h"

#include <algorithm>

namespace glissade {
namespace {

constexpr char16_t kFirstBeyondAscii = 0x80;

}  // namespace

QChar mnemonicOf(const QString& text) {
  for (int at = text.indexOf(QLatin1Char('&')); at >= 0 && at + 1 < text.size();
       at = text.indexOf(QLatin1Char('&'), at + 2)) {
    if (text.at(at + 1) != QLatin1Char('&')) return text.at(at + 1).toLower();
  }
  return {};
}

/// Uses only ASCII letters, because not every keyboard has others.
void addMnemonics(const QMenu& menu) {
  QString taken;
  for (const QAction* entry : menu.actions()) taken += mnemonicOf(entry->text());
  for (QAction* entry : menu.actions()) {
    QString text = entry->text();
    if (!mnemonicOf(text).isNull()) continue;
    const auto letter = std::find_if(text.begin(), text.end(), [&taken](QChar one) {
      return one.isLetter() && one < QChar(kFirstBeyondAscii) && !taken.contains(one, Qt::CaseInsensitive);
    });
    if (letter == text.end()) continue;
    taken += letter->toLower();
    entry->setText(text.insert(static_cast<int>(letter - text.begin()), QLatin1Char('&')));
  }
}

}  // namespace glissade
