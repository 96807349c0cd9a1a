#pragma once

#include <QFlags>

namespace glissade {

/// What of the document has changed. Opening another scenario changes everything.
enum class Change {
  Scenario = 0x01,     ///< another scenario was opened
  Arrangement = 0x02,  ///< its bodies, its object, start, goal, workspace or rules
  Semantics = 0x04,    ///< the user's semantic edits
  Knowledge = 0x08,    ///< the environment model
  Options = 0x10,      ///< how the environment is modelled
  Settings = 0x20,     ///< strategy, seed and parameters of the next run
  Results = 0x40,      ///< the path
  File = 0x80,         ///< the file, and whether it has all edits
  Paths = 0x100,       ///< the paths that are kept
  Sequence = 0x200     ///< what is demanded of assembly plans
};
Q_DECLARE_FLAGS(Changes, Change)
Q_DECLARE_OPERATORS_FOR_FLAGS(Changes)

inline constexpr int kEveryChange = 0x3ff;

}  // namespace glissade
