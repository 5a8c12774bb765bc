#pragma once

#include "app/document/document.h"
#include "engine/base/result.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>

namespace tractus::controllers {

// Models that the user edits while drawing on their plants.

// Writes the model of a plant with editable rules into a new folder and returns the file with the
// rules. Fails with a user error if the plant has no rules or no file can be written.
Result<std::filesystem::path> write_rules(scene::PlantState const& plant,
                                          std::filesystem::path const& folder);

// Returns the change that follows the saving of a model's file: the active plant is derived again
// from the new text, keeping what was drawn on it. Fails with a user error if the active plant does
// not use this model.
Result<document::StepRequest::Change> take_rules(scene::LoadModel const& model,
                                                 scene::Scene const& scene);

// The active plant's model as its files contain it; nullopt if it has no files.
std::optional<scene::LoadModel> model_drawn_on(scene::DocumentState const& state);

} // namespace tractus::controllers
