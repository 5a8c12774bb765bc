#include "app/io/model_file.h"

#include "app/io/measured_file.h"
#include "app/methods/all_inputs.h"
#include "app/terminal/error_text.h"
#include "engine/base/file.h"
#include "engine/export/glb_lines.h"
#include "engine/lsystem/notations/book_text.h"
#include "engine/lsystem/notations/foreign_text.h"
#include "engine/lsystem/view/color_files.h"
#include "engine/lsystem/view/environment_choice.h"
#include "engine/plant/skeleton_lines.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::io {

static constexpr std::size_t kMaxFileSize = std::size_t { 16 } << 20;

// Returns the files with this extension in the model's folder, sorted by name.
static std::vector<std::filesystem::path> files_beside(std::filesystem::path const& path,
                                                       std::string const& ending)
{
    std::error_code ignored;
    std::vector<std::filesystem::path> files;
    auto const folder = path.has_parent_path() ? path.parent_path() : ".";
    for (auto const& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().extension() == ending && entry.is_regular_file(ignored))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// True if the file is a model. Models contain "Lsystem:"; other files with the same extension, such
// as control panels, do not. An unreadable file counts as a model.
static bool is_model(std::filesystem::path const& path)
{
    auto text = read_text_file(path, kMaxFileSize);
    if (!text)
        return true;
    std::transform(text->begin(), text->end(), text->begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text->find("lsystem:") != std::string::npos;
}

// Returns the file with the model's name and this extension. If it is missing, returns the only
// file with the extension, unless the folder contains another model.
static std::optional<std::filesystem::path> find_beside(std::filesystem::path const& path,
                                                        std::string const& ending)
{
    auto beside = path;
    beside.replace_extension(ending);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(beside, ignored))
        return beside;
    auto const files = files_beside(path, ending);
    auto const models = files_beside(path, path.extension());
    bool const is_alone = std::count_if(models.begin(), models.end(), is_model) == 1;
    return files.size() == 1 && is_alone ? std::optional(files.front()) : std::nullopt;
}

// Returns the path of the view file, if there is one.
static std::optional<std::filesystem::path> view_of(std::filesystem::path const& path,
                                                    ModelCompanions const& companions)
{
    if (!companions.view.empty())
        return companions.view;
    auto beside = path;
    beside.replace_extension(".v");
    std::error_code ignored;
    if (beside == path || !std::filesystem::exists(beside, ignored))
        return std::nullopt;
    return beside;
}

// Returns the path of the colour file with this extension, if there is one.
static std::optional<std::filesystem::path> colors_of(std::filesystem::path const& path,
                                                      ModelCompanions const& companions,
                                                      std::string const& ending)
{
    if (companions.colors.empty())
        return find_beside(path, ending);
    return companions.colors.extension() == ending ? std::optional(companions.colors)
                                                   : std::nullopt;
}

// Appends the contents of a colour file, if there is one, to the view as statements.
static Result<void> add_colors(std::optional<std::filesystem::path> const& file,
                               Result<std::string> (*statements)(std::string const& name,
                                                                 std::string_view bytes),
                               std::string& view_text)
{
    if (!file)
        return {};
    auto const bytes = TRY(read_file(*file, kMaxFileSize));
    view_text += '\n' + TRY(statements(file->string(), bytes));
    return {};
}

// Reads a text that should be a model. Fails if it is in another program's language.
static Result<std::string> read_rules(std::filesystem::path const& path)
{
    auto text = TRY(read_text_file(path, kMaxFileSize));
    if (auto const foreign = lsystem::find_foreign_notation(text))
        return fail(Fault::User, lsystem::describe_foreign_text(path.string(), *foreign));
    return text;
}

Result<lsystem::ModelSource> load_model_source(std::filesystem::path const& path,
                                               ModelCompanions const& companions)
{
    lsystem::ModelSource source;
    source.name = path.string();
    source.text = TRY(read_rules(path));
    auto view_path = path;
    view_path.replace_extension(".v");
    source.view_name = view_path.string();
    if (auto const view = view_of(path, companions)) {
        source.view_name = view->string();
        source.view_text = TRY(read_text_file(*view, kMaxFileSize));
    }
    if (companions.dialect == kBookDialect) {
        auto book = lsystem::read_book_model(source.text);
        source.text = std::move(book.text);
        source.view_text += '\n' + book.view;
    }
    auto const& colors = companions.colors;
    if (!colors.empty() && colors.extension() != ".mat" && colors.extension() != ".map")
        return fail(Fault::User,
                    fmt::format("{}: colours are in .mat or .map files", colors.string()));
    // Colours are applied as on cpfg's command line: the first definition of a colour counts, so
    // materials come first.
    TRY(add_colors(colors_of(path, companions, ".mat"), lsystem::material_file_statements,
                   source.view_text));
    TRY(add_colors(colors_of(path, companions, ".map"), lsystem::color_map_statements,
                   source.view_text));
    if (!companions.environment.empty()) {
        TRY(lsystem::parse_environment(companions.environment));
        source.view_text += "\nenvironment: " + companions.environment + '\n';
    }
    return source;
}

// Lists view and colour files beside the model that the model does not use, one sentence each.
static std::vector<std::string> unused_companions(std::filesystem::path const& path,
                                                  ModelCompanions const& companions)
{
    std::vector<std::string> result;
    auto const note = [&](std::string const& ending,
                          std::optional<std::filesystem::path> const& used, char const* option) {
        for (auto const& file : files_beside(path, ending)) {
            auto model = file;
            std::error_code ignored;
            if (used && std::filesystem::equivalent(file, *used, ignored))
                continue;
            if (std::filesystem::exists(model.replace_extension(path.extension()), ignored))
                continue; // The file belongs to another model.
            result.push_back(fmt::format("{} is not used, since its name is not the model's; "
                                         "{} {} uses it",
                                         file.string(), option, file.string()));
        }
    };
    if (companions.view.empty())
        note(".v", view_of(path, companions), "--view");
    // The user has chosen colours, so unused colour files are not listed.
    if (!companions.colors.empty())
        return result;
    note(".mat", colors_of(path, companions, ".mat"), "--colors");
    note(".map", colors_of(path, companions, ".map"), "--colors");
    return result;
}

std::vector<std::string> warnings_of_unused_companions(std::filesystem::path const& path,
                                                       ModelCompanions const& companions)
{
    constexpr std::size_t kMaxListedNames = 3;
    auto unused = unused_companions(path, companions);
    if (unused.size() > kMaxListedNames) {
        auto const more = unused.size() - kMaxListedNames;
        unused.resize(kMaxListedNames);
        unused.push_back(fmt::format("{} more views and colour files beside {} are not used", more,
                                     path.string()));
    }
    return unused;
}

void warn_of_unused_companions(std::filesystem::path const& path, ModelCompanions const& companions)
{
    for (auto const& warning : warnings_of_unused_companions(path, companions))
        terminal::print_warning(warning);
}

bool leads_out_of_folder(std::filesystem::path const& name)
{
    return name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end();
}

lsystem::IncludeReader model_includes(std::filesystem::path const& path)
{
    return [folder = path.parent_path()](std::string const& name) -> Result<std::string> {
        std::filesystem::path const file(name);
        if (leads_out_of_folder(file))
            return fail(Fault::User, fmt::format("{} is outside the model's folder", name));
        std::error_code ignored;
        if (!std::filesystem::exists(folder / file, ignored))
            if (auto made = TRY(methods::make_input(folder, name)))
                return std::move(*made);
        return read_text_file(folder / file, kMaxFileSize);
    };
}

Result<scene::LoadModel> load_model_edit(std::filesystem::path const& path,
                                         ModelCompanions const& companions)
{
    scene::LoadModel edit;
    edit.source = TRY(load_model_source(path, companions));
    auto const from_files = model_includes(path);
    // Compiles the model, to record the files that it includes.
    auto const record = [&](std::string const& name) -> Result<std::string> {
        auto text = from_files(name);
        if (text)
            edit.includes[name] = *text;
        return text;
    };
    TRY(lsystem::compile_model(edit.source, record));
    return edit;
}

// Reads the lines of a skeleton in the format of the file's extension. Empty for other extensions.
static Result<std::vector<SkeletonPiece>> load_lines(std::filesystem::path const& path)
{
    constexpr std::size_t kMaxSkeletonSize = std::size_t { 512 } << 20;
    if (path.extension() == ".obj")
        return parse_obj_lines(path.string(), TRY(read_text_file(path, kMaxSkeletonSize)));
    if (path.extension() == ".glb")
        return exports::read_glb_lines(path.string(), TRY(read_file(path, kMaxSkeletonSize)));
    if (path.extension() == ".gltf")
        return fail(Fault::User,
                    fmt::format("{}: glTF files are read in their binary form: export it as .glb",
                                path.string()));
    return std::vector<SkeletonPiece>();
}

Result<scene::Edit> load_plant_quietly(std::filesystem::path const& path,
                                       ModelCompanions const& companions)
{
    auto lines = TRY(load_lines(path));
    if (!lines.empty())
        return scene::LoadSkeleton { path.string(), std::move(lines) };
    if (path.extension() == ".txt") // Measured plants can have this extension, too.
        TRY(read_rules(path));
    auto measured = TRY(load_measured_edit(path));
    if (measured)
        return *std::move(measured);
    // A variable, as g++ 14 issues a false warning about the destruction of a temporary.
    scene::LoadModel model = TRY(load_model_edit(path, companions));
    return model;
}

Result<scene::Edit> load_plant_edit(std::filesystem::path const& path,
                                    ModelCompanions const& companions)
{
    auto edit = TRY(load_plant_quietly(path, companions));
    if (edit.get<scene::LoadModel>())
        warn_of_unused_companions(path, companions);
    return edit;
}

Result<lsystem::Model> load_model(std::filesystem::path const& path,
                                  ModelCompanions const& companions)
{
    auto const source = TRY(load_model_source(path, companions));
    return lsystem::compile_model(source, model_includes(path));
}

} // namespace tractus::io
