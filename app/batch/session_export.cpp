#include "app/batch/session_export.h"

#include "app/batch/session_plant.h"
#include "app/document/model_cost.h"
#include "app/io/model_file.h"
#include "app/io/stroke_file.h"
#include "engine/base/file.h"
#include "engine/plant/mtg.h"
#include "engine/plant/plant_addresses.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke_text.h"

#include <array>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <sstream>

namespace tractus::batch {

namespace fs = std::filesystem;

namespace {

constexpr char const* kStrokesName = "strokes.txt";

// Writes files into a folder and records their names.
class FolderWriter {
public:
    explicit FolderWriter(fs::path folder)
        : folder_(std::move(folder))
        , inner_(folder_)
    {
    }

    // Sets the subfolder for files written after this call.
    void enter(fs::path const& inner) { inner_ = folder_ / inner; }

    Result<void> write(fs::path const& name, std::string const& text)
    {
        if (name.empty() || io::leads_out_of_folder(name))
            return fail(Fault::User,
                        fmt::format("the session's model includes {}, which is outside the model's "
                                    "folder",
                                    name.string()));
        auto const path = inner_ / name;
        TRY(write_file(path, text));
        files.push_back(path);
        return {};
    }

    std::vector<fs::path> files;

private:
    fs::path folder_;
    fs::path inner_;
};

// Returns the last component of a name that may be a path, with its extension replaced.
fs::path file_name(std::string const& path, char const* ending)
{
    auto const stem = fs::path(path).stem();
    bool const is_usable = !stem.empty() && stem != "." && stem != "..";
    return (is_usable ? stem.string() : "model") + ending;
}

Result<void> write_plant(FolderWriter& out, lsystem::ModelSource const& source,
                         std::map<std::string, std::string> const& includes)
{
    TRY(out.write(file_name(source.name, ".l"), source.text));
    if (!source.view_text.empty())
        TRY(out.write(file_name(source.name, ".v"), source.view_text));
    for (auto const& [name, text] : includes)
        TRY(out.write(name, text));
    return {};
}

// Writes a skeleton in the form that parse_obj_lines() reads: y points up; small plants are in
// metres.
Result<void> write_plant(FolderWriter& out, scene::LoadSkeleton const& edit)
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

// Writes a measured plant. It keeps its own extension if that is .txt and the format allows it. The
// name "strokes.txt" is reserved for the strokes.
Result<void> write_plant(FolderWriter& out, scene::LoadMeasured const& edit)
{
    // Default file extensions in the order of LoadMeasured::Format.
    constexpr std::array kEndings { ".mtg", ".csv", ".ply" };
    auto const usual = kEndings[static_cast<std::size_t>(edit.format)];
    auto const own = file_name(edit.name, ".txt");
    bool const is_text = edit.format == scene::LoadMeasured::Format::Qsm
        && fs::path(edit.name).extension() == ".txt" && own != kStrokesName;
    return out.write(is_text ? own : file_name(edit.name, usual), edit.text);
}

// Writes a plant that comes from neither a file nor a model, as a graph of its base plant.
Result<void> write_graph(FolderWriter& out, std::string const& name,
                         scene::PlantSource const& source)
{
    auto const built = TRY(source.build(document::load_options()));
    std::ostringstream text;
    write_mtg(text, built.plant);
    return out.write(file_name(name, ".mtg"), text.str());
}

Result<void> write_source(FolderWriter& out, std::string const& name,
                          scene::PlantSource const& source)
{
    if (auto const* const edit = scene::loaded_model(source))
        return write_plant(out, edit->source, edit->includes);
    if (auto const* const edit = scene::loaded_skeleton(source))
        return write_plant(out, *edit);
    if (auto const* const edit = scene::loaded_measured(source))
        return write_plant(out, *edit);
    if (auto const model = TRY(source.model()))
        return write_plant(out, model->source, model->includes);
    return source.empty() ? Result<void>() : write_graph(out, name, source);
}

// Returns the subfolder for the files of a grafted part, or of a plant other than the first.
fs::path inner_folder(std::string const& name, scene::ItemId id)
{
    return fmt::format("{}-{}", file_name(name, "").string(), scene::name_of(id));
}

// Describes to the user where a plant is placed, or to which plant a part is attached.
std::string describe_place(scene::PlantState const& plant, scene::DocumentState const& state)
{
    auto const& at_mm = plant.stands_at_mm;
    return fmt::format("plant {}: {} at {:.1f}, {:.1f}, {:.1f} mm{}{}\n", scene::name_of(plant.id),
                       fs::path(plant.name).filename().string(), at_mm.x(), at_mm.y(), at_mm.z(),
                       plant.is_hidden ? ", hidden" : "",
                       plant.id == state.active ? ", takes what is drawn" : "");
}

std::string describe_place(scene::Graft const& graft, scene::PlantState const& parent)
{
    return fmt::format("part {}: {} on plant {}\n", scene::name_of(part_of(graft.prefix)),
                       fs::path(graft.name).filename().string(), scene::name_of(parent.id));
}

// Writes each plant and each grafted part. The first plant is written into the folder itself. Each
// other plant or part has a subfolder, as its file names may equal those of the first plant.
Result<void> write_plants(FolderWriter& out, scene::DocumentState const& state)
{
    std::string places;
    for (auto const& plant : state.plants) {
        if (plant != state.plants.front())
            out.enter(inner_folder(plant->name, plant->id));
        TRY(write_source(out, plant->name, plant->source));
        places += describe_place(*plant, state);
        for (auto const& graft : plant->grafts) {
            if (graft.limb) { // A drawn limb has no file of its own.
                places += fmt::format("{} on plant {}\n", graft.name, scene::name_of(plant->id));
                continue;
            }
            out.enter(inner_folder(graft.name, part_of(graft.prefix)));
            TRY(write_source(out, graft.name, graft.source));
            places += describe_place(graft, *plant);
        }
    }
    out.enter("");
    bool const is_one = state.plants.size() == 1 && state.plants.front()->grafts.empty();
    return is_one || state.plants.empty() ? Result<void>() : out.write("plants.txt", places);
}

} // namespace

Result<std::vector<fs::path>> export_session(fs::path const& session, fs::path const& folder,
                                             scene::EditKinds kinds)
{
    auto const scene = TRY(load_session_scene(session, kinds));
    FolderWriter out(folder);
    TRY(write_plants(out, scene.state));
    if (!scene.associations.empty())
        TRY(out.write(kStrokesName, print_strokes(io::strokes_of(scene))));
    return std::move(out.files);
}

} // namespace tractus::batch
