#pragma once

#include "app/batch/collection.h"

#include <filesystem>
#include <ostream>
#include <span>
#include <string>

namespace tractus::batch {

// A plant that was written, and the file that contains it.
struct ManifestPlant {
    PlantPlace place;
    std::string file; // Path of the file, relative to the manifest.
};

// Path of a collection's manifest.
std::filesystem::path manifest_path(CollectionOptions const& options);

// Writes everything needed to recreate each plant, as JSON with one line per plant:
//
//   { "tractus": "0.1.0", "model": …, "drawing": … or null, "seed": 1, "count": 12,
//     "shard": [1, 1], "growth": "usual", "liking": 1,
//     "between_plants_mm": [mean, standard deviation], "from_drawn_mm": [the same],
//     "plants": [{ "number": 1, "age": 1, "position_mm": [x, y, z], "rotation_deg": 0,
//                  "file": … }, …] }
Result<void> write_manifest(std::ostream& out, CollectionOptions const& options,
                            CollectionReport const& report, std::span<ManifestPlant const> plants);

} // namespace tractus::batch
