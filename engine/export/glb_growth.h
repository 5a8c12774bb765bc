#pragma once

#include "engine/export/glb_writer.h"
#include "engine/mesh/aged_mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace tractus::exports {

// A plant as it grows.
struct GrowthFilm {
    std::string name = "plant"; // UTF-8; what is not becomes a replacement character.
    mesh::AgedMesh const* mesh = nullptr;
    std::vector<double> ages {}; // Ascending, and the last is that of mesh->whole().
    double seconds = 10;         // Time from the first age to the last; above 0.

    // The plant at an age, as AgedMesh::at() takes it. Called for each age but the last, in order,
    // and perhaps again; what it answers need only hold until the next call.
    std::function<Plant const&(double age)> plant_at {};
    GlbOptions::Textures textures = GlbOptions::Textures::Embedded;
};

// Writes it as one binary glTF 2.0 file, in metres, +y up: one mesh, the whole plant, with a morph
// target for each younger age (positions and normals; "age 0.25" and so on in extras.targetNames),
// and an animation "growth" of its weights that goes evenly from age to age. All weights are 0 by
// default: programs that do not play it show the whole plant. Leaves are triangles of the mesh,
// since instances do not move. No extension is needed. Same input, same bytes.
//
// `out` as for write_glb(). Memory holds two ages of the plant, however many there are. Fails if
// the stream fails, if a coordinate is not finite, and, before anything is written, if the file
// would pass glTF's limit of 4 GiB.
Result<GlbSummary> write_glb(std::ostream& out, GrowthFilm const& film);

} // namespace tractus::exports
