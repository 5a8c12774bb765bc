#include "app/batch/job.h"
#include "app/methods/all_methods.h"

#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/play/simulated_recording.h"
#include "calib/rig_file.h"
#include "engine/base/file.h"
#include "engine/export/glb_reader.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_measures.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::batch {
namespace {

namespace fs = std::filesystem;

double width_mm(mesh::Mesh const& mesh)
{
    auto const box = mesh::bounds(mesh);
    return box.max_mm.x() - box.min_mm.x();
}

// Fixture with a stem of ten segments, 100 mm high, that has a leaf of 300 mm on its left and one
// on its right.
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
        auto const scene
            = scene::apply_edit({}, io::load_model_edit(folder_ / "leafy.l").value()).value();
        plant_width_mm_ = width_mm(mesh::make_mesh(*scene.base));
        auto const script
            = sim::parse_gesture_script("version = 1\n[[gesture]]\ntool = \"indicate\"\n"
                                        "path = \"line\"\nfrom_mm = [0, 0, 50]\n"
                                        "to_mm = [0, 10, 60]\n",
                                        "script");
        ASSERT_TRUE(script) << script.error().message;
        auto const log = [&](std::ostream& out) {
            return play::write_simulated_recording(out, *script, scene,
                                                   methods::all_methods().tools);
        };
        ASSERT_TRUE(write_file(folder_ / "leafy.tractus-log", log));
    }

    void TearDown() override { fs::remove_all(folder_); }

    void write(std::string const& name, std::string const& text)
    {
        ASSERT_TRUE(write_file(folder_ / name, text));
    }

    // Returns a job that varies the leafy stem by its drawing, and writes into the folder "out".
    JobOptions job(std::size_t variations) const
    {
        return { .drawing
                 = { .log = folder_ / "leafy.tractus-log", .methods = methods::all_methods() },
                 .model = folder_ / "leafy.l",
                 .variations = variations,
                 .folder = folder_ / "out",
                 .individuality = {} };
    }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_job_test_" + std::to_string(::getpid()));
    double plant_width_mm_ = 0;
};

TEST_F(LeafyJob, PlacesPlantsSideBySideWithTheirLeaves)
{
    terminal::Progress progress;
    auto const report = run_job(job(2), progress);
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_EQ(report->plants, 2u);
    auto const collection
        = exports::read_glb(read_file(folder_ / "out" / "collection.glb").value());
    ASSERT_TRUE(collection) << collection.error().message;
    EXPECT_GT(plant_width_mm_, 400);
    EXPECT_GT(width_mm(*collection), 2 * plant_width_mm_);
}

TEST_F(LeafyJob, ShowsTheDrawingInFourSeasons)
{
    auto options = job(1);
    options.all_seasons = true;
    terminal::Progress progress;
    auto const report = run_job(options, progress);
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_EQ(report->plants, 5u);
    auto const bytes = read_file(folder_ / "out" / "collection.glb").value();
    for (auto const* name :
         { "leafy 1", "leafy spring", "leafy summer", "leafy autumn", "leafy winter" })
        EXPECT_NE(bytes.find(name), std::string::npos) << name;
}

// A recording that begins with an empty sheet contains the loading of its plant.
TEST_F(LeafyJob, BeginsWithAnEmptySheet)
{
    JobOptions options { .variations = 2, .folder = folder_ / "sheet" };
    options.drawing.log
        = files::find_resource("demo/first-plants/sketch-surface.tractus-log").value();
    options.drawing.methods = methods::all_methods();
    terminal::Progress progress;
    auto const report = run_job(options, progress);
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_EQ(report->model, "an empty sheet");
    EXPECT_EQ(report->plants, 2u);
    EXPECT_GT(report->triangles, 0u);
    EXPECT_TRUE(fs::exists(folder_ / "sheet" / "collection.glb"));
}

TEST_F(LeafyJob, SaysThatTheRigIsAnotherOne)
{
    calib::Rig rig;
    rig.full_scale_counts = 1023; // The converter of the log has a full scale of 4095 counts.
    ASSERT_TRUE(calib::save_rig(rig, folder_ / "other.rig.toml"));
    terminal::Progress progress;
    auto const report = run_job({ .drawing = { .log = folder_ / "leafy.tractus-log",
                                               .methods = methods::all_methods(),
                                               .rig = folder_ / "other.rig.toml" },
                                  .model = folder_ / "leafy.l",
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

TEST_F(LeafyJob, VariesAnotherProgramsSkeletonByStrokesInSpace)
{
    write("tree.obj",
          "v 0 0 0\nv 0 0.5 0\nv 0 1 0\nv 0.4 0.8 0\nv -0.3 0.7 0\n"
          "l 1 2 3\nl 2 4\nl 2 5\n");
    // Four strokes: one for each of the three branches, including the trunk, and one too many.
    write("drawing.strokes",
          "0 0 0\n0 0 50\n40 0 90\n\n0 0 0\n10 0 0\n10 30 20\n\n"
          "0 0 0\n10 0 0\n\n0 0 0\n10 0 0\n");
    terminal::Progress progress;
    auto const report = run_job(
        { .drawing = { .log = folder_ / "drawing.strokes", .methods = methods::all_methods() },
          .model = folder_ / "tree.obj",
          .variations = 2,
          .folder = folder_ / "out",
          .growth = { .preset = "windy hillside" },
          .age = 0.7 },
        progress);
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_EQ(report->strokes, 3u);
    EXPECT_EQ(report->branches_selected, 3u);
    EXPECT_EQ(report->segments, 4u);
    ASSERT_EQ(report->notes.size(), 1u);
    EXPECT_NE(report->notes[0].find("more strokes than branches"), std::string::npos);
    auto const text = read_file(folder_ / "out" / "report.txt").value();
    EXPECT_NE(text.find("windy hillside"), std::string::npos);
    EXPECT_NE(text.find("age                   0.7"), std::string::npos);
    EXPECT_TRUE(exports::read_glb(read_file(folder_ / "out" / "collection.glb").value()));
}

TEST_F(LeafyJob, SaysWhatIsWrongWithAFileOfStrokes)
{
    write("drawing.strokes", "0 0 0\n1 one 1\n");
    write("drawing.tilt", "no sketch");
    terminal::Progress progress;
    for (auto const* name : { "drawing.strokes", "drawing.tilt" }) {
        auto const report
            = run_job({ .drawing = { .log = folder_ / name, .methods = methods::all_methods() },
                        .model = folder_ / "leafy.l",
                        .folder = folder_ / "out" },
                      progress);
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().fault, Fault::User);
        EXPECT_NE(report.error().message.find(name), std::string::npos);
    }
}

} // namespace
} // namespace tractus::batch
