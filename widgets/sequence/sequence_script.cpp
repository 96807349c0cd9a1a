#include "widgets/sequence/sequence_script.h"

#include <algorithm>

#include "engine/base/enum_names.h"
#include "engine/base/number_text.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

Result<double> numberIn(const std::string& word, double most) {
  const auto number = toNumber(word);
  if (!number || *number < 0.0 || *number > most) {
    return wrongCommand("'" + word + "' is not a number from 0 to " + toText(most));
  }
  return *number;
}

/// Names of scripts, which write a dash where files have an underscore.
constexpr EnumNames<PlanEnd, 4> kEndWords{{"complete", "stuck", "time-limit", "interrupted"}};

std::string endOf(const ShownPlan& shown) {
  if (!shown.plan) return "none";
  return kEndWords.of(shown.plan->end);
}

/// The count that the word names; nothing if the word is unknown.
std::optional<std::size_t> countOf(const ShownPlan& shown, const std::string& what) {
  const auto checked = [&shown](StepCheck check) {
    return static_cast<std::size_t>(std::count(shown.check.steps.begin(), shown.check.steps.end(), check));
  };
  if (what == "steps") return shown.plan ? shown.plan->steps.size() : 0;
  if (what == "stuck") return shown.plan ? shown.plan->stuck.size() : 0;
  if (what == "parts") return shown.plan ? shown.plan->parts() : 0;
  if (what == "proved") return checked(StepCheck::Agrees);
  if (what == "refuted") return checked(StepCheck::Disagrees);
  if (what == "conditions") return shown.check.conditions.size();
  return std::nullopt;
}

Outcome expectSequence(const ShownPlan& shown, const std::string& what, const std::string& expected) {
  std::string found;
  if (what == "end") {
    found = endOf(shown);
  } else if (const auto count = countOf(shown, what)) {
    found = std::to_string(*count);
  } else {
    return wrongCommand("'" + what + "' is unknown", "Say steps, stuck, parts, proved, refuted, conditions or end.");
  }
  if (found == expected) return Done{};
  return unmetExpectation("the sequence has " + what + " " + found + ", not " + expected);
}

Outcome planSteps(const Workbench& bench, SequenceController& sequence, const std::string& word) {
  if (!bench.document.scenario()) return wrongCommand("no product is open");
  constexpr double kMostSteps = 1e6;
  const auto most = numberIn(word == "all" ? "1000000" : word, kMostSteps);
  if (!most) return most.error();
  const bool resume = bench.actions["sequence.resume"]->isEnabled();
  sequence.plan(resume, word == "all" ? std::nullopt : std::optional(static_cast<std::size_t>(*most)));
  return Done{};
}

}  // namespace

void addSequenceCommands(const Workbench& bench, SequenceController& sequence) {
  ScriptCommands& scripts = bench.scripts;
  SequencePanel& panel = *sequence.panel();
  scripts.add("plan-sequence", 1,
              [&bench, &sequence](const Words& words) { return planSteps(bench, sequence, words[0]); });
  scripts.add("expect-sequence", 2,
              [&sequence](const Words& words) { return expectSequence(sequence.shown(), words[0], words[1]); });
  scripts.add("open-sequence", 1,
              [&sequence](const Words& words) { return outcomeOf(sequence.open(QString::fromStdString(words[0]))); });
  scripts.add("export-sequence", 1, [&sequence](const Words& words) {
    return sequence.written(words[0], [&](const InstructionJob::Finished& finished) {
      sequence.exportTo(QString::fromStdString(words[0]), finished);
    });
  });
  scripts.add("show-step", 1, [&panel](const Words& words) -> Outcome {
    const std::size_t steps = panel.shown().plan ? panel.shown().plan->steps.size() : 0;
    const auto number = numberIn(words[0], static_cast<double>(steps));
    if (!number) return number.error();
    const auto place = static_cast<std::size_t>(*number);
    return place > 0 && panel.chooseStep(place - 1) ? Outcome(Done{}) : wrongCommand("there is no step " + words[0]);
  });
  scripts.add("seek-sequence", 1, [&panel](const Words& words) -> Outcome {
    const auto share = numberIn(words[0], 1.0);
    if (!share) return share.error();
    const double steps = panel.shown().plan ? static_cast<double>(panel.shown().plan->steps.size()) : 0.0;
    panel.showTime(steps * *share);
    return Done{};
  });
  scripts.add("explode", 1, [&panel](const Words& words) -> Outcome {
    const auto share = numberIn(words[0], 1.0);
    if (!share) return share.error();
    panel.showExploded(*share);
    return Done{};
  });
}

}  // namespace glissade
