#include "app/batch/collection_manifest.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace tractus::batch {

// Formats a value as one line of JSON. File names may contain any bytes; invalid UTF-8 becomes a
// replacement character.
static std::string line(nlohmann::ordered_json const& value)
{
    return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool is_one_file(CollectionOptions const& options)
{
    auto const ending = options.output.extension();
    return ending == ".glb" || ending == ".html";
}

std::filesystem::path manifest_path(CollectionOptions const& options)
{
    auto const [number, parts] = options.shard;
    auto const shard = parts > 1 ? fmt::format("-{}-of-{}", number, parts) : "";
    if (!is_one_file(options))
        return options.output / fmt::format("manifest{}.json", shard);
    return options.output.parent_path()
        / fmt::format("{}{}.json", options.output.stem().string(), shard);
}

Result<void> write_manifest(std::ostream& out, CollectionOptions const& options,
                            CollectionReport const& report, std::span<ManifestPlant const> plants)
{
    auto const spread = [](variation::DistanceSpread const& of) {
        return nlohmann::ordered_json { of.mean_mm, of.deviation_mm };
    };
    nlohmann::ordered_json head {
        { "tractus", TRACTUS_VERSION },
        { "model", options.model.filename().string() },
        { "drawing", nullptr },
        { "seed", options.seed },
        { "count", options.count },
        { "shard", { options.shard.number, options.shard.parts } },
        { "growth", growth_name(options.model, options.growth) },
        { "liking", options.growth.variability },
        { "between_plants_mm", spread(report.between_plants) },
        { "from_drawn_mm", spread(report.from_drawn) },
    };
    if (options.drawing)
        head["drawing"] = options.drawing->log.filename().string();
    head["individuality"] = {
        { "branches", options.individuality.branches }, { "size", options.individuality.size },
        { "turn", options.individuality.turn },         { "age", options.individuality.age },
        { "organs", options.individuality.organs },     { "seeds", options.individuality.seeds }
    };
    if (options.construction > 0)
        head["construction"] = options.construction;
    if (auto const& season = options.growth.season)
        head["season"] = { { "month", season->month }, { "fallen", season->fallen } };
    auto text = line(head);
    // Removes the closing brace, as the list of plants follows inside the same object.
    text.pop_back();
    out << text << ",\n\"plants\": [";
    char const* separator = "\n";
    for (auto const& [place, file] : plants) {
        auto const& at = place.position_mm;
        out << separator
            << line({ { "number", place.index + 1 },
                      { "age", place.age },
                      { "position_mm", { at.x(), at.y(), at.z() } },
                      { "rotation_deg", place.rotation_rad * 180 / std::numbers::pi },
                      { "file", file } });
        separator = ",\n";
    }
    out << "\n]}\n";
    return {};
}

} // namespace tractus::batch
