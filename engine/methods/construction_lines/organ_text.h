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

// Functions for surfaces in the text of a model. The picture of a surface is a file of the same
// name with .png.

// Formats a surface as a file of cpfg's Bezier editor (.s), whose SIZE is the organ's length.
std::string format_surface(std::vector<BezierPatch> const& patches);

// Replaces the leaves with this letter in the rules by a surface. The file is named after the
// model: MODEL_organ.s for the letter l, MODEL_organ_a.s for a, and so on.
void put_leaf(LineModel& model, OrganSurface const& surface, char letter);

// Adds flat surfaces of the shape of the plain blades in the view, for cpfg, which does not support
// blades: if a view has both, tractus draws the blades. The files are named after the model:
// MODEL_leaf.s for the letter l, MODEL_leaf_a.s for a, and so on.
void add_blade_surfaces(LineModel& model);

std::size_t count_surfaces(std::span<LineOrgan const> organs);

// Returns the rules Q(z, h) of organs that are surfaces (line_rules.h); `before`: number of organs
// that precede them; `place`: text used in place of z.
std::string surface_rules(std::span<LineOrgan const> organs, std::size_t before,
                          std::string const& place);

// Adds the surfaces of organs to the model: their files, named after the model with _organ_1.s and
// so on, and their entries in the view. Fails with a user error if there are more than
// kMaxSurfaces.
Result<void> add_surfaces(LineModel& model, std::span<LineOrgan const> organs, std::size_t before);

} // namespace tractus::lines
