#pragma once

#include "app/render/image.h"

#include <gtest/gtest.h>
#include <sstream>
#include <string>

namespace tractus::pictures {

// Returns the bytes of a PNG image of the given size in pixels.
inline std::string small_png(int width = 40, int height = 30)
{
    std::ostringstream out;
    EXPECT_TRUE(render::write_png(out, render::Image(width, height, { 10, 200, 30, 255 })));
    return out.str();
}

} // namespace tractus::pictures
