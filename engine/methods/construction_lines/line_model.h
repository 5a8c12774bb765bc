#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/pattern.h"
#include "engine/methods/construction_lines/several_stems.h"
#include "engine/plant/plant.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace tractus::lines {

// A plant as text: rules and view, and the function files that the view refers to, by name.
struct LineModel {
    lsystem::ModelSource source;
    std::map<std::string, std::string> functions;
};

// Writes the plant of a construction in cpfg's language, in a form that people can read and edit.
// One derivation step makes one node, so fewer steps give a younger stem. The names of its files
// begin with `name`, which consists of letters, digits, - and _. One millimetre of the sketch is
// one centimetre of the plant, as in all generated models.
//
// Organs at 0 and 180 degrees around the stem, on its left and right, have the angles and sizes of
// those sides; in between both are linear in the azimuth, as in the paper. With boundaries in
// space, or if the pattern says so, sizes follow half-ellipses (Construction::around).
LineModel write_model(Construction const& measured, Pattern const& pattern,
                      std::string const& name);

// Writes the plant of several stems, at least one, with a single set of rules: tables give each
// stem's position and functions; stems with the same organs share functions. A lateral stem appears
// in sequence with its parent's nodes and takes an additional derivation step. A stem is no thicker
// than its parent. If one of the stems has boundaries in space, the sizes of all follow
// half-ellipses. For a single stem the text is that of the other write_model().
//
// If layers of several stems have different organs, the rules contain the placeholder <leaves> for
// the rules of organs that are surfaces (composed_model.h); for a single stem, layers are ignored.
LineModel write_model(std::span<MeasuredStem const> measured, Pattern const& pattern,
                      std::string const& name);

// Returns the tips of a plant's organs in coordinates of the sketch: (u, v, depth), millimetres, in
// the plant's order. `plant` is generated from the model, with ten plant millimetres per millimetre
// of the sheet; `construction` is that of its first stem.
std::vector<Vec3> organ_tips(Construction const& construction, Plant const& plant);

} // namespace tractus::lines
