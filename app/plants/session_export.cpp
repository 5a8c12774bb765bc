#include "app/plants/session_export.h"

#include "app/plants/model_file.h"
#include "app/plants/session_plant.h"
#include "app/plants/stroke_file.h"
#include "drivers/file.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke_text.h"

#include <array>
#include <fmt/format.h>
#include <iterator>

namespace tractus {

namespace fs = std::filesystem;

namespace {

constexpr char const* kStrokesName = "strokes.txt";

// Writes files into a folder, and keeps their names.
class FolderWriter {
public:
    explicit FolderWriter(fs::path folder)
        : folder_(std::move(folder))
    {
    }

    Result<void> write(fs::path const& name, std::string const& text)
    {
        if (name.empty() || leads_out_of_folder(name))
            return fail(Fault::User,
                        fmt::format("the session's model includes {}, which is outside the model's "
                                    "folder",
                                    name.string()));
        auto const path = folder_ / name;
        TRY(write_file(path, text));
        files.push_back(path);
        return {};
    }

    std::vector<fs::path> files;

private:
    fs::path folder_;
};

// The end of a name that was a path, with another ending.
fs::path file_name(std::string const& path, char const* ending)
{
    auto const stem = fs::path(path).stem();
    bool const is_usable = !stem.empty() && stem != "." && stem != "..";
    return (is_usable ? stem.string() : "model") + ending;
}

Result<void> write_plant(FolderWriter& out, LoadModel const& edit)
{
    TRY(out.write(file_name(edit.source.name, ".l"), edit.source.text));
    if (!edit.source.view_text.empty())
        TRY(out.write(file_name(edit.source.name, ".v"), edit.source.view_text));
    for (auto const& [name, text] : edit.includes)
        TRY(out.write(name, text));
    return {};
}

// Writes what parse_obj_lines() reads: y up, and metres if the whole is small.
Result<void> write_plant(FolderWriter& out, LoadSkeleton const& edit)
{
    constexpr double kSmall = 100;
    Bounds box;
    for (auto const& line : edit.lines) {
        box.add(line.from_mm);
        box.add(line.to_mm);
    }
    bool const is_small = box.empty() || (box.max_mm - box.min_mm).maxCoeff() < kSmall;
    double const unit = is_small ? 1e-3 : 1;
    std::string text = is_small ? "# metres\n" : "# millimetres\n";
    for (auto const& line : edit.lines)
        for (Vec3 const& end : { line.from_mm, line.to_mm })
            fmt::format_to(std::back_inserter(text), "v {} {} {}\n", unit * end.x(), unit * end.z(),
                           -unit * end.y());
    for (std::size_t i = 0; i < edit.lines.size(); ++i)
        fmt::format_to(std::back_inserter(text), "l {} {}\n", 2 * i + 1, 2 * i + 2);
    return out.write(file_name(edit.name, ".obj"), text);
}

// Under its own ending, if that is one of its format's. "strokes.txt" are the strokes.
Result<void> write_plant(FolderWriter& out, LoadMeasured const& edit)
{
    constexpr std::array kEndings { ".mtg", ".csv", ".ply" }; // In the order of the formats.
    auto const usual = kEndings[static_cast<std::size_t>(edit.format)];
    auto const own = file_name(edit.name, ".txt");
    bool const is_text = edit.format == LoadMeasured::Format::Qsm
        && fs::path(edit.name).extension() == ".txt" && own != kStrokesName;
    return out.write(is_text ? own : file_name(edit.name, usual), edit.text);
}

} // namespace

Result<std::vector<fs::path>> export_session(fs::path const& session, fs::path const& folder,
                                             EditKinds kinds)
{
    auto const edits = TRY(session_edits(session, kinds));
    auto const scene = TRY(load_session_scene(session, kinds));
    FolderWriter out(folder);
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        if (auto const* const model = edit->get<LoadModel>())
            TRY(write_plant(out, *model));
        else if (auto const* const skeleton = edit->get<LoadSkeleton>())
            TRY(write_plant(out, *skeleton));
        else if (auto const* const measured = edit->get<LoadMeasured>())
            TRY(write_plant(out, *measured));
        if (edit->kind().loads_plant)
            break;
    }
    if (!scene.associations.empty())
        TRY(out.write(kStrokesName, print_strokes(strokes_of(scene))));
    return std::move(out.files);
}

} // namespace tractus
