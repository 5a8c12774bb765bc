#pragma once

#include "app/methods/all_methods.h"
#include "tests/app/drawing_station.h"
#include "tests/app/simple_rig.h"

#include <optional>
#include <utility>

namespace tractus {

// Returns a station with the simple pen and the tools of all methods. Its surface stays at a height
// of 100 mm.
inline station::Station flat_station(std::optional<tools::Tool> const& tool = {})
{
    return flat_station(methods::all_methods().tools, tool);
}

// Returns a station whose surface stays at 100 mm, together with a document of the scene.
inline DrawingStation station_on(scene::Scene scene, std::optional<tools::Tool> const& tool = {})
{
    return { flat_station(tool), std::move(scene) };
}

} // namespace tractus
