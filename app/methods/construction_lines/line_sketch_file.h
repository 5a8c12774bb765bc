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

// The contents of a sketch's file: construction lines, and the arrangement of organs.
struct LineSketchFile {
    LineSketch sketch;
    // Further stems of the plant, each with its own lines.
    std::vector<LineSketch> further_stems {};
    // Strokes in drawing order whose roles are to be recognised (StemRecogniser). If there are any,
    // they are used instead of `sketch` and `further_stems`.
    std::vector<std::vector<Vec3>> strokes;
    // For each stroke of `strokes` that begins another stem, by its index: the numbers of nodes in
    // the layers of this stem.
    std::map<std::size_t, std::vector<int>> stem_strokes {};
    Pattern pattern;
    // Organs of each layer, the same for all stems (LineSketch::organs_per_layer).
    std::vector<LayerOrgans> layers {};
    // Kinds of organs, to which `layers` refers by index.
    std::vector<OrganSource> organs {};
    OrganSource organ {}; // Shape of the leaves; without patches, leaves are plain blades.
    std::vector<std::string> unknown_keys; // Keys of the file that were not understood.
};

// Values that replace those in a sketch's file, if given.
struct SketchOverrides {
    std::string pattern;
    std::string sizes {};
    std::optional<double> divergence_deg;
    std::vector<int> nodes_per_layer;
};

// Reads a sketch of construction lines from JSON; lengths in millimetres, angles in degrees:
//
//   pattern          "distichous", "decussate", "spiral", "alternate", or "whorled(N)", N 2 to 24
//   divergence       angle of "spiral" and "alternate"; default 137.5 and 180
//   stem             [[u, v], …] or [[u, v, w], …]: right, up, and towards the viewer; base first
//   sizes            how sizes change around the stem: "linear" (default) or "half-ellipses"
//   left, right      [[u, v], …]: the boundaries; one of them may be missing. A line [[u, v, w], …]
//                    some w of which differs from that of the stem's base by more than a
//                    twentieth of the stem's length counts as one of "boundaries"
//   boundaries       [[[u, v, w], …], …]: further boundaries, each in space at its azimuth around
//                    the stem
//   inclinations     [[[u, v], …], …]; optional
//   strokes          [[[u, v], …], …]: in place of the lines above, all lines, the stem first; the
//                    role of each is recognised. A stroke that begins another stem is an object
//                    {"stem": [[u, v], …]}
//   nodes_per_layer  [N, …]: one number for each layer between neighbouring inclination lines
//   stems            [{…}, …]: more stems of the plant, each an object with the keys stem, left,
//                    right, boundaries, inclinations and nodes_per_layer; only stem is required
//   face             how organs are turned about their length: "flat", "up" or "down"; by default
//                    distichous organs are flat and others up
//   organs           ["leaf.json", null, {…}, …] or "leaf.json": the organs of each layer, from
//                    below. Each is the file of another sketch, relative to this one, whose plant
//                    is the organ; a leaf, given as in "organ"; or an object with the optional keys
//                    "pattern", "divergence", "face" and "organ". The last entry also applies to
//                    all layers above
//   organ            {"left": [[u, v], …], "right": …, "midrib": …, "section": …, "color": …,
//                    "texture": …}: the shape of the leaves in three views (organ_surface.h). One
//                    side, the midrib and the section may be missing. "color" is "#rrggbb";
//                    "texture" is a PNG file, relative to this one, and replaces "color". Or
//                    "heart.organ": a file with the same content (organ_file.h), relative to this
//                    one. Or "heart": a built-in leaf
//
// Values in `given` override those in the file. Fails with a user error that names the file, the
// place and what to write.
Result<LineSketchFile> parse_line_sketch(std::string_view text, std::string const& name,
                                         SketchOverrides const& given = {});

// Reads a sketch from a file of at most 2 MiB: JSON as for parse_line_sketch(), or an SVG drawing
// (.svg, see svg_sketch.h).
Result<LineSketchFile> load_line_sketch(std::filesystem::path const& path,
                                        SketchOverrides const& given = {});

} // namespace tractus::lines
