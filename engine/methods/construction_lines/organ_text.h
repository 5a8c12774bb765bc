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

// Surfaces in the text of a model. A picture of one is a file called as its own is, with .png.

// A file of cpfg's Bezier editor (.s), whose SIZE is the organ's length.
std::string surface_text(std::vector<BezierPatch> const& patches);

// Puts a surface in the place of the leaves that the rules call by this letter. The file is called
// as the model is, with _organ.s, and behind it the letter if it is not l.
void put_leaf(LineModel& model, OrganSurface const& surface, char letter);

// Adds surfaces as flat as the plain blades that the view names, for cpfg, which knows no blades:
// where a view names both, tractus draws the blades. The files are called as the model is, with
// _leaf.s, and behind it the letter if it is not l.
void add_blade_surfaces(LineModel& model);

std::size_t count_surfaces(std::span<LineOrgan const> organs);

// The rules of organs that are surfaces (line_rules.h), of which so many others come before:
// Q(z, h), where `place` says what stands in place of z.
std::string surface_rules(std::span<LineOrgan const> organs, std::size_t before,
                          std::string const& place);

// Adds their files, called as the model is, with _organ_1.s and so on, and what the view says of
// them. Fails, as the user's fault, for more than kMostSurfaces.
Result<void> add_surfaces(LineModel& model, std::span<LineOrgan const> organs, std::size_t before);

} // namespace tractus::lines
