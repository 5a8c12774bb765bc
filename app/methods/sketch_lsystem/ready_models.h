#pragma once

#include "engine/methods/sketch_lsystem/model_rule.h"

#include <span>
#include <string_view>

namespace tractus::sketch {

// One of our models that can be grown along a stroke, as its files were when the program was built.
struct ModelTexts {
    std::string_view name; // "birch"
    std::string_view rules;
    std::string_view view;
};
std::span<ModelTexts const> model_texts();

// One of them by its name, which must be one. Its leaves are plain blades, not grown ones, which
// would be in each edit.
sketch::ModelRule ready_model(std::string_view name);

} // namespace tractus::sketch
