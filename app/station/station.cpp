#include "app/station/station.h"
#include "drivers/height_decoders.h"
#include "drivers/tablets/pen_decoders.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::station {

static Bounds volume_of(StationOptions const& options)
{
    Bounds volume_mm;
    auto const T_world_tablet = calib::T_world_tablet(options.rig);
    auto const& size_mm = options.rig.tablet_size_mm;
    for (double const x : { 0.0, size_mm.x() })
        for (double const y : { 0.0, size_mm.y() })
            volume_mm.add(T_world_tablet * Vec3(x, y, 0));
    auto const heights = calib::calibrated_heights(options.rig);
    bool const is_known = heights && !options.scripted_height;
    volume_mm.min_mm.z() = is_known ? heights->low_mm : 0;
    volume_mm.max_mm.z() = is_known ? heights->high_mm : scene::DrawingVolume().height_mm;
    return volume_mm;
}

static tools::Tool first_tool(StationOptions const& options)
{
    if (options.tool)
        return *options.tool;
    return options.tools.empty() ? tools::Tool() : tools::Tool(*options.tools.front());
}

static bool has_options(tools::ToolKind const& kind)
{
    return !tools::word_settings(tools::Tool(kind)).empty()
        || !tools::number_settings(tools::Tool(kind)).empty();
}

// Kinds of tools that the pen's other end uses with the options last chosen for the kind.
static std::vector<tools::ToolKind const*> kinds_to_remember(tools::ToolKinds tools)
{
    std::vector<tools::ToolKind const*> kinds;
    for (auto const* const tool : tools) {
        auto const& [kind, options] = tool->other_end;
        if (kind && !options && has_options(*kind)
            && std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
            kinds.push_back(kind);
    }
    return kinds;
}

Station::Station(StationOptions const& options)
    : height_monitor_(options.rig)
    , volume_mm_(volume_of(options))
    , height_model_(options.rig.height_model)
    , is_height_measured_(!options.scripted_height)
    , is_height_watched_(is_height_measured_ && options.is_height_watched)
    , tablet_latency_(options.rig.tablet_latency)
    , sample_times_(options.rig.sample_times)
    , nib_(options.rig.nib)
    , tool_changes_ { { Timestamp::min(), first_tool(options) } }
    , remembered_kinds_(kinds_to_remember(options.tools))
    , selected_tool_(first_tool(options))
    , tools_(options.tools)
    , layers_(options.layers)
    , curves_(options.curves)
    , min_extents_(options.min_extents)
{
}

Result<Station> Station::create(std::span<drivers::DeviceInfo const> devices,
                                StationOptions const& options)
{
    Station station(options);
    TRY(station.add_pens(devices, options));
    for (std::size_t i = 0; i < devices.size() && !station.height_decoder_; ++i) {
        if (station.find_pen(i))
            continue;
        if (auto decoder = drivers::make_height_decoder(devices[i])) {
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

Result<void> Station::add_pens(std::span<drivers::DeviceInfo const> devices,
                               StationOptions const& options)
{
    std::string reasons;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        auto decoder = drivers::make_pen_decoder(devices[i]);
        if (!decoder) {
            reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", decoder.error().message);
            continue;
        }
        auto rig = options.rig;
        auto const& traits = (*decoder)->traits();
        Vec2 scale = Vec2::Ones();
        if (!pens_.empty())
            rig.tablet_size_mm = traits.size_mm;
        else if (rig.surface_mm && traits.is_size_assumed)
            scale = rig.surface_mm->cwiseQuotient(traits.size_mm);
        pens_.push_back({ .device = i,
                          .decoder = *std::move(decoder),
                          .silence = {},
                          .scale = scale,
                          .fuser = options.scripted_height
                              ? calib::Fuser(rig, *options.scripted_height)
                              : calib::Fuser(rig) });
    }
    if (!pens_.empty())
        return {};
    return fail(Fault::User,
                fmt::format("there is no pen to draw with: {}",
                            reasons.empty() ? "no device at all" : reasons));
}

Station::Pen* Station::find_pen(std::size_t device)
{
    auto const found = std::find_if(pens_.begin(), pens_.end(),
                                    [&](Pen const& pen) { return pen.device == device; });
    return found == pens_.end() ? nullptr : &*found;
}

void Station::push(std::size_t device, Timestamp received, std::span<std::byte const> report)
{
    counts_.reports += !report.empty();
    pass_time(received);
    if (auto* const pen = find_pen(device))
        push_pen(*pen, received, report);
    else if (height_decoder_ && device == height_device_)
        push_height(received, report);
    else
        counts_.ignored_reports += !report.empty();
}

void Station::push_pen(Pen& pen, Timestamp received, std::span<std::byte const> report)
{
    if (report.empty()) {
        if (auto const gone = pen.decoder->leave(received))
            use_pen(pen, *gone);
        return;
    }
    new_pens_.clear();
    if (auto const decoded = pen.decoder->decode(received, report, new_pens_); !decoded)
        count_broken(decoded.error());
    for (auto const& sample : new_pens_) {
        pen.silence.heard(sample);
        use_pen(pen, sample);
    }
}

void Station::pass_time(Timestamp now)
{
    if (is_height_watched_)
        height_monitor_.advance(now);
    for (auto& pen : pens_)
        if (auto const gone = pen.silence.leave_after_silence(*pen.decoder, now)) {
            pen.fuser.forget_silence();
            use_pen(pen, *gone);
        }
}

void Station::use_pen(Pen& pen, drivers::PenSample const& decoded)
{
    auto sample = decoded;
    sample.position_mm = sample.position_mm.cwiseProduct(pen.scale);
    ++counts_.pen_samples;
    pen_in_range_ = sample.in_range;
    if (!is_height_there_)
        return; // The sample is ignored: without the height sensor, the pen's height is unknown.
    pen.fuser.set_may_leave_silently(pen.decoder->silence_limit().has_value());
    auto const tip = pen.fuser.push(sample);
    follow_surface(pen); // Applies height readings up to this pen sample.
    pen.last_sample = sample;
    if (tip) {
        follow_touch(pen, *tip);
        pen.builder.push_live(*tip);
        newest_tip_ = *tip;
        keep_moment(pen, sample, *tip);
    }
    take_settled(pen);
}

// Time stamp for a tool change that must precede this tip. Like that of all tool changes, it is a
// time of arrival. If sample times are smoothed, it is half-way between this tip and the last one,
// so that a recording can round it to microseconds.
Timestamp Station::change_before(TipSample const& tip, std::optional<Timestamp> last_tip) const
{
    bool const is_exact = sample_times_ == calib::SampleTimes::AsArrived || !last_tip;
    return (is_exact ? tip.time : *last_tip + (tip.time - *last_tip) / 2) + tablet_latency_;
}

// Decides at the start of a touch whether the touch draws or operates the window's controls.
void Station::follow_touch(Pen& pen, TipSample const& tip)
{
    auto const began = change_before(tip, std::exchange(pen.last_tip, tip.time));
    if (tip.touching == pen.touches_since.has_value())
        return;
    if (!tip.touching) {
        pen.touches_since.reset();
        if (is_pressing())
            change_tool(began, selected_tool_);
        return;
    }
    pen.touches_since = began;
    Vec2 const place_mm = tip.position_mm.head<2>();
    if (std::any_of(pressing_areas_.begin(), pressing_areas_.end(),
                    [&](Eigen::AlignedBox2d const& area) { return area.contains(place_mm); }))
        change_tool(began, pressing());
}

void Station::convert_touch_to_press()
{
    for (auto const& pen : pens_)
        if (pen.touches_since && !is_pressing())
            change_tool(*pen.touches_since, pressing());
}

void Station::keep_moment(Pen const& pen, drivers::PenSample const& sample, TipSample const& tip)
{
    // If nobody fetches the moments often enough, the older half of them is dropped.
    if (moments_.size() == kMaxMoments)
        moments_.erase(moments_.begin(), moments_.begin() + kMaxMoments / 2);
    moments_.push_back({ .in_range = sample.in_range,
                         .touching = tip.touching,
                         .eraser = tip.eraser,
                         .pressing = tip.touching && is_pressing(),
                         .barrel = sample.in_range && (sample.buttons & 1) != 0,
                         .pressure = tip.pressure,
                         .position_mm = tip.position_mm,
                         .time = tip.time,
                         .tilt_rad = tip.tilt_rad,
                         .device = pen.device });
}

void Station::push_height(Timestamp received, std::span<std::byte const> report)
{
    if (report.empty())
        return end_with_height();
    heights_.clear();
    if (auto const decoded = height_decoder_->decode(received, report, heights_); !decoded)
        count_broken(decoded.error());
    counts_.height_samples += heights_.size();
    is_height_there_ |= !heights_.empty();
    if (is_height_measured_)
        for (auto const& height : heights_) {
            if (is_height_watched_)
                height_monitor_.push(height);
            if (height_monitor_.is_on_rail(height)) {
                for (auto& pen : pens_)
                    pen.fuser.miss_height(height.time);
                continue;
            }
            auto const height_mm = calib::height_mm(height_model_, height.counts);
            if (height_mm && !height_monitor_.doubts_last()) {
                read_height_mm_ = height_mm;
                read_height_time_ = height.time;
            }
            for (auto& pen : pens_) {
                pen.fuser.push(height);
                follow_surface(pen);
            }
        }
    for (auto& pen : pens_)
        take_settled(pen);
}

// Moves a touching pen along with the surface while the pen sends no reports.
void Station::follow_surface(Pen& pen)
{
    for (auto const& tip : pen.fuser.take_live()) {
        ++counts_.tips_in_silence;
        pen.builder.push_live(tip);
        newest_tip_ = tip;
        keep_moment(pen, pen.last_sample, tip);
    }
}

// Handles the loss of the height sensor. Unfinished strokes end with the sensor's last readings.
// Further pen samples are ignored, because their height is unknown.
void Station::end_with_height()
{
    if (!is_height_measured_)
        return;
    is_height_there_ = false;
    height_monitor_.restart_after_reconnection();
    for (auto& pen : pens_) {
        finish(pen);
        pen.fuser.forget_heights();
    }
}

void Station::take_settled(Pen& pen)
{
    for (auto const& tip : pen.fuser.take_settled())
        if (auto stroke = pen.builder.push(tip))
            finish_stroke(*std::move(stroke));
}

void Station::finish(Pen& pen)
{
    pen.fuser.flush();
    take_settled(pen);
    if (auto stroke = pen.builder.finish())
        finish_stroke(*std::move(stroke));
}

void Station::finish()
{
    for (auto& pen : pens_)
        finish(pen);
}

std::vector<std::vector<TipSample>> Station::inks() const
{
    std::vector<std::vector<TipSample>> inks;
    if (is_pressing())
        return inks;
    for (auto const& pen : pens_)
        if (auto ink = pen.builder.ink(); !ink.empty())
            inks.push_back(std::move(ink));
    return inks;
}

std::optional<double> Station::surface_height_mm() const
{
    if (is_height_measured_)
        return read_height_mm_;
    return newest_tip_ ? std::optional(newest_tip_->position_mm.z()) : std::nullopt;
}

bool Station::pen_rests() const
{
    constexpr Duration kHandAtRest = std::chrono::milliseconds(50);
    return read_height_mm_ && newest_tip_ && read_height_time_ - newest_tip_->time > kHandAtRest;
}

calib::FuserCounts Station::fuser_counts() const
{
    // Counts of height readings are taken from the first pen, because all pens receive the same
    // heights.
    auto sum = pens_.front().fuser.counts();
    for (std::size_t i = 1; i < pens_.size(); ++i) {
        auto const& counts = pens_[i].fuser.counts();
        sum.pens += counts.pens;
        sum.settled += counts.settled;
        sum.pens_without_height += counts.pens_without_height;
    }
    return sum;
}

void Station::set_tool(Timestamp time, tools::Tool const& tool)
{
    if (tool.is_done_at_once()) {
        new_tool_changes_.push_back({ time, tool });
        ++counts_.strokes;
        strokes_.push_back({ {}, tool });
        return;
    }
    bool const is_press = tool == pressing();
    if (!is_press)
        selected_tool_ = tool;
    bool const touch_goes_on = std::any_of(
        pens_.begin(), pens_.end(), [](Pen const& pen) { return pen.touches_since.has_value(); });
    // A tool that was chosen by pressing a control takes effect when the press ends.
    if (is_press || !is_pressing() || !touch_goes_on)
        change_tool(time, tool);
}

void Station::change_tool(Timestamp time, tools::Tool const& tool)
{
    // Removes tool changes that are too old to affect an unfinished stroke.
    constexpr Duration kLongestStroke = std::chrono::hours(1);
    while (tool_changes_.size() > 1 && tool_changes_[1].time < time - kLongestStroke) {
        forget(tool_changes_.front().tool);
        tool_changes_.erase(tool_changes_.begin());
    }
    tool_changes_.push_back({ std::max(time, tool_changes_.back().time), tool });
    new_tool_changes_.push_back(tool_changes_.back());
}

void Station::forget(tools::Tool const& tool)
{
    auto const is_same = [&](tools::Tool const& other) { return &other.kind() == &tool.kind(); };
    forgotten_.erase(std::remove_if(forgotten_.begin(), forgotten_.end(), is_same),
                     forgotten_.end());
    if (std::find(remembered_kinds_.begin(), remembered_kinds_.end(), &tool.kind())
        != remembered_kinds_.end())
        forgotten_.push_back(tool);
}

tools::Tool Station::chosen_before(tools::ToolKind const& kind,
                                   ToolChanges::const_iterator end) const
{
    while (end != tool_changes_.begin())
        if (auto const& tool = (--end)->tool; &tool.kind() == &kind)
            return tool;
    for (auto const& tool : forgotten_)
        if (&tool.kind() == &kind)
            return tool;
    return tools::Tool(kind);
}

tools::Tool Station::other_end_of(tools::Tool const& tool, ToolChanges::const_iterator before) const
{
    auto const& [kind, options] = tool.kind().other_end;
    if (!kind)
        return tool;
    return options ? tools::Tool(*kind, options()) : chosen_before(*kind, before);
}

std::vector<tools::Tool> Station::remembered() const
{
    std::vector<tools::Tool> tools;
    for (auto const* const kind : remembered_kinds_) {
        // If no tool of this kind was ever selected, the tool bar must not show the kind's method
        // as the one last used in its group.
        bool const was_selected
            = std::any_of(tool_changes_.begin(), tool_changes_.end(),
                          [&](ToolChange const& change) { return &change.tool.kind() == kind; })
            || std::any_of(forgotten_.begin(), forgotten_.end(),
                           [&](tools::Tool const& tool) { return &tool.kind() == kind; });
        if (was_selected)
            tools.push_back(chosen_before(*kind, tool_changes_.end()));
    }
    return tools;
}

std::vector<tools::Tool> Station::tools_for_continuation() const
{
    std::vector<tools::Tool> tools;
    for (auto& tool : remembered())
        if (tool != tools::Tool(tool.kind()) && &tool.kind() != &selected_tool_.kind())
            tools.push_back(std::move(tool));
    tools.push_back(selected_tool_);
    return tools;
}

// A stroke belongs to the tool that was selected when the stroke began, although its end becomes
// known later.
tools::Tool Station::meaning_of(std::vector<TipSample> const& tips) const
{
    if (tips.empty())
        return selected_tool_;
    // Tool changes have times of arrival, while tips have earlier times: without the tablet's
    // latency.
    auto const after = std::upper_bound(
        tool_changes_.begin() + 1, tool_changes_.end(), tips.front().time + tablet_latency_,
        [](Timestamp value, ToolChange const& change) { return value < change.time; });
    auto const& tool = std::prev(after)->tool;
    return tips.front().eraser ? other_end_of(tool, after) : tool;
}

void Station::finish_stroke(Stroke stroke)
{
    auto const tool = meaning_of(stroke.tips);
    if (tool == pressing())
        return;
    if (tools::extent_mm(stroke) < tools::min_extent_mm(min_extents_, tool.kind())) {
        ++counts_.dabs;
        last_dab_ = &tool.kind();
        return;
    }
    ++counts_.strokes;
    strokes_.push_back({ std::move(stroke), tool });
}

void Station::count_broken(Error const& error)
{
    if (counts_.broken_reports++ == 0)
        counts_.first_broken = error.message;
}

} // namespace tractus::station
