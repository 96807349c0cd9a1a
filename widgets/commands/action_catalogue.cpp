#include "widgets/commands/action_catalogue.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QToolButton>

namespace glissade {
namespace {

QString translated(const char* text) { return QCoreApplication::translate("Actions", text); }

QString plain(QString text) { return text.remove(QLatin1Char('&')); }

}  // namespace

const std::vector<ActionSpec>& actionSpecs() {
  static const std::vector<ActionSpec> specs{
      {"file.new", QT_TRANSLATE_NOOP("Actions", "&New from parts..."), "Ctrl+N",
       QT_TRANSLATE_NOOP("Actions", "Make a scenario of mesh or URDF files, one of which moves"), false},
      {"file.open", QT_TRANSLATE_NOOP("Actions", "&Open..."), "Ctrl+O",
       QT_TRANSLATE_NOOP("Actions", "Open a scenario or an OMPL.app problem"), false},
      {"file.save", QT_TRANSLATE_NOOP("Actions", "&Save"), "Ctrl+S",
       QT_TRANSLATE_NOOP("Actions", "Save the scenario with its attributes, strategy and parameters"), false},
      {"file.save-as", QT_TRANSLATE_NOOP("Actions", "Save &as..."), "Ctrl+Shift+S",
       QT_TRANSLATE_NOOP("Actions", "Save the scenario under another name"), false},
      {"file.export", QT_TRANSLATE_NOOP("Actions", "&Export path..."), "Ctrl+E",
       QT_TRANSLATE_NOOP("Actions", "Save the certified path: as data, or as an animation for 3D viewers"), false},
      {"file.open-path", QT_TRANSLATE_NOOP("Actions", "Open pa&th..."), "Ctrl+Alt+P",
       QT_TRANSLATE_NOOP("Actions", "Read a path of this scenario, and prove that it holds or see where it is blocked"),
       false},
      {"file.save-recording", QT_TRANSLATE_NOOP("Actions", "Save &recording..."), "Ctrl+Alt+S",
       QT_TRANSLATE_NOOP("Actions", "Save what was done in the last run, to replay it bit by bit"), false},
      {"file.open-recording", QT_TRANSLATE_NOOP("Actions", "Open re&cording..."), "Ctrl+Alt+O",
       QT_TRANSLATE_NOOP("Actions", "Replay a recorded run"), false},
      {"file.quit", QT_TRANSLATE_NOOP("Actions", "&Quit"), "Ctrl+Q", QT_TRANSLATE_NOOP("Actions", "Leave Glissade"),
       false},
      {"recent.forget", QT_TRANSLATE_NOOP("Actions", "&Forget these"), "",
       QT_TRANSLATE_NOOP("Actions", "Empty the list of the files opened last"), false},
      {"edit.undo", QT_TRANSLATE_NOOP("Actions", "&Undo"), "Ctrl+Z",
       QT_TRANSLATE_NOOP("Actions", "Take the last edit back"), false},
      {"edit.redo", QT_TRANSLATE_NOOP("Actions", "&Redo"), "Ctrl+Shift+Z",
       QT_TRANSLATE_NOOP("Actions", "Do again what was taken back"), false},
      {"environment.build", QT_TRANSLATE_NOOP("Actions", "Find &places"), "F7",
       QT_TRANSLATE_NOOP("Actions", "Build the environment model: octree, places, borders, compatibility"), false},
      {"attribute.add", QT_TRANSLATE_NOOP("Actions", "&Add attribute..."), "",
       QT_TRANSLATE_NOOP("Actions", "Define an attribute of your own on places or bodies"), false},
      {"attribute.rename", QT_TRANSLATE_NOOP("Actions", "Re&name..."), "",
       QT_TRANSLATE_NOOP("Actions", "Rename the attribute of the current row, where it is your own"), false},
      {"attribute.remove", QT_TRANSLATE_NOOP("Actions", "Re&move"), "",
       QT_TRANSLATE_NOOP("Actions", "Remove the attribute of the current row, where it is your own"), false},
      {"attribute.remove-strays", QT_TRANSLATE_NOOP("Actions", "Remove edits with&out effect"), "",
       QT_TRANSLATE_NOOP("Actions", "Forget what was said of places and borders that are not there any more"), false},
      {"place.forbid", QT_TRANSLATE_NOOP("Actions", "&Forbid"), "Ctrl+B",
       QT_TRANSLATE_NOOP("Actions", "Let no path lead through the selected places, or allow it again"), false},
      {"place.prefer", QT_TRANSLATE_NOOP("Actions", "&Prefer"), "Ctrl+Shift+B",
       QT_TRANSLATE_NOOP("Actions", "Favour ways through the selected places, or no longer"), false},
      {"milestone.set", QT_TRANSLATE_NOOP("Actions", "&Milestone"), "Ctrl+M",
       QT_TRANSLATE_NOOP("Actions", "The chosen step ends where the object in your hand is"), false},
      {"milestone.reset", QT_TRANSLATE_NOOP("Actions", "R&eset"), "",
       QT_TRANSLATE_NOOP("Actions", "The chosen step ends where the planner likes"), false},
      {"assembly.add", QT_TRANSLATE_NOOP("Actions", "&Add parts..."), "Ctrl+Shift+N",
       QT_TRANSLATE_NOOP("Actions", "Put parts from mesh or URDF files into the scene"), false},
      {"assembly.remove", QT_TRANSLATE_NOOP("Actions", "&Remove"), "Del",
       QT_TRANSLATE_NOOP("Actions", "Take the selected bodies out of the scene"), false},
      {"assembly.moves", QT_TRANSLATE_NOOP("Actions", "This part &moves"), "Ctrl+Shift+M",
       QT_TRANSLATE_NOOP("Actions",
                         "The selected body becomes the object, from where it lies to \"out\"; what moved "
                         "until now stays where it started"),
       false},
      {"assembly.arrange", QT_TRANSLATE_NOOP("Actions", "Arrange &with the mouse"), "Ctrl+G",
       QT_TRANSLATE_NOOP("Actions", "Drag bodies, start and goal in the view; Ctrl+drag turns them"), true},
      {"assembly.start-here", QT_TRANSLATE_NOOP("Actions", "&Start here"), "Ctrl+Alt+1",
       QT_TRANSLATE_NOOP("Actions", "The motion starts where the object in your hand is"), false},
      {"assembly.goal-here", QT_TRANSLATE_NOOP("Actions", "&Goal here"), "Ctrl+Alt+2",
       QT_TRANSLATE_NOOP("Actions", "The motion ends where the object in your hand is"), false},
      {"assembly.goal-out", QT_TRANSLATE_NOOP("Actions", "Goal &out"), "Ctrl+Alt+3",
       QT_TRANSLATE_NOOP("Actions", "The motion ends anywhere clear of the other bodies"), false},
      {"assembly.free-ends", QT_TRANSLATE_NOOP("Actions", "Move the ends &clear"), "Ctrl+Alt+5",
       QT_TRANSLATE_NOOP("Actions",
                         "Where the object touches or overlaps a body at its start or goal, move it clear by "
                         "the least that is found"),
       false},
      {"assembly.swap", QT_TRANSLATE_NOOP("Actions", "S&wap start and goal"), "Ctrl+Alt+4",
       QT_TRANSLATE_NOOP("Actions", "Mounting instead of removing, or the other way round"), false},
      {"assembly.fit-workspace", QT_TRANSLATE_NOOP("Actions", "&Fit the workspace"), "",
       QT_TRANSLATE_NOOP("Actions", "A workspace about all bodies, with room for the object to get out"), false},
      {"fits.find", QT_TRANSLATE_NOOP("Actions", "Find f&its"), "Ctrl+I",
       QT_TRANSLATE_NOOP("Actions", "List the pairs of bodies that touch or overlap, with their kind and allowance"),
       false},
      {"fits.isolate", QT_TRANSLATE_NOOP("Actions", "Is&olate the pair"), "",
       QT_TRANSLATE_NOOP("Actions", "Draw the two bodies of the chosen fit and no other obstacles"), false},
      {"fits.accept", QT_TRANSLATE_NOOP("Actions", "Accept the &clash"), "",
       QT_TRANSLATE_NOOP("Actions", "Allow the overlap of the chosen pair; results state it"), false},
      {"fits.thread", QT_TRANSLATE_NOOP("Actions", "Is a t&hread"), "",
       QT_TRANSLATE_NOOP("Actions", "The chosen pair is a thread that is drawn as cylinders"), false},
      {"fits.require-clearance", QT_TRANSLATE_NOOP("Actions", "Require c&learance"), "",
       QT_TRANSLATE_NOOP("Actions", "Allow nothing for the chosen pair: the whole bodies count"), false},
      {"fits.as-measured", QT_TRANSLATE_NOOP("Actions", "As m&easured"), "",
       QT_TRANSLATE_NOOP("Actions", "Take back what was said about the chosen pair"), false},
      {"run.start", QT_TRANSLATE_NOOP("Actions", "&Start"), "F5",
       QT_TRANSLATE_NOOP("Actions", "Plan with a fresh roadmap and the current seed"), false},
      {"run.pause", QT_TRANSLATE_NOOP("Actions", "&Pause"), "F6",
       QT_TRANSLATE_NOOP("Actions", "Hold the planner, or let it go on"), true},
      {"run.stop", QT_TRANSLATE_NOOP("Actions", "S&top"), "Shift+F5",
       QT_TRANSLATE_NOOP("Actions", "End the run; what was found stays shown"), false},
      {"run.restart", QT_TRANSLATE_NOOP("Actions", "&Restart"), "Ctrl+R",
       QT_TRANSLATE_NOOP("Actions", "Stop and start again with the same seed"), false},
      {"run.restart-new-seed", QT_TRANSLATE_NOOP("Actions", "Restart with a &new seed"), "Ctrl+Shift+R",
       QT_TRANSLATE_NOOP("Actions", "Stop and start again with the next seed"), false},
      {"run.tuning", QT_TRANSLATE_NOOP("Actions", "&Automatic tuning"), "Ctrl+T",
       QT_TRANSLATE_NOOP("Actions", "Let α, N and d set themselves while planning, or take them back as you had them"),
       true},
      {"strategy.rules", QT_TRANSLATE_NOOP("Actions", "R&ules of the strategy..."), "Ctrl+U",
       QT_TRANSLATE_NOOP("Actions", "Read how the strategy weighs places and chooses planners, and change it"), false},
      {"work.cancel", QT_TRANSLATE_NOOP("Actions", "&Cancel"), "Esc",
       QT_TRANSLATE_NOOP("Actions",
                         "End what is being done in the background: reading, smoothing, looking for reasons"),
       false},
      {"replay.last", QT_TRANSLATE_NOOP("Actions", "Replay the &last run"), "F10",
       QT_TRANSLATE_NOOP("Actions", "Run the last run, or the recording opened last, again bit by bit"), false},
      {"replay.again", QT_TRANSLATE_NOOP("Actions", "Replay with &current parameters"), "Shift+F10",
       QT_TRANSLATE_NOOP("Actions", "What the same operator would have led to with the sliders as they are set"),
       false},
      {"replay.play", QT_TRANSLATE_NOOP("Actions", "Play the r&eplay"), "Ctrl+Space",
       QT_TRANSLATE_NOOP("Actions", "Let the replayed run pass, or hold it"), true},
      {"replay.step", QT_TRANSLATE_NOOP("Actions", "Step &forward"), "Ctrl+Right",
       QT_TRANSLATE_NOOP("Actions", "Show the next step of the replay"), false},
      {"replay.step-back", QT_TRANSLATE_NOOP("Actions", "Step &back"), "Ctrl+Left",
       QT_TRANSLATE_NOOP("Actions", "Show the step before"), false},
      {"replay.to-start", QT_TRANSLATE_NOOP("Actions", "To the be&ginning"), "Ctrl+Shift+Left",
       QT_TRANSLATE_NOOP("Actions", "Show the replay from its beginning"), false},
      {"replay.close", QT_TRANSLATE_NOOP("Actions", "Close the repla&y"), "Ctrl+W",
       QT_TRANSLATE_NOOP("Actions", "Go back to the session; its run and parameters are as they were left"), false},
      {"object.to-start", QT_TRANSLATE_NOOP("Actions", "&Object to the start"), "Ctrl+Home",
       QT_TRANSLATE_NOOP("Actions", "Put the object in your hand back to the start"), false},
      {"operator.camera", QT_TRANSLATE_NOOP("Actions", "Steer the &camera"), "F3",
       QT_TRANSLATE_NOOP("Actions", "Keys, 6D mouse and gamepad move the camera, or the object again"), true},
      {"operator.camera-roll", QT_TRANSLATE_NOOP("Actions", "The camera &rolls"), "Shift+F3",
       QT_TRANSLATE_NOOP("Actions", "Turning about the line of sight rolls the camera, or the horizon stays level"),
       true},
      {"operator.devices", QT_TRANSLATE_NOOP("Actions", "&Devices..."), "F4",
       QT_TRANSLATE_NOOP("Actions", "Calibrate 6D mouse, keys and gamepad: live axes, curves, presets, buttons"),
       false},
      {"path.play", QT_TRANSLATE_NOOP("Actions", "&Play the path"), "Ctrl+P",
       QT_TRANSLATE_NOOP("Actions", "Move the object along the path, or hold it"), true},
      {"path.smooth", QT_TRANSLATE_NOOP("Actions", "S&mooth the path"), "Ctrl+Shift+P",
       QT_TRANSLATE_NOOP("Actions", "Shorten the path by shortcuts that are certified, or show it as planned"), true},
      {"path.loop", QT_TRANSLATE_NOOP("Actions", "Loop"), "",
       QT_TRANSLATE_NOOP("Actions", "Begin again when the path was played to its end"), true},
      {"path.backwards", QT_TRANSLATE_NOOP("Actions", "Backwards"), "",
       QT_TRANSLATE_NOOP("Actions", "Play the path from its goal to its start"), true},
      {"path.tightest", QT_TRANSLATE_NOOP("Actions", "Tigh&test place"), "Ctrl+Alt+T",
       QT_TRANSLATE_NOOP("Actions", "Show the object at the place of the smallest clearance"), false},
      {"path.first-blocked", QT_TRANSLATE_NOOP("Actions", "Where is it &blocked?"), "Ctrl+Alt+B",
       QT_TRANSLATE_NOOP("Actions", "Show the object at the first place where the path is blocked"), false},
      {"difficulty.find", QT_TRANSLATE_NOOP("Actions", "&Why no path?"), "Ctrl+Shift+D",
       QT_TRANSLATE_NOOP("Actions",
                         "Look for what stands in the way: the tightest passage, and how much would have to give"),
       false},
      {"difficulty.play", QT_TRANSLATE_NOOP("Actions", "Play the way of &least penetration"), "Ctrl+Shift+Space",
       QT_TRANSLATE_NOOP("Actions", "Move the object along the way on which least has to give, or hold it"), true},
      {"study.open", QT_TRANSLATE_NOOP("Actions", "&Open study results..."), "Ctrl+Shift+O",
       QT_TRANSLATE_NOOP("Actions", "Browse a study's tables and plots, and see its runs again"), false},
      {"study.zoom-out", QT_TRANSLATE_NOOP("Actions", "Whole &plot"), "Ctrl+Shift+0",
       QT_TRANSLATE_NOOP("Actions",
                         "Show all of the study's plot again after a rubber band or the wheel has enlarged a part"),
       false},
      {"study.copy-plot", QT_TRANSLATE_NOOP("Actions", "&Copy plot"), "Ctrl+Shift+C",
       QT_TRANSLATE_NOOP("Actions", "Put the study's plot into the clipboard as it is seen"), false},
      {"study.save-plot", QT_TRANSLATE_NOOP("Actions", "&Save plot..."), "Ctrl+Shift+E",
       QT_TRANSLATE_NOOP("Actions", "Save the study's plot as it is seen, as SVG or PNG"), false},
      {"study.report-pdf", QT_TRANSLATE_NOOP("Actions", "&Report as PDF..."), "",
       QT_TRANSLATE_NOOP("Actions", "Write the report of the study that is open as PDF"), false},
      {"view.fit", QT_TRANSLATE_NOOP("Actions", "&Fit"), "Ctrl+0",
       QT_TRANSLATE_NOOP("Actions", "Show everything, direction kept"), false},
      {"view.isometric", QT_TRANSLATE_NOOP("Actions", "&Isometric"), "Ctrl+1",
       QT_TRANSLATE_NOOP("Actions", "Look from a corner"), false},
      {"view.front", QT_TRANSLATE_NOOP("Actions", "Fr&ont"), "Ctrl+2", QT_TRANSLATE_NOOP("Actions", "Look along y"),
       false},
      {"view.back", QT_TRANSLATE_NOOP("Actions", "&Back"), "Ctrl+3", QT_TRANSLATE_NOOP("Actions", "Look against y"),
       false},
      {"view.left", QT_TRANSLATE_NOOP("Actions", "&Left"), "Ctrl+4", QT_TRANSLATE_NOOP("Actions", "Look along x"),
       false},
      {"view.right", QT_TRANSLATE_NOOP("Actions", "&Right"), "Ctrl+5", QT_TRANSLATE_NOOP("Actions", "Look against x"),
       false},
      {"view.top", QT_TRANSLATE_NOOP("Actions", "&Top"), "Ctrl+6", QT_TRANSLATE_NOOP("Actions", "Look down"), false},
      {"view.bottom", QT_TRANSLATE_NOOP("Actions", "Botto&m"), "Ctrl+7", QT_TRANSLATE_NOOP("Actions", "Look up"),
       false},
      {"view.finer-cells", QT_TRANSLATE_NOOP("Actions", "Fi&ner cells"), "Ctrl+]",
       QT_TRANSLATE_NOOP("Actions", "Show the octree's cells one level deeper"), false},
      {"view.coarser-cells", QT_TRANSLATE_NOOP("Actions", "&Coarser cells"), "Ctrl+[",
       QT_TRANSLATE_NOOP("Actions", "Show the octree's cells one level less deep"), false},
      {"view.path-authors", QT_TRANSLATE_NOOP("Actions", "Path by &author"), "Ctrl+Shift+A",
       QT_TRANSLATE_NOOP("Actions", "Colour the path by who made each segment: computer, operator, contact"), true},
      {"view.keep-roadmap", QT_TRANSLATE_NOOP("Actions", "&Keep the roadmap"), "",
       QT_TRANSLATE_NOOP("Actions", "Draw the roadmap in full, not faint, while a path is shown"), true},
      {"display.shaded-edges", QT_TRANSLATE_NOOP("Actions", "Shaded with &edges"), "Ctrl+Shift+1",
       QT_TRANSLATE_NOOP("Actions", "Draw bodies opaque, with their edges"), true},
      {"display.shaded", QT_TRANSLATE_NOOP("Actions", "&Shaded"), "Ctrl+Shift+2",
       QT_TRANSLATE_NOOP("Actions", "Draw bodies opaque, without edges"), true},
      {"display.see-through", QT_TRANSLATE_NOOP("Actions", "See-&through"), "Ctrl+Shift+3",
       QT_TRANSLATE_NOOP("Actions", "Draw bodies transparent, with all their edges"), true},
      {"display.wireframe", QT_TRANSLATE_NOOP("Actions", "&Wireframe"), "Ctrl+Shift+4",
       QT_TRANSLATE_NOOP("Actions", "Draw only the edges of bodies; hidden edges are dashed"), true},
      {"display-selected.shaded-edges", QT_TRANSLATE_NOOP("Actions", "Selected: shaded with edges"), "",
       QT_TRANSLATE_NOOP("Actions", "Draw the selected bodies opaque, with their edges"), false},
      {"display-selected.shaded", QT_TRANSLATE_NOOP("Actions", "Selected: shaded"), "",
       QT_TRANSLATE_NOOP("Actions", "Draw the selected bodies opaque, without edges"), false},
      {"display-selected.see-through", QT_TRANSLATE_NOOP("Actions", "Selected: see-through"), "",
       QT_TRANSLATE_NOOP("Actions", "Draw the selected bodies transparent, with all their edges"), false},
      {"display-selected.wireframe", QT_TRANSLATE_NOOP("Actions", "Selected: wireframe"), "",
       QT_TRANSLATE_NOOP("Actions", "Draw only the edges of the selected bodies"), false},
      {"display-selected.as-view", QT_TRANSLATE_NOOP("Actions", "Selected: as the view"), "",
       QT_TRANSLATE_NOOP("Actions", "Draw the selected bodies in the display mode of the view again"), false},
      {"body.hide", QT_TRANSLATE_NOOP("Actions", "&Hide the selected bodies"), "Ctrl+H",
       QT_TRANSLATE_NOOP("Actions", "Draw the selected obstacles no more; planning still knows them"), false},
      {"body.isolate", QT_TRANSLATE_NOOP("Actions", "&Isolate the selected bodies"), "Ctrl+Alt+H",
       QT_TRANSLATE_NOOP("Actions", "Draw the selected obstacles and no others"), false},
      {"body.show-all", QT_TRANSLATE_NOOP("Actions", "&Show all bodies"), "Ctrl+Shift+H",
       QT_TRANSLATE_NOOP("Actions", "Draw all obstacles again"), false},
      {"view.dark", QT_TRANSLATE_NOOP("Actions", "&Dark theme"), "Ctrl+D",
       QT_TRANSLATE_NOOP("Actions", "Light figures on a dark ground"), true},
      {"view.reset-layout", QT_TRANSLATE_NOOP("Actions", "Reset la&yout"), "",
       QT_TRANSLATE_NOOP("Actions", "Put all panels where they were at first"), false},
      {"layer.bodies", QT_TRANSLATE_NOOP("Actions", "Obstacles"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the obstacles"), true},
      {"layer.object", QT_TRANSLATE_NOOP("Actions", "Object"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the object in your hand"), true},
      {"layer.ends", QT_TRANSLATE_NOOP("Actions", "Start and goal"), "",
       QT_TRANSLATE_NOOP("Actions", "Show start and goal as ghosts"), true},
      {"layer.workspace", QT_TRANSLATE_NOOP("Actions", "Workspace"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the bounds of the reference point"), true},
      {"layer.roadmap", QT_TRANSLATE_NOOP("Actions", "Roadmap"), "", QT_TRANSLATE_NOOP("Actions", "Show the trees"),
       true},
      {"layer.path", QT_TRANSLATE_NOOP("Actions", "Path"), "", QT_TRANSLATE_NOOP("Actions", "Show the path"), true},
      {"layer.contact", QT_TRANSLATE_NOOP("Actions", "Contact"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the nearest obstacle and the tangent plane"), true},
      {"layer.force", QT_TRANSLATE_NOOP("Actions", "Guidance force"), "",
       QT_TRANSLATE_NOOP("Actions", "Show what guides the hand: the force as an arrow, its strength as a tint"), true},
      {"layer.free-cells", QT_TRANSLATE_NOOP("Actions", "Free cells"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the octree's free cells, the coarsest first"), true},
      {"layer.mobile-cells", QT_TRANSLATE_NOOP("Actions", "Cells with mobile bodies"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the cells that only mobile bodies clutter"), true},
      {"layer.static-cells", QT_TRANSLATE_NOOP("Actions", "Cells with static bodies"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the cells that static bodies clutter"), true},
      {"layer.places", QT_TRANSLATE_NOOP("Actions", "Places"), "F8",
       QT_TRANSLATE_NOOP("Actions", "Show the places, coloured by complexity; click to select"), true},
      {"layer.borders", QT_TRANSLATE_NOOP("Actions", "Borders"), "",
       QT_TRANSLATE_NOOP("Actions", "Show where places meet"), true},
      {"layer.graph", QT_TRANSLATE_NOOP("Actions", "Topological graph"), "F9",
       QT_TRANSLATE_NOOP("Actions", "Show the topological graph with its costs"), true},
      {"layer.coarse-path", QT_TRANSLATE_NOOP("Actions", "Coarse path"), "",
       QT_TRANSLATE_NOOP("Actions", "Show the cheapest way through the graph"), true},
      {"layer.milestones", QT_TRANSLATE_NOOP("Actions", "Milestones"), "",
       QT_TRANSLATE_NOOP("Actions",
                         "Show the configurations to pass through; drag one to move it, Ctrl+drag to turn it"),
       true},
      {"layer.region", QT_TRANSLATE_NOOP("Actions", "Region of a step"), "",
       QT_TRANSLATE_NOOP("Actions", "Show where the local planner of the chosen step searches"), true},
      {"layer.difficulty", QT_TRANSLATE_NOOP("Actions", "What stands in the way"), "",
       QT_TRANSLATE_NOOP("Actions", "Show why no path was found: blocking body, gap, way of least penetration"), true},
      {"panel.scene", QT_TRANSLATE_NOOP("Actions", "Scene panel"), "Alt+1",
       QT_TRANSLATE_NOOP("Actions", "Bring the list of bodies to the front"), false},
      {"panel.semantics", QT_TRANSLATE_NOOP("Actions", "Semantics panel"), "Alt+2",
       QT_TRANSLATE_NOOP("Actions", "Bring the editor of semantic attributes to the front"), false},
      {"panel.run", QT_TRANSLATE_NOOP("Actions", "Run panel"), "Alt+3",
       QT_TRANSLATE_NOOP("Actions", "Bring the figures of the run to the front"), false},
      {"panel.plan", QT_TRANSLATE_NOOP("Actions", "Plan panel"), "Alt+4",
       QT_TRANSLATE_NOOP("Actions", "Bring the topological steps to the front"), false},
      {"panel.path", QT_TRANSLATE_NOOP("Actions", "Path panel"), "Alt+5",
       QT_TRANSLATE_NOOP("Actions", "Bring the path and its certificate to the front"), false},
      {"panel.difficulty", QT_TRANSLATE_NOOP("Actions", "Difficulty panel"), "Alt+6",
       QT_TRANSLATE_NOOP("Actions", "Bring the reasons why no path was found to the front"), false},
      {"panel.fits", QT_TRANSLATE_NOOP("Actions", "Fits panel"), "Alt+8",
       QT_TRANSLATE_NOOP("Actions", "Bring the table of fits to the front"), false},
      {"panel.section", QT_TRANSLATE_NOOP("Actions", "Section panel"), "Alt+7",
       QT_TRANSLATE_NOOP("Actions", "Bring the section planes to the front"), false},
      {"help.shortcuts", QT_TRANSLATE_NOOP("Actions", "&Keys and shortcuts"), "F1",
       QT_TRANSLATE_NOOP("Actions", "How to steer, and all shortcuts"), false},
      {"help.about", QT_TRANSLATE_NOOP("Actions", "&About Glissade"), "",
       QT_TRANSLATE_NOOP("Actions", "Version, licence and the papers"), false},
  };
  return specs;
}

ActionCatalogue::ActionCatalogue(QObject* parent) : QObject(parent) {
  for (const ActionSpec& spec : actionSpecs()) {
    auto* action = new QAction(translated(spec.text), this);
    action->setObjectName(QLatin1String(spec.id));
    action->setCheckable(spec.checkable);
    const QKeySequence keys(QString::fromLatin1(spec.shortcut));
    action->setShortcut(keys);
    QString tip = translated(spec.tip);
    if (!keys.isEmpty()) tip += QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
    action->setToolTip(tip);
    action->setStatusTip(translated(spec.tip));
    actions_.insert(QLatin1String(spec.id), action);
  }
}

QString ActionCatalogue::shortcutTable() const {
  QString rows;
  for (const ActionSpec& spec : actionSpecs()) {
    if (spec.shortcut[0] == '\0') continue;
    const QAction* action = actions_.value(QLatin1String(spec.id));
    rows +=
        QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td><td>&nbsp;&nbsp;%3</td></tr>")
            .arg(action->shortcut().toString(QKeySequence::NativeText), plain(action->text()), translated(spec.tip));
  }
  return rows;
}

QHBoxLayout* makeActionRow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent) {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (const char* id : ids) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(actions[QLatin1String(id)]);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
  }
  row->addStretch();
  return row;
}

}  // namespace glissade
