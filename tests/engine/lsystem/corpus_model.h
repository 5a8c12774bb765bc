#pragma once

#include "engine/lsystem/language/model.h"
#include "tests/file_bytes.h"

#include <filesystem>
#include <string>

namespace tractus::lsystem {

// Compiles the model in the file `path`. Its view is `view`, or if that is empty, the file beside
// the model with the same name.
inline Result<Model> compile_file(std::filesystem::path const& path, std::string const& view = {})
{
    auto const view_path = view.empty() ? std::filesystem::path(path).replace_extension(".v")
                                        : path.parent_path() / view;
    ModelSource source;
    source.name = path.filename().string();
    source.text = file_bytes(path);
    source.view_name = view_path.filename().string();
    source.view_text = file_bytes(view_path);
    return compile_model(source, [&](std::string const& name) -> Result<std::string> {
        if (!std::filesystem::exists(path.parent_path() / name))
            return fail(Fault::User, name + " does not exist");
        return file_bytes(path.parent_path() / name);
    });
}

} // namespace tractus::lsystem
