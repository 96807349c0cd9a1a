// Every kind of a person's edit holds in every situation. The rows of kWords are the kinds, the columns the situations.
// A cell is tested here, or states why it does not apply, or names the test that covers it.
#include <gtest/gtest.h>

#include <QTemporaryDir>

#include <cstdlib>
#include <functional>
#include <map>

#include "engine/base/random_stream.h"
#include "engine/files/hand_run.h"
#include "engine/files/product_file.h"
#include "engine/files/scenario_io.h"
#include "engine/files/sequence_knowledge.h"
#include "engine/sequence/demand_edits.h"
#include "tests/engine/support/directories.h"
#include "widgets/document/workbench_document.h"

namespace glissade {
namespace {

using Edit = std::function<void(WorkbenchDocument&)>;
using Question = std::function<bool(const Scenario&)>;

enum class Situation {
  UndoneAndRedone,
  Rearranged,
  MovedByHand,
  Reopened,
  CommandLine,
  PathStrategies,
  SequenceStrategies,
  Check
};
constexpr Situation kSituations[] = {Situation::UndoneAndRedone,    Situation::Rearranged,  Situation::MovedByHand,
                                     Situation::Reopened,           Situation::CommandLine, Situation::PathStrategies,
                                     Situation::SequenceStrategies, Situation::Check};
constexpr const char* kSituationNames[] = {"UndoneAndRedone", "Rearranged",     "MovedByHand",        "Reopened",
                                           "CommandLine",     "PathStrategies", "SequenceStrategies", "Check"};

/// Cells that are not tested here, with the reason or the name of the test.
using Reasons = std::map<Situation, std::string>;

struct Word {
  std::string name;
  Edit say;
  Question isInScenario;  ///< whether the scenario holds the edit
  /// Whether a strategy of sequences receives the edit, if it should.
  std::function<bool(const SequenceDemands&)> reachesSequences;
  /// Whether a planner of paths receives the edit, if it should.
  std::function<bool(const LoadedScenario&)> reachesPaths;
  Reasons elsewhere;
};

const Reasons kOfSequences{{Situation::PathStrategies,
                            "it is about the order and the motions of a product's parts, not about the one motion"}};
const Reasons kOfPaths{
    {Situation::SequenceStrategies, "it is about the motion of the scenario's object; sequences move every part"}};
const Reasons kOfSettings{
    {Situation::UndoneAndRedone, "settings of the next run are tried out and are not on the undo stack"},
    {Situation::SequenceStrategies, "sequences have parameters of their own, which do not depend on a run's"}};

Reasons operator+(Reasons a, const Reasons& b) {
  a.insert(b.begin(), b.end());
  return a;
}

Reasons checkedBy(const std::string& test) { return {{Situation::Check, test}}; }
const Reasons kPlanIsChecked =
    checkedBy("plan_judge_test and cli_test: a plan is judged against the demands it states");
const Reasons kNotChecked =
    checkedBy("it says how a run searches or in which order it prefers; no path is false for it");

SemanticSelection bodies(std::initializer_list<const char*> ids) {
  SemanticSelection selection;
  for (const char* id : ids) selection.bodies.insert(QString::fromLatin1(id));
  return selection;
}

Edit attribute(const std::string& name, const AttributeValue& value) {
  return [=](WorkbenchDocument& document) {
    EXPECT_TRUE(document.semantics().setAttribute(bodies({"O2"}), name, value).ok()) << name;
    document.semantics().endGesture();
  };
}

Question hasAttribute(const std::string& name, const AttributeValue& value) {
  return [=](const Scenario& scenario) {
    for (const BodyDescription& body : scenario.bodies) {
      const auto found = body.attributes.find(name);
      if (body.id == "O2") return found != body.attributes.end() && found->second == value;
    }
    return false;
  };
}

Word knowledge(const std::string& name, const AttributeValue& value,
               std::function<bool(const SequenceDemands&)> reaches) {
  return {name,    attribute(name, value),       hasAttribute(name, value), std::move(reaches),
          nullptr, kOfSequences + kPlanIsChecked};
}

/// An edit of the place of the map with this number.
Edit placeAttribute(const std::string& name, const AttributeValue& value) {
  return [=](WorkbenchDocument& document) {
    SemanticSelection selection;
    selection.places.insert(1);
    EXPECT_TRUE(document.semantics().setAttribute(selection, name, value).ok());
    document.semantics().endGesture();
  };
}

bool placeHas(const std::vector<PlaceEdit>& places, const std::string& name, const AttributeValue& value) {
  return std::any_of(places.begin(), places.end(), [&](const PlaceEdit& edit) {
    const auto found = edit.attributes.find(name);
    return found != edit.attributes.end() && found->second == value;
  });
}

std::vector<PathPoint> upwards() {
  return {{Pose::identity(), Author::Computer}, {Pose::translation({0.0, 0.0, 5.0}), Author::Computer}};
}

Word demand(const std::string& name, const std::function<SequenceDemands(SequenceDemands)>& add,
            const std::function<bool(const SequenceDemands&)>& has) {
  return {name,
          [add, name](WorkbenchDocument& document) {
            document.setDemands(QString::fromStdString(name), add(document.demands()));
          },
          [has](const Scenario& scenario) { return has(scenario.sequence); },
          has,
          nullptr,
          kOfSequences + kPlanIsChecked};
}

Word setting(const std::string& name, ParameterId id, double value, const Reasons& reasons) {
  return {name,
          [=](WorkbenchDocument& document) {
            RunSettings settings = document.settings();
            EXPECT_TRUE(settings.parameters.set(id, value).ok());
            document.setSettings(settings);
          },
          [=](const Scenario& scenario) {
            const auto found = scenario.parameters.find(id);
            return found != scenario.parameters.end() && found->second == value;
          },
          nullptr,
          [=](const LoadedScenario& loaded) { return loaded.parameters[id] == value; },
          kOfSettings + reasons};
}

Word fit(const std::string& name, const FitEdit& edit, const std::function<bool(const FitEdit&)>& has) {
  return {name,
          [=](WorkbenchDocument& document) {
            EXPECT_TRUE(document
                            .edit(QStringLiteral("Fit"),
                                  [&](Scenario& scenario) {
                                    scenario.fits.pairs.push_back(edit);
                                    return Outcome(Done{});
                                  })
                            .ok());
          },
          [=](const Scenario& scenario) {
            return std::any_of(scenario.fits.pairs.begin(), scenario.fits.pairs.end(), has);
          },
          nullptr,
          [=](const LoadedScenario& loaded) {
            return std::any_of(loaded.scenario.fits.pairs.begin(), loaded.scenario.fits.pairs.end(), has);
          },
          {{Situation::SequenceStrategies, "product_fits_test: fits of products read the same pairs"},
           {Situation::Check, "cli_test: the check states what the user allows"}}};
}

const std::vector<Word>& words() {
  static const std::vector<Word> kWords = [] {
    const auto names = [](const auto& list, const char* id) {
      return std::find(list.begin(), list.end(), id) != list.end();
    };
    const auto of = [](const auto& list) {
      return std::any_of(list.begin(), list.end(), [](const auto& each) { return each.first == "O2"; });
    };
    std::vector<Word> all{
        {"forbidden", placeAttribute("forbidden", true),
         [](const Scenario& scenario) { return placeHas(scenario.places, "forbidden", true); }, nullptr,
         [](const LoadedScenario& loaded) { return forbidsPlaces(*loaded.problem.scene.edits); },
         kOfPaths + checkedBy("the file states the regions: ForbiddenRegionsAreSaved")},
        {"preferred", placeAttribute("preference", 5.0),
         [](const Scenario& scenario) { return placeHas(scenario.places, "preference", 5.0); }, nullptr,
         [](const LoadedScenario& loaded) { return placeHas(loaded.problem.scene.edits->places, "preference", 5.0); },
         kOfPaths + kNotChecked},
        {"milestone",
         [](WorkbenchDocument& document) {
           document.semantics().setMilestone(0, Pose::translation({0.1, 0.2, 0.3}));
         },
         [](const Scenario& scenario) { return !scenario.milestones.empty(); }, nullptr,
         [](const LoadedScenario& loaded) { return !loaded.problem.scene.edits->milestones.empty(); },
         kOfPaths + kNotChecked},
        demand(
            "locked",
            [](SequenceDemands demands) {
              demands.places.push_back({{"O2"}, 1, true});
              return demands;
            },
            [](const SequenceDemands& demands) { return demandsOn({"O2"}, demands).isLocked(); }),
        demand(
            "kept_order",
            [](SequenceDemands demands) {
              return withOrder({{"O3"}, {"O4"}}, std::move(demands));
            },
            [](const SequenceDemands& demands) {
              return std::find(demands.before.begin(), demands.before.end(),
                               std::pair<std::string, std::string>("O3", "O4")) != demands.before.end();
            }),
        demand(
            "forbidden_direction",
            [](SequenceDemands demands) { return withForbidden({"O3"}, Vector3::UnitX(), std::move(demands)); },
            [](const SequenceDemands& demands) { return !demandsOn({"O3"}, demands).forbidden.empty(); }),
        demand(
            "motion_by_hand",
            [](SequenceDemands demands) {
              return withMotion({{"O3"}, upwards(), kByHand}, std::move(demands));
            },
            [](const SequenceDemands& demands) { return demandsOn({"O3"}, demands).isByHand(); }),
        knowledge("goes_before", std::string("O3"),
                  [](const SequenceDemands& demands) {
                    return std::find(demands.before.begin(), demands.before.end(),
                                     std::pair<std::string, std::string>("O2", "O3")) != demands.before.end();
                  }),
        knowledge("goes_with", std::string("O3"),
                  [=](const SequenceDemands& demands) {
                    return std::any_of(demands.together.begin(), demands.together.end(),
                                       [&](const auto& group) { return names(group, "O2") && names(group, "O3"); });
                  }),
        knowledge("stays", true, [=](const SequenceDemands& demands) { return names(demands.stay, "O2"); }),
        knowledge("base", true, [=](const SequenceDemands& demands) { return names(demands.stay, "O2"); }),
        knowledge("fragile", true, [=](const SequenceDemands& demands) { return names(demands.fragile, "O2"); }),
        knowledge("class", std::string("screw"), [=](const SequenceDemands& demands) { return of(demands.fasteners); }),
        knowledge("needs_tool", std::string("socket"),
                  [=](const SequenceDemands& demands) { return of(demands.tools); }),
        knowledge("mass", 2.5, [=](const SequenceDemands& demands) { return of(demands.masses); }),
        setting("required_clearance", ParameterId::RequiredClearance, 3e-4,
                checkedBy("cli_test: the check keeps the scenario's required clearance")),
        setting("alpha", ParameterId::Alpha, 0.37, kNotChecked),
        setting("N", ParameterId::ContactSamples, 7.0, kNotChecked),
        setting("d", ParameterId::ContactDistance, 0.02, kNotChecked),
        fit("allowance_by_hand", {"object", "O2", std::nullopt, 1e-5, false},
            [](const FitEdit& each) { return each.b == "O2" && each.allowance == 1e-5; }),
        fit("accepted_clash", {"object", "O3", std::nullopt, std::nullopt, true},
            [](const FitEdit& each) { return each.b == "O3" && each.accepted; })};
    return all;
  }();
  return kWords;
}

const ScenarioPtr& teaching() {
  static const ScenarioPtr scenario = [] {
    auto loaded = loadScenario(test::sourceDirectory() + "/samples/teaching/scenario.json");
    loaded->scenario.places.clear();
    loaded->scenario.milestones.clear();
    loaded->problem.scene.edits = std::make_shared<const SemanticEdits>(semanticEditsOf(loaded->scenario));
    return std::make_shared<const LoadedScenario>(std::move(*loaded));
  }();
  return scenario;
}

const SceneKnowledgePtr& teachingKnowledge() {
  static const SceneKnowledgePtr knowledge = *buildSceneKnowledge(teaching()->problem, 1e-6);
  return knowledge;
}

void open(WorkbenchDocument& document, const ScenarioPtr& scenario) {
  document.open(scenario);
  document.setKnowledge(teachingKnowledge());
}

/// Saves the document, and loads the file.
ScenarioPtr reopened(WorkbenchDocument& document, const QTemporaryDir& folder) {
  const std::string file = folder.filePath(QStringLiteral("saved.json")).toStdString();
  const Scenario content = document.contentFor(file);
  EXPECT_TRUE(saveScenario(content, file).ok());
  document.noteSaved(file, content);
  auto loaded = loadScenario(file);
  EXPECT_TRUE(loaded.ok()) << toString(loaded.error());
  return std::make_shared<const LoadedScenario>(std::move(*loaded));
}

Outcome moveABody(WorkbenchDocument& document, double by) {
  const Vector3 at = document.scenario()->obstacles.back().X_WB.position;
  return document.place({AssemblyItem::Kind::Body, "O5"}, Pose::translation(at + Vector3(0.0, 0.0, by)));
}

using Cell = std::tuple<std::size_t, Situation>;

class WordInSituation : public testing::TestWithParam<Cell> {
 protected:
  WordInSituation() {
    open(document, teaching());
    EXPECT_FALSE(word.isInScenario(document.contentFor("")));
    word.say(document);
  }
  void expectSaid(const std::string& when) {
    EXPECT_TRUE(word.isInScenario(document.contentFor(""))) << word.name << " " << when;
  }
  void look(Situation situation);

  const Word& word = words()[std::get<0>(GetParam())];
  WorkbenchDocument document;
  QTemporaryDir folder;
};

void WordInSituation::look(Situation situation) {
  switch (situation) {
    case Situation::UndoneAndRedone: {
      document.undoStack().undo();
      EXPECT_FALSE(word.isInScenario(document.contentFor("")));
      document.undoStack().redo();
      expectSaid("once redone");
      break;
    }
    case Situation::Rearranged: {
      ASSERT_TRUE(moveABody(document, 0.01).ok());
      expectSaid("after a body was moved");
      document.undoStack().undo();
      expectSaid("after the move was undone");
      break;
    }
    case Situation::MovedByHand: {
      const auto change = [&](Scenario& scenario) {
        return prepareHandRun({"O3"}, {"O2"}, *document.scenario(), {}, scenario);
      };
      ASSERT_TRUE(document.edit(QStringLiteral("By hand"), change).ok());
      document.undoStack().undo();
      expectSaid("after a part was moved by hand");
      break;
    }
    case Situation::Reopened: {
      WorkbenchDocument other;
      other.open(reopened(document, folder));
      EXPECT_TRUE(word.isInScenario(other.contentFor(""))) << "opened again";
      EXPECT_TRUE(word.isInScenario(document.contentFor(""))) << "where it was saved";
      break;
    }
    case Situation::CommandLine: {
      // The command line plans with the scenario that it loads from the file.
      const ScenarioPtr loaded = reopened(document, folder);
      EXPECT_TRUE(word.isInScenario(loaded->scenario));
      break;
    }
    case Situation::PathStrategies: {
      EXPECT_TRUE(word.reachesPaths(*reopened(document, folder)));
      break;
    }
    case Situation::SequenceStrategies: {
      const auto demands = knownDemands(document.current(), productOf(*document.scenario()));
      ASSERT_TRUE(demands.ok()) << toString(demands.error());
      EXPECT_TRUE(word.reachesSequences(*demands));
      break;
    }
    case Situation::Check: FAIL() << "not looked at here"; break;
  }
}

TEST_P(WordInSituation, IsNotDropped) {
  const Situation situation = std::get<1>(GetParam());
  const auto elsewhere = word.elsewhere.find(situation);
  if (elsewhere != word.elsewhere.end()) {
    EXPECT_GT(elsewhere->second.size(), 20U) << "the reason";
  } else {
    look(situation);
  }
}

std::string nameOf(const Cell& cell) {
  return words()[std::get<0>(cell)].name + "_" + kSituationNames[static_cast<int>(std::get<1>(cell))];
}

INSTANTIATE_TEST_SUITE_P(Words, WordInSituation,
                         testing::Combine(testing::Range(std::size_t{0}, words().size()),
                                          testing::ValuesIn(kSituations)),
                         [](const auto& parameter) { return nameOf(parameter.param); });

TEST(Words, ForbiddenRegionsAreSavedWhereThePlacesAre) {
  WorkbenchDocument document;
  open(document, teaching());
  EXPECT_TRUE(document.savedContentFor("").forbiddenRegions.empty());
  placeAttribute("forbidden", true)(document);
  const Scenario content = document.savedContentFor("");
  ASSERT_EQ(content.forbiddenRegions.size(), 1U);
  EXPECT_FALSE(content.forbiddenRegions.front().boxes.empty());
  const auto readBack = parseScenario(writeScenario(content), "");
  ASSERT_TRUE(readBack.ok()) << toString(readBack.error());
  EXPECT_TRUE(readBack->forbiddenRegions == content.forbiddenRegions);
  EXPECT_EQ(writeScenario(*readBack), writeScenario(content));
  EXPECT_TRUE(document.contentFor("").forbiddenRegions.empty()) << "what is kept meanwhile may be stale";
}

/// Runs random sessions: an edit holds after all later actions, until it is undone.
class RandomSession {
 public:
  explicit RandomSession(std::uint64_t seed) : stream_(seed, "a session of edits") {
    open(document_, teaching());
    said_ = {wordsOf(document_)};
  }

  void run(int steps) {
    for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) act();
  }

 private:
  using Said = std::vector<bool>;
  static Said wordsOf(const WorkbenchDocument& document) {
    const Scenario scenario = document.contentFor("");
    Said said;
    for (const Word& word : words()) said.push_back(word.isInScenario(scenario));
    return said;
  }
  static bool isUndoable(std::size_t word) { return words()[word].elsewhere.count(Situation::UndoneAndRedone) == 0; }

  void act() {
    const double choice = stream_.uniform();
    if (choice < 0.45) {
      say(static_cast<std::size_t>(stream_.uniform() * static_cast<double>(words().size())));
    } else if (choice < 0.65) {
      step(-1);
    } else if (choice < 0.75) {
      step(1);
    } else if (choice < 0.85) {
      arrange();
    } else if (choice < 0.93) {
      runEnds();
    } else {
      saveAndReopen();
    }
    expectAllSaid();
  }

  void note(const std::string& what) { history_ += what + "\n"; }

  /// Makes an edit. An undoable edit holds from the next state of the undo stack on; a setting holds in all states.
  void say(std::size_t word) {
    note("say " + words()[word].name);
    if (said_[at_][word]) return;  // a second edit of this kind would change nothing
    Said next = said_[at_];
    next[word] = true;
    words()[word].say(document_);
    if (isUndoable(word)) {
      push(next);
    } else {
      for (Said& each : said_) each[word] = true;
    }
  }

  void push(const Said& next) {
    said_.resize(++at_);
    said_.push_back(next);
  }

  void step(int by) {
    const auto to = static_cast<std::ptrdiff_t>(at_) + by;
    if (to < 0 || to >= static_cast<std::ptrdiff_t>(said_.size())) return;
    note(by < 0 ? "undo" : "redo");
    at_ = static_cast<std::size_t>(to);
    if (by < 0) document_.undoStack().undo();
    if (by > 0) document_.undoStack().redo();
  }

  void arrange() {
    note("move a body");
    ASSERT_TRUE(moveABody(document_, stream_.uniform(0.001, 0.01)).ok());
    push(said_[at_]);
  }

  /// Ends a run with a path, which the document has as its result.
  void runEnds() {
    note("a run ends");
    RunResults results;
    results.path = std::make_shared<const Path>(Path{upwards(), {}});
    results.provenance = {"auto", 1};
    document_.setResults(results);
    document_.setResults({});
  }

  void saveAndReopen() {
    note("save and reopen");
    const Said now = said_[at_];
    open(document_, reopened(document_, folder_));
    said_ = {now};
    at_ = 0;
  }

  void expectAllSaid() {
    const Said now = wordsOf(document_);
    for (std::size_t word = 0; word < words().size(); ++word) {
      EXPECT_EQ(now[word], said_[at_][word]) << words()[word].name << " after\n" << history_;
    }
  }

  RandomStream stream_;
  WorkbenchDocument document_;
  QTemporaryDir folder_;
  std::vector<Said> said_;  ///< for each state of the undo stack
  std::size_t at_ = 0;
  std::string history_;
};

/// packaging/reliability.sh sets the number of sessions and the first seed.
std::uint64_t numberFrom(const char* variable, std::uint64_t usual) {
  const char* text = std::getenv(variable);
  return text == nullptr ? usual : std::strtoull(text, nullptr, 10);
}

TEST(Words, NoneIsDroppedInRandomSessions) {
  const std::uint64_t sessions = numberFrom("GLISSADE_WORD_SESSIONS", 50);
  const std::uint64_t first = numberFrom("GLISSADE_WORD_SEED", 1);
  for (std::uint64_t seed = first; seed < first + sessions && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomSession(seed).run(40);
  }
}

}  // namespace
}  // namespace glissade
