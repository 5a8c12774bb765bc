#pragma once

#include "app/batch/drawing.h"
#include "app/terminal/progress.h"
#include "engine/base/result.h"
#include "engine/export/glb_writer.h"
#include "engine/mesh/make_mesh.h"
#include "engine/variation/diversity.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::batch {

// A part of a collection that one of several machines makes: number `number`, counted from 1, of
// `parts`. Its plants are the same as in the whole collection.
struct Shard {
    std::size_t number = 1;
    std::size_t parts = 1;
};

// Arrangement of a collection's plants.
enum class Stand {
    Grid,    // Plants stand in a regular grid.
    Scatter, // Randomly displaced from the grid, as if grown naturally, without overlapping places.
};

// Range of ages, above 0 and at most 1; each plant's age is uniformly distributed in it. See
// Grower::grow().
struct AgeRange {
    double youngest = 1;
    double oldest = 1;
};

constexpr std::size_t kMaxDetails = 6;

// Limit for one shard, as places and manifest entries are kept in memory.
constexpr std::size_t kMaxPlantsInShard = 1'000'000;

struct CollectionOptions {
    std::filesystem::path model {};
    scene::EditKinds kinds {};                // Kinds of edits that a session may contain.
    std::optional<DrawingOptions> drawing {}; // Without a drawing plants vary by chance alone.
    GrowthOptions growth {};
    // How far each plant's construction deviates from what was drawn, before growth: arrangement of
    // an outlined tree's branches, angles of a rule, construction lines (SourceVariation::spread).
    double construction = 0;
    // How much plants of one bed differ in addition to their growth.
    variation::Individuality individuality = variation::kPlantsOfOneBed;
    AgeRange ages {};
    std::uint64_t seed = 1;
    std::size_t count = 12; // Plants in all shards together; at least 1.
    Shard shard {};
    Stand stand = Stand::Grid;

    // A .glb file for all plants, each in its place, or a folder for one .glb per plant, each at
    // its own origin.
    std::filesystem::path output {};
    // Image file of a contact sheet (collection_sheet.h); empty: none.
    std::filesystem::path sheet {};
    mesh::MeshOptions mesh {};
    exports::GlbOptions glb {};
    bool has_wind = false; // True if files contain data for animation by wind; glb.wind says where.

    // Number of coarser levels of detail of each plant, 0 to kMaxDetails. Each has half the
    // triangles of the one before (engine/mesh/level_of_detail.h); the last is a billboard.
    std::size_t details = 0;
};

// One plant of a collection; a pure function of the collection's seed and size and of the plant's
// number.
struct PlantPlace {
    std::uint32_t index = 0; // Index of the plant; together with the seed it makes the PlantKey.
    double age = 1;
    Vec3 position_mm = Vec3::Zero(); // Ground frame: origin at the first plant, +z up.
    double rotation_rad = 0;         // Rotation about +z.
};

// Places of a shard's plants. `spacing_mm` is the distance between neighbours; `count` and `shard`
// are taken from the options.
std::vector<PlantPlace> place_plants(CollectionOptions const& options, double spacing_mm);

struct CollectionReport {
    DrawingReport drawing;
    std::size_t plants = 0;      // Plants written in this shard.
    std::size_t segments = 0;    // Segments of one fully grown plant.
    std::uint64_t triangles = 0; // Triangles of all plants.
    std::uint64_t bytes = 0;     // Total size of all .glb files.

    // Distances between at most 64 plants of the whole collection, and from them to the drawn
    // plant.
    variation::DistanceSpread between_plants;
    variation::DistanceSpread from_drawn;
    double height_mm = 0; // Height of the plant as drawn.

    std::filesystem::path manifest;
    std::filesystem::path sheet; // Path of the contact sheet; empty if there is none.
    std::vector<std::string> notes;
};

// Makes a collection and its JSON manifest, which gives each plant's seed, index, age, place and
// file. The manifest is manifest.json in the folder, or FILE.json beside FILE.glb; with several
// shards the name contains the shard's number. The output depends only on the options, not on the
// number of threads. Memory use does not grow with the number of plants. Every file appears
// complete or not at all; if the run is stopped or the disk is full, files written before stay.
// Fails like reading the plant and its drawing, if a file cannot be written, if pictures are wanted
// and the system has no OpenGL, and with a user error if a shard has more than kMaxPlantsInShard
// plants.
Result<CollectionReport> make_collection(CollectionOptions const& options,
                                         terminal::Progress& progress);

// Formats the report for the user.
std::string print_report(CollectionReport const& report);

} // namespace tractus::batch
