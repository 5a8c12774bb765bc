#include "engine/lsystem/view/view_texture.h"

#include "engine/lsystem/view/view.h"
#include "engine/plant/png_pixels.h"

#include <array>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus::lsystem {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

// Returns a PNG file with a single column of pixels, from the top to the bottom.
std::string column_of(std::vector<Pixel> const& pixels)
{
    PixelRows rows { 1, static_cast<int>(pixels.size()), {} };
    for (auto pixel = pixels.rbegin(); pixel != pixels.rend(); ++pixel)
        rows.rgba.insert(rows.rgba.end(), pixel->begin(), pixel->end());
    return upside_down_png(rows);
}

std::vector<Pixel> pixels_of(std::string const& png)
{
    std::vector<Pixel> pixels;
    EXPECT_TRUE(read_png_pixels(png, 100, [&](int, int height) {
        pixels.resize(static_cast<std::size_t>(height));
        return pixels.front().data();
    }));
    return pixels;
}

constexpr Pixel kBlack { 0, 0, 0, 255 };
constexpr Pixel kWhite { 255, 255, 255, 255 };
constexpr Pixel kClear { 255, 0, 0, 10 };

Result<View> view_with(std::string const& png, std::string const& line)
{
    return parse_view("a.v", line, [&](std::string const& name) -> Result<std::string> {
        if (name == "petal.png")
            return png;
        return fail(Fault::User, "it is not there");
    });
}

TEST(ViewTexture, StandsForTheColour)
{
    auto const png = column_of({ kBlack, kBlack, kWhite, kClear });
    auto const view
        = view_with(png, "material: 3 petal texture=petal.png kind=petal color=1,0,0\n");
    ASSERT_TRUE(view) << view.error().message;
    auto const& material = view->materials.at(3);
    auto const& textures = material.textures;
    ASSERT_TRUE(textures.base_color);
    EXPECT_EQ(textures.color, MaterialTextures::Color::Replaced);
    EXPECT_EQ(textures.alpha, MaterialTextures::Alpha::Mask);
    EXPECT_EQ(textures.base_color->edges, TexturePicture::Edges::Clamp);
    EXPECT_EQ(pixels_of(textures.base_color->bytes),
              (std::vector<Pixel> { kClear, kWhite, kBlack, kBlack }))
        << "v is 0 at the base";
    // A third of white light, in sRGB: 1.055 / 3^(1 / 2.4) - 0.055.
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(material.base_color[i], 0.6124f, 1e-3f);
}

TEST(ViewTexture, OfStemsIsRepeatedAndOpaqueWithoutHoles)
{
    auto const view = view_with(column_of({ kBlack, kWhite }),
                                "material: 1 bark kind=bark texture=petal.png\n");
    ASSERT_TRUE(view);
    auto const& textures = view->materials.at(1).textures;
    EXPECT_EQ(textures.base_color->edges, TexturePicture::Edges::Repeat);
    EXPECT_EQ(textures.alpha, MaterialTextures::Alpha::Opaque);
}

TEST(ViewTexture, ThatIsMissingIsAWarning)
{
    auto const view = view_with("", "material: 2 leaf kind=leaf color=0,1,0 texture=no.png\n");
    ASSERT_TRUE(view);
    ASSERT_EQ(view->warnings.size(), 1U);
    EXPECT_EQ(view->warnings[0],
              "a.v:1:1: cannot read the texture no.png (it is not there); the material has its "
              "colour alone");
    EXPECT_EQ(view->materials.at(2).base_color, Vec3f(0, 1, 0));
    EXPECT_FALSE(view->materials.at(2).textures.base_color);
}

TEST(ViewTexture, ThatIsNoPictureIsAnError)
{
    auto const said = [](std::string const& bytes) {
        auto const view = view_with(bytes, "\nmaterial: 2 leaf texture=petal.png\n");
        return view ? "no error" : view.error().message;
    };
    EXPECT_EQ(said("GIF89a"),
              "a.v:2:1: the texture petal.png: it is no PNG picture: save it as one");
    auto const png = column_of({ kBlack });
    EXPECT_EQ(said(png), "no error");
    EXPECT_EQ(said(png + std::string(kMaxTextureBytes, 'x')),
              "a.v:2:1: the texture petal.png: it has more than 16 MiB: make it smaller");
    auto const damaged = said(png.substr(0, 40));
    EXPECT_NE(damaged.find("a.v:2:1: the texture petal.png: the picture is damaged: "),
              std::string::npos)
        << damaged;
}

} // namespace
} // namespace tractus::lsystem
