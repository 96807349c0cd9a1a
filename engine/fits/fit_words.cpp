#include "engine/fits/fit_words.h"

#include <algorithm>

#include "engine/fits/contact_report.h"

namespace glissade {

const FitEdit* editOf(const FitSettings& settings, const BodyId& a, const BodyId& b) {
  const auto found = std::find_if(settings.pairs.begin(), settings.pairs.end(), [&](const FitEdit& edit) {
    return (edit.a == a && edit.b == b) || (edit.a == b && edit.b == a);
  });
  return found == settings.pairs.end() ? nullptr : &*found;
}

evidence::FitWords wordsOf(const FitSettings& settings) {
  evidence::FitWords words{settings.on, settings.acceptedClash, {}};
  for (const FitEdit& edit : settings.pairs) {
    evidence::PairWord word{edit.a, edit.b};
    if (edit.kind) word.kind = kContactKindNames.of(*edit.kind);
    word.allowance = edit.allowance;
    word.accepted = edit.accepted;
    word.pitch = edit.pitch;
    word.turned = edit.turned;
    words.pairs.push_back(std::move(word));
  }
  words.cut = settings.cut;
  return words;
}

evidence::PartingWords partingsOf(const std::vector<JointEdit>& edits) {
  evidence::PartingWords words;
  for (const JointEdit& edit : edits) {
    const bool parts = edit.word == JointEdit::Word::Dissolved || edit.word == JointEdit::Word::PressedOut;
    for (const BodyId& other : edit.key.others) {
      const std::pair<BodyId, BodyId> pair = std::minmax(edit.key.body, other);
      std::erase(words.pairs, pair);
      if (parts) words.pairs.push_back(pair);
    }
  }
  return words;
}

std::vector<std::vector<BodyId>> unitsOf(const std::vector<JointEdit>& edits) {
  std::vector<std::vector<BodyId>> units;
  for (const JointEdit& edit : edits) {
    const JointKind kind = edit.key.kind;
    if (kind != JointKind::Insert && kind != JointKind::Permanent && kind != JointKind::Unit) continue;
    std::vector<BodyId> bodies{edit.key.body};
    bodies.insert(bodies.end(), edit.key.others.begin(), edit.key.others.end());
    std::erase(units, bodies);
    if (edit.word == JointEdit::Word::Confirmed) units.push_back(std::move(bodies));
  }
  return units;
}

}  // namespace glissade
