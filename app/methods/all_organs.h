#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::methods {

// Leaves in three views, which plants of construction lines bear: those that come with the program,
// those that are drawn in the document, and the user's own, by their files (.organ).

struct OrganKind {
    std::string name; // "heart".
    std::filesystem::path file;
};
std::vector<OrganKind> organ_kinds(); // Ours, in alphabetical order.

bool is_organ_file(std::filesystem::path const& file);

// The leaves that are drawn for plants of a document, and the texts of their files. One whose lines
// are no leaf is none.
struct DrawnOrgan {
    scene::ItemId plant = 0;
    std::string text;
};
std::vector<DrawnOrgan> drawn_organs(scene::DocumentState const& state);

// Whether the plant that takes what is drawn can bear one.
bool takes_organs(scene::DocumentState const& state);

// The edits that bring one to that plant. Fails, as the user's fault, where it cannot bear one, and
// for a file that is none.
Result<std::vector<scene::Edit>> organ_edits(scene::Scene const& scene,
                                             std::filesystem::path const& file);

// What to say after that.
std::string said_of_organ(scene::DocumentState const& after);

// One alone, upright on the ground, its upper side towards who looks from the front. Fails, as the
// user's fault, for a file that is none.
Result<Plant> plant_of_organ(std::filesystem::path const& file);

} // namespace tractus::methods
