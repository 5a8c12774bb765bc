#include "app/station.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus {

namespace {

struct Pen {
    std::size_t device = 0;
    std::unique_ptr<PenDecoder> decoder;
};

// The first device that is a pen, or why none is.
Result<Pen> find_pen(std::span<DeviceInfo const> devices)
{
    std::string reasons;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        auto decoder = make_pen_decoder(devices[i]);
        if (decoder)
            return Pen { i, *std::move(decoder) };
        reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", decoder.error().message);
    }
    return fail(Fault::User,
                fmt::format("there is no pen to draw with: {}",
                            reasons.empty() ? "no device at all" : reasons));
}

} // namespace

Station::Station(StationOptions options, Fuser fuser)
    : fuser_(std::move(fuser))
    , height_monitor_(options.rig)
    , is_height_measured_(!options.scripted_height)
    , tablet_latency_(options.rig.tablet_latency)
    , tool_changes_ { { Timestamp::min(), options.tool } }
    , scene_(std::move(options.scene))
{
}

Result<Station> Station::create(std::span<DeviceInfo const> devices, StationOptions options)
{
    auto pen = TRY(find_pen(devices));
    auto fuser = options.scripted_height ? Fuser(options.rig, *options.scripted_height)
                                         : Fuser(options.rig);
    Station station(std::move(options), std::move(fuser));
    station.pen_device_ = pen.device;
    station.pen_decoder_ = std::move(pen.decoder);
    for (std::size_t i = 0; i < devices.size() && !station.height_decoder_; ++i) {
        if (i == pen.device)
            continue;
        if (auto decoder = make_height_decoder(devices[i])) {
            station.height_decoder_ = *std::move(decoder);
            station.height_device_ = i;
        }
    }
    if (station.is_height_measured_ && !station.height_decoder_)
        return fail(Fault::User,
                    "there is no height sensor beside the pen: give the height with "
                    "--height, as millimetres or as rise, fall, arch or sway");
    return station;
}

void Station::push(std::size_t device, Timestamp received, std::span<std::byte const> report)
{
    ++counts_.reports;
    pass_time(received);
    if (device == pen_device_)
        push_pen(received, report);
    else if (height_decoder_ && device == height_device_)
        push_height(received, report);
    else
        ++counts_.ignored_reports;
}

void Station::push_pen(Timestamp received, std::span<std::byte const> report)
{
    if (is_height_measured_)
        height_monitor_.advance(received);
    auto const sample = pen_decoder_->decode(received, report);
    if (!sample)
        return count_broken(sample.error());
    if (!*sample)
        return;
    pen_silence_.heard(**sample);
    use_pen(**sample);
}

void Station::pass_time(Timestamp now)
{
    if (auto const gone = pen_silence_.leave_if_over(*pen_decoder_, now))
        use_pen(*gone);
}

void Station::use_pen(PenSample const& sample)
{
    ++counts_.pen_samples;
    pen_in_range_ = sample.in_range;
    if (auto const tip = fuser_.push(sample)) {
        builder_.push_live(*tip);
        newest_tip_ = *tip;
    }
    take_settled();
}

void Station::push_height(Timestamp received, std::span<std::byte const> report)
{
    heights_.clear();
    if (auto const decoded = height_decoder_->decode(received, report, heights_); !decoded)
        count_broken(decoded.error());
    counts_.height_samples += heights_.size();
    if (is_height_measured_)
        for (auto const& height : heights_) {
            height_monitor_.push(height);
            if (!height_monitor_.is_on_rail(height))
                fuser_.push(height);
        }
    take_settled();
}

void Station::take_settled()
{
    for (auto const& tip : fuser_.take_settled())
        if (auto stroke = builder_.push(tip))
            finish_stroke(*std::move(stroke));
}

void Station::finish()
{
    fuser_.flush();
    take_settled();
    if (auto stroke = builder_.finish())
        finish_stroke(*std::move(stroke));
}

void Station::set_tool(Timestamp time, Tool const& tool)
{
    tool_changes_.push_back({ std::max(time, tool_changes_.back().time), tool });
}

// A stroke belongs to the tool in hand when it began, though it is known to have ended only later.
Tool Station::tool_at(Timestamp time) const
{
    auto const after = std::upper_bound(
        tool_changes_.begin() + 1, tool_changes_.end(), time,
        [](Timestamp value, ToolChange const& change) { return value < change.time; });
    return std::prev(after)->tool;
}

void Station::finish_stroke(Stroke stroke)
{
    ++counts_.strokes;
    // Tool changes are stamped on arrival, tips with the tablet's latency taken off.
    DrawnStroke drawn { std::move(stroke), {}, {} };
    drawn.tool = tool_at(drawn.stroke.tips.front().time + tablet_latency_);
    auto const edits = edits_of(drawn.tool, drawn.stroke, scene_);
    if (!edits)
        drawn.refusal = edits.error().message;
    for (std::size_t i = 0; drawn.refusal.empty() && i < edits->size(); ++i) {
        auto next = apply_edit(scene_, (*edits)[i]);
        if (next)
            scene_ = *std::move(next);
        else
            drawn.refusal = next.error().message;
    }
    strokes_.push_back(std::move(drawn));
}

void Station::count_broken(Error const& error)
{
    if (counts_.broken_reports++ == 0)
        counts_.first_broken = error.message;
}

} // namespace tractus
