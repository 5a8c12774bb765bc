#include "app/io/model_file.h"
#include "app/methods/all_methods.h"
#include "app/play/simulated_recording.h"
#include "app/station/log_replay.h"
#include "engine/base/file.h"
#include "engine/scene/scene.h"
#include "tests/vm/checks.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus {

namespace {

// Returns the hand that write_simulated_recording() uses.
Result<sim::Hand> hand_of(TruthOptions const& options)
{
    auto const text = TRY(read_file(options.script));
    auto const script = TRY(sim::parse_gesture_script(text, options.script));
    auto const edit = TRY(io::load_model_edit(options.model));
    return play::simulated_hand(script, TRY(scene::apply_edit({}, edit)));
}

// Returns the recording's clock minus the hand's clock: the median over the pen's reports, which
// must all have arrived, in order. A truncated recording may lack the last ones.
Result<Duration> clock_offset(drivers::Log const& sent, drivers::Log const& got, bool is_torn)
{
    std::vector<Timestamp> sent_times;
    std::vector<Duration> offsets;
    for (auto const& record : sent.records)
        if (record.device == 0)
            sent_times.push_back(record.time);
    for (auto const& record : got.records)
        if (record.device == 0 && record.size > 0 && offsets.size() < sent_times.size())
            offsets.push_back(record.time - sent_times[offsets.size()]);
    if (offsets.empty() || (offsets.size() != sent_times.size() && !is_torn))
        return fail(Fault::Device,
                    fmt::format("{} reports of the pen came of {} that were sent", offsets.size(),
                                sent_times.size()));
    auto const middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::nth_element(offsets.begin(), middle, offsets.end());
    return *middle;
}

// Distances of tips from where the hand was at their time.
struct StrokeErrors {
    double sum_of_squares = 0;
    double largest_mm = 0;
    // Greatest distance of a tip from the hand's path within kLateness of the tip's time.
    double largest_from_path_mm = 0;
    std::size_t count = 0;

    void add(TipSample const& tip, Timestamp time, sim::Hand const& hand)
    {
        constexpr Duration kLateness = std::chrono::milliseconds(20);
        constexpr Duration kStep = std::chrono::microseconds(500);
        auto const distance_mm
            = [&](Timestamp at) { return (tip.position_mm - hand.at(at).position_mm).norm(); };
        double const error_mm = distance_mm(time);
        double from_path_mm = error_mm;
        for (auto later = -kLateness; later <= kLateness; later += kStep)
            from_path_mm = std::min(from_path_mm, distance_mm(time + later));
        sum_of_squares += error_mm * error_mm;
        largest_mm = std::max(largest_mm, error_mm);
        largest_from_path_mm = std::max(largest_from_path_mm, from_path_mm);
        ++count;
    }

    double rms_mm() const { return std::sqrt(sum_of_squares / static_cast<double>(count)); }
};

Result<std::vector<document::DrawnStroke>> strokes_of_recording(drivers::Log const& log,
                                                                std::string const& model)
{
    auto const edit = TRY(io::load_model_edit(model));
    document::Document document(TRY(scene::apply_edit({}, edit)),
                                document::Document::Working::AtOnce);
    auto replay = TRY(station::LogReplay::create(log, { .methods = methods::all_methods() }));
    replay.run(document);
    return document.take_finished_strokes();
}

} // namespace

Result<void> compare_strokes(TruthOptions const& options)
{
    auto const hand = TRY(hand_of(options));
    auto const sent = TRY(drivers::read_log(options.sent));
    auto const got = TRY(drivers::read_log(options.got));
    auto const offset = TRY(clock_offset(sent, got, options.is_torn));
    auto const strokes = TRY(strokes_of_recording(got, options.model));
    auto const drawn_count = options.strokes > 0 ? options.strokes : hand.strokes().size();
    if (strokes.size() != drawn_count)
        return fail(
            Fault::Station,
            fmt::format("{} strokes came of {} that were drawn", strokes.size(), drawn_count));
    StrokeErrors errors;
    for (auto const& drawn : strokes)
        for (auto const& tip : drawn.stroke.tips)
            errors.add(tip, tip.time - offset, hand);
    print_figure("error rms", errors.rms_mm(), "mm");
    print_figure("error max", errors.largest_mm, "mm");
    print_figure("error max from the path", errors.largest_from_path_mm, "mm");
    if (!(errors.rms_mm() <= options.limit_rms_mm && errors.largest_mm <= options.limit_max_mm
          && errors.largest_from_path_mm <= options.limit_path_mm))
        return fail(Fault::Station, "the strokes lie too far from the truth");
    fmt::print("{} strokes with {} tips lie where they were drawn\n", strokes.size(), errors.count);
    return {};
}

Result<void> check_interrupted_strokes(std::string const& log_name, std::string const& model,
                                       std::size_t least)
{
    constexpr Duration kLongestGap = std::chrono::milliseconds(200);
    auto const log = TRY(drivers::read_log(log_name));
    auto const strokes = TRY(strokes_of_recording(log, model));
    std::size_t count = 0;
    for (auto const& drawn : strokes) {
        auto const& tips = drawn.stroke.tips;
        count += tips.size();
        for (std::size_t i = 1; i < tips.size(); ++i)
            if (tips[i].time - tips[i - 1].time > kLongestGap)
                return fail(Fault::Station, "a stroke goes on where a device was away");
    }
    fmt::print("{} strokes with {} tips\n", strokes.size(), count);
    if (strokes.size() < least)
        return fail(Fault::Station, fmt::format("expected {} strokes at least", least));
    return {};
}

} // namespace tractus
