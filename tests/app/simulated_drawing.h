#pragma once

#include "app/methods/all_methods.h"
#include "app/play/simulated_recording.h"
#include "drivers/logs/log.h"
#include "tests/app/small_model.h"

#include <sstream>
#include <string>
#include <string_view>

namespace tractus {

// Script in which the simulated hand shapes the trunk of the small model and then leans the plant.
constexpr std::string_view kTrunkAndWind = R"(
version = 1
seed = 3
[[gesture]]
tool = "select"
trace = "axis"
axis = 0
[[gesture]]
tool = "draw"
propagation = "both"
path = "line"
from_mm = [0, 0, 50]
to_mm = [40, 20, 200]
[[gesture]]
tool = "indicate"
path = "line"
from_mm = [0, 0, 100]
to_mm = [30, 0, 110]
)";

// Returns the text of a log in which the simulated hand draws a script on the small model.
inline Result<std::string> recorded(std::string_view script_text)
{
    auto const script = TRY(sim::parse_gesture_script(script_text, "script"));
    std::ostringstream out;
    TRY(play::write_simulated_recording(out, script, small_scene(), methods::all_methods().tools));
    return out.str();
}

inline drivers::Log recorded_log(std::string_view script_text = kTrunkAndWind)
{
    return drivers::parse_log(recorded(script_text).value(), "hand").value();
}

} // namespace tractus
