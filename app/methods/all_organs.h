#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::methods {

// A kind of leaf drawn in three views (top, side, section), for plants made of construction lines:
// a built-in kind or the user's .organ file. A leaf drawn in the document is a DrawnOrgan instead.

struct OrganKind {
    std::string name; // Name of the leaf, for example "heart".
    std::filesystem::path file;
};
// The built-in kinds of leaves drawn in three views, in alphabetical order.
std::vector<OrganKind> organ_kinds();

bool is_organ_file(std::filesystem::path const& file);

// A leaf drawn in three views in the document, and the text for its .organ file. Leaves whose lines
// are not complete yet are not listed.
struct DrawnOrgan {
    scene::ItemId plant = 0;
    std::string text;
};
std::vector<DrawnOrgan> drawn_organs(scene::DocumentState const& state);

// True if the active plant can have leaves drawn in three views.
bool takes_organs(scene::DocumentState const& state);

// Returns the edits that add a leaf drawn in three views to the active plant. Fails with a user
// error if this plant cannot have such leaves or the file is invalid.
Result<std::vector<scene::Edit>> organ_edits(scene::Scene const& scene,
                                             std::filesystem::path const& file);

// Message for the user about the scene after organ_edits() were applied.
std::string describe_organ(scene::DocumentState const& after);

// A plant that consists of a single leaf drawn in three views. The leaf is upright on the ground,
// with its upper side towards a viewer in front. Fails with a user error if the file is invalid.
Result<Plant> plant_of_organ(std::filesystem::path const& file);

} // namespace tractus::methods
