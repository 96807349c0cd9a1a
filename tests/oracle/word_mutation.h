#pragma once

#include <string>
#include <vector>

#include "tests/oracle/json_mutation.h"

namespace glissade::oracle {

/// The known truth of a plan after a change.
enum class MutantTruth {
  False,    ///< a number or a name is wrong: the plan must be refused
  ByWords,  ///< the plan depends on its own words, if it holds at all: it must not be called valid without a condition
  Unknown   ///< the plan must get an answer
};

struct WordMutant {
  std::string what;  ///< description of the change for people
  MutantTruth truth = MutantTruth::Unknown;
  bool clashesAreAccepted = true;  ///< whether the person who checks it accepts clashes
};

/// Changes the words, joints, groups, numbers, yields or hosts of an assembly plan. Precondition: all steps of the plan
/// have one body, and the product has screws.
WordMutant mutateWords(Json& plan, MutationDice& dice);

}  // namespace glissade::oracle
