#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "sim/hand.h"
#include "sim/path.h"
#include "sim/rig_geometry.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tractus::sim {

// A hand's part, written down: which tools it takes, and what it draws with each. Logs for
// demonstrations and tests are made from it. TOML; millimetres of the world frame, degrees:
//
//     version = 1
//     seed = 7                    # Of the hand's tremor and the sensors' noise; 1 if left out.
//     tools = "older"             # Tools mean what their words alone say in a log; if left out or
//                                 # "newest", what a person takes in hand now.
//     coil_height_mm = 9          # The tablet sees the pen so far above its nib; 0 if left out.
//     lean_deg = [30, -20]        # How the pen is held, to +x and +y; as HandOptions if left out.
//     leaned_around_deg = [25, 20]  # And how far it is leaned around that; 0 if left out.
//
//     [[gesture]]
//     tool = "select"
//     trace = "axis"              # Draws over a branch of the plant as it is seen on the tablet:
//     axis = 2                    # this one, counted by the program that shows the plant.
//     height_mm = 50              # The carriage's; 50 if left out.
//
//     [[gesture]]
//     tool = "draw"               # As in a recording; `tractus tools` lists them.
//     propagation = "both"        # For "draw": "selected", "descendants" or "both".
//     path = "helix"              # And then the path's own keys, in the table below.
//     foot_mm = [0, 0, 40]
//     radius_mm = 35
//     turns = 2
//     rise_mm = 250
//     speed_mm_s = 180            # Cruising; 5 to 1000, 150 if left out.
//
//     [[gesture]]
//     tool = "sketch"
//     words = "laterals=3 branch" # Of any tool, as they follow it in a recording.
//     path = "s_curve"
//     ...
//
//     [[gesture]]
//     tool = "hide_plant"
//     words = "now"               # Done at once, without a path.
//
//     path        keys (see path.h; those in brackets are 0 if left out)
//
//     line        from_mm, to_mm
//
//     arc         center_mm, radius_mm, sweep_deg, [start_deg], [rise_mm]
//
//     helix       foot_mm, radius_mm, turns, [rise_mm], [start_deg],
//                 end_radius_mm (as radius_mm if left out)
//
//     s_curve     from_mm, to_mm, swing_mm
//
//     branch      from_mm, length_mm, heading_deg, elevation_deg, [turn_deg], [bend_deg]
//
//     polyline    points_mm

// Goes over a branch of the plant on the screen; what its rank counts is the tracer's affair.
struct AxisTrace {
    std::size_t rank = 0;
    double height_mm = 50;
};

// Draws nothing: the tool is done at once.
struct AtOnce { };

struct Gesture {
    std::string tool {};  // As in a recording; who knows the tools checks it.
    std::string words {}; // What follows it there.
    // An AxisTrace for "select" alone. Shapes are drawable.
    std::variant<PathShape, AxisTrace, AtOnce> path {};
    double speed_mm_s = 150;
    std::string place {}; // "FILE:LINE: gesture[1]", for errors.
};

struct GestureScript {
    std::uint64_t seed = 1;
    // Older: the recording has the tools' words as they stand here. Newest: also those that make
    // them the tools that a person takes in hand now.
    enum class Tools { Newest, Older } tools = Tools::Newest;
    double coil_height_mm = 0;
    std::optional<Vec2> lean_deg {};
    Vec2 leaned_around_deg = Vec2::Zero();
    std::vector<Gesture> gestures; // At least one.
};

// Fails as the user's fault, naming `file`, the line and the key.
Result<GestureScript> parse_gesture_script(std::string_view text, std::string const& file);

// The branch of a rank as the user sees it: points in the tablet frame, millimetres.
using AxisTracer = std::function<Result<std::vector<Vec2>>(std::size_t rank)>;

// Returns what the hand draws: one stroke per gesture that has a path, in order, for a Hand and
// simulate_rig().
// `tracer` is asked for the branches. Fails, as the user's fault, if a gesture is out of the rig's
// reach, and with the tracer's error; both name the gesture's place.
Result<std::vector<HandStroke>> strokes_of(GestureScript const& script, RigGeometry const& geometry,
                                           AxisTracer const& tracer);

} // namespace tractus::sim
