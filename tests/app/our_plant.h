#pragma once

#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "engine/scene/scene.h"

#include <string_view>

namespace tractus {

// Returns a scene with one plant, grown from a model that comes with the program, such as "birch".
inline scene::Scene our_plant(std::string_view name)
{
    return scene::apply_edit({}, io::load_model_edit(files::find_model(name).value()).value())
        .value();
}

} // namespace tractus
