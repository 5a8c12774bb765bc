#include "tests/engine/methods/leaves/drawing_hand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tractus::leaf {

namespace {

using Line = std::vector<Vec2>;

// Gives the position on a line at a distance from its beginning. The line is extended beyond both
// of its ends.
class Walk {
public:
    explicit Walk(Line const& line)
        : line_(line)
    {
        for (std::size_t i = 1; i < line.size(); ++i)
            lengths_.push_back(lengths_.back() + (line[i] - line[i - 1]).norm());
    }

    double length() const { return lengths_.back(); }

    Vec2 at(double length) const
    {
        auto const above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
        auto const i = static_cast<std::size_t>(above - lengths_.begin());
        double const share
            = (length - lengths_[i - 1]) / std::max(1e-9, lengths_[i] - lengths_[i - 1]);
        return line_[i - 1] + share * (line_[i] - line_[i - 1]);
    }

private:
    Line const& line_;
    std::vector<double> lengths_ { 0 };
};

class Drawer {
public:
    Drawer(Manner const& manner, Random& random)
        : manner_(manner)
        , random_(random)
    {
    }

    // Draws a line of the flat leaf, in millimetres. The pen begins `before_mm` before the line and
    // ends `behind_mm` behind it.
    std::vector<Vec3> draw(Line const& line, double before_mm, double behind_mm)
    {
        double const rate_hz = random_.uniform(100, 500);
        double const usual_mm_s = random_.uniform(40, 110);
        double const change_hz = random_.uniform(0.5, 2);
        Walk const walk(line);
        double const end = walk.length() + behind_mm;
        auto const waves = tremor();
        std::vector<Vec3> tips;
        double at = -before_mm;
        for (double time = 0; at < end; time += 1 / rate_hz) {
            tips.push_back(in_space(walk.at(at)) + trembling(waves, time));
            // The pen moves slowly at the beginning and at the end.
            double const slow
                = std::min({ 1.0, 0.25 + 0.1 * (at + before_mm), 0.25 + 0.1 * (end - at) });
            at += slow * usual_mm_s * (1 + 0.35 * std::sin(2 * kPi * change_hz * time)) / rate_hz;
        }
        tips.push_back(in_space(walk.at(end)) + trembling(waves, double(tips.size()) / rate_hz));
        if (random_.uniform() < 0.5)
            std::ranges::reverse(tips);
        return tips;
    }

    double miss_mm(double most) { return random_.uniform(-most, most); }

private:
    struct Wave {
        double hz = 8;
        double phase = 0;
    };
    using Waves = std::array<std::array<Wave, 6>, 3>;

    Waves tremor()
    {
        Waves waves;
        for (auto& axis : waves)
            for (auto& wave : axis)
                wave = { random_.uniform(4, 12), random_.uniform(0, 2 * kPi) };
        return waves;
    }

    Vec3 trembling(Waves const& waves, double time) const
    {
        Vec3 sum = Vec3::Zero();
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (auto const& wave : waves[axis])
                sum[static_cast<Eigen::Index>(axis)] += (axis == 2 ? 1.0 / 3 : 1.0)
                    * manner_.tremor_mm * std::sqrt(2.0 / 6)
                    * std::sin(2 * kPi * wave.hz * time + wave.phase);
        return sum;
    }

    // Converts a point of the flat leaf to space. The blade bends evenly from its base, and the
    // petiole is straight.
    Vec3 in_space(Vec2 const& at_mm) const
    {
        Vec3 at(at_mm.x(), at_mm.y(), 0);
        // In radians per millimetre.
        double const bend = radians(manner_.bend_deg) / manner_.size_mm;
        if (bend != 0 && at.y() > 0) {
            at.z() = -(1 - std::cos(bend * at.y())) / bend;
            at.y() = std::sin(bend * at.y()) / bend;
        }
        return manner_.place_mm
            + Eigen::AngleAxisd(radians(manner_.turned_deg), Vec3::UnitZ()) * at;
    }

    Manner const& manner_;
    Random& random_;
};

Line scaled(Line line, double scale)
{
    for (auto& at : line)
        at *= scale;
    return line;
}

// Rotates the points of a closed line, so that it begins at a random one.
Line turned_round(Line ring, Random& random)
{
    double const where = random.uniform();
    auto const begin = where < 0.3 ? 0
        : where < 0.5              ? ring.size() / 2
                                   : static_cast<std::size_t>(where * double(ring.size()));
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(begin), ring.end());
    ring.push_back(ring.front());
    return ring;
}

} // namespace

HandDrawing draw_by_hand(BotanicalLeaf const& leaf, Manner const& manner, Random& random)
{
    constexpr double kMiss_mm = 1;
    Drawer drawer(manner, random);
    std::vector<std::pair<std::vector<Vec3>, HandDrawing::Meant>> strokes;
    auto const add = [&](Line const& line, double before, double behind, HandDrawing::Meant meant) {
        strokes.emplace_back(drawer.draw(scaled(line, manner.size_mm), before, behind), meant);
    };
    bool const one_half = manner.outline == Manner::Outline::OneHalf;
    HandDrawing::Meant const outline { StrokeRole::Outline, nullptr };
    auto const add_half = [&](Line const& line) {
        double const behind_mm = drawer.miss_mm(kMiss_mm);
        add(line, drawer.miss_mm(kMiss_mm), behind_mm, outline);
    };
    if (manner.outline == Manner::Outline::Closed) {
        double const behind_mm = drawer.miss_mm(2);
        add(turned_round(leaf.margin(), random), 0, behind_mm, outline);
    } else {
        add_half(leaf.right);
        if (!one_half)
            add_half(leaf.left);
    }
    add({ { 0, manner.has_stalk ? -leaf.stalk : 0 }, { 0, 1 } }, 0, -random.uniform(0, 2),
        { StrokeRole::Midrib, nullptr });
    auto const add_veins = [&](std::vector<BotanicalLeaf::Vein> const& veins, StrokeRole role) {
        for (auto const& vein : veins) {
            auto const& main = vein.parent >= 0 ? leaf.mains[std::size_t(vein.parent)] : vein;
            if (one_half && main.angle_deg <= 0)
                continue;
            double const short_by = random.uniform(0, 0.1);
            add(vein.line, drawer.miss_mm(kMiss_mm),
                -short_by * manner.size_mm * (vein.line.back() - vein.line.front()).norm(),
                { role, &vein });
        }
    };
    add_veins(leaf.mains, StrokeRole::MainVein);
    add_veins(leaf.sides, StrokeRole::SideVein);
    for (std::size_t i = strokes.size(); i > 1; --i)
        std::swap(strokes[i - 1], strokes[static_cast<std::size_t>(random.uniform() * double(i))]);
    HandDrawing made;
    for (auto& [tips, meant] : strokes) {
        made.drawing.strokes.push_back(std::move(tips));
        made.meant.push_back(meant);
    }
    return made;
}

} // namespace tractus::leaf
