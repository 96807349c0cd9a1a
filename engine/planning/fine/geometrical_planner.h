#pragma once

#include "engine/places/environment_model.h"
#include "engine/planning/sampling_region.h"

namespace glissade {

/// The geometrical planner (paper 2, sections 4.2 and 5.2): A* over the free cells of an area, from the cell of one
/// point to that of another. Cells that are nearer to a body, static or mobile, than the thickness of the object cost
/// more. Cells that contain bodies are not entered. Returns the path's cells, in order; empty where there is no way, or
/// after a stop.
std::vector<std::size_t> findCellPath(const EnvironmentModel& environment, const std::vector<std::size_t>& area,
                                      const std::vector<double>& clearance, const Vector3& from, const Vector3& to,
                                      double objectRadius, const StopToken& stop = {});

/// The path's cells and those of the area within `radius` of them, ascending.
std::vector<std::size_t> regionAlong(const CellGrid& grid, const std::vector<std::size_t>& path,
                                     const std::vector<std::size_t>& area, double radius);

}  // namespace glissade
