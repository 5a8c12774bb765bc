#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::methods {

// A leaf drawn in three views (top, side, section), for plants made of construction lines: a
// built-in one or the user's .organ file. Leaves drawn in the document are of type DrawnOrgan.

struct OrganKind {
    std::string name; // For example "heart".
    std::filesystem::path file;
};
std::vector<OrganKind> organ_kinds(); // The built-in kinds, in alphabetical order.

bool is_organ_file(std::filesystem::path const& file);

// A leaf drawn in three views in the document, and the text of its .organ file. Plants whose lines
// do not make a leaf yet are not listed.
struct DrawnOrgan {
    scene::ItemId plant = 0;
    std::string text;
};
std::vector<DrawnOrgan> drawn_organs(scene::DocumentState const& state);

// True if the active plant can bear leaves drawn in three views.
bool takes_organs(scene::DocumentState const& state);

// Returns the edits that add a leaf in three views to the active plant. Fails with a user error if
// that plant cannot bear one or the file is invalid.
Result<std::vector<scene::Edit>> organ_edits(scene::Scene const& scene,
                                             std::filesystem::path const& file);

// Message for the user after organ_edits() were applied.
std::string describe_organ(scene::DocumentState const& after);

// A plant that consists of one leaf in three views, upright on the ground, with its upper side
// towards a viewer in front. Fails with a user error if the file is invalid.
Result<Plant> plant_of_organ(std::filesystem::path const& file);

} // namespace tractus::methods
