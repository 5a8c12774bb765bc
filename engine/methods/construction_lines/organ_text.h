#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/composed_model.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/organ_surface.h"
#include "engine/plant/bezier_patch.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tractus::lines {

// Functions for surfaces in the text of a model. A surface is a file (.s); its picture is a file
// with the same name and the extension .png.

// Formats a surface as a file of cpfg's Bezier editor (.s), whose SIZE is the organ's length.
std::string format_surface(std::vector<BezierPatch> const& patches);

// Makes the model draw a surface in place of the leaves with this letter. The surface's file is
// named after the model: MODEL_organ.s for the letter l, MODEL_organ_a.s for a, and so on.
void put_leaf(LineModel& model, OrganSurface const& surface, char letter);

// Adds a flat surface of the same shape for each plain blade in the view, because cpfg does not
// support blades. If a view has both for a letter, tractus draws the blade. The files are named
// after the model: MODEL_leaf.s for the letter l, MODEL_leaf_a.s for a, and so on.
void add_blade_surfaces(LineModel& model);

std::size_t count_surfaces(std::span<LineOrgan const> organs);

// Returns the rules Q(z, h) of those organs that are surfaces (line_rules.h). `before` is the
// number of surfaces that the model numbers before them; `place` is the text of the rules'
// parameters before h, such as z.
std::string surface_rules(std::span<LineOrgan const> organs, std::size_t before,
                          std::string const& place);

// Adds the surfaces of organs to the model: their files, named after the model with _organ_1.s and
// so on, and their entries in the view. `before` is the number of surfaces numbered before them.
// Fails with a user error if the model would have more than kMaxSurfaces.
Result<void> add_surfaces(LineModel& model, std::span<LineOrgan const> organs, std::size_t before);

} // namespace tractus::lines
