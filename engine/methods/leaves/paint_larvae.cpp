#include "engine/methods/leaves/paint_larvae.h"

#include "engine/base/random.h"
#include "engine/methods/leaves/paint_noise.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tractus::leaf {

namespace {

constexpr std::uint32_t kLarvaStream = 3;

class Larva {
public:
    Larva(LarvaGround const& ground, Larvae const& larvae, std::span<float> alpha,
          std::span<float> eaten)
        : ground_(ground)
        , larvae_(larvae)
        , side_(ground.side)
        , alpha_(alpha)
        , eaten_(eaten)
    {
    }

    void go(std::uint64_t seed, int number)
    {
        Random random({ .seed = seed,
                        .stream = kLarvaStream,
                        .substream = static_cast<std::uint32_t>(number) });
        Vec2 at = find_start(random);
        double heading = random.uniform(0, 2 * kPi);
        double const radius
            = random.uniform(larvae_.min_radius, larvae_.most_radius) * double(side_);
        auto const bites
            = static_cast<int>(random.uniform(larvae_.min_bites, larvae_.most_bites + 1));
        for (int i = 0; i < bites; ++i) {
            bite(at, radius, grid_hash(seed, number, i));
            heading += radians(25) * random.normal();
            if (!move(at, heading, radius, i > 0))
                return;
        }
    }

    void mine(std::uint64_t seed, int number, std::span<float> mined) const
    {
        constexpr int kSteps = 110;
        // Half-width of the mine at its end, as a share of the picture's side.
        constexpr double kLastShare = 0.011;
        Random random({ .seed = seed,
                        .stream = kLarvaStream,
                        .substream = static_cast<std::uint32_t>(number) });
        Vec2 at = find_start(random);
        double heading = random.uniform(0, 2 * kPi);
        for (int i = 0; i < kSteps; ++i) {
            double const radius = kLastShare * side_ * (0.25 + 0.75 * i / kSteps);
            mark(at, radius, mined);
            heading += radians(20) * random.normal();
            if (!move(at, heading, radius, i > 0))
                return;
        }
    }

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_)
            + static_cast<std::size_t>(x);
    }
    bool is_inside(Vec2 const& at) const
    {
        return at.x() >= 0 && at.y() >= 0 && at.x() < side_ && at.y() < side_;
    }
    std::size_t pixel(Vec2 const& at) const
    {
        return index(static_cast<int>(at.x()), static_cast<int>(at.y()));
    }
    bool is_spared(Vec2 const& at) const
    {
        return is_inside(at) && ground_.protection[pixel(at)] > 0.5f;
    }
    bool is_on_leaf(Vec2 const& at) const
    {
        return is_inside(at) && ground_.coverage[pixel(at)] > 0.5f;
    }
    bool is_free(Vec2 const& at, double radius) const
    {
        for (int i = 0; i < 8; ++i) {
            double const angle = 0.25 * kPi * i;
            if (is_spared(at + 0.5 * radius * Vec2(std::cos(angle), std::sin(angle))))
                return false;
        }
        return !is_spared(at);
    }

    // Returns a random starting point for a larva: on the leaf or, more often, at its margin.
    Vec2 find_start(Random& random) const
    {
        Vec2 at(0, 0);
        for (int i = 0; i < 200 && (!is_on_leaf(at) || !is_free(at, 0.04 * side_)); ++i)
            at = { random.uniform(0, side_), random.uniform(0, side_) };
        double const angle = random.uniform(0, 2 * kPi);
        if (random.uniform() < 0.7)
            while (is_on_leaf(at))
                at += 0.5 * Vec2(std::cos(angle), std::sin(angle));
        return at;
    }

    // Moves a larva straight ahead or, if spared veins block the way, with the smallest possible
    // turn. Returns false if all directions are blocked.
    bool move(Vec2& at, double& heading, double radius, bool must_stay) const
    {
        for (int turn = 0; turn <= 16; ++turn) {
            double const aside = radians(20) * ((turn + 1) / 2) * (turn % 2 == 0 ? 1 : -1);
            double const way = heading + aside;
            Vec2 const next = at + 0.7 * radius * Vec2(std::cos(way), std::sin(way));
            if (!is_free(next, radius) || (must_stay && !is_on_leaf(next)))
                continue;
            at = next;
            heading = way;
            return true;
        }
        return false;
    }

    void mark(Vec2 const& at, double radius, std::span<float> marks) const
    {
        double const far = radius + 1;
        int const x0 = std::clamp(static_cast<int>(at.x() - far), 0, side_);
        int const x1 = std::clamp(static_cast<int>(at.x() + far) + 1, 0, side_);
        int const y0 = std::clamp(static_cast<int>(at.y() - far), 0, side_);
        int const y1 = std::clamp(static_cast<int>(at.y() + far) + 1, 0, side_);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                double const inside
                    = std::clamp(radius - (Vec2(x + 0.5, y + 0.5) - at).norm() + 0.5, 0.0, 1.0);
                auto const i = index(x, y);
                marks[i] = std::max(
                    marks[i], static_cast<float>(inside * (1 - double(ground_.protection[i]))));
            }
    }

    double rim() const { return std::max(1.5, 0.008 * side_); }

    void bite(Vec2 const& at, double radius, double wobble)
    {
        double const far = 1.2 * radius + rim() + 1;
        int const x0 = std::clamp(static_cast<int>(at.x() - far), 0, side_);
        int const x1 = std::clamp(static_cast<int>(at.x() + far) + 1, 0, side_);
        int const y0 = std::clamp(static_cast<int>(at.y() - far), 0, side_);
        int const y1 = std::clamp(static_cast<int>(at.y() + far) + 1, 0, side_);
        std::complex<double> const turn = std::polar(0.1, 7 * wobble);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                Vec2 const away = Vec2(x + 0.5, y + 0.5) - at;
                double const distance = away.norm();
                if (distance < far)
                    bite_pixel(index(x, y), away, distance, { radius, turn });
            }
    }

    struct Bite {
        double radius = 0;
        // Amplitude and phase of the wave along the bite's edge, which has three periods per turn.
        std::complex<double> wobble;
    };
    void bite_pixel(std::size_t i, Vec2 const& away, double distance, Bite const& bite)
    {
        // Powers of a complex number give the sines of three and seven times the angle without
        // computing the angle.
        std::complex<double> const z
            = distance > 0 ? std::complex(away.x(), away.y()) / distance : std::complex(1.0);
        auto const z3 = z * z * z;
        double const edge
            = bite.radius * (1 + (z3 * bite.wobble).imag() + 0.06 * (z3 * z3 * z).imag());
        double const disc = std::clamp(edge - distance + 0.5, 0.0, 1.0);
        double const kept = 1 - disc * (1 - double(ground_.protection[i]));
        alpha_[i] = std::min(alpha_[i], static_cast<float>(double(ground_.coverage[i]) * kept));
        double const near = std::clamp((edge + rim() - distance) / rim(), 0.0, 1.0);
        eaten_[i] = std::max(eaten_[i], static_cast<float>(near));
    }

    LarvaGround const& ground_;
    Larvae const& larvae_;
    int side_;
    std::span<float> alpha_;
    std::span<float> eaten_;
};

} // namespace

void eat(LarvaGround const& ground, Larvae const& larvae, std::uint64_t seed,
         std::span<float> alpha, std::span<float> eaten)
{
    for (int i = 0; i < larvae.count; ++i)
        Larva(ground, larvae, alpha, eaten).go(seed, i);
}

void mine(LarvaGround const& ground, int count, std::uint64_t seed, std::span<float> mined)
{
    Larvae const larvae;
    for (int i = 0; i < count; ++i)
        Larva(ground, larvae, {}, {}).mine(seed, i, mined);
}

void keep_connected(LarvaGround const& ground, Vec2 const& base, std::span<float> alpha)
{
    int const side = ground.side;
    std::vector<std::uint8_t> is_kept(alpha.size());
    std::vector<int> pending;
    auto const visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= side || y >= side)
            return;
        int const at = y * side + x;
        auto const i = static_cast<std::size_t>(at);
        if (is_kept[i] || alpha[i] <= 0)
            return;
        is_kept[i] = 1;
        // A pixel that is mostly eaten is kept at the edge of the leaf, but does not connect other
        // pixels to the petiole.
        if (alpha[i] >= 0.5f * ground.coverage[i])
            pending.push_back(at);
    };
    int const near = std::max(2, side / 64);
    auto const x0 = static_cast<int>(base.x());
    auto const y0 = static_cast<int>(base.y());
    for (int y = y0 - near; y <= y0 + near; ++y)
        for (int x = x0 - near; x <= x0 + near; ++x)
            visit(x, y);
    while (!pending.empty()) {
        int const i = pending.back();
        pending.pop_back();
        visit(i % side - 1, i / side);
        visit(i % side + 1, i / side);
        visit(i % side, i / side - 1);
        visit(i % side, i / side + 1);
    }
    for (std::size_t i = 0; i < alpha.size(); ++i)
        alpha[i] = is_kept[i] ? alpha[i] : 0;
}

} // namespace tractus::leaf
