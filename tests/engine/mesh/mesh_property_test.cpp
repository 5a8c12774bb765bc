#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_plan.h"
#include "tests/engine/mesh/mesh_checks.h"
#include "tests/engine/mesh/random_plants.h"

#include <cstdlib>
#include <rapidcheck/gtest.h>

namespace tractus::mesh {
namespace {

// Fixes the seed of the property tests, unless the environment variable RC_PARAMS sets other
// parameters.
[[maybe_unused]] bool const has_parameters
    = setenv("RC_PARAMS", "seed=1 max_success=60", 0) == 0; // NOLINT(concurrency-mt-unsafe)

rc::Gen<MeshOptions> random_options()
{
    return rc::gen::apply(
        [](int min_sides, int more_sides, int subdivision, bool collar, bool open) {
            return MeshOptions { .min_sides = min_sides,
                                 .max_sides = min_sides + more_sides,
                                 .subdivision = subdivision,
                                 .collar = collar ? 0.45 : 0,
                                 .ends
                                 = open ? MeshOptions::Ends::Open : MeshOptions::Ends::Closed };
        },
        rc::gen::inRange(3, 12), rc::gen::inRange(0, 40), rc::gen::inRange(0, 5),
        rc::gen::arbitrary<bool>(), rc::gen::arbitrary<bool>());
}

bool same_surfaces(Mesh const& a, Mesh const& b)
{
    return a.surfaces.size() == b.surfaces.size()
        && std::equal(a.surfaces.begin(), a.surfaces.end(), b.surfaces.begin(), same_triangles);
}

RC_GTEST_PROP(MeshProperties, IsTheSameOnAnyNumberOfThreads, ())
{
    auto const plant = *random_plants();
    auto const options = *random_options();
    auto const make = [&] { return make_mesh(plant, options); };
    auto const single = on_threads(1, make);
    RC_ASSERT(same_surfaces(single, on_threads(2, make)));
    RC_ASSERT(same_surfaces(single, on_threads(5, make)));
}

RC_GTEST_PROP(MeshProperties, IsSound, ())
{
    auto const mesh = make_mesh(*random_plants(), *random_options());
    for (auto const& surface : mesh.surfaces)
        expect_sound(surface);
    RC_ASSERT(!::testing::Test::HasFailure());
}

// Each piece gets a buffer that is longer than planned, so that writing beyond the plan is
// detected.
RC_GTEST_PROP(MeshProperties, PiecesTakeTheRoomThatThePlanSays, ())
{
    auto const plant = *random_plants();
    auto const options = *random_options();
    auto const mesh = make_mesh(plant, options);
    MeshPlan const plan(plant, options);
    RC_ASSERT(plan.surfaces().size() == mesh.surfaces.size());
    Vec3f const untouched = Vec3f::Constant(-12345);
    constexpr std::uint32_t kUntouched = 0xdeadbeef;
    for (std::size_t s = 0; s < mesh.surfaces.size(); ++s) {
        auto const& surface = plan.surfaces()[s];
        for (std::size_t piece = 0; piece < surface.piece_count(); ++piece) {
            auto const start = surface.start_of(piece);
            auto const extent = surface.extent_of(piece);
            TriangleMesh buffer;
            buffer.positions_mm.assign(extent.vertices + 1, untouched);
            buffer.normals.assign(extent.vertices + 1, untouched);
            buffer.texture_coordinates.assign(extent.vertices + 1, untouched.head<2>());
            buffer.indices.assign(extent.indices + 1, kUntouched);
            auto place = place_in(buffer, {});
            place.vertex = static_cast<std::uint32_t>(start.vertices);
            plan.make_piece(surface, piece, place);

            auto const same = [](auto const& made, auto const& whole, std::size_t from) {
                return std::equal(made.begin(), made.end() - 1,
                                  whole.begin() + static_cast<std::ptrdiff_t>(from));
            };
            RC_ASSERT(same(buffer.positions_mm, mesh.surfaces[s].positions_mm, start.vertices));
            RC_ASSERT(same(buffer.normals, mesh.surfaces[s].normals, start.vertices));
            RC_ASSERT(same(buffer.indices, mesh.surfaces[s].indices, start.indices));
            RC_ASSERT(buffer.positions_mm.back() == untouched);
            RC_ASSERT(buffer.normals.back() == untouched);
            RC_ASSERT(buffer.texture_coordinates.back() == untouched.head<2>());
            RC_ASSERT(buffer.indices.back() == kUntouched);
        }
    }
}

} // namespace
} // namespace tractus::mesh
