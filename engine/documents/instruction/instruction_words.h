#pragma once

#include <string>

#include "engine/documents/plan_words.h"
#include "engine/sequence/step_view.h"

namespace glissade {

/// The work of a fitter as a sentence with one verb: "Screw in 4 × ISO 4762 M3x8." `what`: the parts that come.
std::string workSentence(const StepMotion& motion, const std::string& what, const DocumentWords& words);

/// The instruction between two viewpoints: "Turn the product over."; empty: none.
std::string turnSentence(const Viewpoint& from, const Viewpoint& to, const DocumentWords& words);

/// The text with a capital first letter, if that is a letter of ASCII or Latin-1.
std::string capitalized(std::string text);

}  // namespace glissade
