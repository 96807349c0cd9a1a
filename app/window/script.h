#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"

namespace glissade {

/// One line of a script: what to do, with its words.
struct ScriptCommand {
  int line = 0;  ///< in the file, from 1
  std::string name;
  std::vector<std::string> arguments;
};

/// Parses a script. One command a line, a word that begins with '#' and what follows is a comment:
///
///   action ID                   an action of the catalogue, e.g. run.start
///   set PARAMETER VALUE         a parameter by its key, e.g. set alpha 0.5 (taken back from the tuner
///                               by that) or set tuning 7 (α, N and d set themselves)
///   expect-value PARAMETER VALUE   this is in force, the tuner's value where it sets itself
///   select-operator ID          hand, keyboard, mouse6d, gamepad, expert, default, novice,
///                               simulated-haptic
///   key press|release|tap KEY   a key over the 3D view, e.g. key press W
///   plug DEVICE NAME            a keyboard, mouse6d or gamepad of that name comes, offscreen
///   unplug DEVICE               it goes
///   deflect DEVICE X Y Z RX RY RZ   its six raw axes, each in [-1, 1]
///   press DEVICE BUTTON         a button of it, from 0
///   expect-steering TARGET      object or camera
///   steps N                     let the session do N planner steps (offscreen)
///   wait STATE LIMIT            idle, planning, paused, solved, ended; LIMIT in steps offscreen,
///                               in seconds on screen
///   expect STATE                the session is in this state now
///   rule node|edge EXPRESSION   of strategy "own": f or g, without blanks
///   select-strategy ID          g, gt, gts1, gts2, gts, own, contact-birrt, ...
///   open FILE                   another scenario
///   save FILE                   the scenario with its edits
///   select KIND NAME            a place by its name, a body by its id, a step by its number
///   new-scenario FILE UNIT UP   of this part, which moves: metres in a unit of the file, Y or Z; a part of a
///                               STEP file as in asm.step:pin, with 1 and Z
///   add-part FILE ROLE UNIT UP  static or mobile; of a STEP file all parts that are not there yet
///   place WHAT X,Y,Z ROLL,PITCH,YAW   a body by its id, "start", or "goal": millimetres, degrees
///   expect-place WHAT X,Y,Z     it is there, to a hundredth of a millimetre; "nowhere": there is none
///   show-body ID yes|no         whether an obstacle is drawn
///   click X Y                   the left button over the 3D view, in pixels
///   drag X Y TO_X TO_Y          the left button held from one pixel of the 3D view to another
///   attribute NAME VALUE        on what is selected: yes, no, a number or a text; "-" resets it
///   type NAME TEXT              into the editor of that attribute, without Enter
///   define NAME TYPE OWNER      an attribute: bool, integer, number, text; of place or body
///   expect-attribute NAME VALUE what is selected has this value
///   expect-way NAMES            the places that the coarse path leads through: P1,P6,P2
///   expect-step NAME            the step that is highlighted crosses this place; "-": none is
///   expect-plan WHAT            the coarse plan that is shown: tried (a run's), preview, none
///   identify ID                 how places are found: region-growing, watershed
///   study DIR                   the browser of a study's results
///   study-cell N                chooses its N-th cell
///   study-plot N                brings its N-th plot to the front
///   study-zoom X0 Y0 X1 Y1      shows a part of the plot, 0 to 1 along each axis, y up
///   study-save-plot FILE        the plot as it is seen, .svg or .png
///   study-run N SEED            shows that run of the N-th cell again (offscreen: go on with wait)
///   study-screenshot FILE       the browser as PNG
///   save-recording FILE         what was done in the last run
///   replay FILE                 a recorded run again
///   seek STEP                   shows that step of the replay
///   expect-replay VERDICT       same, different, another (other parameters), closed
///   expect-difficulty PART BODY  after difficulty.find: least, tightest or frontier names this body; "-": none
///   show-difficulty PART  chooses that row
///   screenshot FILE             the whole window as PNG
///   export FILE                 the path, in the format of the ending
///   quit
///
/// Errors are MalformedInput naming file and line: unknown command, wrong number of words.
Result<std::vector<ScriptCommand>> parseScript(const std::string& text, const std::string& file);

}  // namespace glissade
