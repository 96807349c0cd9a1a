// Attacks `glissade-cli check` with trapped parts and with changed paths and plans. It uses no code of the engine.
#include <exception>
#include <iostream>
#include <string>

#include "tests/oracle/mutation_campaign.h"
#include "tests/oracle/overlap_campaign.h"
#include "tests/oracle/trapped_campaign.h"
#include "tests/oracle/word_campaign.h"

namespace glissade::oracle {
namespace {

int run(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if ((command == "trapped" || command == "open") && (argc == 6 || argc == 7)) {
    TrappedOptions options{argv[2], argv[3], std::stoull(argv[4]), std::stoull(argv[5])};
    options.open = command == "open";
    if (argc == 7) options.planEvery = std::stoull(argv[6]);
    return runTrapped(options);
  }
  if (command == "mutants" && argc == 6) {
    return runMutations({argv[2], argv[3], std::stoull(argv[4]), std::stoull(argv[5])});
  }
  if (command == "words" && argc == 7) {
    return runWordMutations({argv[2], argv[3], argv[4], std::stoull(argv[5]), std::stoull(argv[6])});
  }
  if (command == "overlaps" && argc == 6) {
    return runOverlaps({argv[2], argv[3], std::stoull(argv[4]), std::stoull(argv[5])});
  }
  std::cerr << "usage: check_attack trapped GLISSADE_CLI FOLDER SEED PAIRS [PLAN_EVERY]\n"
               "       check_attack open GLISSADE_CLI FOLDER SEED PAIRS [PLAN_EVERY]\n"
               "       check_attack mutants GLISSADE_CLI FOLDER SEED MUTANTS\n"
               "       check_attack words GLISSADE_CLI FOLDER PRODUCT.step SEED MUTANTS\n"
               "       check_attack overlaps GLISSADE_CLI FOLDER SEED CASES\n";
  return 2;
}

}  // namespace
}  // namespace glissade::oracle

int main(int argc, char** argv) {
  try {
    return glissade::oracle::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "check_attack: " << error.what() << "\n";
    return 3;
  }
}
