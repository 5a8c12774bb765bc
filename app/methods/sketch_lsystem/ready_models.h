#pragma once

#include "engine/methods/sketch_lsystem/model_rule.h"

#include <span>
#include <string_view>

namespace tractus::sketch {

// A built-in model that can be grown along a stroke. The texts of its files are compiled into the
// program.
struct ModelTexts {
    std::string_view name; // Name of the model, for example "birch".
    std::string_view rules;
    std::string_view view;
};
std::span<ModelTexts const> model_texts();

// Returns the built-in model with this name, which must exist. Its leaves are plain blades, because
// grown leaves would have to be stored in every edit.
sketch::ModelRule ready_model(std::string_view name);

} // namespace tractus::sketch
