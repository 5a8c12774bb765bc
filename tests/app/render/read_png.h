#pragma once

#include "app/render/image.h"

#include <gtest/gtest.h>
#include <png.h>
#include <string>

namespace tractus::render {

// Decodes a PNG file. If that fails, the test fails and the returned picture is empty.
inline Image read_png(std::string const& bytes)
{
    png_image header {};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) {
        ADD_FAILURE() << header.message;
        return {};
    }
    header.format = PNG_FORMAT_RGBA;
    Image picture(static_cast<int>(header.width), static_cast<int>(header.height));
    EXPECT_NE(png_image_finish_read(&header, nullptr, picture.pixels().data(), 0, nullptr), 0)
        << header.message;
    return picture;
}

} // namespace tractus::render
