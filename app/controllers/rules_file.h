#pragma once

#include "app/document/document.h"
#include "engine/base/result.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>

namespace tractus::controllers {

// Functions for models that the user edits while drawing on their plants.

// Writes the model of a plant with editable rules into a new folder and returns the file with the
// rules. Fails with a user error if the plant has no such rules or a file cannot be written.
Result<std::filesystem::path> write_rules(scene::PlantState const& plant,
                                          std::filesystem::path const& folder);

// Returns the change to make after the user has saved a model's file: the active plant is derived
// again from the new text, and what was drawn on it is kept. Fails with a user error if the active
// plant does not use this model.
Result<document::StepRequest::Change> take_rules(scene::LoadModel const& model,
                                                 scene::Scene const& scene);

// Returns the active plant's model as its files contain it: those that it was loaded from, or those
// that write_rules() writes. nullopt if it has neither.
std::optional<scene::LoadModel> model_drawn_on(scene::DocumentState const& state);

} // namespace tractus::controllers
