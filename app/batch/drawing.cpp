#include "app/batch/drawing.h"

#include "app/batch/plant_season.h"
#include "app/batch/session_plant.h"
#include "app/document/document.h"
#include "app/io/model_file.h"
#include "app/io/stroke_file.h"
#include "app/methods/all_leaves.h"
#include "app/play/paced_log.h"
#include "app/session/begin_empty.h"
#include "app/station/log_replay.h"
#include "calib/rig_file.h"
#include "drivers/logs/log.h"
#include "engine/variation/growth_preset.h"

#include <fmt/core.h>
#include <set>

namespace tractus::batch {

namespace {

constexpr char const* kUsual = "usual";

// Adds notes that say why pen samples were lost or are doubtful.
void note_heights(calib::FuserCounts const& counts, std::vector<std::string>& notes)
{
    if (counts.heights_refused > 0)
        notes.push_back(
            fmt::format("{} of {} height readings are not of the rig's calibration, and "
                        "were left out: calibrate again",
                        counts.heights_refused, counts.heights));
    if (counts.heights_uncalibrated > 0)
        notes.push_back(fmt::format("{} of {} height readings lie outside the calibrated range, "
                                    "where heights are guesses",
                                    counts.heights_uncalibrated, counts.heights));
    if (counts.pens_without_height > 0)
        notes.push_back(fmt::format("{} of {} pen samples had no height reading at their time, and "
                                    "were left out",
                                    counts.pens_without_height, counts.pens));
}

// Names a stroke in messages by its time, or an action without a stroke by its line in the log.
std::string name_of(document::DrawnStroke const& drawn)
{
    if (!drawn.stroke.tips.empty())
        return fmt::format("a stroke at {:.1f} s", to_seconds(drawn.stroke.tips.front().time));
    auto const words = tools::words_for(drawn.tool);
    return fmt::format("\"{} {}\"", words.name, words.arguments);
}

class DrawingReader {
public:
    DrawingReader(DrawingOptions const& options, document::Document& document,
                  terminal::Progress& progress, DrawingReport& report)
        : options_(options)
        , document_(document)
        , progress_(progress)
        , report_(report)
    {
    }

    Result<Drawing> read();
    void note_drawing(Drawing const& drawing);

private:
    Result<void> read_strokes();
    Result<void> replay();
    Result<void> play(station::LogReplay& replay);
    Result<void> take_finished_strokes();
    void note_replay(station::Station const& station);

    DrawingOptions const& options_;
    document::Document& document_;
    terminal::Progress& progress_;
    DrawingReport& report_;
    std::vector<document::DrawnStroke> strokes_;
    Nib nib_ = Nib::Point;
};

Result<Drawing> DrawingReader::read()
{
    TRY(io::is_stroke_file(options_.log) ? read_strokes() : replay());
    return Drawing { document_.newest()->scene, std::move(strokes_), nib_ };
}

// Reads a file of strokes. The file does not say which branches the strokes shape, so the n-th
// stroke is assigned to the n-th branch.
Result<void> DrawingReader::read_strokes()
{
    progress_.begin("reading the strokes");
    for (auto& stroke : TRY(io::load_strokes(options_.log))) {
        if (strokes_.size() == document_.newest()->scene.base->axes.size()) {
            report_.notes.push_back("there are more strokes than branches: the rest is left out");
            break;
        }
        document_.draw({ std::move(stroke), tools::Tool(*options_.methods.tools.front()) });
        TRY(take_finished_strokes());
    }
    report_.log = options_.log.string();
    report_.strokes = strokes_.size();
    return {};
}

Result<void> DrawingReader::take_finished_strokes()
{
    for (auto& drawn : document_.take_finished_strokes())
        strokes_.push_back(std::move(drawn));
    while (auto const done = document_.take_done())
        if (!done->status)
            report_.notes.push_back(done->status.error().message);
    if (auto const& why = document_.newest()->not_kept; !why.empty())
        return fail(Fault::User, why);
    return {};
}

// Plays the whole log, at the requested multiple of real time or as fast as possible.
Result<void> DrawingReader::play(station::LogReplay& replay)
{
    constexpr Duration kStep = std::chrono::milliseconds(10);
    auto const pace = play::pace_from_now(replay.begin(), options_.speed.value_or(1));
    for (bool goes_on = true; goes_on;) {
        auto const time = options_.speed ? pace.data_time(pace.now()) : Timestamp::max();
        bool const is_stroke_end = replay.advance_to_stroke(time);
        replay.replay_into(document_);
        TRY(take_finished_strokes());
        goes_on = !replay.is_over();
        if (goes_on && !is_stroke_end)
            pace.wait(kStep);
    }
    return replay.outcome();
}

Result<void> DrawingReader::replay()
{
    progress_.begin("reading the log");
    auto const log = TRY(drivers::read_log(options_.log));
    report_.log = options_.log.string();
    if (auto const warnings = drivers::summarize_warnings(log); !warnings.empty())
        report_.notes.push_back(warnings);

    progress_.begin("replaying the log");
    station::ReplayOptions replay_options { .methods = options_.methods };
    if (options_.rig)
        replay_options.rig = TRY(calib::load_rig(*options_.rig));
    if (options_.height)
        replay_options.height = TRY(calib::parse_height_scenario(*options_.height));
    auto replay = TRY(station::LogReplay::create(log, replay_options));
    TRY(play(replay));
    auto const& counts = replay.station().counts();
    if (counts.pen_samples == 0 && counts.broken_reports > 0)
        return fail(Fault::Device,
                    fmt::format("{}: the reports are not what the report descriptors say, the "
                                "first: {}",
                                log.name, counts.first_broken));
    note_replay(replay.station());
    nib_ = replay.station().nib();
    report_.notes.insert(report_.notes.end(), replay.left_out().begin(), replay.left_out().end());
    return {};
}

void DrawingReader::note_replay(station::Station const& station)
{
    auto const& counts = station.counts();
    report_.reports = counts.reports;
    report_.broken_reports = counts.broken_reports;
    report_.pen_samples = counts.pen_samples;
    report_.height_samples = counts.height_samples;
    report_.strokes = counts.strokes;
    note_heights(station.fuser_counts(), report_.notes);
    for (auto& sentence : calib::describe_faults(station.height_monitor(), {}))
        report_.notes.push_back(std::move(sentence));
    if (counts.strokes == 0)
        report_.notes.push_back(
            station.fuser_counts().pens_without_height > 0
                ? "no stroke has heights: the plants vary by chance alone"
                : "the pen never touched the tablet: the plants vary by chance alone");
    if (counts.broken_reports > 0)
        report_.notes.push_back(fmt::format("{} reports could not be decoded, the first: {}",
                                            counts.broken_reports, counts.first_broken));
}

void DrawingReader::note_drawing(Drawing const& drawing)
{
    report_.indicators = drawing.scene.indicators.size();
    std::set<std::vector<SegmentId>> paths;
    for (auto const& association : drawing.scene.associations)
        paths.insert(association.what.path);
    report_.branches_selected = paths.size();
    for (auto const& drawn : drawing.strokes)
        if (!drawn.refusal.empty())
            report_.notes.push_back(
                fmt::format("{} changed nothing: {}", name_of(drawn), drawn.refusal));
}

} // namespace

std::string growth_name(std::filesystem::path const& model, GrowthOptions const& growth)
{
    return growth.preset.value_or(is_session_file(model) ? "as in the session" : kUsual);
}

Result<std::vector<scene::Edit>>
growing_plant_edits(PlantChoice const& plant, GrowthOptions const& growth, std::uint64_t seed)
{
    // Without a model, the drawing makes plants, whose growth it defines itself.
    if (plant.model.empty())
        return std::vector<scene::Edit> { session::BeginEmpty {} };
    std::vector<scene::Edit> edits;
    std::optional<variation::GrowthParameters> own;
    if (is_session_file(plant.model)) {
        edits = TRY(session_edits(plant.model, plant.kinds));
        for (auto const& edit : edits)
            if (auto const* const set = edit.get<scene::SetGrowth>())
                own = TRY(variation::at_variability(set->parameters, set->variability));
    } else {
        edits.push_back(TRY(io::load_plant_edit(plant.model)));
    }
    if (!own || growth.preset)
        own = TRY(variation::growth_preset(growth.preset.value_or(kUsual)));
    edits.push_back(scene::SetGrowth { *own, seed, growth.variability });
    if (!growth.leaves.empty()) {
        auto const scene = TRY(document::scene_after({}, edits));
        for (auto& edit : TRY(methods::foliage_edits(scene, scene.state.active,
                                                     methods::parse_foliage(growth.leaves))))
            edits.push_back(std::move(edit));
    }
    if (growth.season) {
        auto const scene = TRY(document::scene_after({}, edits));
        for (auto& edit : TRY(season_edits(scene, growth.season)))
            edits.push_back(std::move(edit));
    }
    return edits;
}

Result<scene::Scene> growing_plant(std::filesystem::path const& model,
                                   std::vector<scene::Edit> const& edits)
{
    auto scene = TRY(document::scene_after({}, edits));
    bool const is_model = !model.empty() && !is_session_file(model);
    if (is_model && scene.base->segment_count() == 0)
        return fail(Fault::User,
                    fmt::format("{}: the plant has no branch that a stroke could shape: its "
                                "derivation draws nothing",
                                model.string()));
    return scene;
}

Result<scene::Scene> load_growing_plant(PlantChoice const& plant, GrowthOptions const& growth,
                                        std::uint64_t seed)
{
    return growing_plant(plant.model, TRY(growing_plant_edits(plant, growth, seed)));
}

Result<Drawing> read_drawing(DrawingOptions const& options, scene::Scene scene,
                             terminal::Progress& progress, DrawingReport& report)
{
    document::Document document(std::move(scene), document::Document::Working::AtOnce,
                                following_edits);
    return read_drawing(options, document, progress, report);
}

Result<Drawing> read_drawing(DrawingOptions const& options, document::Document& document,
                             terminal::Progress& progress, DrawingReport& report)
{
    DrawingReader reader(options, document, progress, report);
    auto drawing = TRY(reader.read());
    reader.note_drawing(drawing);
    return drawing;
}

Result<std::vector<Stroke>> drawn_strokes(DrawingOptions const& options)
{
    if (io::is_stroke_file(options.log))
        return io::load_strokes(options.log);
    terminal::Progress progress;
    DrawingReport report;
    auto const drawing = TRY(read_drawing(options, scene::Scene {}, progress, report));
    progress.finish();
    std::vector<Stroke> strokes;
    for (auto const& drawn : drawing.strokes)
        if (!drawn.stroke.tips.empty()) // Actions without a stroke have no tips and are skipped.
            strokes.push_back(drawn.stroke);
    return strokes;
}

} // namespace tractus::batch
