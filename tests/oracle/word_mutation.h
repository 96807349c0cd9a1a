#pragma once

#include <string>
#include <vector>

#include "tests/oracle/json_mutation.h"

namespace glissade::oracle {

/// The known truth of a plan after a change.
enum class MutantTruth {
  False,    ///< a number or a name is wrong: it must be refused
  ByWords,  ///< it rests on words of its own, if it holds at all: it must not be called valid without a condition
  Unknown   ///< it must be answered
};

struct WordMutant {
  std::string what;  ///< was done, for people
  MutantTruth truth = MutantTruth::Unknown;
  bool clashesAreAccepted = true;  ///< by the person who checks it
};

/// Changes the words, joints, groups, numbers, yields or hosts of an assembly plan whose steps all have one body, and
/// whose product has screws.
WordMutant mutateWords(Json& plan, MutationDice& dice);

}  // namespace glissade::oracle
