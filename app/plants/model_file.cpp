#include "app/plants/model_file.h"

#include "drivers/file.h"
#include "engine/export/glb_lines.h"
#include "engine/lsystem/color_files.h"
#include "engine/plant/skeleton_lines.h"

#include <algorithm>
#include <fmt/core.h>
#include <optional>
#include <string>
#include <utility>

namespace tractus {

static constexpr std::size_t kMaxFileSize = std::size_t { 16 } << 20;

// The only file with this ending in a folder.
static std::optional<std::filesystem::path> only_file(std::filesystem::path const& folder,
                                                      std::string const& ending)
{
    std::error_code ignored;
    std::optional<std::filesystem::path> only;
    for (auto const& entry : std::filesystem::directory_iterator(folder, ignored)) {
        if (entry.path().extension() != ending || !entry.is_regular_file(ignored))
            continue;
        if (only)
            return std::nullopt;
        only = entry.path();
    }
    return only;
}

// The file beside the model with its name and this ending; where there is none, the only one with
// the ending in a folder that is this model's alone.
static std::optional<std::filesystem::path> find_beside(std::filesystem::path const& path,
                                                        std::string const& ending)
{
    auto beside = path;
    beside.replace_extension(ending);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(beside, ignored))
        return beside;
    auto const folder = path.has_parent_path() ? path.parent_path() : ".";
    return only_file(folder, path.extension()) ? only_file(folder, ending) : std::nullopt;
}

// Appends what a file of colours beside the model says, if there is one, to the view.
static Result<void> add_colors(std::filesystem::path const& path, std::string const& ending,
                               Result<std::string> (*statements)(std::string const& name,
                                                                 std::string_view bytes),
                               std::string& view_text)
{
    auto const file = find_beside(path, ending);
    if (!file)
        return {};
    auto const bytes = TRY(read_file(*file, kMaxFileSize));
    view_text += '\n' + TRY(statements(file->string(), bytes));
    return {};
}

Result<ModelSource> load_model_source(std::filesystem::path const& path)
{
    ModelSource source;
    source.name = path.string();
    source.text = TRY(read_text_file(path, kMaxFileSize));
    auto view_path = path;
    view_path.replace_extension(".v");
    source.view_name = view_path.string();
    std::error_code ignored;
    if (view_path != path && std::filesystem::exists(view_path, ignored))
        source.view_text = TRY(read_text_file(view_path, kMaxFileSize));
    // What cpfg is given on its command line. The first that names a colour counts: materials.
    TRY(add_colors(path, ".mat", material_file_statements, source.view_text));
    TRY(add_colors(path, ".map", color_map_statements, source.view_text));
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
        return read_text_file(folder / file, kMaxFileSize);
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

// The lines of a file, by its name's ending; empty for one that has none.
static Result<std::vector<SkeletonPiece>> load_lines(std::filesystem::path const& path)
{
    constexpr std::size_t kMaxSkeletonSize = std::size_t { 512 } << 20;
    if (path.extension() == ".obj")
        return parse_obj_lines(path.string(), TRY(read_text_file(path, kMaxSkeletonSize)));
    if (path.extension() == ".glb")
        return read_glb_lines(path.string(), TRY(read_file(path, kMaxSkeletonSize)));
    if (path.extension() == ".gltf")
        return fail(Fault::User,
                    fmt::format("{}: glTF files are read in their binary form: export it as .glb",
                                path.string()));
    return std::vector<SkeletonPiece>();
}

Result<Edit> load_plant_edit(std::filesystem::path const& path)
{
    auto lines = TRY(load_lines(path));
    if (!lines.empty())
        return LoadSkeleton { path.string(), std::move(lines) };
    // By way of a name: g++ 14 warns wrongly of what it would destroy otherwise.
    LoadModel model = TRY(load_model_edit(path));
    return model;
}

Result<Model> load_model(std::filesystem::path const& path)
{
    auto const source = TRY(load_model_source(path));
    return compile_model(source, model_includes(path));
}

} // namespace tractus
