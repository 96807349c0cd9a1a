#include "engine/study/study_words.h"

namespace glissade {
namespace {

/// Texts of the supplied studies (`samples/studies`) and names of states and measures, for the catalogue: reports find
/// their French by the English text.
[[maybe_unused]] constexpr CatalogueText kStudyTexts[] = {
    GLISSADE_TEXT("solved"),
    GLISSADE_TEXT("no-path"),
    GLISSADE_TEXT("limit-reached"),
    GLISSADE_TEXT("in-collision"),
    GLISSADE_TEXT("error"),
    GLISSADE_TEXT("time"),
    GLISSADE_TEXT("memory"),
    GLISSADE_TEXT("crashed"),
    GLISSADE_TEXT("holds"),
    GLISSADE_TEXT("does not hold"),
    GLISSADE_TEXT("open"),
    GLISSADE_TEXT("success rate"),
    GLISSADE_TEXT("virtual s"),
    GLISSADE_TEXT("nodes"),
    GLISSADE_TEXT("edges"),
    GLISSADE_TEXT("random configurations"),
    GLISSADE_TEXT("Virtual time (s)"),
    GLISSADE_TEXT("Table I: influence of α without contact, environment 1"),
    GLISSADE_TEXT("Table II: influence of α with contact, environment 1"),
    GLISSADE_TEXT("Table III: influence of the number of contact samples N, environment 1"),
    GLISSADE_TEXT("Table IV: influence of the contact distance d, environment 1"),
    GLISSADE_TEXT("Table V: influence of α with contact, environment 2"),
    GLISSADE_TEXT("Figure 14: strategies on the shape game"),
    GLISSADE_TEXT("Figure 14 on the roomier shape game"),
    GLISSADE_TEXT("Time (s)"),
    GLISSADE_TEXT("Nodes"),
    GLISSADE_TEXT("Edges"),
    GLISSADE_TEXT("Success rate"),
    GLISSADE_TEXT("Random configurations"),
    GLISSADE_TEXT("Random configurations (mean)"),
    GLISSADE_TEXT("Any operator beats none by more than ten times in nodes."),
    GLISSADE_TEXT("Any operator beats none by more than fifty times in time."),
    GLISSADE_TEXT("Any operator beats none by more than a hundred times in time."),
    GLISSADE_TEXT("Small α is slow without contact: α = 0.3 to 0.1 take more than twice the time of α = 0.95 to 0.4."),
    GLISSADE_TEXT("α = 0.95 is the fastest row."),
    GLISSADE_TEXT("With contact small α is fast: α = 0.2 to 0.01 need fewer nodes than α = 0.8 and 0.5."),
    GLISSADE_TEXT("α = 0.08 is the fastest row."),
    GLISSADE_TEXT("With contact even the operator alone, α = 0, finds a path every time."),
    GLISSADE_TEXT("N has little influence on environment 1: within a factor of four in time."),
    GLISSADE_TEXT("N has little influence on environment 1: within a factor of two in nodes."),
    GLISSADE_TEXT("N = 5 is the fastest row."),
    GLISSADE_TEXT("d has little influence on environment 1: within a factor of two in time."),
    GLISSADE_TEXT("d has little influence on environment 1: within a factor of 1.2 in nodes."),
    GLISSADE_TEXT("The BiRRT alone finds no path."),
    GLISSADE_TEXT("Contact beats no contact at equal α = 0.5 by more than ten times in time."),
    GLISSADE_TEXT("Contact beats no contact at equal α = 0.5 in nodes."),
    GLISSADE_TEXT("Extremes of α are worse: α = 0.98, 0.95 and 0.05 take longer than any between."),
    GLISSADE_TEXT("α = 0, the operator alone, finds no path."),
    GLISSADE_TEXT("G fails on the pentagon and the star."),
    GLISSADE_TEXT("G succeeds on the circle, the square and the triangle."),
    GLISSADE_TEXT("GT fails where the nearest hole does not fit: circle, square, star."),
    GLISSADE_TEXT("GTS1 fails on the star, which has no hole of its shape."),
    GLISSADE_TEXT("GTS2 succeeds most often of the paper's four on the star."),
    GLISSADE_TEXT("GTS2 needs less than a tenth of G's random configurations on the square, the triangle, the pentagon "
                  "and the star."),
    GLISSADE_TEXT("Our GTS needs fewer random configurations than any of the paper's."),
    GLISSADE_TEXT("α is the share of the computer; α = 1 is the plain BiRRT, without any operator. Lockstep at 40 "
                  "planner steps a second of the operator's time, as fast as the paper's planner with him."),
    GLISSADE_TEXT("As table I, with contact sampling near obstacles (N = 10, d = 0.15 m). Lockstep at 40 planner steps "
                  "a second of the operator's time, as fast as the paper's planner with him."),
    GLISSADE_TEXT("α = 0.2, d = 0.15 m. Lockstep at 40 planner steps a second of the operator's time, as fast as the "
                  "paper's planner with him."),
    GLISSADE_TEXT("α = 0.2, N = 5. Lockstep at 40 planner steps a second of the operator's time, as fast as the "
                  "paper's planner with him."),
    GLISSADE_TEXT(
        "N = 10, d = 0.15 m; with what section III.G says of the plain BiRRT, of no contact and of α = 0. Lockstep at "
        "40 planner steps a second of the operator's time, as fast as the paper's planner with him."),
    GLISSADE_TEXT("Preset \"tight\", the limits of section 6.1: 100,000 random configurations a topological step, "
                  "2,000 a border, 1,000,000 for G. GTS is ours: computed compatibility, scores, a loop."),
    GLISSADE_TEXT(
        "Preset \"paper-like\": wider holes, as the drawings of the paper suggest. The limits of section 6.1."),
    GLISSADE_TEXT("printed as 2h45m"),
    GLISSADE_TEXT("edges as printed; violates edges=2*nodes-2 (2566 expected); 1074 equals the alpha=0.08 row of Table "
                  "II, so probably a copy error"),
    GLISSADE_TEXT("fastest row"),
    GLISSADE_TEXT("printed as 2h45m; same run as Table I (alpha=1 never enters contact)"),
    GLISSADE_TEXT("one edge pair short of 2*nodes-2 (3456)"),
    GLISSADE_TEXT("section III.G"),
    GLISSADE_TEXT("odd edge count as printed (4050 expected)"),
    GLISSADE_TEXT("pentagon hole, narrow"),
    GLISSADE_TEXT("mostly pentagon hole"),
    GLISSADE_TEXT("triangular hole, not the larger passage (text)"),
    GLISSADE_TEXT("mainly pentagon hole"),
    GLISSADE_TEXT("pentagon hole, large"),
    GLISSADE_TEXT("pentagon hole, largest"),
    GLISSADE_TEXT("triangular hole (not compatible)"),
    GLISSADE_TEXT("square hole, large (semantic)"),
    GLISSADE_TEXT("round hole, large (semantic)"),
    GLISSADE_TEXT("square hole, large"),
    GLISSADE_TEXT("Five rigid-body problems of OMPL.app, which are not part of Glissade: they are looked for in "
                  "shared/problems/omplapp beside its folder. OMPL's planners run as OMPL's users run them: its metric "
                  "and defaults, collisions by FCL, edges looked at every 1 % or 0.1 % of the extent, the range its "
                  "default (20 % of the extent), 3 % or 1 %. Our certificate judges their paths; one that it refuses "
                  "(not-certified) is not solved. Seconds are of the processor, but auto, which plans in lanes, is "
                  "held to what one waits; over all runs: one that was not solved counts with the time it had."),
    GLISSADE_TEXT("Problems nobody here wrote: auto beside OMPL's planners"),
    GLISSADE_TEXT("Problems of our own making: auto beside OMPL's planners"),
    GLISSADE_TEXT(
        "Spirals, mazes, furniture in rooms and twisted tubes, as generate-made-problems writes them; generator and "
        "seeds were fixed before the first run. OMPL's planners run as OMPL's users run them: its metric and defaults, "
        "collisions by FCL, edges looked at every 0.1 % of the extent, the range its default (20 % of the extent), 3 % "
        "or 1 %. Our certificate judges their paths; one that it refuses (not-certified) is not solved. Seconds are of "
        "the processor; over all runs: one that was not solved counts with the time it had."),
    GLISSADE_TEXT("auto takes a quarter of the processor time of OMPL's best."),
    GLISSADE_TEXT("RRT-Connect, range 3 %"),
    GLISSADE_TEXT("RRT-Connect, range 1 %"),
    GLISSADE_TEXT("auto solves 18 of 20 runs of bugtrap at least."),
    GLISSADE_TEXT("auto solves every run of Easy, cubicles, Twistycool and alpha-1.5, with a certified path."),
    GLISSADE_TEXT("auto takes a fifth of the time of OMPL's best at 0.1 %."),
    GLISSADE_TEXT("Automatic tuning of α, N and d against fixed settings"),
    GLISSADE_TEXT("Tuned runs are solved at least nine tenths as often as with the best fixed setting."),
    GLISSADE_TEXT("Tuned α, N and d are within 15 % of the best fixed setting in median steps, without knowing it."),
    GLISSADE_TEXT("α, N and d set themselves from what computer, operator and contact earned lately, against the best "
                  "of a coarse grid of fixed settings, the same seeds for all. Lockstep at 40 planner steps a second "
                  "of the operator's time."),
    GLISSADE_TEXT("BiRRT alone, one run: 2 h 45 (paper 1, table I)"),
    GLISSADE_TEXT("BiRRT alone: nothing in a night; a person with contact: 61 s (paper 1, table V)"),
    GLISSADE_TEXT("Environment 1: a median of 0.2 s at most."),
    GLISSADE_TEXT("Environment 2: a median of 3 s at most."),
    GLISSADE_TEXT("Environments 1 and 2: faster than our BiRRT and than OMPL's planners."),
    GLISSADE_TEXT("Strategy auto without an operator, beside other planners: our BiRRT, GTS on the pump, and "
                  "unmodified OMPL (edges looked at every 0.1 % of the extent). Seconds are of the processor, but what "
                  "is asked of auto alone and beside GTS is what one waits; over all runs: one that was not solved "
                  "counts with the time it had. A path of OMPL's counts as solved where our certificate holds."),
    GLISSADE_TEXT("The automatic planner on our samples"),
    GLISSADE_TEXT("The pump: ten times faster than GTS."),
    GLISSADE_TEXT("auto solves every run, with a certified path."),
    GLISSADE_TEXT("not-certified"),
    GLISSADE_TEXT("paper"),
    GLISSADE_TEXT("Scenario"),
    GLISSADE_TEXT("Success rate (%)"),
    GLISSADE_TEXT("Authority α"),
    GLISSADE_TEXT("Contact samples N"),
    GLISSADE_TEXT("Contact distance d (m)"),
};

}  // namespace

std::string StudyWords::operator()(CatalogueText text, std::initializer_list<MessageArgument> arguments) const {
  return toString(Message(text, arguments), language_);
}

std::string StudyWords::operator()(const std::string& text) const {
  return toString(Message(CatalogueText{text.c_str()}), language_);
}

}  // namespace glissade
