#include "engine/evidence/pair_words.h"

#include <algorithm>

namespace glissade::evidence {

bool FitWords::isCut(const BodyId& id) const {
  return std::any_of(cut.begin(), cut.end(), [&](const std::string& name) {
    const std::string& whole = id.text();
    return whole == name ||
           (whole.size() > name.size() && whole.ends_with(name) && whole[whole.size() - name.size() - 1] == '/');
  });
}

const SnapWord* FitWords::snapOf(const BodyId& a, const BodyId& b) const {
  const auto found = std::find_if(snaps.begin(), snaps.end(), [&](const SnapWord& word) {
    return (word.hook == a && word.edge == b) || (word.hook == b && word.edge == a);
  });
  return found == snaps.end() ? nullptr : &*found;
}

Message FitWords::partingOf(const BodyId& a, const BodyId& b) const {
  if (partings.anyPair) return GLISSADE_TEXT("the user uses no joints");
  const std::pair<BodyId, BodyId> pair = std::minmax(a, b);
  if (std::find(partings.pairs.begin(), partings.pairs.end(), pair) != partings.pairs.end()) {
    return GLISSADE_TEXT("the user has dissolved their joint, or has it pressed out");
  }
  const PairWord* word = about(a, b);
  if (word == nullptr || word->isThread()) return {};
  if (!word->kind.empty()) return {GLISSADE_TEXT("the user calls the pair '%1'"), {word->kind}};
  return word->accepted ? Message(GLISSADE_TEXT("the user accepts their clash")) : Message();
}

const PairWord* FitWords::about(const BodyId& a, const BodyId& b) const {
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const PairWord& word) {
    return (word.a == a && word.b == b) || (word.a == b && word.b == a);
  });
  return found == pairs.end() ? nullptr : &*found;
}

}  // namespace glissade::evidence
