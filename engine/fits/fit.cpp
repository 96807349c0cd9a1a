#include "engine/fits/fit.h"

#include <array>
#include <sstream>
#include <utility>

namespace glissade {
namespace {

/// The role of the body that is taken thinner.
Fit::Role roleOfThinner(const Fit& fit) {
  if (!fit.yields || fit.role == Fit::Role::Other) return fit.role;
  return fit.role == Fit::Role::Shaft ? Fit::Role::Hole : Fit::Role::Shaft;
}

CatalogueText inWords(ContactKind kind) {
  constexpr std::array<CatalogueText, 8> kKinds{
      GLISSADE_TEXT("clearance"), GLISSADE_TEXT("planar"),  GLISSADE_TEXT("cylindrical"), GLISSADE_TEXT("thread"),
      GLISSADE_TEXT("press"),     GLISSADE_TEXT("overlap"), GLISSADE_TEXT("contact"),     GLISSADE_TEXT("clash")};
  return kKinds[static_cast<std::size_t>(kind)];
}

/// The text that says on which surface a body is taken thinner. %1 is the body, %2 the amount, %3 the other body, %4
/// the kind.
CatalogueText thinnerText(const Fit& fit) {
  const bool isThread = fit.kind == ContactKind::Thread;
  switch (roleOfThinner(fit)) {
    case Fit::Role::Shaft:
      return isThread ? GLISSADE_TEXT("%1, %2 in the tapped hole of %3 (%4)")
                      : GLISSADE_TEXT("%1, %2 in the hole of %3 (%4)");
    case Fit::Role::Hole:
      return isThread ? GLISSADE_TEXT("%1, %2 on the thread of %3 (%4)")
                      : GLISSADE_TEXT("%1, %2 on the shaft of %3 (%4)");
    case Fit::Role::Other: break;
  }
  return GLISSADE_TEXT("%1, %2 on %3 (%4)");
}

}  // namespace

Message inWords(const Fit& fit, const std::string& object, const std::string& obstacle) {
  const std::string& thinner = fit.yields ? obstacle : object;
  const std::string& other = fit.yields ? object : obstacle;
  if (fit.hollow && fit.kind == ContactKind::Thread) {
    return {GLISSADE_TEXT("%1 without what its screw %2 fills (no tapped hole in the file)"), {thinner, other}};
  }
  if (fit.hollow) {
    return {GLISSADE_TEXT("%1 without what overlaps %2, up to %3 deep (accepted clash)"),
            {thinner, other, Depth{fit.allowance}}};
  }
  Message kind = inWords(fit.kind);
  if (fit.evidence.byPerson > 0.0) kind = {GLISSADE_TEXT("%1, user-defined"), {kind}};
  Message words{thinnerText(fit), {thinner, Length{fit.allowance}, other, kind}};
  if (!fit.thread) return words;
  const Length pitch{fit.thread->rule.pitch};
  if (fit.thread->size.empty()) return {GLISSADE_TEXT("%1, pitch %2"), {words, pitch}};
  return {GLISSADE_TEXT("%1, pitch %2 (ISO coarse, %3)"), {words, pitch, fit.thread->size}};
}

Message withTurns(Message words, double turns) {
  if (turns <= 0.0) return words;
  std::ostringstream text;
  text.precision(3);
  text << turns;
  return {GLISSADE_TEXT("%1, %2 {2|turn|turns}"), {std::move(words), text.str()}};
}

}  // namespace glissade
