#include "engine/methods/construction_lines/varied_sketch.h"

#include "engine/base/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tractus::lines {

namespace {

// Amplitude of the sheet's deformation, as a share of the stem's length, for a spread of 1.
constexpr double kBend = 0.04;
// Standard deviation of a layer's number of nodes, as a share of that number, for a spread of 1.
constexpr double kNodes = 0.1;
constexpr std::size_t kWaves = 4;

// A smooth random deformation of the sheet.
class Bend {
public:
    // Makes a deformation that leaves the point `from_mm` in its place.
    Bend(Random& random, Vec2 const& from_mm, double length_mm, double amplitude)
        : from_mm_(from_mm)
        , length_mm_(length_mm)
    {
        // Minimum number of wavelengths per stem length; kMax: maximum.
        constexpr double kMin = 0.3;
        constexpr double kMax = 1.1;
        double const each = amplitude * length_mm / std::sqrt(kWaves / 2.0);
        for (auto& wave : waves_) {
            double const along = random.uniform(0, 2 * kPi);
            wave.number
                = 2 * kPi * random.uniform(kMin, kMax) * Vec2(std::cos(along), std::sin(along));
            wave.phase = random.uniform(0, 2 * kPi);
            // Drawn in a statement of its own, because compilers evaluate arguments in different
            // orders.
            double const y = random.normal();
            wave.moves_mm = each * Vec2(random.normal(), y).cwiseMin(2).cwiseMax(-2);
        }
    }

    Vec2 moved(Vec2 const& place_mm) const
    {
        Vec2 const at = (place_mm - from_mm_) / length_mm_;
        Vec2 result = place_mm;
        for (auto const& wave : waves_)
            result += (std::sin(wave.number.dot(at) + wave.phase) - std::sin(wave.phase))
                * wave.moves_mm;
        return result;
    }

private:
    struct Wave {
        Vec2 number = Vec2::Zero(); // Wave vector in radians per stem length.
        double phase = 0;
        Vec2 moves_mm = Vec2::Zero();
    };

    Vec2 from_mm_;
    double length_mm_;
    std::array<Wave, kWaves> waves_;
};

double length_of(std::vector<TipSample> const& tips)
{
    double sum_mm = 0;
    for (std::size_t i = 1; i < tips.size(); ++i)
        sum_mm += (tips[i].position_mm - tips[i - 1].position_mm).head<2>().norm();
    return sum_mm;
}

} // namespace

PenSketch varied_sketch(PenSketch sketch, scene::SourceVariation const& variation)
{
    constexpr std::uint32_t kStream = 0x6C69;
    auto const stem
        = std::find_if(sketch.lines.begin(), sketch.lines.end(), [](SketchLine const& line) {
              return line.role == Role::Stem && line.stem == 0;
          });
    auto const drawn = stem == sketch.lines.end() ? fail(Fault::User, "there is no stem")
                                                  : stem->stroke.tips.in_memory();
    if (!drawn || drawn->empty())
        return sketch;
    auto const& of_stem = stem->sheet;
    double const length_mm = of_stem.size * std::max(length_of(drawn->vector()), 1.0);
    Random random({ variation.seed, kStream + variation.stream, variation.plant });
    Bend const bend(random, of_stem.on_sheet(drawn->front().position_mm.head<2>()), length_mm,
                    kBend * variation.spread);
    for (auto& line : sketch.lines) {
        double const nodes = line.nodes * (1 + kNodes * variation.spread * random.normal());
        line.nodes = std::clamp(static_cast<int>(std::lround(nodes)), std::min(line.nodes, 1),
                                kMaxNodesInLayer);
        auto const tips = line.stroke.tips.in_memory();
        if (!tips)
            continue;
        auto moved = tips->vector();
        for (auto& tip : moved)
            tip.position_mm.head<2>()
                = line.sheet.on_tablet(bend.moved(line.sheet.on_sheet(tip.position_mm.head<2>())));
        line.stroke.tips = std::move(moved);
    }
    return sketch;
}

} // namespace tractus::lines
