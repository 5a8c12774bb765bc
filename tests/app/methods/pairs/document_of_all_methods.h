#pragma once

#include "app/batch/plant_group.h"
#include "app/methods/all_methods.h"
#include "engine/export/glb_writer.h"
#include "engine/mesh/make_mesh.h"
#include "tests/app/session/small_session.h"

#include <gtest/gtest.h>
#include <sstream>
#include <string>

namespace tractus::methods {

inline session::SessionOptions options_for_all_methods()
{
    auto options = session::options_for_tests();
    options.kinds = all_methods().edits;
    return options;
}

// Returns all visible plants of a scene as the bytes of a .glb file.
inline std::string exported(scene::Scene const& scene)
{
    auto const mesh = mesh::make_mesh(batch::shown_plants(scene).value());
    std::ostringstream out;
    exports::PlacedMesh placed;
    placed.mesh = &mesh;
    EXPECT_TRUE(exports::write_glb(out, std::span(&placed, 1)));
    return out.str();
}

} // namespace tractus::methods
