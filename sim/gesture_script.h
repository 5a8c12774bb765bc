#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "sim/hand.h"
#include "sim/path.h"
#include "sim/rig_geometry.h"
#include "sim/unkindness.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tractus::sim {

// A script for a simulated hand: which tools it uses, and what it draws with each. Logs for
// demonstrations and tests are made from such scripts. TOML; world frame, millimetres and degrees:
//
//     version = 1
//     seed = 7                    # Seed of tremor and sensor noise; default: 1.
//     tools = "older"             # "older": tools as in old logs; "newest" (default): the
//                                 # current tools.
//     coil_height_mm = 9          # Height of the pen's coil above its nib; default: 0.
//     lean_deg = [30, -20]        # Tilt of the pen to +x and +y; default: see HandOptions.
//     leaned_around_deg = [25, 20]  # Variation of that tilt; default: 0.
//
//     [unkind]                    # Faults of hand, devices and computer (unkindness_table.h);
//     dab_share = 0.3             # without this table there are none.
//
//     [[gesture]]
//     tool = "select"
//     trace = "axis"              # Traces a branch of the plant as seen on the tablet:
//     axis = 2                    # this one, as counted by the program that shows the plant.
//     height_mm = 50              # Height of the carriage; default: 50.
//
//     [[gesture]]
//     tool = "draw"               # Word in recordings; `tractus tools` lists the tools.
//     propagation = "both"        # For "draw": "selected", "descendants" or "both".
//     path = "helix"              # Followed by the path's own keys, see the table below.
//     foot_mm = [0, 0, 40]
//     radius_mm = 35
//     turns = 2
//     rise_mm = 250
//     speed_mm_s = 180            # Cruising speed, 5 to 1000; default: 150.
//
//     [[gesture]]
//     tool = "sketch"
//     words = "laterals=3 branch" # Arguments of any tool, as in a recording.
//     path = "s_curve"
//     ...
//
//     [[gesture]]
//     tool = "hide_plant"
//     words = "now"               # The tool acts at once, without a path.
//
//     path        keys (see path.h; those in brackets default to 0)
//
//     line        from_mm, to_mm
//
//     arc         center_mm, radius_mm, sweep_deg, [start_deg], [rise_mm]
//
//     helix       foot_mm, radius_mm, turns, [rise_mm], [start_deg],
//                 end_radius_mm (default: radius_mm)
//
//     s_curve     from_mm, to_mm, swing_mm
//
//     branch      from_mm, length_mm, heading_deg, elevation_deg, [turn_deg], [bend_deg]
//
//     polyline    points_mm

// Traces a branch of the plant on the screen; AxisTracer interprets the rank.
struct AxisTrace {
    std::size_t rank = 0;
    double height_mm = 50;
};

// Path of a tool that acts at once.
struct AtOnce { };

struct Gesture {
    // Word of the tool in recordings; checked by the caller, who knows the tools.
    std::string tool {};
    std::string words {}; // Arguments that follow the tool's word in recordings.
    // Path of the pen; AxisTrace only for the tool "select". Shapes are drawable.
    std::variant<PathShape, AxisTrace, AtOnce> path {};
    double speed_mm_s = 150;
    std::string place {}; // Position in the script, "FILE:LINE: gesture[1]", for errors.
};

struct GestureScript {
    std::uint64_t seed = 1;
    // Meaning of the tools' words in the script. Older: the words are written to the recording
    // unchanged, with the meaning that they have in old logs. Newest: words that select the current
    // tools are added.
    enum class Tools { Newest, Older } tools = Tools::Newest;
    double coil_height_mm = 0;
    std::optional<Vec2> lean_deg {};
    Vec2 leaned_around_deg = Vec2::Zero();
    Unkindness unkindness {};
    std::vector<Gesture> gestures; // The script has at least one gesture.
};

// Parses a script. Fails with a user error naming `file`, the line and the key.
Result<GestureScript> parse_gesture_script(std::string_view text, std::string const& file);

// Returns the branch at a rank, as the user sees it: points in the tablet frame, in millimetres.
using AxisTracer = std::function<Result<std::vector<Vec2>>(std::size_t rank)>;

// Converts a script into strokes for a Hand and simulate_rig(): one for each gesture with a path,
// in order, with the dabs and hooks of the script's `unkindness`. `tracer` provides the branches.
// Fails with a user error if a gesture is outside the rig's reach, and with the tracer's error;
// both name the gesture's position.
Result<std::vector<HandStroke>> strokes_of(GestureScript const& script, RigGeometry const& geometry,
                                           AxisTracer const& tracer);

} // namespace tractus::sim
