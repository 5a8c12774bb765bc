#include "drivers/sensors/height_frame_decoder.h"

#include "drivers/sensors/clock_map.h"
#include "drivers/sensors/height_frame_parser.h"

#include <algorithm>
#include <charconv>
#include <fmt/core.h>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace tractus::drivers {

namespace {

std::optional<std::string_view> find_title(DeviceInfo const& info)
{
    if (!info.report_descriptor.empty())
        return std::nullopt;
    for (auto const& [index, text] : info.strings)
        if (text.starts_with(kHeightSensorTitle))
            return text;
    return std::nullopt;
}

class HeightFrameDecoder final : public HeightDecoder {
public:
    explicit HeightFrameDecoder(std::uint16_t full_scale)
        : full_scale_(full_scale)
    {
    }

    std::int32_t full_scale() const override { return full_scale_; }
    HeightStreamCounts stream_counts() const override;

    using HeightDecoder::decode;
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<HeightSample>& out) override;

private:
    Result<void> use(HeightFrame const& frame, Timestamp received, std::vector<HeightSample>& out);
    ClockMap::Order count_sequence(HeightFrame const& frame);

    std::uint16_t full_scale_;
    HeightFrameParser parser_;
    // Frames of the current report. A member only to reuse its memory.
    std::vector<HeightFrame> frames_;
    ClockMap clock_;
    std::optional<std::uint16_t> last_sequence_;
    Timestamp last_time_ = Timestamp::min();
    HeightStreamCounts counts_;
};

HeightStreamCounts HeightFrameDecoder::stream_counts() const
{
    auto counts = counts_;
    counts.corrupt_frames += parser_.corrupt_frames();
    counts.garbage_bytes = parser_.garbage_bytes();
    return counts;
}

Result<void> HeightFrameDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                        std::vector<HeightSample>& out)
{
    auto const corrupt = parser_.corrupt_frames();
    auto const garbage = parser_.garbage_bytes();
    frames_.clear();
    parser_.push(report, frames_);
    Result<void> result;
    for (auto const& frame : frames_)
        if (auto used = use(frame, received, out); !used)
            result = std::move(used);
    if (parser_.corrupt_frames() > corrupt)
        return fail(Fault::Device, "height sensor: the checksum of a frame is wrong");
    if (parser_.garbage_bytes() > garbage)
        return fail(Fault::Device,
                    fmt::format("height sensor: {} bytes that belong to no frame",
                                parser_.garbage_bytes() - garbage));
    return result;
}

Result<void> HeightFrameDecoder::use(HeightFrame const& frame, Timestamp received,
                                     std::vector<HeightSample>& out)
{
    auto const readings = frame.readings();
    auto const highest = *std::max_element(readings.begin(), readings.end());
    if (highest > full_scale_ || frame.period_us == 0) {
        ++counts_.corrupt_frames;
        return fail(Fault::Device,
                    fmt::format("height sensor frame {}: {} counts every {} us, expected 0 to {} "
                                "counts",
                                frame.sequence, highest, frame.period_us, full_scale_));
    }
    ++counts_.frames;
    counts_.overruns += (frame.flags & kHeightFrameOverrun) != 0;
    counts_.reference_faults += (frame.flags & kHeightFrameReferenceFault) != 0;
    auto const order = count_sequence(frame);
    // A frame is sent when its last reading has been taken.
    auto const steps = static_cast<std::uint32_t>(frame.count - 1);
    if (!clock_.add(frame.device_us + steps * frame.period_us, received, order))
        ++counts_.clock_restarts;
    auto device_us = frame.device_us;
    for (auto const counts : readings) {
        last_time_ = std::max(clock_.host_time(device_us), last_time_ + Duration(1));
        out.push_back({ .time = last_time_, .counts = counts, .full_scale = full_scale_ });
        device_us += frame.period_us;
    }
    return {};
}

// Counts the frames missing before this one, and returns whether it is known to follow the last
// one.
ClockMap::Order HeightFrameDecoder::count_sequence(HeightFrame const& frame)
{
    // Longest step in frame numbers that the clock map cannot mistake for a restart.
    constexpr std::uint16_t kNext = 64;
    // A step of at least this size means that the frame numbers went back.
    constexpr std::uint16_t kForward = 0x8000;
    bool const is_start = (frame.flags & kHeightFrameStart) != 0 || !last_sequence_;
    if (is_start) {
        counts_.clock_restarts += last_sequence_.has_value();
        clock_.restart();
        last_sequence_ = frame.sequence;
        return ClockMap::Order::Unknown;
    }
    auto const step = static_cast<std::uint16_t>(frame.sequence - *last_sequence_);
    last_sequence_ = frame.sequence;
    if (step > 0 && step < kForward)
        counts_.lost_frames += step - 1u;
    return step > 0 && step <= kNext ? ClockMap::Order::Follows : ClockMap::Order::Unknown;
}

} // namespace

bool is_height_frame_device(DeviceInfo const& info)
{
    return find_title(info).has_value();
}

Result<std::unique_ptr<HeightDecoder>> make_height_frame_decoder(DeviceInfo const& info)
{
    auto const title = find_title(info);
    if (!title)
        return fail(Fault::User,
                    fmt::format("{} is not a height sensor of the station's own kind", info.name));
    auto const number = title->substr(kHeightSensorTitle.size());
    std::uint16_t full_scale = 0;
    auto const [end, error]
        = std::from_chars(number.data(), number.data() + number.size(), full_scale);
    if (error != std::errc() || end != number.data() + number.size() || full_scale == 0)
        return fail(Fault::Device,
                    fmt::format("{} calls itself \"{}\": expected a full scale of 1 to 65535 at "
                                "its end",
                                info.name, *title));
    return std::make_unique<HeightFrameDecoder>(full_scale);
}

} // namespace tractus::drivers
