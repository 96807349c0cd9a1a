#include "engine/study/study_words.h"

#include "engine/study/instruction/instruction_french.h"
#include "engine/study/study_french.h"

namespace glissade {
namespace {

/// The translation; nothing where there is none.
std::optional<std::string_view> inFrench(std::string_view english) {
  for (const auto* sentences : {&studyFrench(), &instructionFrench()}) {
    if (const auto found = sentences->find(english); found != sentences->end()) return found->second;
  }
  return std::nullopt;
}

}  // namespace

bool StudyWords::knows(std::string_view english) const {
  return language_ == Language::English || inFrench(english).has_value();
}

std::string StudyWords::operator()(std::string_view english, std::initializer_list<std::string> arguments) const {
  const std::string_view sentence = language_ == Language::French ? inFrench(english).value_or(english) : english;
  std::string text;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool place =
        sentence[i] == '%' && i + 1 < sentence.size() && sentence[i + 1] >= '1' && sentence[i + 1] <= '9';
    const auto which = place ? static_cast<std::size_t>(sentence[i + 1] - '1') : arguments.size();
    if (which < arguments.size()) {
      text += *(arguments.begin() + which);
      ++i;
    } else {
      text += sentence[i];
    }
  }
  return text;
}

}  // namespace glissade
