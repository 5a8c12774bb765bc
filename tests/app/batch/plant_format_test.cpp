#include "app/batch/plant_format.h"

#include "app/batch/plant_file.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/methods/all_habits.h"
#include "engine/base/base64.h"
#include "engine/base/file.h"
#include "engine/export/glb_reader.h"
#include "engine/scene/scene.h"
#include "tests/engine/export/stl_triangles.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::batch {
namespace {

namespace fs = std::filesystem;

class PlantFormats : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    static Plant plant_of(scene::Edit const& edit)
    {
        return *scene::apply_edit({}, edit).value().base;
    }

    static Plant model(std::string const& name)
    {
        return plant_of(io::load_plant_edit(files::find_model(name).value()).value());
    }

    // A stem that forks, as lines of another program.
    Plant fork() const
    {
        auto const path = folder_ / "fork.obj";
        EXPECT_TRUE(write_file(path,
                               "v 0 0 0\nv 0 0.1 0\nv 0.05 0.15 0\nv -0.05 0.16 0.01\n"
                               "l 1 2\nl 2 3\nl 2 4\n"));
        return plant_of(io::load_plant_edit(path).value());
    }

    WrittenFile write(Plant const& plant, std::string const& name,
                      SolidFileOptions const& solid = {}) const
    {
        auto const written = write_plant_file(plant, "plant", folder_ / name, { .solid = solid });
        EXPECT_TRUE(written) << written.error().message;
        return written.value_or(WrittenFile {});
    }

    // Writes an .stl file and expects each of its edges to have exactly two triangles.
    WrittenFile expect_closed(Plant const& plant, SolidFileOptions const& solid = {}) const
    {
        auto written = write(plant, "plant.stl", solid);
        auto const triangles = mesh::stl_triangles(read_file(folder_ / "plant.stl").value());
        EXPECT_EQ(triangles.size(), written.triangles);
        EXPECT_GT(triangles.size(), 100u);
        EXPECT_EQ(mesh::count_bad_edges(triangles), 0u);
        EXPECT_EQ(written.note.find("the surface is closed, in "), 0u) << written.note;
        return written;
    }

    fs::path folder_ = fs::temp_directory_path() / ("tractus-formats-" + std::to_string(getpid()));
};

TEST_F(PlantFormats, APageHasThePlantAndItsNameInside)
{
    auto const plant = model("daisy");
    auto const path = folder_ / "page.html";
    auto const written = write_plant_file(plant, "a <b> & \"c\"", path);
    ASSERT_TRUE(written) << written.error().message;
    auto const page = read_file(path).value();
    EXPECT_NE(page.find("<title>a &lt;b&gt; &amp; &quot;c&quot;</title>"), std::string::npos);
    EXPECT_EQ(page.find('@'), std::string::npos) << "no placeholder is left";
    std::string const before = "type=\"application/octet-stream\">";
    auto const begin = page.find(before) + before.size();
    auto const glb = from_base64(page.substr(begin, page.find('<', begin) - begin));
    ASSERT_TRUE(glb);
    auto const read = exports::read_glb(*glb);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->triangle_count(), written->triangles);
}

TEST_F(PlantFormats, EachIsWrittenAndSaysHowManyTriangles)
{
    auto const plant = model("leaf");
    for (auto const& format : plant_formats()) {
        auto const name = "plant" + std::string(format.ending);
        EXPECT_EQ(plant_format_of(name), &format);
        if (format.ending == ".png")
            continue; // It needs OpenGL.
        EXPECT_EQ(write(plant, name).triangles > 0, format.has_triangles) << name;
        EXPECT_GT(fs::file_size(folder_ / name), 0u) << name;
    }
    EXPECT_FALSE(is_plant_file("plant.gif"));
    EXPECT_EQ(listed({ ".a", ".b", ".c" }), ".a, .b or .c");
}

TEST_F(PlantFormats, EveryStlIsClosed)
{
    expect_closed(fork());
    for (char const* const name : { "shrub", "birch", "broadleaf" })
        expect_closed(model(name));
    expect_closed(plant_of(methods::tree_of_habit("birch", 8, 1).value()));
}

TEST_F(PlantFormats, AWatertightStlIsOneShell)
{
    EXPECT_EQ(expect_closed(fork(), { .is_watertight = true }).note,
              "the surface is closed, in one shell");
    SolidFileOptions const printed { .is_watertight = true, .height_mm = 60 };
    for (char const* const name : { "shrub", "birch", "broadleaf" })
        EXPECT_EQ(expect_closed(model(name), printed).note, "the surface is closed, in one shell")
            << name;
    expect_closed(plant_of(methods::tree_of_habit("birch", 8, 1).value()), printed);
}

TEST_F(PlantFormats, APrintedPlantHasItsHeight)
{
    write(model("shrub"), "plant.stl", { .height_mm = 120, .without_leaves = true });
    float highest = 0;
    for (auto const& corners : mesh::stl_triangles(read_file(folder_ / "plant.stl").value()))
        for (auto const& corner : corners)
            highest = std::max(highest, corner[2]);
    EXPECT_NEAR(highest, 120, 2);
}

TEST_F(PlantFormats, APlySaysWhetherItIsClosed)
{
    auto const plant = fork();
    EXPECT_EQ(write(plant, "plant.ply").note,
              "the surface is open, as it is shown; --watertight closes it");
    EXPECT_EQ(write(plant, "plant.ply", { .is_watertight = true }).note,
              "the surface is closed, in one shell");
}

TEST_F(PlantFormats, AUsdaHasItsPicturesBesideIt)
{
    write(model("leaf"), "plant.usda");
    auto const text = read_file(folder_ / "plant.usda").value();
    EXPECT_NE(text.find("def PointInstancer"), std::string::npos);
    auto at = text.find("@./");
    EXPECT_NE(at, std::string::npos);
    for (; at != std::string::npos; at = text.find("@./", at + 1)) {
        auto const name = text.substr(at + 3, text.find('@', at + 3) - at - 3);
        EXPECT_TRUE(fs::exists(folder_ / name)) << name;
    }
}

} // namespace
} // namespace tractus::batch
