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

// A plant as text: rules, a view, and the contents of the function files that the view names, by
// file name.
struct LineModel {
    lsystem::ModelSource source;
    std::map<std::string, std::string> functions;
};

// Writes the plant of a construction in cpfg's language, in a form that people can read and edit.
// One derivation step makes one node, so fewer steps give a younger stem. The names of the model's
// files begin with `name`, which consists of letters, digits, - and _. One millimetre of the sketch
// is one centimetre of the plant, as in all generated models.
//
// Organs on the stem's left and right, at the azimuths 0 and 180 degrees, have the angles and sizes
// of these sides. At other azimuths angles and sizes are interpolated linearly in the azimuth
// (Anastacio et al. 2008). If there are boundaries in space, or if `pattern` has
// Sizes::HalfEllipses, sizes follow half-ellipses instead (Construction::around).
LineModel write_model(Construction const& measured, Pattern const& pattern,
                      std::string const& name);

// Writes the plant of several stems, at least one, with a single set of rules: tables give each
// stem's position and functions; stems with the same organs share functions. A lateral stem takes a
// derivation step of its own, between those of its parent's nodes below and above it. A stem is no
// thicker than its parent. If one of the stems has boundaries in space, the sizes of all stems'
// organs follow half-ellipses. For a single stem the text is that of the other write_model().
//
// If layers of several stems have different organs, the rules contain the placeholder <leaves> for
// the rules of organs that are surfaces (composed_model.h). With a single stem, differences between
// its layers are ignored.
LineModel write_model(std::span<MeasuredStem const> measured, Pattern const& pattern,
                      std::string const& name);

// Returns the tips of a plant's organs in coordinates of the sketch, (u, v, depth) in millimetres,
// in the order of Plant::organs. `plant` is generated from the model, with ten plant millimetres
// per millimetre of the sheet; `construction` is that of the plant's first stem.
std::vector<Vec3> organ_tips(Construction const& construction, Plant const& plant);

} // namespace tractus::lines
