#pragma once

#include "app/methods/construction_lines/organ_source.h"
#include "engine/base/result.h"
#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/layer_organs.h"
#include "engine/methods/construction_lines/pattern.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lines {

// A sketch of construction lines, and the pattern in which organs stand.
struct LineSketchFile {
    LineSketch sketch;
    std::vector<LineSketch> more_stems {}; // Of the same plant, each with its own lines.
    // In place of all of their lines: strokes in the order in which they were drawn
    // (StemRecogniser).
    std::vector<std::vector<Vec3>> strokes;
    // Which of the strokes begin another stem, by their numbers, and how many nodes the layers of
    // that one have.
    std::map<std::size_t, std::vector<int>> stem_strokes {};
    Pattern pattern;
    std::vector<LayerOrgans> layers {};    // Of all stems: LineSketch::organs_per_layer.
    std::vector<OrganSource> organs {};    // In the order of their numbers.
    OrganSource organ {};                  // What its leaves look like; no patches: plain blades.
    std::vector<std::string> unknown_keys; // What else the file says.
};

// Reads such a sketch from JSON, millimetres and degrees:
//
//   pattern          "distichous", "decussate", "spiral", "alternate", or "whorled(N)", N 2 to 24
//   divergence       of "spiral" and "alternate"; without it 137.5 and 180
//   stem             [[u, v], …] or [[u, v, w], …]: right, up, and towards the viewer; base first
//   sizes            how they change around the stem: "linear" or "half-ellipses"; without it
//                    linear
//   left, right      [[u, v], …]: the boundaries; one of them may be missing. With [u, v, w] of
//                    which some w is by over a twentieth of the stem's length not that of the
//                    stem's base, one of
//   boundaries       [[[u, v, w], …], …]: more of them, each in space at its azimuth around the
//                    stem
//   inclinations     [[[u, v], …], …]; may be missing
//   strokes          [[[u, v], …], …]: all of these lines, the stem first, without saying which is
//                    which. One that begins another stem is an object {"stem": [[u, v], …]}
//   nodes_per_layer  [N, …]: one number for each layer between neighbouring inclination lines
//   stems            [{…}, …]: more stems of the plant, each an object of stem, left, right,
//                    boundaries, inclinations and nodes_per_layer, of which only the stem has to be
//                    there
//   face             how organs are turned about their length: "flat", "up" or "down"; without it
//                    distichous ones are flat and others up
//   organs           ["leaf.json", null, {…}, …] or "leaf.json": what the organs of each layer are,
//                    from below: plants of another sketch, the file's name from where this one is,
//                    leaves, or what "organ" may be; or an object of "pattern", "divergence",
//                    "face" and "organ", each of which may be missing. What is said last counts for
//                    all layers above, too
//   organ            {"left": [[u, v], …], "right": …, "midrib": …, "section": …, "color": …,
//                    "texture": …}: the shape of the leaves in three views (organ_surface.h), of
//                    which one side, the midrib and the section may be missing, their colour,
//                    "#rrggbb", and in its place a picture, "petal.png", a PNG file from where
//                    this one is; or "heart.organ", the name of a file that says the same
//                    (organ_file.h), from where this one is; or "heart", one of ours
//
// What is given besides a file counts in place of what the file says.
//
// Fails, as the user's fault, with file, place and what to write.
struct GivenBesides {
    std::string pattern;
    std::string sizes {};
    std::optional<double> divergence_deg;
    std::vector<int> nodes_per_layer;
};
Result<LineSketchFile> parse_line_sketch(std::string_view text, std::string const& name,
                                         GivenBesides const& given = {});

// The same from a file of at most 2 MiB, which may also be an SVG drawing (.svg; svg_sketch.h).
Result<LineSketchFile> load_line_sketch(std::filesystem::path const& path,
                                        GivenBesides const& given = {});

} // namespace tractus::lines
