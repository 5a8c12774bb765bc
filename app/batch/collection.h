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

// A part of a collection, so that many machines make it together: the `number`-th of `parts`, the
// first is 1. Plant for plant it is what the whole collection has there.
struct Shard {
    std::size_t number = 1;
    std::size_t parts = 1;
};

// How the plants of a collection stand.
enum class Stand {
    Grid,    // In rows.
    Scatter, // Out of line, as if they had grown there; none within another's place.
};

// Ages, above 0 and at most 1, from the youngest to the oldest; each plant's is drawn evenly from
// between. See Grower::grow().
struct AgeRange {
    double youngest = 1;
    double oldest = 1;
};

constexpr std::size_t kMostDetails = 6;

// Plants in one shard: their places and what the manifest says of them are kept in memory.
constexpr std::size_t kMostPlantsInShard = 1'000'000;

struct CollectionOptions {
    std::filesystem::path model {};
    scene::EditKinds kinds {};                // Kinds of its edits, if it is a session.
    std::optional<DrawingOptions> drawing {}; // If there is none, plants vary by chance alone.
    GrowthOptions growth {};
    // How much each plant is another one than what was drawn before it grows: the arrangement of an
    // outlined tree's branches, the angles of a rule, construction lines (SourceVariation::spread).
    double construction = 0;
    // How much plants of one bed differ beside their growth.
    variation::Individuality individuality { .branches = 0.08, .size = 0.12, .turn = 1 };
    AgeRange ages {};
    std::uint64_t seed = 1;
    std::size_t count = 12; // Plants in all shards together; at least 1.
    Shard shard {};
    Stand stand = Stand::Grid;

    // A .glb for all plants, each in its place, or a folder for one .glb per plant, each at its own
    // origin.
    std::filesystem::path output {};
    // A picture of small pictures (collection_sheet.h); none if it is empty.
    std::filesystem::path sheet {};
    mesh::MeshOptions mesh {};
    exports::GlbOptions glb {};
    bool has_wind = false; // Whether files have what the wind needs; glb.wind says where.

    // Coarser levels that each plant has beside itself, each of half the triangles of the one
    // before (engine/mesh/level_of_detail.h); the last one is a billboard. 0 to kMostDetails.
    std::size_t details = 0;
};

// One plant of a collection. A pure function of the collection's seed, size and the plant's number.
struct PlantPlace {
    std::uint32_t index = 0; // Makes its PlantKey, together with the seed.
    double age = 1;
    Vec3 position_mm = Vec3::Zero(); // Ground frame: where the first plant stands, +z up.
    double rotation_rad = 0;         // About +z.
};

// The places of a shard's plants. `spacing_mm` is how far apart they stand, `count` and `shard` as
// in CollectionOptions.
std::vector<PlantPlace> place_plants(CollectionOptions const& options, double spacing_mm);

struct CollectionReport {
    DrawingReport drawing;
    std::size_t plants = 0;      // Written: of this shard.
    std::size_t segments = 0;    // Segments of one full-grown plant.
    std::uint64_t triangles = 0; // Triangles of all plants.
    std::uint64_t bytes = 0;     // Bytes of all .glb files.

    // Distances of at most 64 plants of the whole collection, full-grown.
    variation::DistanceSpread between_plants;
    variation::DistanceSpread from_drawn;
    double height_mm = 0; // Height of the plant as drawn.

    std::filesystem::path manifest;
    std::filesystem::path sheet; // Empty if there is none.
    std::vector<std::string> notes;
};

// Makes a collection, and a manifest in JSON that says of each plant by which seed, index and age
// it was grown, where it stands, and in which file it is: manifest.json in the folder, or FILE.json
// beside FILE.glb; with the shard's number where there are several.
//
// The bytes depend on the options alone, not on the number of threads. Memory holds a few plants,
// whatever their number. Every file appears whole or not at all: when it is stopped or the disk is
// full, what was written before stays. Fails as reading the plant and its drawing does, where a
// file cannot be written, where pictures are wanted and the system has no OpenGL, and, as the
// user's fault, where a shard has more than kMostPlantsInShard.
Result<CollectionReport> make_collection(CollectionOptions const& options,
                                         terminal::Progress& progress);

// The report as lines for a person to read.
std::string print_report(CollectionReport const& report);

} // namespace tractus::batch
