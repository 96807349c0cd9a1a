#include "widgets/commands/action_help.h"

#include <QCoreApplication>

#include <utility>

namespace glissade {
namespace {

/// Where the tip says too little to a person who sees the action for the first time.
constexpr std::pair<const char*, const char*> kMore[] = {
    {"file.new", QT_TRANSLATE_NOOP("ActionHelp",
                                   "STEP files of a product become one row for each part, placed as the assembly has "
                                   "it. Meshes may need a unit and an axis. One part moves; the others are static or "
                                   "mobile.")},
    {"file.open", QT_TRANSLATE_NOOP("ActionHelp",
                                    "A scenario holds bodies, the object that moves, its start and goal, places, "
                                    "fits, kept paths and parameters.")},
    {"run.start", QT_TRANSLATE_NOOP("ActionHelp",
                                    "The strategy, the operator and the sliders of the panel Interaction say how. A "
                                    "path that is found is proved free of penetration. Parameters can be changed "
                                    "while the run goes on.")},
    {"run.tuning", QT_TRANSLATE_NOOP("ActionHelp",
                                     "The program changes the values while it plans, from what computer, operator "
                                     "and contact have earned lately. A slider that is touched is set by hand again.")},
    {"environment.build",
     QT_TRANSLATE_NOOP("ActionHelp",
                       "The free space is divided into cells, and cells of similar narrowness "
                       "into places. Places overlap in borders. Layers and the strategies with places plan a "
                       "coarse path through places first.")},
    {"place.forbid", QT_TRANSLATE_NOOP("ActionHelp",
                                       "The coarse path is planned again at once, also during a run. An edit of a "
                                       "place is saved with the scenario and can be undone.")},
    {"milestone.set", QT_TRANSLATE_NOOP("ActionHelp",
                                        "A milestone is a configuration in the border of two places that the path "
                                        "passes through. It can be dragged in the scene, too.")},
    {"assembly.free-ends", QT_TRANSLATE_NOOP("ActionHelp",
                                             "CAD parts touch in their assembled position. Where clearance is "
                                             "required, start or goal have to move by the distance that is found and "
                                             "stated.")},
    {"assembly.moves", QT_TRANSLATE_NOOP("ActionHelp",
                                         "The object is what moves: one body, or several as one rigid body. All other "
                                         "bodies are obstacles.")},
    {"assembly.leave-out", QT_TRANSLATE_NOOP("ActionHelp",
                                             "CAD files often hold variants of a part that are drawn over each other. "
                                             "One is built, the others are left out. Proofs are about the product "
                                             "without them.")},
    {"fits.find", QT_TRANSLATE_NOOP("ActionHelp",
                                    "Parts of a product touch or overlap as designed. A fit says by how much the "
                                    "object is taken thinner against one body, and every result states it.")},
    {"joints.find", QT_TRANSLATE_NOOP("ActionHelp",
                                      "Screws, nuts, inserts, pins and rolling bearings are recognised by their "
                                      "shapes. Belts, clips, what is glued, and purchased units are suggested and "
                                      "count when you confirm them.")},
    {"sequence.plan", QT_TRANSLATE_NOOP("ActionHelp",
                                        "Assembly is the reverse order. The plan says which step makes way for which, "
                                        "which parts have to be held, and which tool turns a fastener.")},
    {"access.sequence", QT_TRANSLATE_NOOP("ActionHelp",
                                          "Several ways to hold the part or its tool are tried, with the wrist bent in "
                                          "six ways. Hand, forearm and tool are sampled along the motion: this is no "
                                          "proof. Measures of the hand are those of ANSUR II.")},
    {"path.smooth",
     QT_TRANSLATE_NOOP("ActionHelp", "The shortened path is proved like the planned one; both are kept.")},
    {"path.sweep", QT_TRANSLATE_NOOP("ActionHelp",
                                     "The surface contains the object at every time of the path, and is nowhere "
                                     "farther from it than the stated bound.")},
    {"difficulty.find", QT_TRANSLATE_NOOP("ActionHelp",
                                          "The panel Difficulty lists the smallest distance between the two trees, "
                                          "the bodies between them, and by how much the object would have to be "
                                          "thinner.")},
    {"assist.go",
     QT_TRANSLATE_NOOP("ActionHelp",
                       "The hand is taken to a configuration that the search has reached. The ghost is the "
                       "nearest one on the other side: lead the object there. Where nobody held the "
                       "object, or the search had ended, it starts again by hand.")},
    {"replay.last", QT_TRANSLATE_NOOP("ActionHelp",
                                      "Every run is recorded with its seed, its parameters and what the operator "
                                      "did. The replay gives the same roadmap, node by node.")},
    {"operator.frame",
     QT_TRANSLATE_NOOP("ActionHelp", "It holds for keys and devices. F over the scene does the same.")},
    {"operator.camera", QT_TRANSLATE_NOOP("ActionHelp",
                                          "Keys and devices move the object as a rule. In camera mode the same input "
                                          "moves the view instead.")},
};

}  // namespace

QString actionHelp(const QString& id, const QString& text, const QString& keys, const QString& tip) {
  QString name = text.toHtmlEscaped();
  if (!keys.isEmpty()) name += QStringLiteral(" (%1)").arg(keys.toHtmlEscaped());
  QString help = QStringLiteral("<b>%1</b><p>%2.</p>").arg(name, tip.toHtmlEscaped());
  for (const auto& [about, more] : kMore) {
    if (id != QLatin1String(about)) continue;
    help += QStringLiteral("<p>%1</p>").arg(QCoreApplication::translate("ActionHelp", more).toHtmlEscaped());
  }
  return help;
}

}  // namespace glissade
