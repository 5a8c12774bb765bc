#include "app/commands/command_line.h"
#include "app/methods/all_methods.h"
#include "engine/base/file.h"
#include "engine/export/glb_writer.h"
#include "tests/app/render/read_png.h"
#include "tests/app/render/small_mesh.h"

#include <array>
#include <filesystem>
#include <unistd.h>

namespace tractus::render {

class RenderCommand : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::temp_directory_path()
            / ("tractus_render_" + std::to_string(::getpid()));
        std::filesystem::create_directory(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string file(char const* name) const { return (folder_ / name).string(); }

    int render(std::string const& input, std::string const& output, char const* size = "160x120")
    {
        std::array const arguments { "tractus",      "render", input.c_str(), "-o",
                                     output.c_str(), "--size", size };
        return commands::run_command_line(static_cast<int>(arguments.size()), arguments.data(),
                                          methods::all_methods());
    }

    std::filesystem::path folder_;
};

TEST_F(RenderCommand, DrawsAGlbInTheAskedSize)
{
    auto const mesh = post_with_leaves();
    std::array const plants { exports::PlacedMesh { .mesh = &mesh } };
    auto const written = write_file(file("post.glb"), [&](std::ostream& out) -> Result<void> {
        TRY(exports::write_glb(out, plants));
        return {};
    });
    ASSERT_TRUE(written) << written.error().message;
    ASSERT_EQ(render(file("post.glb"), file("post.png")), 0);

    auto const picture = read_png(read_file(file("post.png")).value_or(""));
    ASSERT_EQ(picture.width(), 160);
    ASSERT_EQ(picture.height(), 120);
    int leaf = 0;
    for (auto const& pixel : picture.pixels())
        leaf += pixel.green > pixel.red + 15 && pixel.green > pixel.blue + 30;
    EXPECT_GT(leaf, 300);
}

TEST_F(RenderCommand, LeavesNoPictureOfWhatIsNoGlb)
{
    ASSERT_TRUE(write_file(file("text.glb"), "no glTF"));
    EXPECT_EQ(render(file("text.glb"), file("text.png")), 1);
    EXPECT_FALSE(std::filesystem::exists(file("text.png")));
}

TEST_F(RenderCommand, RefusesWhatIsNoSize)
{
    for (char const* const size :
         { "", "8", "160x", "x120", "160x120x3", "8x8", "9000x9000", "-16x16" })
        EXPECT_EQ(render(file("any.glb"), file("any.png"), size), 2) << size;
}

} // namespace tractus::render
