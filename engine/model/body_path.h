#pragma once

#include <string>
#include <vector>

namespace glissade {

/// A body's place in the tree of its product: the names of the assemblies that contain it, from the root on, and the
/// body's name, joined by "/". Ids and names of bodies are such paths. Only these functions parse them.

/// The steps of a path: "pump", "rotor", "nut" for "pump/rotor/nut". Empty steps are left out.
std::vector<std::string> stepsOf(const std::string& path);

/// "pump" for "pump/rotor/nut".
std::string firstStepOf(const std::string& path);

/// "nut" for "pump/rotor/nut".
std::string lastStepOf(const std::string& path);

/// "pump/rotor" for "pump", "rotor".
std::string pathOf(const std::vector<std::string>& steps);

/// True if the step is the name with a number, as importers give it to the second of two siblings: "pin#2" for "pin".
bool isNumbered(const std::string& step, const std::string& name);
/// The step without the number that distinguishes siblings: "pin" of "pin#2".
std::string withoutNumber(const std::string& step);

/// Both paths, joined; one of them if the other is empty.
std::string joinedPath(const std::string& path, const std::string& rest);

/// The assemblies that contain the body, from the root on: "pump", "pump/rotor".
std::vector<std::string> assembliesAbove(const std::string& path);

/// True if the path is the node, or below it. All paths are below the empty node.
bool isWithin(const std::string& path, const std::string& node);

/// The rest of a path below a node that contains it; empty if it is the node.
std::string pathWithin(const std::string& path, const std::string& node);

/// True if the path is `end`, or ends in it, in whole names: "nut" and "rotor/nut", but not "ut".
bool endsInPath(const std::string& path, const std::string& end);

/// True if the name means the body: its path, or that of an assembly that contains it, ends in the name.
bool isMeantBy(const std::string& name, const std::string& path);

}  // namespace glissade
