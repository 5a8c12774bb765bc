#include "sim/unkindness.h"

#include "engine/base/random.h"
#include "sim/path.h"
#include "sim/random_streams.h"
#include "sim/rig_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::sim {

namespace {

using namespace std::chrono_literals;

using Reports = std::vector<drivers::RawReport>;

// Byte of a tablet report that contains the tip, eraser and in-range bits.
constexpr std::size_t kPenBits = 1;

bool has_same_bytes(drivers::RawReport const& a, drivers::RawReport const& b)
{
    return std::ranges::equal(a.bytes(), b.bytes());
}

void leave_out_repeated(Reports& reports)
{
    reports.erase(std::unique(reports.begin(), reports.end(), has_same_bytes), reports.end());
}

void skip_some(Reports& reports, double share, Random& random)
{
    Reports sent;
    for (auto const& report : reports) {
        bool const is_event
            = sent.empty() || sent.back().storage[kPenBits] != report.storage[kPenBits];
        if (random.uniform() >= share || is_event)
            sent.push_back(report);
    }
    reports = std::move(sent);
}

// Returns the end of the period that contains `time`; periods of this length start at time 0.
Timestamp end_of_period(Timestamp time, Duration length)
{
    auto const since = time.time_since_epoch();
    return Timestamp((since / length + 1) * length);
}

void batch(Reports& reports, Duration period)
{
    for (auto& report : reports)
        report.received = end_of_period(report.received, period);
}

void make_wrong(Reports& reports, std::int32_t full_scale, Unkindness const& unkindness,
                Random& random)
{
    constexpr double kMinOff = 100;
    auto next = Timestamp(unkindness.wrong_period);
    int wrong = 0;
    for (auto& report : reports) {
        if (report.received >= next) {
            wrong = 1 + static_cast<int>(random.uniform() * unkindness.most_wrong_in_a_row);
            next = report.received + unkindness.wrong_period;
        }
        if (wrong == 0)
            continue;
        --wrong;
        int const counts = std::to_integer<int>(report.storage[1])
            | std::to_integer<int>(report.storage[2]) << 8;
        double const off = random.uniform(kMinOff, full_scale / 2.0);
        auto const said = static_cast<int>(counts > full_scale / 2 ? counts - off : counts + off);
        report.storage[1] = static_cast<std::byte>(said & 0xff);
        report.storage[2] = static_cast<std::byte>(said >> 8);
    }
}

void stall(Reports& reports, Unkindness const& unkindness)
{
    constexpr std::size_t kKeptByKernel = 64; // Size of hidraw's buffer; later reports are lost.
    Reports read;
    std::size_t kept = 0; // Number of reports kept during the present stall.
    std::optional<Timestamp> last_end;
    for (auto report : reports) {
        auto const end = end_of_period(report.received, unkindness.stall_period);
        if (report.received >= end - unkindness.stall) {
            kept = last_end == end ? kept + 1 : 1;
            last_end = end;
            if (kept > kKeptByKernel)
                continue;
            report.received = end;
        }
        read.push_back(report);
    }
    reports = std::move(read);
}

// Returns a horizontal half circle that continues the stroke. `side` is 1 for a hook to the left,
// -1 for a hook to the right.
std::vector<Vec3> hook(Path const& path, double length_mm, double side)
{
    constexpr int kPieces = 6;
    Vec3 place_mm = path.points_mm().back();
    Vec3 const direction = path.direction(path.length_mm());
    double heading_rad = std::atan2(direction.y(), direction.x());
    std::vector<Vec3> points;
    for (int i = 0; i < kPieces; ++i) {
        heading_rad += side * kPi / kPieces;
        place_mm += length_mm / kPieces * Vec3(std::cos(heading_rad), std::sin(heading_rad), 0);
        points.push_back(place_mm);
    }
    return points;
}

} // namespace

Unkindness all_unkindness(std::uint64_t seed)
{
    return { .seed = seed,
             .min_hook_mm = 0.5,
             .most_hook_mm = 2,
             .dab_share = 0.35,
             .tremor_mm = 0.3,
             .reports_changes_only = true,
             .skipped_share = 0.2,
             .batch_period = 15ms,
             .wrong_period = 300ms,
             .stall = 80ms,
             .stall_period = 700ms };
}

void add_hooks(std::vector<HandStroke>& strokes, RigGeometry const& geometry,
               Unkindness const& unkindness)
{
    Random random({ .seed = unkindness.seed, .stream = kHookStream });
    for (auto& stroke : strokes) {
        double const length_mm = random.uniform(unkindness.min_hook_mm, unkindness.most_hook_mm);
        double const side = random.uniform() < 0.5 ? -1 : 1;
        if (length_mm <= 0)
            continue;
        auto points = stroke.path.points_mm();
        auto const added = hook(stroke.path, length_mm, side);
        points.insert(points.end(), added.begin(), added.end());
        Path const hooked(points);
        if (check_reach(geometry, hooked))
            stroke.path = hooked;
    }
}

void add_dabs(std::vector<HandStroke>& strokes, RigGeometry const& geometry,
              Unkindness const& unkindness)
{
    constexpr double kShareOfShort = 0.85;
    constexpr double kFarthest_mm = 2; // Greatest distance of a dab from the start of the stroke.
    Random random({ .seed = unkindness.seed, .stream = kDabStream });
    std::vector<HandStroke> all;
    for (auto const& stroke : strokes) {
        bool const is_short = random.uniform() < kShareOfShort;
        double const length_mm = is_short ? random.uniform(0.2, 2) : random.uniform(2, 4.5);
        double const place_rad = random.uniform(0, 2 * kPi);
        double const heading_rad = random.uniform(0, 2 * kPi);
        double const away_mm = random.uniform(0.2, kFarthest_mm);
        if (random.uniform() < unkindness.dab_share) {
            Vec3 const from_mm = stroke.path.points_mm().front()
                + away_mm * Vec3(std::cos(place_rad), std::sin(place_rad), 0);
            Vec3 const to_mm
                = from_mm + length_mm * Vec3(std::cos(heading_rad), std::sin(heading_rad), 0);
            HandStroke const dab { .path = Path({ from_mm, to_mm }),
                                   .speed_mm_s = stroke.speed_mm_s,
                                   .pressure = stroke.pressure / 2,
                                   .eraser = stroke.eraser,
                                   .is_dab = true };
            if (check_reach(geometry, dab.path))
                all.push_back(dab);
        }
        all.push_back(stroke);
    }
    strokes = std::move(all);
}

void set_tremor(HandOptions& options, Unkindness const& unkindness)
{
    if (unkindness.tremor_mm <= 0)
        return;
    options.plane_tremor_mm = unkindness.tremor_mm;
    options.min_tremor_hz = 8;
    options.most_tremor_hz = 12;
}

void make_unkind(SimulatedRun& run, Unkindness const& unkindness)
{
    Random random({ .seed = unkindness.seed, .stream = kUnkindnessStream });
    auto& pen = run.tablet.reports;
    if (unkindness.reports_changes_only)
        leave_out_repeated(pen);
    if (unkindness.skipped_share > 0)
        skip_some(pen, unkindness.skipped_share, random);
    if (unkindness.batch_period > Duration(0))
        batch(pen, unkindness.batch_period);
    if (unkindness.wrong_period > Duration(0))
        make_wrong(run.height.reports, run.rig.full_scale_counts, unkindness, random);
    if (unkindness.stall > Duration(0) && unkindness.stall_period > Duration(0))
        for (auto* const device : { &run.tablet, &run.height })
            stall(device->reports, unkindness);
}

} // namespace tractus::sim
