#include "engine/lsystem/derivation/environments.h"

#include "engine/base/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/core.h>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::lsystem {

namespace {

using Queries = std::span<EnvironmentQuery const>;
using Cell = std::array<std::int32_t, 3>; // Integer coordinates x, y, z of a voxel.

constexpr std::size_t kMaxCells = std::size_t { 1 } << 24;

// Returns the voxel that contains a position; no value if the voxel's coordinates are too large.
std::optional<Cell> cell_at(Vec3 const& position, double size)
{
    constexpr double kMax = 1e9;
    Cell cell {};
    for (int i = 0; i < 3; ++i) {
        double const coordinate = std::floor(position[i] / size);
        if (!(std::fabs(coordinate) < kMax))
            return std::nullopt;
        cell[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(coordinate);
    }
    return cell;
}

void answer(EnvironmentQuery const& query, std::size_t index, double value)
{
    if (index < query.parameters.size())
        query.parameters[index] = static_cast<float>(value);
}

void answer(EnvironmentQuery const& query, std::size_t first, Vec3 const& vector)
{
    for (std::size_t i = 0; i < 3; ++i)
        answer(query, first + i, vector[static_cast<int>(i)]);
}

// Returns a parameter of a query, or `otherwise` if the module does not have that parameter.
// Negative and non-finite values count as 0.
double asked(EnvironmentQuery const& query, std::size_t index, double otherwise)
{
    if (index >= query.parameters.size())
        return otherwise;
    auto const value = static_cast<double>(query.parameters[index]);
    return std::isfinite(value) && value >= 0 ? value : 0;
}

// Returns the direction in which a function of the cells increases at a cell, by central
// differences between the cell's neighbours. 0 if it is the same on all sides.
template<typename Value> Vec3 direction_of_more(Cell const& cell, Value const& value_at)
{
    Vec3 result = Vec3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto before = cell;
        auto behind = cell;
        --before[axis];
        ++behind[axis];
        result[static_cast<int>(axis)] = value_at(behind) - value_at(before);
    }
    double const length = result.norm();
    return length > 1e-12 ? Vec3(result / length) : Vec3(Vec3::Zero());
}

Error too_large(std::string_view name, double cell)
{
    return { Fault::User,
             fmt::format("environment {}: the plant spans more than {} voxels; choose cell= larger "
                         "than {}",
                         name, kMaxCells, cell) };
}

// Checks the time limit whenever kWorkBetweenLooks voxels have been visited.
class Watch {
public:
    Watch(std::string_view environment, TimeLimit const& limit)
        : environment_(environment)
        , limit_(limit)
    {
    }

    // Counts work, in visited voxels. Fails with a user error when the time is over.
    Result<void> spend(std::size_t work)
    {
        spent_ += work;
        if (spent_ < kWorkBetweenLooks)
            return {};
        spent_ = 0;
        if (!limit_.is_over || !limit_.is_over())
            return {};
        return fail(Fault::User,
                    fmt::format("environment {}: the answers were not there when {} s had passed; "
                                "derive fewer steps, or raise the limit of time",
                                environment_, limit_.seconds));
    }

private:
    static constexpr std::size_t kWorkBetweenLooks = 16'384;

    std::string_view environment_;
    TimeLimit limit_;
    std::size_t spent_ = 0;
};

// Weights in voxels, as a summed-area table in x and z for each layer: the weight of any rectangle
// of a layer takes four lookups.
class WeightGrid {
public:
    // Stores the weights of objects in these cells. Returns false if the grid would be too large.
    bool fill(std::span<std::optional<Cell> const> cells, std::span<double const> weights);

    // Returns the total weight of a square of cells, `layer` layers above `cell`: of those at most
    // `reach` cells away from it in x and in z.
    double weight(Cell const& cell, std::int64_t layer, std::int64_t reach) const
    {
        auto const y = cell[1] + layer - low_[1];
        if (y < 0 || y >= size_[1])
            return 0;
        auto const from_x = std::clamp<std::int64_t>(cell[0] - reach - low_[0], 0, size_[0]);
        auto const to_x = std::clamp<std::int64_t>(cell[0] + reach + 1 - low_[0], 0, size_[0]);
        auto const from_z = std::clamp<std::int64_t>(cell[2] - reach - low_[2], 0, size_[2]);
        auto const to_z = std::clamp<std::int64_t>(cell[2] + reach + 1 - low_[2], 0, size_[2]);
        return sums_[index(y, to_x, to_z)] - sums_[index(y, from_x, to_z)]
            - sums_[index(y, to_x, from_z)] + sums_[index(y, from_x, from_z)];
    }

    std::size_t size() const { return sums_.size(); }

private:
    std::size_t index(std::int64_t y, std::int64_t x, std::int64_t z) const
    {
        return static_cast<std::size_t>((y * (size_[0] + 1) + x) * (size_[2] + 1) + z);
    }

    std::array<std::int64_t, 3> low_ {};
    std::array<std::int64_t, 3> size_ {};
    std::vector<double> sums_;
};

bool WeightGrid::fill(std::span<std::optional<Cell> const> cells, std::span<double const> weights)
{
    std::array<std::int64_t, 3> high {};
    bool is_first = true;
    for (auto const& cell : cells) {
        for (std::size_t i = 0; cell && i < 3; ++i) {
            low_[i] = is_first ? (*cell)[i] : std::min<std::int64_t>(low_[i], (*cell)[i]);
            high[i] = is_first ? (*cell)[i] : std::max<std::int64_t>(high[i], (*cell)[i]);
        }
        is_first = is_first && !cell;
    }
    double count = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        size_[i] = is_first ? 0 : high[i] - low_[i] + 1;
        count *= static_cast<double>(size_[i] + 1);
    }
    if (count > static_cast<double>(kMaxCells))
        return false;
    sums_.assign(static_cast<std::size_t>(size_[1] * (size_[0] + 1) * (size_[2] + 1)), 0);
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (auto const& cell = cells[i])
            sums_[index((*cell)[1] - low_[1], (*cell)[0] - low_[0] + 1, (*cell)[2] - low_[2] + 1)]
                += weights[i];
    for (std::int64_t y = 0; y < size_[1]; ++y)
        for (std::int64_t x = 1; x <= size_[0]; ++x)
            for (std::int64_t z = 1; z <= size_[2]; ++z)
                sums_[index(y, x, z)] += sums_[index(y, x - 1, z)] + sums_[index(y, x, z - 1)]
                    - sums_[index(y, x - 1, z - 1)];
    return true;
}

class Light {
public:
    Light(EnvironmentChoice const& choice, TimeLimit const& time)
        : watch_("light", time)
        , cell_(choice["cell"])
        , full_(choice["full"])
    {
        double strength = choice["shade"];
        for (int layer = 0; layer < static_cast<int>(choice["depth"]); ++layer) {
            strengths_.push_back(strength);
            strength /= choice["decay"];
        }
    }

    Result<void> operator()(int, Queries queries)
    {
        std::vector<std::optional<Cell>> cells;
        std::vector<double> weights;
        for (auto const& query : queries) {
            cells.push_back(cell_at(query.position, cell_));
            weights.push_back(asked(query, 1, 1));
        }
        WeightGrid grid;
        if (!grid.fill(cells, weights))
            return tl::unexpected<Error>(too_large("light", cell_));
        TRY(watch_.spend(queries.size() + grid.size()));
        auto const light_at = [&](Cell const& cell) {
            double shade = 0;
            for (std::size_t layer = 0; layer < strengths_.size(); ++layer) {
                auto const reach = static_cast<std::int64_t>(layer);
                shade += strengths_[layer] * grid.weight(cell, reach, reach);
            }
            return full_ - shade;
        };
        for (std::size_t i = 0; i < queries.size(); ++i) {
            TRY(watch_.spend(strengths_.size() + 1));
            auto const& cell = cells[i];
            answer(queries[i], 0,
                   cell ? std::max(light_at(*cell) + strengths_[0] * weights[i], 0.0) : full_);
            if (queries[i].parameters.size() > 2)
                answer(queries[i], 2,
                       cell ? direction_of_more(*cell, light_at) : Vec3(Vec3::Zero()));
        }
        return {};
    }

private:
    Watch watch_;
    double cell_;
    double full_;
    // Strength of an object's shade, indexed by the number of layers below the object.
    std::vector<double> strengths_;
};

class Space {
public:
    Space(EnvironmentChoice const& choice, TimeLimit const& time)
        : watch_("space", time)
        , radius_(choice["radius"])
    {
    }

    Result<void> operator()(int step, Queries queries)
    {
        if (step == 0)
            balls_.clear();
        for (auto const& query : queries)
            answer(query, 0, TRY(take(query.position, asked(query, 1, radius_))) ? 1 : 0);
        return {};
    }

private:
    struct Ball {
        Vec3 center = Vec3::Zero();
        double radius = 0;
    };

    // Returns true if a ball of space with this centre and radius is granted: it overlaps no ball
    // that was granted before, or is itself such a ball. Granted balls are stored by size class
    // (the power of 2 above their diameter) and by the voxel of their centre. A voxel is at least
    // as large as its balls, so only a few voxels of each class must be searched.
    Result<bool> take(Vec3 const& center, double radius)
    {
        int size = 0;
        std::frexp(2 * radius, &size);
        if (!(radius > 0) || !cell_at(center, std::ldexp(1, size)))
            return false;
        for (auto const& [other_size, voxels] : balls_) {
            double const side = std::ldexp(1, other_size);
            double const reach = radius + side / 2;
            auto const low = cell_at(center - Vec3::Constant(reach), side);
            auto const high = cell_at(center + Vec3::Constant(reach), side);
            if (!low || !high)
                return false;
            for (auto voxel = voxels.lower_bound({ (*low)[0], (*low)[1], (*low)[2] });
                 voxel != voxels.end() && voxel->first[0] <= (*high)[0]; ++voxel) {
                TRY(watch_.spend(voxel->second.size() + 1));
                for (auto const& ball : voxel->second) {
                    double const distance = (ball.center - center).norm();
                    if (distance < 1e-4 * radius)
                        return true;
                    if (distance < (ball.radius + radius) * (1 - 1e-6))
                        return false;
                }
            }
        }
        balls_[size][*cell_at(center, std::ldexp(1, size))].push_back({ center, radius });
        return true;
    }

    Watch watch_;
    double radius_;
    // Balls of space that modules asked for and were granted, by size class (exponent of 2) and by
    // the voxel of their centre.
    std::map<int, std::map<Cell, std::vector<Ball>>> balls_;
};

class Terrain {
public:
    explicit Terrain(EnvironmentChoice const& choice)
        : slope_(std::tan(radians(choice["slope"])))
        , hill_(choice["hill"])
        , per_length_(2 * kPi / choice["wave"])
    {
    }

    Result<void> operator()(int, Queries queries) const
    {
        for (auto const& query : queries) {
            auto const& at = query.position;
            double const x = per_length_ * at.x();
            double const z = per_length_ * at.z();
            double const ground = slope_ * at.x() + hill_ / 2 * (std::cos(x) * std::cos(z) - 1);
            answer(query, 0, at.y() - ground);
            Vec3 const normal { hill_ / 2 * per_length_ * std::sin(x) * std::cos(z) - slope_, 1,
                                hill_ / 2 * per_length_ * std::cos(x) * std::sin(z) };
            answer(query, 1, normal.normalized());
        }
        return {};
    }

private:
    double slope_;
    double hill_;
    double per_length_;
};

class Water {
public:
    Water(EnvironmentChoice const& choice, TimeLimit const& time)
        : watch_("water", time)
        , cell_(choice["cell"])
        , content_(choice["content"])
        , uptake_(choice["uptake"])
        , diffusion_(choice["diffusion"])
    {
    }

    Result<void> operator()(int step, Queries queries)
    {
        if (step == 0)
            changed_.clear();
        TRY(spread());
        std::map<Cell, double> demands;
        std::vector<std::optional<Cell>> cells;
        for (auto const& query : queries) {
            TRY(watch_.spend(1));
            auto const& cell = cells.emplace_back(cell_at(query.position, cell_));
            if (cell)
                demands[*cell] += asked(query, 1, 1);
        }
        std::map<Cell, double> given; // Amount of water given per unit of demand.
        for (auto const& [cell, demand] : demands) {
            double const taken = std::min(at(cell), uptake_ * demand);
            given[cell] = demand > 0 ? taken / demand : 0;
            if (taken > 0)
                changed_[cell] = at(cell) - taken;
        }
        for (std::size_t i = 0; i < queries.size(); ++i) {
            auto const& cell = cells[i];
            answer(queries[i], 0, cell ? given[*cell] * asked(queries[i], 1, 1) : 0);
            if (queries[i].parameters.size() > 2)
                answer(queries[i], 2,
                       cell ? direction_of_more(*cell, [&](Cell const& near) { return at(near); })
                            : Vec3(Vec3::Zero()));
        }
        return {};
    }

private:
    double at(Cell const& cell) const
    {
        auto const found = changed_.find(cell);
        return found != changed_.end() ? found->second : cell[1] < 0 ? content_ : 0;
    }

    // Diffuses water from each voxel to drier neighbours. No water leaves the soil.
    Result<void> spread()
    {
        if (diffusion_ == 0)
            return {};
        auto next = changed_;
        for (auto const& [cell, water] : changed_) {
            TRY(watch_.spend(6));
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (int side : { -1, 1 }) {
                    auto near = cell;
                    near[axis] += side;
                    if (near[1] >= 0)
                        continue;
                    bool const is_changed = changed_.contains(near);
                    double const flow = diffusion_ * (at(near) - water);
                    next[cell] += flow;
                    if (!is_changed && std::fabs(flow) > 1e-6 * content_)
                        next.try_emplace(near, content_).first->second -= flow;
                }
        }
        changed_ = std::move(next);
        if (changed_.size() > kMaxCells / 16)
            return tl::unexpected<Error>(too_large("water", cell_));
        return {};
    }

    Watch watch_;
    double cell_;
    double content_;
    double uptake_;
    double diffusion_;
    std::map<Cell, double> changed_; // Voxels whose water differs from the initial content.
};

} // namespace

Environment make_environment(EnvironmentChoice const& choice, TimeLimit const& time)
{
    if (choice.name == "light")
        return Light(choice, time);
    if (choice.name == "space")
        return Space(choice, time);
    if (choice.name == "terrain")
        return Terrain(choice);
    if (choice.name == "water")
        return Water(choice, time);
    return {};
}

} // namespace tractus::lsystem
