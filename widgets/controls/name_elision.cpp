#include "widgets/controls/name_elision.h"

#include <algorithm>

namespace glissade {
namespace {

const QChar kEllipsis(0x2026);

QString reversed(const QString& text) {
  QString back = text;
  std::reverse(back.begin(), back.end());
  return back;
}

int commonLength(const QString& a, const QString& b) {
  return static_cast<int>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

/// Keeps a letter. A digit is kept with its whole number, and the '#' before it.
void keep(const QString& name, int at, std::vector<bool>& kept) {
  kept[at] = true;
  if (!name[at].isDigit()) return;
  for (int i = at + 1; i < name.size() && name[i].isDigit(); ++i) kept[i] = true;
  int first = at;
  while (first > 0 && name[first - 1].isDigit()) kept[--first] = true;
  if (first > 0 && name[first - 1] == QLatin1Char('#')) kept[first - 1] = true;
}

/// The kept letters with an ellipsis in each gap. A gap of one letter is not a gap.
QString textOf(const QString& name, const std::vector<bool>& kept) {
  QString text;
  for (int i = 0; i < name.size(); ++i) {
    const bool isAlone = (i == 0 || kept[i - 1]) && (i + 1 == name.size() || kept[i + 1]);
    if (kept[i] || isAlone) {
      text += name[i];
    } else if (!text.endsWith(kEllipsis)) {
      text += kEllipsis;
    }
  }
  return text;
}

/// The letters before the kept ones, from the end of the name.
std::vector<int> nextLetters(const std::vector<bool>& kept) {
  std::vector<int> next;
  for (int i = static_cast<int>(kept.size()) - 1; i >= 0; --i) {
    const bool isBeforeKept = i + 1 == static_cast<int>(kept.size()) || kept[i + 1];
    if (!kept[i] && isBeforeKept) next.push_back(i);
  }
  return next;
}

}  // namespace

NameElision::NameElision(const QStringList& names) {
  for (const QString& name : names) reversed_ << reversed(name);
  std::sort(reversed_.begin(), reversed_.end());
  reversed_.removeDuplicates();
}

/// The last letter in which the name differs from each other name.
NameElision::Kept NameElision::distinctLetters(const QString& name) const {
  Kept kept(name.size());
  const QString back = reversed(name);
  const auto here = std::lower_bound(reversed_.begin(), reversed_.end(), back);
  const auto keepFrom = [&](const QString& other) {
    const int common = commonLength(back, other);
    if (common < name.size()) keep(name, name.size() - 1 - common, kept);
    return common;
  };
  for (auto other = here; other != reversed_.end(); ++other) {
    if (*other != back && keepFrom(*other) == 0) break;
  }
  for (auto other = here; other != reversed_.begin();) {
    if (keepFrom(*--other) == 0) break;
  }
  return kept;
}

QString NameElision::elided(const QString& name, const QFontMetrics& metrics, int width) const {
  if (metrics.horizontalAdvance(name) <= width) return name;
  Kept kept = distinctLetters(name);
  const auto grow = [&](int letter) {
    Kept more = kept;
    keep(name, letter, more);
    const bool fits = metrics.horizontalAdvance(textOf(name, more)) <= width;
    if (fits) kept = std::move(more);
    return fits;
  };
  // The last step of the path first, then all runs of letters to their left.
  for (int letter = name.size() - 1; letter > name.lastIndexOf(QLatin1Char('/')) && grow(letter);) --letter;
  for (bool grows = true; grows;) {
    grows = false;
    for (const int letter : nextLetters(kept)) grows = grow(letter) || grows;
  }
  return textOf(name, kept);
}

}  // namespace glissade
