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

// A plant as text: rules and view, and the files of functions that the view names, by name.
struct LineModel {
    lsystem::ModelSource source;
    std::map<std::string, std::string> functions;
};

// The plant of a construction in cpfg's language, for people to read and to edit. A step makes a
// node, so fewer steps are a younger stem. The names of its files begin with `name`, which has only
// letters, digits, - and _. A millimetre of the sketch is a centimetre of the plant, as in all our
// models.
//
// At 0 and 180 degrees around the stem, so on its left and its right, organs have those sides'
// angles and sizes; in between both change linearly with the angle around it, as in the paper.
// Around boundaries in space, and where the pattern has it, sizes follow half-ellipses
// (Construction::around).
LineModel write_model(Construction const& measured, Pattern const& pattern,
                      std::string const& name);

// The plant of several stems, at least one, for which the rules are there once: tables say where
// each stem stands and which functions are its own, and stems with the same organs share theirs.
// Stems that stand on another come with its nodes: where a stem is to bear one, it takes a step for
// it. A stem is no thicker than what bears it. Where one of them has boundaries in space the sizes
// of all of them follow half-ellipses. With a single stem it is the text of that one.
//
// Where layers of several stems bear different organs the rules have <leaves> where those of organs
// that are surfaces are to stand in (composed_model.h); of a single stem layers do not count.
LineModel write_model(std::span<MeasuredStem const> measured, Pattern const& pattern,
                      std::string const& name);

// Where the tips of a plant's organs are in the sketch: (u, v, depth), millimetres, in the plant's
// order. The plant is the model's, at ten times a turtle's unit a millimetre, and the construction
// that of its first stem.
std::vector<Vec3> organ_tips(Construction const& construction, Plant const& plant);

} // namespace tractus::lines
