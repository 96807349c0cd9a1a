#pragma once

#include <array>

#include "engine/base/enum_names.h"

namespace glissade {

/// A set of panels for one kind of work. Each remembers its layout.
enum class Workspace { Assembly, Planning, Study };

inline constexpr std::array<Workspace, 3> kWorkspaces{Workspace::Assembly, Workspace::Planning, Workspace::Study};
/// The actions that show the workspaces; their layouts have the same keys in the settings.
inline constexpr EnumNames<Workspace, 3> kWorkspaceActions{
    {"workspace.assembly", "workspace.planning", "workspace.study"}};

}  // namespace glissade
