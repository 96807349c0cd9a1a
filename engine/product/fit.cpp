#include "engine/product/fit.h"

#include <sstream>

#include "engine/base/depth_text.h"
#include "engine/base/quantity_text.h"

namespace glissade {
namespace {

/// The role of the body that is taken thinner.
Fit::Role roleOfThinner(const Fit& fit) {
  if (!fit.yields || fit.role == Fit::Role::Other) return fit.role;
  return fit.role == Fit::Role::Shaft ? Fit::Role::Hole : Fit::Role::Shaft;
}

}  // namespace

std::string inWords(const Fit& fit, const std::string& object, const std::string& obstacle) {
  const std::string& thinner = fit.yields ? obstacle : object;
  const std::string& other = fit.yields ? object : obstacle;
  if (fit.hollow && fit.kind == ContactKind::Thread) {
    return thinner + " taken without what its screw " + other + " fills (no hole in the file)";
  }
  if (fit.hollow) {
    return thinner + " taken without what overlaps " + other + ", up to " + depthInMillimetres(fit.allowance) +
           " deep (accepted clash)";
  }
  const bool isThread = fit.kind == ContactKind::Thread;
  std::string where = " against ";
  if (roleOfThinner(fit) == Fit::Role::Shaft) where = isThread ? " in the tapped hole of " : " in the hole of ";
  if (roleOfThinner(fit) == Fit::Role::Hole) where = isThread ? " on the thread of " : " on the shaft of ";
  const std::string person = fit.evidence.byPerson > 0.0 ? ", as a person allows" : "";
  std::string words = thinner + " taken " + inMillimetres(fit.allowance) + " thinner" + where + other + " (" +
                      kContactKindNames.of(fit.kind) + person + ")";
  if (!fit.thread) return words;
  words += ", pitch " + inMillimetres(fit.thread->rule.pitch);
  return fit.thread->size.empty() ? words : words + " (ISO coarse, " + fit.thread->size + ")";
}

std::string turnsInWords(double turns) {
  if (turns <= 0.0) return {};
  std::ostringstream text;
  text.precision(3);
  text << ", " << turns << " turns";
  return text.str();
}

}  // namespace glissade
