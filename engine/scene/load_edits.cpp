#include "engine/scene/edit_words.h"
#include "engine/scene/lsystem_source.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/scene/measured_source.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/core.h>
#include <utility>

namespace tractus::scene {

namespace {

// Words for Drawn and LoadMeasured::Format in sessions, in the order of the enumerations.
constexpr std::array kDrawn { "forget", "keep", "beside" };
constexpr std::array kMeasuredFormats { "mtg", "qsm", "ply" };

std::string file_name(std::string const& path)
{
    return std::filesystem::path(path).filename().string();
}

char const* describe_drawn(Drawn drawn)
{
    static constexpr std::array kWords { "", ", and keeps what was drawn",
                                         ", beside what is there" };
    return kWords[static_cast<std::size_t>(drawn)];
}

// Lists the fields that only an added plant has. In a session they follow the field "drawn".
template<typename T> void list_plant(Fields& fields, T& edit)
{
    if (edit.drawn != Drawn::Beside)
        return;
    fields.field("stands_at_mm", &edit.stands_at_mm);
    fields.id(edit.id);
}

template<typename T>
NewSource new_source(T const& edit, std::string const& name, SourceKind const& kind)
{
    return { .name = name,
             .source = PlantSource(kind, edit),
             .drawn = edit.drawn,
             .stands_at_mm = edit.stands_at_mm,
             .id = edit.id };
}

void list(Fields& fields, LoadModel& edit)
{
    fields.field("name", &edit.source.name);
    fields.field("text", &edit.source.text);
    fields.field("view_name", &edit.source.view_name);
    fields.field("view_text", &edit.source.view_text);
    fields.field("includes", &edit.includes);
    fields.field("steps", &edit.steps);
    fields.field("seed", &edit.seed);
    fields.word("drawn", edit.drawn, kDrawn);
    list_plant(fields, edit);
}

constexpr SourceKind kLSystem = make_source_kind<LoadModel, build_lsystem>("lsystem");

Result<DocumentState> applied(DocumentState state, LoadModel const& edit, SceneBuilder&)
{
    return with_source(std::move(state), new_source(edit, edit.source.name, kLSystem));
}

std::string described(LoadModel const& edit)
{
    auto text = fmt::format("takes the model {}: {} of rules", file_name(edit.source.name),
                            counted(edit.source.text.size(), "byte"));
    if (!edit.includes.empty())
        text += fmt::format(", {}", counted(edit.includes.size(), "more file"));
    if (edit.steps)
        text += fmt::format(
            ", {}", counted(static_cast<std::size_t>(std::max(*edit.steps, 0)), "derivation step"));
    return fmt::format("{}, seed {}{}", text, edit.seed, describe_drawn(edit.drawn));
}

void list(Fields& fields, LoadSkeleton& edit)
{
    fields.field("name", &edit.name);
    fields.word("drawn", edit.drawn, kDrawn);
    list_plant(fields, edit);
    fields.numbers(edit.lines);
}

Result<BuiltSource> build_skeleton(LoadSkeleton const& edit, LoadOptions const&)
{
    return BuiltSource { TRY(plant_from_lines(edit.name, edit.lines)) };
}

constexpr SourceKind kLines = make_source_kind<LoadSkeleton, build_skeleton>("lines");

Result<DocumentState> applied(DocumentState state, LoadSkeleton const& edit, SceneBuilder&)
{
    return with_source(std::move(state), new_source(edit, edit.name, kLines));
}

std::string described(LoadSkeleton const& edit)
{
    return fmt::format("takes the skeleton {}: {}{}", file_name(edit.name),
                       counted(edit.lines.size(), "line"), describe_drawn(edit.drawn));
}

void list(Fields& fields, LoadMeasured& edit)
{
    fields.field("name", &edit.name);
    fields.field("text", &edit.text);
    fields.word("format", edit.format, kMeasuredFormats);
    fields.word("drawn", edit.drawn, kDrawn);
    list_plant(fields, edit);
}

constexpr SourceKind kMeasured = make_source_kind<LoadMeasured, build_measured>("measured");

Result<DocumentState> applied(DocumentState state, LoadMeasured const& edit, SceneBuilder&)
{
    return with_source(std::move(state), new_source(edit, edit.name, kMeasured));
}

std::string described(LoadMeasured const& edit)
{
    static constexpr std::array kWhat { "a graph", "cylinders", "a skeleton" };
    return fmt::format("takes the measured plant {}: {} of {}{}", file_name(edit.name),
                       counted(edit.text.size(), "byte"),
                       kWhat[static_cast<std::size_t>(edit.format)], describe_drawn(edit.drawn));
}

} // namespace

std::optional<PlantSource> with_model_seed(PlantSource const& source, std::uint64_t seed)
{
    auto const* const loaded = source.get<LoadModel>(kLSystem);
    if (!loaded)
        return std::nullopt;
    auto other = *loaded;
    other.seed = seed;
    return PlantSource(kLSystem, std::move(other));
}

LoadModel const* loaded_model(PlantSource const& source)
{
    return source.get<LoadModel>(kLSystem);
}

LoadSkeleton const* loaded_skeleton(PlantSource const& source)
{
    return source.get<LoadSkeleton>(kLines);
}

LoadMeasured const* loaded_measured(PlantSource const& source)
{
    return source.get<LoadMeasured>(kMeasured);
}

constexpr EditKind LoadModel::kKind
    = make_edit_kind<LoadModel, list, applied, described>("load_model", true);

constexpr EditKind LoadSkeleton::kKind
    = make_edit_kind<LoadSkeleton, list, applied, described>("load_skeleton", true);

constexpr EditKind LoadMeasured::kKind
    = make_edit_kind<LoadMeasured, list, applied, described>("load_measured", true);

} // namespace tractus::scene
