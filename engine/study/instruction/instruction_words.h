#pragma once

#include <string>

#include "engine/sequence/step_view.h"
#include "engine/study/plan_words.h"

namespace glissade {

/// What a fitter does, as a sentence with one verb: "Screw in 4 × ISO 4762 M3x8." `what`: what comes.
std::string workSentence(const AssemblyStep& step, const std::string& what, const StudyWords& words);

/// What is asked for between two viewpoints: "Turn the product over."; empty: nothing.
std::string turnSentence(const Viewpoint& from, const Viewpoint& to, const StudyWords& words);

/// "4 × nut"; "nut" where there is one.
std::string countedName(const std::string& name, std::size_t count);

/// The text with its first letter as a capital one, where that is a letter of ASCII or Latin-1.
std::string capitalized(std::string text);

}  // namespace glissade
