#include "engine/methods/silhouettes/fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr double kMaxOverlap = 0.2; // Share of a new crown's cells that may be covered already.
// Largest and smallest scale of a copy relative to the branch that it copies.
constexpr double kLargestCopy = 1.5;
constexpr double kSmallestCopy = 0.15;
// A lone branch whose cap radius is below this share of the outline's diagonal is not copied.
constexpr double kSliver = 0.05;
constexpr std::array kSizes { 1.0, 0.7, 0.5, 0.35 };

class Filler {
public:
    Filler(CrownToFill const& crown, FillOptions const& options)
        : crown_(crown)
        , options_(options)
        , grid_(crown.outline)
        , trunk_(crown.trunk.begin(), crown.trunk.end())
        , run_(crown.run)
        , last_(crown.trunk.size() - 1)
    {
        for (auto const& branch : crown.branches)
            grid_.cover(grid_.cells_of(branch.crown));
        if (!crown.apex.empty())
            grid_.cover(grid_.cells_of(crown.apex));
        min_count_ = static_cast<std::size_t>(
            options.min_copy * static_cast<double>(grid_.cells_of(crown.outline).count));
        if (crown.goes_on)
            extend_trunk(*crown.goes_on);
        models_ = crown.branches;
        if (models_.empty() || is_sliver()) {
            lens_ = lens();
            models_ = { &lens_, 1 };
        }
    }

    FilledCrown run()
    {
        result_.coverage_before = grid_.coverage();
        for (int step = 0; step < options_.steps; ++step) {
            double const share = options_.first_step + static_cast<double>(step) / options_.steps;
            if (share > 1 - 1e-9)
                break;
            auto const sample = run_.first
                + static_cast<std::size_t>(std::lround(
                    share * static_cast<double>(run_.last - run_.first)));
            for (auto const side : { Side::Left, Side::Right })
                add_copy(sample, side,
                         2 * static_cast<std::size_t>(step) + (side == Side::Right ? 1 : 0));
        }
        fill_gaps();
        result_.coverage_after = grid_.coverage();
        return std::move(result_);
    }

private:
    bool is_sliver() const
    {
        return crown_.branches.size() == 1 && crown_.branches[0].path.length > 0
            && radius_of(crown_.branches[0]) < kSliver * box_of(crown_.outline).diagonal();
    }

    // Radius of the cap of a branch's bump, recovered from the cone's angle (cone_angle_deg()).
    static double radius_of(Branch const& branch)
    {
        double const share = (branch.cone_deg - 20) / 90;
        return share * (branch.path.curve.end - branch.path.curve.base).norm();
    }

    void extend_trunk(Vec2 const& to)
    {
        Vec2 const from = trunk_.back();
        double const gap = length_of(trunk_) / static_cast<double>(last_);
        auto const more = std::max<long>(1, std::lround((to - from).norm() / gap));
        for (long i = 1; i <= more; ++i)
            trunk_.emplace_back(from
                                + (to - from) * static_cast<double>(i) / static_cast<double>(more));
        run_.last = trunk_.size() - 1;
    }

    // The branch to copy if the crown has none, or only a sliver (kSliver): straight, three
    // sixteenths of the trunk long, with a lens as its crown.
    Branch lens() const
    {
        double const length = length_of(crown_.trunk) / 4;
        Branch branch;
        branch.path.t = 0.5;
        branch.path.curve = { Vec2::Zero(), Vec2(0.75 * length, 0), Vec2(0.75 * length, 0),
                              Vec2(0.75 * length, 0) };
        for (int i = 0; i < 24; ++i) {
            double const angle = i * kPi / 12;
            branch.crown.emplace_back(0.5 * length * (1 - std::cos(angle)),
                                      -0.22 * length * std::sin(angle));
        }
        return branch;
    }

    std::size_t nearest_model(double t, Side side) const
    {
        std::size_t best = 0;
        auto best_rank = std::pair(true, std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < models_.size(); ++i) {
            auto const rank
                = std::pair(models_[i].path.side != side, std::fabs(models_[i].path.t - t));
            if (rank < best_rank) {
                best_rank = rank;
                best = i;
            }
        }
        return best;
    }

    Vec2 start_at(std::size_t sample, double t, Side side) const
    {
        auto const next = std::min(sample + 1, trunk_.size() - 1);
        return turned(direction_of(trunk_[next] - trunk_[sample > 0 ? sample - 1 : 0]),
                      sign_of(side) * radians(crown_.angles.at_deg(t)));
    }

    // The similarity that moves a model to a new base, as large as its copy fits inside the
    // outline; no value if the copy would be too small.
    std::optional<Similarity> fitted(Branch const& model, Vec2 const& base, Vec2 const& start,
                                     Side side) const
    {
        auto const& curve = model.path.curve;
        double const over = crown_.angles.over();
        Vec2 const from = direction_of(over > 0 ? chord_to_share(curve, over)
                                                : Vec2(curve.at(1.0 / 16) - curve.base));
        bool const mirrors = model.path.side != side;
        Vec2 const unit = turn_between(from, start, mirrors);
        Similarity way { .from = curve.base, .to = base, .turn = unit, .mirrors = mirrors };
        double low = 0;
        double high = kLargestCopy;
        for (int i = 0; i < 12; ++i) {
            double const middle = (low + high) / 2;
            way.turn = middle * unit;
            bool inside = true;
            for (std::size_t c = 1; c < model.crown.size() && inside; c += 2)
                inside = grid_.is_inside(way.point(model.crown[c]));
            (inside ? low : high) = middle;
        }
        if (low < kSmallestCopy)
            return std::nullopt;
        way.turn = low * unit;
        return way;
    }

    std::size_t count() const { return crown_.branches.size() + result_.added.size(); }

    void add_copy(std::size_t sample, Side side, std::size_t number)
    {
        if (count() >= options_.most_branches || !grid_.is_inside(trunk_[sample]))
            return;
        double const t = std::min(1.0, static_cast<double>(sample) / static_cast<double>(last_));
        auto const index = nearest_model(t, side);
        auto const& model = models_[index];
        auto const way = fitted(model, trunk_[sample], start_at(sample, t, side), side);
        for (double const size : kSizes) {
            if (!way)
                return;
            auto smaller = *way;
            smaller.turn *= size;
            auto crown = smaller.points(model.crown);
            auto const cells = grid_.cells_of(crown);
            if (cells.count == 0 || cells.count < min_count_
                || static_cast<double>(grid_.count_covered(cells))
                    > kMaxOverlap * static_cast<double>(cells.count))
                continue;
            grid_.cover(cells);
            Branch branch { .origin = Branch::Origin::Copy,
                            .number = number,
                            .path = model.path,
                            .crown = std::move(crown),
                            .is_beyond = sample > last_,
                            .from_model = smaller };
            branch.path.curve = smaller.cubic(model.path.curve);
            branch.path.trunk_sample = sample;
            branch.path.t = t;
            branch.path.side = side;
            branch.path.length = length_of(branch.path.curve.points(17));
            if (models_.data() == crown_.branches.data())
                branch.model = index;
            else
                copy_first_lens(branch);
            result_.added.push_back(std::move(branch));
            return;
        }
    }

    // All branches made from lens() become copies of the first of them. The first call only records
    // which branch that is; later calls set the model of `branch` and the similarity from it.
    void copy_first_lens(Branch& branch)
    {
        if (!first_lens_) {
            first_lens_ = result_.added.size();
            return;
        }
        auto const& first = result_.added[*first_lens_].path;
        Vec2 const from = first.curve.end - first.curve.base;
        Vec2 const to = branch.path.curve.end - branch.path.curve.base;
        bool const mirrors = first.side != branch.path.side;
        branch.model = crown_.branches.size() + *first_lens_;
        branch.from_model = { .from = first.curve.base,
                              .to = branch.path.curve.base,
                              .turn = turn_between(from, to, mirrors) / from.squaredNorm(),
                              .mirrors = mirrors };
    }

    void fill_gaps()
    {
        constexpr double kMinCells = 2.2;
        double const least = std::max(options_.min_gap * std::sqrt(signed_area(crown_.outline)),
                                      kMinCells * grid_.cell());
        constexpr int kMaxTries = 100;
        for (int tries = 0; tries < kMaxTries; ++tries) {
            if (count() >= options_.most_branches || grid_.coverage() >= options_.enough)
                return;
            auto const gap = grid_.widest_gap(gap_step());
            if (gap.radius < least)
                return;
            add_gap_branch(gap);
        }
    }

    // Step for widest_gap(). The search for gaps dominates the time of inference. Outlines with few
    // samples, as inferred crowns have, are therefore searched with twice the step, in a quarter of
    // the time.
    int gap_step() const
    {
        constexpr std::size_t kFewSamples = 200;
        return crown_.outline.size() < kFewSamples ? 4 : 2;
    }

    // Outline of the free area around a gap's centre, up to twice the distance to the nearest
    // covered point.
    std::vector<Vec2> free_around(CoverageGrid::Gap const& gap) const
    {
        constexpr int kRays = 32;
        std::vector<Vec2> crown;
        for (int i = 0; i < kRays; ++i) {
            Vec2 const ray = turned(Vec2::UnitX(), 2 * kPi * i / kRays);
            double far = 0.8 * gap.radius;
            while (far < 2 * gap.radius && grid_.is_free(gap.center + (far + grid_.cell()) * ray))
                far += grid_.cell();
            crown.emplace_back(gap.center + far * ray);
        }
        return crown;
    }

    void add_gap_branch(CoverageGrid::Gap const& gap)
    {
        auto crown = free_around(gap);
        auto const cells = grid_.cells_of(crown);
        bool const overlaps = static_cast<double>(grid_.count_covered(cells))
            > kMaxOverlap * static_cast<double>(cells.count);
        // The cells count as covered even if no branch is added, so that the next gap found is a
        // different one.
        grid_.cover(cells);
        if (overlaps)
            return;
        BranchSearch const search {
            .trunk = trunk_, .bases = run_, .outline = crown_.outline, .angles = crown_.angles
        };
        auto nearest = run_.first;
        for (auto k = run_.first; k <= run_.last; ++k)
            if ((trunk_[k] - gap.center).squaredNorm()
                < (trunk_[nearest] - gap.center).squaredNorm())
                nearest = k;
        Vec2 const away = direction_of(gap.center - trunk_[nearest]);
        // The tangent also points up along the trunk, so that the branch starts well below the gap,
        // as natural branches do.
        auto path = infer_branch(
            search,
            { .end = gap.center, .tangent = direction_of(away + direction_at_end(nearest)) });
        if (path.length < options_.min_length * box_of(crown_.outline).diagonal())
            return;
        path.t = std::min(1.0, static_cast<double>(path.trunk_sample) / static_cast<double>(last_));
        result_.added.push_back({ .origin = Branch::Origin::Gap,
                                  .number = gaps_++,
                                  .path = path,
                                  .crown = std::move(crown),
                                  .is_beyond = path.trunk_sample > last_ });
    }

    Vec2 direction_at_end(std::size_t sample) const
    {
        auto const next = std::min(sample + 1, trunk_.size() - 1);
        return 0.5 * direction_of(trunk_[next] - trunk_[sample > 0 ? sample - 1 : 0]);
    }

    CrownToFill const& crown_;
    FillOptions const& options_;
    CoverageGrid grid_;
    std::vector<Vec2> trunk_; // Trunk including its extension.
    Run run_;
    std::size_t last_;          // Index of the last sample of the drawn trunk.
    std::size_t min_count_ = 0; // Minimum number of cells of a copy's crown.
    std::span<Branch const> models_;
    Branch lens_;
    // Index of the first copy of lens_ among the added branches.
    std::optional<std::size_t> first_lens_;
    std::size_t gaps_ = 0;
    FilledCrown result_;
};

} // namespace

std::vector<Vec2> Branch::line(std::size_t count) const
{
    if (stroke.empty())
        return path.curve.points(count);
    std::vector<Vec2> points { path.curve.base };
    points.insert(points.end(), stroke.begin(), stroke.end());
    return points;
}

FilledCrown fill_crown(CrownToFill const& crown, FillOptions const& options)
{
    return Filler(crown, options).run();
}

} // namespace tractus::silhouette
