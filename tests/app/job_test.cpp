#include "app/job.h"

#include "app/model_file.h"
#include "app/render/mesh_measures.h"
#include "app/simulated_recording.h"
#include "calib/rig_file.h"
#include "drivers/file.h"
#include "engine/export/glb_reader.h"
#include "engine/mesh/make_mesh.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;

double width_mm(Mesh const& mesh)
{
    auto const box = bounds(mesh);
    return box.max_mm.x() - box.min_mm.x();
}

// A stem of ten segments, 100 mm high, with a leaf of 300 mm to the left and one to the right.
class LeafyJob : public testing::Test {
protected:
    void SetUp() override
    {
        fs::create_directories(folder_);
        write("leafy.l",
              "Lsystem: 1\nderivation length: 10\nAxiom: A\n"
              "A --> FA\nhomomorphism\nA --> [+(90)~l][-(90)~l]\nendlsystem\n");
        write("leafy.v",
              "material: 2 leaf kind=leaf color=0.2,0.5,0.2\n"
              "organ: l leaf kind=blade material=2 length=30 width=5\n");
        auto const scene = apply_edit({}, load_model_edit(folder_ / "leafy.l").value()).value();
        plant_width_mm_ = width_mm(make_mesh(*scene.base));
        auto const script = parse_gesture_script("version = 1\n[[gesture]]\ntool = \"indicate\"\n"
                                                 "path = \"line\"\nfrom_mm = [0, 0, 50]\n"
                                                 "to_mm = [0, 10, 60]\n",
                                                 "script");
        ASSERT_TRUE(script) << script.error().message;
        auto const log
            = [&](std::ostream& out) { return write_simulated_recording(out, *script, scene); };
        ASSERT_TRUE(write_file(folder_ / "leafy.tractus-log", log));
    }

    void TearDown() override { fs::remove_all(folder_); }

    void write(std::string const& name, std::string const& text)
    {
        ASSERT_TRUE(write_file(folder_ / name, text));
    }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_job_test_" + std::to_string(::getpid()));
    double plant_width_mm_ = 0;
};

TEST_F(LeafyJob, PlacesPlantsSideBySideWithTheirLeaves)
{
    Progress progress;
    auto const report = run_job({ .log = folder_ / "leafy.tractus-log",
                                  .model = folder_ / "leafy.l",
                                  .rig = {},
                                  .height = {},
                                  .variations = 2,
                                  .folder = folder_ / "out" },
                                progress);
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_EQ(report->plants, 2u);
    auto const collection = read_glb(read_file(folder_ / "out" / "collection.glb").value());
    ASSERT_TRUE(collection) << collection.error().message;
    EXPECT_GT(plant_width_mm_, 400);
    EXPECT_GT(width_mm(*collection), 2 * plant_width_mm_);
}

TEST_F(LeafyJob, SaysThatTheRigIsAnotherOne)
{
    Rig rig;
    rig.full_scale_counts = 1023; // The log's converter reads up to 4095.
    ASSERT_TRUE(save_rig(rig, folder_ / "other.rig.toml"));
    Progress progress;
    auto const report = run_job({ .log = folder_ / "leafy.tractus-log",
                                  .model = folder_ / "leafy.l",
                                  .rig = folder_ / "other.rig.toml",
                                  .height = {},
                                  .variations = 1,
                                  .folder = folder_ / "out" },
                                progress);
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_EQ(report->strokes, 0u);
    ASSERT_EQ(report->notes.size(), 3u);
    EXPECT_NE(report->notes[0].find("height readings are not of the rig's calibration"),
              std::string::npos);
    EXPECT_NE(report->notes[1].find("pen samples had no height reading"), std::string::npos);
    EXPECT_EQ(report->notes[2], "no stroke has heights: the plants vary by chance alone");
}

} // namespace
} // namespace tractus
