#pragma once

#include <string>
#include <vector>

namespace glissade {

/// A body's place in the tree of its product: the names of the assemblies that it is in, from the root on, and its own,
/// joined by "/". Ids and names of bodies are such paths. Nothing else in the program takes them apart.

/// The names on the way: "pump", "rotor", "nut" of "pump/rotor/nut". Empty ones are left out.
std::vector<std::string> stepsOf(const std::string& path);

/// "pump" of "pump/rotor/nut".
std::string firstStepOf(const std::string& path);

/// "nut" of "pump/rotor/nut".
std::string lastStepOf(const std::string& path);

/// "pump/rotor" of its steps.
std::string pathOf(const std::vector<std::string>& steps);

/// The step is the name with a number, as importers give it to the second of two siblings: "pin#2" of "pin".
bool isNumbered(const std::string& step, const std::string& name);

/// Both, one after the other; one of them where the other is empty.
std::string joinedPath(const std::string& path, const std::string& rest);

/// The assemblies that it is in, from the root on: "pump", "pump/rotor".
std::vector<std::string> assembliesAbove(const std::string& path);

/// The path is the node, or below it. All are below the empty node.
bool isWithin(const std::string& path, const std::string& node);

/// What remains of the path below a node that it is within; empty where it is the node.
std::string pathWithin(const std::string& path, const std::string& node);

/// The path is this, or ends in it, in whole names: "nut" and "rotor/nut", but not "ut".
bool endsInPath(const std::string& path, const std::string& end);

/// The name means the body: its path ends in it, or that of an assembly that it is in does.
bool isMeantBy(const std::string& name, const std::string& path);

}  // namespace glissade
