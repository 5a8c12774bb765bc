#include "sim/simulated_tablet.h"

#include "calib/lean_track.h"
#include "engine/base/check.h"
#include "engine/base/random.h"
#include "sim/random_streams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace tractus::sim {

namespace {

constexpr double kCountsPerMm = 100;
constexpr double kMaxPressure = 8191;
constexpr double kMaxTilt_deg = 90;
constexpr std::uint8_t kPenReportId = 2;
constexpr std::size_t kReportSize = 10;

// Flags of PenReport::bits.
constexpr std::uint8_t kTip = 1 << 0;
constexpr std::uint8_t kEraser = 1 << 3;
constexpr std::uint8_t kInvert = 1 << 4;
constexpr std::uint8_t kInRange = 1 << 5;

// Contents of one report, in the device's units.
struct PenReport {
    std::uint8_t bits = 0;
    std::uint16_t x = 0;
    std::uint16_t y = 0;
    std::uint16_t pressure = 0;
    std::int8_t tilt_x = 0;
    std::int8_t tilt_y = 0;
};

void append(std::vector<std::byte>& bytes, std::initializer_list<int> values)
{
    for (int const value : values)
        bytes.push_back(static_cast<std::byte>(value));
}

// Appends an axis: its usage, its logical and physical maximum in 4 bytes each, and 16 bits of
// input. The physical unit is 0.01 mm, so both maxima are equal.
void append_axis(std::vector<std::byte>& bytes, int usage, int counts)
{
    int const low = counts & 0xff;
    int const high = counts >> 8;
    append(bytes, { 0x09, usage, 0x27, low, high, 0, 0, 0x47, low, high, 0, 0, 0x81, 0x02 });
}

std::vector<std::byte> report_descriptor(Vec2 const& size_mm)
{
    Vec2 const counts = size_mm * kCountsPerMm;
    CHECK(counts.minCoeff() > 0 && counts.maxCoeff() <= 65535);
    std::vector<std::byte> bytes;
    // Digitizers page, Pen, application collection.
    append(bytes, { 0x05, 0x0d, 0x09, 0x02, 0xa1, 0x01 });
    append(bytes, { 0x85, kPenReportId });
    append(bytes, { 0x09, 0x20, 0xa1, 0x00 }); // Stylus, physical collection.
    // Usages: tip switch, barrel switch, second barrel switch.
    append(bytes, { 0x09, 0x42, 0x09, 0x44, 0x09, 0x5a });
    append(bytes, { 0x09, 0x45, 0x09, 0x3c, 0x09, 0x32 }); // Usages: eraser, invert, in range.
    append(bytes, { 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x06, 0x81, 0x02 });
    append(bytes, { 0x95, 0x02, 0x81, 0x03 });              // Padding of 2 bits.
    append(bytes, { 0x05, 0x01, 0x75, 0x10, 0x95, 0x01 });  // Generic Desktop page, 16 bits each.
    append(bytes, { 0x65, 0x11, 0x55, 0x0d, 0x35, 0x00 });  // Unit: centimetres, 10^-3, from 0.
    append_axis(bytes, 0x30, static_cast<int>(counts.x())); // The X axis.
    append_axis(bytes, 0x31, static_cast<int>(counts.y())); // The Y axis.
    // Digitizers page, no unit.
    append(bytes, { 0x05, 0x0d, 0x65, 0x00, 0x55, 0x00, 0x45, 0x00 });
    append(bytes, { 0x09, 0x30, 0x26, 0xff, 0x1f, 0x75, 0x0d, 0x81, 0x02 }); // Tip pressure.
    append(bytes, { 0x75, 0x03, 0x81, 0x03 });                               // Padding of 3 bits.
    append(bytes, { 0x09, 0x3d, 0x09, 0x3e }); // X tilt and Y tilt, -90 to 90 degrees.
    append(bytes, { 0x15, 0xa6, 0x25, 0x5a, 0x35, 0xa6, 0x45, 0x5a, 0x65, 0x14 });
    append(bytes, { 0x75, 0x08, 0x95, 0x02, 0x81, 0x02 });
    append(bytes, { 0xc0, 0xc0 });
    return bytes;
}

drivers::RawReport encode(PenReport const& report, Timestamp received)
{
    drivers::RawReport raw { .received = received, .size = kReportSize };
    auto const put = [&](std::size_t at, int value) {
        raw.storage[at] = static_cast<std::byte>(value & 0xff);
    };
    put(0, kPenReportId);
    put(1, report.bits);
    put(2, report.x);
    put(3, report.x >> 8);
    put(4, report.y);
    put(5, report.y >> 8);
    put(6, report.pressure);
    put(7, report.pressure >> 8);
    put(8, report.tilt_x);
    put(9, report.tilt_y);
    return raw;
}

std::uint8_t bits_of(HandState const& state)
{
    unsigned bits = kInRange;
    if (state.eraser)
        bits |= kInvert;
    if (state.touching)
        bits |= state.eraser ? kEraser : kTip;
    return static_cast<std::uint8_t>(bits);
}

std::int8_t tilt_deg(double tilt_rad)
{
    return static_cast<std::int8_t>(
        std::lround(std::clamp(degrees(tilt_rad), -kMaxTilt_deg, kMaxTilt_deg)));
}

PenReport quantise(HandState const& state, Vec2 const& place_mm, Vec2 const& size_mm)
{
    return {
        .bits = bits_of(state),
        .x = static_cast<std::uint16_t>(std::lround(place_mm.x() * kCountsPerMm)),
        .y = static_cast<std::uint16_t>(std::lround((size_mm.y() - place_mm.y()) * kCountsPerMm)),
        .pressure = static_cast<std::uint16_t>(std::lround(state.pressure * kMaxPressure)),
        .tilt_x = tilt_deg(state.tilt_rad.x()),
        .tilt_y = tilt_deg(-state.tilt_rad.y()),
    };
}

} // namespace

drivers::DeviceInfo simulated_tablet_info(Vec2 const& size_mm)
{
    return {
        .name = "Simulated pen tablet",
        .location = "simulated",
        .physical_path = "simulated/tablet",
        .bus = 6,
        .vendor_id = 0,
        .product_id = 1,
        .report_descriptor = report_descriptor(size_mm),
    };
}

drivers::RawReport simulated_tablet_report(TabletPen const& pen, Vec2 const& size_mm,
                                           Timestamp received)
{
    HandState state;
    state.touching = pen.touching;
    state.pressure = pen.pressure;
    Vec2 const place_mm = pen.place_mm.cwiseMax(0).cwiseMin(size_mm);
    auto report = quantise(state, place_mm, size_mm);
    if (!pen.in_range)
        report.bits = 0;
    return encode(report, received);
}

SimulatedTablet simulate_tablet(Hand const& hand, RigGeometry const& geometry,
                                TabletOptions const& options)
{
    SimulatedTablet tablet;
    tablet.device.info = simulated_tablet_info(geometry.tablet_size_mm);
    auto const T_tablet_world = sim::T_tablet_world(geometry);
    DeviceClock clock(options.timing, { .seed = options.seed, .stream = kTabletTimingStream });
    Random tilt_noise({ .seed = options.seed, .stream = kTiltNoiseStream });
    PenReport last;
    for (auto now = clock.next_instant(); now < hand.end(); now = clock.next_instant()) {
        auto state = hand.at(now);
        Vec2 place_mm = (T_tablet_world * state.position_mm).head<2>();
        if (geometry.coil_height_mm != 0)
            place_mm += geometry.coil_height_mm * calib::lean_of(state.tilt_rad);
        if (options.tilt_noise_deg > 0)
            for (double& angle_rad : state.tilt_rad)
                angle_rad += radians(options.tilt_noise_deg) * tilt_noise.normal();
        bool const on_tablet = (place_mm.array() >= 0).all()
            && (place_mm.array() <= geometry.tablet_size_mm.array()).all();
        bool const was_in_range = last.bits & kInRange;
        if (state.in_range && on_tablet) {
            last = quantise(state, place_mm, geometry.tablet_size_mm);
        } else if (was_in_range) {
            last.bits = 0;
            last.pressure = 0;
        } else {
            continue;
        }
        tablet.device.reports.push_back(encode(last, clock.arrival(now)));
        tablet.truth.push_back(
            { .time = now, .position_mm = state.position_mm, .touching = state.touching });
    }
    return tablet;
}

} // namespace tractus::sim
