#pragma once

#include "app/batch/collection_sheet.h"
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

// One of `parts` parts of a collection, so that several machines can make the collection together.
// `number` counts from 1. A plant is the same whether or not its collection is divided.
struct Shard {
    std::size_t number = 1;
    std::size_t parts = 1;
};

// Arrangement of a collection's plants.
enum class Stand {
    Grid, // Plants stand in a regular grid.
    // Plants are displaced randomly from the grid, as if grown naturally. Each stays in its own
    // cell of the grid.
    Scatter,
};

// Range of plant ages, above 0 and at most 1 (fully grown; see Grower::grow()). Each plant's age is
// drawn uniformly from this range.
struct AgeRange {
    double youngest = 1;
    double oldest = 1;
};

constexpr std::size_t kMaxDetails = 6;

// Maximum number of plants in a shard. Their places and manifest entries are kept in memory.
constexpr std::size_t kMaxPlantsInShard = 1'000'000;

struct CollectionOptions {
    std::filesystem::path model {};
    scene::EditKinds kinds {}; // Kinds of edits accepted if `model` is a session.
    // Recorded drawing on the plant. No value: plants vary only by chance.
    std::optional<DrawingOptions> drawing {};
    GrowthOptions growth {};
    // How far each plant's construction deviates from what was drawn (SourceVariation::spread): the
    // arrangement of an outlined tree's branches, the angles of a rule, or construction lines. This
    // is applied before growth.
    double construction = 0;
    // Individual differences between the plants, in addition to differences in growth.
    variation::Individuality individuality = variation::kPlantsOfOneBed;
    AgeRange ages {};
    std::uint64_t seed = 1;
    std::size_t count = 12; // Plants in all shards together; at least 1.
    Shard shard {};
    Stand stand = Stand::Grid;

    // Either a .glb or .html file for all plants, each in its place, or a folder for one .glb file
    // per plant, each plant at its own origin.
    std::filesystem::path output {};
    // Image file of a contact sheet (collection_sheet.h); empty: none.
    std::filesystem::path sheet {};
    PictureSize sheet_tile = kSheetTile;        // Size of each small picture on the contact sheet.
    mesh::MeshOptions mesh { .max_sides = 10 }; // Few, as collections are large files.
    // MeshOptions::organ_error_mm as a share of the drawn plant's height: by default less than a
    // pixel in a picture of the whole plant that is 1500 pixels high.
    double organ_error = 0.0005;
    exports::GlbOptions glb {};
    // True: files contain data for animation by wind, stored as glb.wind says.
    bool has_wind = false;

    // Number of coarser levels of detail of each plant, 0 to kMaxDetails. Each has half the
    // triangles of the one before (engine/mesh/level_of_detail.h); the last is a billboard.
    std::size_t details = 0;
};

// True if all plants go into one file: a .glb file, or a page (plant_page.h).
bool is_one_file(CollectionOptions const& options);

// Place and age of one plant of a collection. They depend only on the plant's index, the spacing
// and the collection's options.
struct PlantPlace {
    std::uint32_t index = 0; // Index of the plant; together with the seed it makes the PlantKey.
    double age = 1;
    Vec3 position_mm = Vec3::Zero(); // Ground frame: origin at the first plant, +z up.
    double rotation_rad = 0;         // Rotation about +z.
};

// Returns the places of the plants of `options.shard`. `spacing_mm` is the distance between
// neighbouring plants.
std::vector<PlantPlace> place_plants(CollectionOptions const& options, double spacing_mm);

struct CollectionReport {
    DrawingReport drawing;
    std::size_t plants = 0;      // Number of plants written in this shard.
    std::size_t segments = 0;    // Number of segments of one fully grown plant.
    std::uint64_t triangles = 0; // Number of triangles of all plants written in this shard.
    std::uint64_t bytes = 0;     // Total size of all .glb files.

    // Distances (variation::Diversity) between pairs of plants, for at most 64 plants of the whole
    // collection, and between these plants and the plant as drawn.
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
// complete or not at all; if the run is stopped or the disk is full, files that were completed
// before remain. Fails like load_growing_plant() and read_drawing(), if a file cannot be written,
// if pictures are requested and the system has no OpenGL, and with a user error if a shard has more
// than kMaxPlantsInShard plants.
Result<CollectionReport> make_collection(CollectionOptions const& options,
                                         terminal::Progress& progress);

// Formats the report for the user.
std::string print_report(CollectionReport const& report);

} // namespace tractus::batch
