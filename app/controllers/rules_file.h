#pragma once

#include "app/document/document.h"
#include "engine/base/result.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>

namespace tractus::controllers {

// Models that somebody writes while their plants are drawn on.

// Writes the model of a plant whose rules somebody may write into a new folder, and gives the file
// of the rules. Fails, as the user's fault, for a plant that has none, and where no file can be
// written.
Result<std::filesystem::path> write_rules(scene::PlantState const& plant,
                                          std::filesystem::path const& folder);

// What follows where a model has been saved: the active plant, if it is the model's, is that of its
// new text, with what was drawn on it. Fails, as the user's fault, if it is another one.
Result<document::WantedStep::Change> take_rules(scene::LoadModel const& model,
                                                scene::Scene const& scene);

// The model of the active plant as it is in its files; no value where that has none.
std::optional<scene::LoadModel> model_drawn_on(scene::DocumentState const& state);

} // namespace tractus::controllers
