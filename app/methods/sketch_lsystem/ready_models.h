#pragma once

#include "engine/methods/sketch_lsystem/model_rule.h"

#include <span>
#include <string_view>

namespace tractus::sketch {

// A built-in model that can be grown along a stroke; its files were compiled into the program.
struct ModelTexts {
    std::string_view name; // For example "birch".
    std::string_view rules;
    std::string_view view;
};
std::span<ModelTexts const> model_texts();

// The built-in model with this name, which must exist. Its leaves are plain blades, because grown
// leaves would be stored in every edit.
sketch::ModelRule ready_model(std::string_view name);

} // namespace tractus::sketch
