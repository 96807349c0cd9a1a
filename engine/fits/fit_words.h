#pragma once

#include <string>
#include <vector>

#include "engine/evidence/pair_words.h"
#include "engine/fits/fit_settings.h"
#include "engine/fits/joint.h"
#include "engine/model/body_id.h"

namespace glissade {

/// A person's statement about a pair, in either order; null if there is none.
const FitEdit* editOf(const FitSettings& settings, const BodyId& a, const BodyId& b);

/// A person's statements about fits, as the judge takes them.
evidence::FitWords wordsOf(const FitSettings& settings);

/// The pairs whose joint a person has dissolved or pressed out, as the judge takes them; the last statement about a
/// pair counts.
evidence::PartingWords partingsOf(const std::vector<JointEdit>& edits);

/// The units that a person has confirmed, bodies by id; the last statement about the same bodies counts.
std::vector<std::vector<BodyId>> unitsOf(const std::vector<JointEdit>& edits);

}  // namespace glissade
