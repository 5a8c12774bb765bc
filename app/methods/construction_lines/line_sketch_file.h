#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/pattern.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lines {

// A sketch of construction lines, and the pattern in which organs stand.
struct LineSketchFile {
    LineSketch sketch;
    // In place of the sketch's lines: strokes in the order in which they were drawn
    // (LineRecogniser).
    std::vector<std::vector<Vec3>> strokes;
    Pattern pattern;
    std::vector<std::string> unknown_keys; // What else the file says.
};

// Reads such a sketch from JSON, millimetres and degrees:
//
//   pattern          "distichous", "decussate", "spiral", "alternate", or "whorled(N)", N 2 to 24
//   divergence       of "spiral" and "alternate"; without it 137.5 and 180
//   stem             [[u, v], …] or [[u, v, w], …]: right, up, and towards the viewer; base first
//   left, right      [[u, v], …]: the boundaries; one of them may be missing
//   inclinations     [[[u, v], …], …]; may be missing
//   strokes          [[[u, v], …], …]: all of these lines, the stem first, without saying which is
//                    which
//   nodes_per_layer  [N, …]: one number for each layer between neighbouring inclination lines
//
// What is given besides a file counts in place of what the file says.
//
// Fails, as the user's fault, with file, place and what to write.
struct GivenBesides {
    std::string pattern;
    std::optional<double> divergence_deg;
    std::vector<int> nodes_per_layer;
};
Result<LineSketchFile> parse_line_sketch(std::string_view text, std::string const& name,
                                         GivenBesides const& given = {});

// The same from a file of at most 2 MiB, which may also be an SVG drawing (.svg; svg_sketch.h).
Result<LineSketchFile> load_line_sketch(std::filesystem::path const& path,
                                        GivenBesides const& given = {});

} // namespace tractus::lines
