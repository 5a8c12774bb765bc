// Fuzzes the whole way of a drawing: a log of any tools, steps, undo and broken reports
// (drawn_recipe.h) is replayed as a command does it, through the station into a document, whose
// session is in a file; then the plants are grown, meshed and exported. The session must open as it
// was left, also when it is undone and done again. The first byte chooses the plant to draw on, and
// whether all is done again on one thread, which must give the same strokes, edits and files.

#include "app/batch/drawing.h"
#include "app/document/model_cost.h"
#include "app/methods/all_methods.h"
#include "app/session/begin_empty.h"
#include "app/session/session.h"
#include "drivers/logs/log.h"
#include "engine/export/glb_writer.h"
#include "engine/plant/mtg.h"
#include "engine/variation/growth.h"
#include "tests/app/small_model.h"
#include "tests/fuzz/drawn_recipe.h"
#include "tests/fuzz/own_file.h"

#include <fstream>
#include <oneapi/tbb/global_control.h>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace tractus;

constexpr std::size_t kMaxSegments = 20'000; // Larger plants are not exported, which takes long.

// The result of a drawing, as texts that can be compared.
struct Outcome {
    std::vector<std::string> notes;   // What the command would say of the drawing.
    std::vector<std::string> strokes; // Refusal, message and edits of each stroke.
    std::vector<std::string> files;   // The plants in other formats.

    bool operator==(Outcome const&) const = default;
};

session::SessionOptions session_options()
{
    return { methods::all_methods().edits, [] { return document::load_options(); },
             [] { return std::chrono::sys_seconds(std::chrono::seconds(1'800'000'000)); } };
}

std::vector<scene::Edit> beginning(bool is_empty)
{
    if (is_empty)
        return { session::BeginEmpty {} };
    return { small_model(), scene::SetGrowth {} };
}

std::string text_of(document::DrawnStroke const& drawn)
{
    auto text = drawn.refusal + "\n" + drawn.message + "\n";
    for (auto const& edit : drawn.edits) {
        auto const record = session::record_of(edit);
        text += record.kind + record.fields + record.numbers + edit.describe() + "\n";
    }
    return text;
}

void export_plant(scene::BuiltPlant const& built, std::vector<std::string>& files)
{
    auto const plan = scene::plan_growth(built);
    if (!is_read(plan))
        return;
    variation::Grower grower(*plan);
    auto const& grown = grower.grow({ built.growth.seed, 0 }, built.growth.age);
    auto const plant = built.growth.age < 1 ? variation::without_unborn(grown) : grown;
    check_plant(plant);
    if (plant.segment_count() > kMaxSegments)
        return;
    std::ostringstream glb;
    exports::PlacedMesh const placed { .mesh = exports::PlantToMesh { .plant = &plant } };
    is_read(exports::write_glb(glb, { &placed, 1 }));
    files.push_back(glb.str());
    std::ostringstream graph;
    write_mtg(graph, plant);
    if (auto const again = parse_mtg("again", graph.str()); is_read(again))
        check_plant(*again);
    files.push_back(graph.str());
}

// The drawn state of a document, which does not depend on the way that led there.
std::string state_of(scene::Scene const& scene)
{
    std::string text;
    for (auto const& plant : scene.plants) {
        text += fmt::format("{} {} {} {} {}\n", plant->base->segment_count(),
                            plant->associations.size(), plant->indicators.size(),
                            plant->selection.size(), plant->drawn->name);
        for (auto const& [id, association, at] : plant->associations)
            text += fmt::format("{} ", id);
        for (auto const& node_mm : plant->base->node_position_mm)
            text += fmt::format("{} {} {} ", node_mm.x(), node_mm.y(), node_mm.z());
    }
    return text;
}

void check_session(std::filesystem::path const& path, scene::Scene const& scene)
{
    auto opened = session::Session::open(path, session_options());
    CHECK(opened);
    auto const drawn = state_of(scene);
    CHECK(state_of(opened->scene()) == drawn);
    auto const step = opened->step();
    while (opened->can_undo())
        CHECK(opened->undo());
    while (opened->step() < step)
        CHECK(opened->redo());
    CHECK(state_of(opened->scene()) == drawn);
}

// Replays the log as the commands do, and exports the plants; returns the scene, whose session is
// in the file `path`.
scene::Scene draw(std::filesystem::path const& log, std::filesystem::path const& path,
                  bool is_empty, Outcome& outcome)
{
    document::Document document(
        session::Session::create(path, {}, beginning(is_empty), session_options()).value(),
        document::Document::Working::AtOnce);
    batch::DrawingReport report;
    terminal::Progress progress;
    auto const drawing = batch::read_drawing({ .log = log, .methods = methods::all_methods() },
                                             document, progress, report);
    outcome.notes = report.notes;
    if (drawing)
        for (auto const& drawn : drawing->strokes)
            outcome.strokes.push_back(text_of(drawn));
    else // Reports that no device sends are a device's error.
        CHECK(drawing.error().fault == Fault::User || drawing.error().fault == Fault::Device);
    CHECK(document.newest()->unkept == 0);
    auto const& scene = document.newest()->scene;
    for (auto const& plant : scene.plants)
        export_plant(*plant, outcome.files);
    return scene;
}

Outcome outcome_of(std::string const& log, bool is_empty)
{
    static auto const log_path = own_file(".tractus-log");
    static auto const path = own_file(".tractus");
    std::ofstream(log_path) << log;
    for (auto const* const ending : { "", "-wal", "-shm" })
        std::filesystem::remove(path.string() + ending);
    Outcome outcome;
    check_session(path, draw(log_path, path, is_empty, outcome));
    return outcome;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    FuzzInput input(data, size);
    auto const how = input.take_byte();
    auto const log = log_of_recipe(input);
    CHECK(drivers::parse_log(log, "fuzz"));
    auto const outcome = outcome_of(log, how % 2 == 1);
    if (how / 2 % 4 == 1) {
        oneapi::tbb::global_control const one_thread(
            oneapi::tbb::global_control::max_allowed_parallelism, 1);
        CHECK(outcome_of(log, how % 2 == 1) == outcome);
    }
    return 0;
}
