#include "app/model_file.h"

#include "drivers/file.h"
#include "engine/plant/skeleton_lines.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus {

static constexpr std::size_t kMaxFileSize = std::size_t { 16 } << 20;

Result<ModelSource> load_model_source(std::filesystem::path const& path)
{
    ModelSource source;
    source.name = path.string();
    source.text = TRY(read_file(path, kMaxFileSize));
    auto view_path = path;
    view_path.replace_extension(".v");
    source.view_name = view_path.string();
    std::error_code ignored;
    if (view_path != path && std::filesystem::exists(view_path, ignored))
        source.view_text = TRY(read_file(view_path, kMaxFileSize));
    return source;
}

bool leads_out_of_folder(std::filesystem::path const& name)
{
    return name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end();
}

IncludeReader model_includes(std::filesystem::path const& path)
{
    return [folder = path.parent_path()](std::string const& name) -> Result<std::string> {
        std::filesystem::path const file(name);
        if (leads_out_of_folder(file))
            return fail(Fault::User, fmt::format("{} is outside the model's folder", name));
        return read_file(folder / file, kMaxFileSize);
    };
}

Result<LoadModel> load_model_edit(std::filesystem::path const& path)
{
    LoadModel edit;
    edit.source = TRY(load_model_source(path));
    auto const from_files = model_includes(path);
    // Compiling it is how to learn what it includes.
    auto const record = [&](std::string const& name) -> Result<std::string> {
        auto text = from_files(name);
        if (text)
            edit.includes[name] = *text;
        return text;
    };
    TRY(compile_model(edit.source, record));
    return edit;
}

Result<Edit> load_plant_edit(std::filesystem::path const& path)
{
    if (path.extension() != ".obj") {
        // By way of a name: g++ 14 warns wrongly of what it would destroy otherwise.
        LoadModel model = TRY(load_model_edit(path));
        return model;
    }
    constexpr std::size_t kMaxSkeletonSize = std::size_t { 512 } << 20;
    auto const text = TRY(read_file(path, kMaxSkeletonSize));
    return Edit { LoadSkeleton { path.string(), TRY(parse_obj_lines(path.string(), text)) } };
}

Result<Model> load_model(std::filesystem::path const& path)
{
    auto const source = TRY(load_model_source(path));
    return compile_model(source, model_includes(path));
}

} // namespace tractus
