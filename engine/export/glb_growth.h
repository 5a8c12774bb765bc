#pragma once

#include "engine/export/glb_writer.h"
#include "engine/mesh/aged_mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace tractus::exports {

// A plant at successive ages, for an animation of its growth.
struct GrowthFilm {
    std::string name = "plant"; // Name in UTF-8; invalid bytes become replacement characters.
    mesh::AgedMesh const* mesh = nullptr;
    std::vector<double> ages {}; // Ages of the plant, ascending; the last is that of mesh->whole().
    double seconds = 10;         // Duration from the first age to the last; above 0.

    // Returns the plant at an age, suitable for AgedMesh::at(). It is called for each age except
    // the last, in ascending order, and the whole sequence may be repeated. The reference must be
    // valid until the next call.
    std::function<Plant const&(double age)> plant_at {};
    GlbOptions::Textures textures = GlbOptions::Textures::Embedded;
};

// Writes the film as one binary glTF 2.0 file, in metres, +y up. It contains one mesh, the whole
// plant, with a morph target (positions and normals) for each younger age. The targets are named
// "age 0.25" and so on in extras.targetNames. The animation "growth" of the target weights moves
// evenly from age to age. All weights are 0 by default, so programs that do not play animations
// show the whole plant. Leaves are triangles of the mesh, since instances cannot morph. No
// extension is required. The same film always gives the same bytes.
//
// `out` must be binary and seekable; the file begins at its current position. Only two ages of the
// plant are in memory at a time. Fails if the stream fails, a coordinate is not finite, or, before
// anything is written, if the file would exceed glTF's limit of 4 GiB.
Result<GlbSummary> write_glb(std::ostream& out, GrowthFilm const& film);

} // namespace tractus::exports
