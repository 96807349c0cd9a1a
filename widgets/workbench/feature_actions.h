#pragma once

#include <vector>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

// The rows of each feature are in widgets/FEATURE/FEATURE_actions.cpp. windowActions() puts them together.

std::vector<ActionSpec> filesActions();     ///< the files of scenarios
std::vector<ActionSpec> productActions();   ///< the product and its bodies
std::vector<ActionSpec> arrangeActions();   ///< the placement of bodies
std::vector<ActionSpec> contactsActions();  ///< fits and joints
std::vector<ActionSpec> placesActions();    ///< places, attributes and milestones
std::vector<ActionSpec> runActions();       ///< runs, replays and difficulties
std::vector<ActionSpec> devicesActions();   ///< devices of the operator
std::vector<ActionSpec> pathsActions();     ///< the path and the kept paths
std::vector<ActionSpec> sequenceActions();  ///< sequences, instructions and the access of a hand
std::vector<ActionSpec> studiesActions();
std::vector<ActionSpec> viewActions();     ///< the view of the scene
std::vector<ActionSpec> sectionActions();  ///< sections
std::vector<ActionSpec> measureActions();  ///< measurements
std::vector<ActionSpec> headsetActions();  ///< the headset
std::vector<ActionSpec> helpActions();     ///< help and the log

}  // namespace glissade
