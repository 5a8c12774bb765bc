#include "engine/methods/self_organising/stand.h"

#include "engine/base/check.h"
#include "engine/methods/self_organising/cell_index.h"
#include "engine/methods/self_organising/life.h"

#include <Eigen/Geometry>
#include <map>
#include <set>
#include <utility>

namespace tractus::self_organising {

namespace {

// Box of all points that can shade a tree or the cells that its buds perceive, in the tree's frame.
Eigen::AlignedBox3d reach_of_shade(GrowingTree const& tree, Habit const& habit)
{
    Eigen::AlignedBox3d box;
    for (auto const& place : tree.places)
        box.extend(place.position);
    double const margin = (habit.shade_depth + habit.sight_cells + 2) * habit.cell_mm;
    box.extend(box.min() - Vec3::Constant(margin));
    box.extend(box.max() + Vec3::Constant(margin));
    return box;
}

// Moves points by `shift` to the frame of a tree and adds those inside `box` to `within`.
void add_within(Eigen::AlignedBox3d const& box, std::vector<Vec3> const& points, Vec3 const& shift,
                std::vector<Vec3>& within)
{
    for (auto const& point : points)
        if (Vec3 const at = point + shift; box.contains(at))
            within.push_back(at);
}

// The centre of each grid cell that contains any of the points after moving them by `shift`, in the
// order of the cells.
std::vector<Vec3> one_for_each_cell(std::vector<Vec3> const& points, Vec3 const& shift, double side)
{
    std::set<Cell> cells;
    for (auto const& point : points)
        cells.insert(cell_at(point + shift, side));
    std::vector<Vec3> middles;
    for (auto const& [i, j, k] : cells)
        middles.push_back(side * (Vec3(double(i), double(j), double(k)) + Vec3::Constant(0.5)));
    return middles;
}

std::vector<Vec3> bud_places(GrowingTree const& tree)
{
    std::vector<Vec3> places;
    for (auto const& bud : living_buds(tree))
        places.push_back(tree.places[bud.node].position);
    return places;
}

} // namespace

Stand::Stand(Place place)
    : place_(std::move(place))
    , waiting_(place_.members.size())
{
}

Result<GrowingTree> Stand::grow_member(std::size_t number, scene::LoadOptions const& options,
                                       YearCallback const& on_year) const
{
    CHECK(number < place_.members.size());
    std::lock_guard const lock(mutex_);
    if (waiting_[number] && !on_year) {
        auto const tree = std::move(waiting_[number]);
        return std::move(*tree);
    }
    auto grown = TRY(grow(number, options, on_year));
    for (std::size_t i = 0; i < grown.size(); ++i)
        if (i != number && !on_year)
            waiting_[i] = std::make_unique<GrowingTree>(std::move(grown[i]));
    return std::move(grown[number]);
}

// Points of the plants that do not grow, in the frame of each member: one for each cell of the
// member's light grid that contains their wood.
Result<std::vector<std::vector<Vec3>>>
Stand::points_of_others(scene::LoadOptions const& options) const
{
    auto const& members = place_.members;
    std::vector<std::vector<Vec3>> still(members.size());
    for (auto const& other : place_.others) {
        // Points on the wood of `other`; key: side length of the light cells for which they are
        // dense enough.
        std::map<double, std::vector<Vec3>> wood_by_cell;
        for (std::size_t i = 0; i < members.size(); ++i) {
            double const cell_mm = members[i].tree.habit.cell_mm;
            auto wood = wood_by_cell.find(cell_mm);
            if (wood == wood_by_cell.end())
                wood = wood_by_cell
                           .emplace(
                               cell_mm,
                               TRY(points_on_wood({ other, place_.scale }, cell_mm / 2, options)))
                           .first;
            Vec3 const shift = (other->stands_at_mm - members[i].stands_at_mm) / place_.scale;
            for (auto const& point : one_for_each_cell(wood->second, shift, cell_mm))
                still[i].push_back(point);
        }
    }
    return still;
}

Result<std::vector<GrowingTree>> Stand::grow(std::size_t watched, scene::LoadOptions const& options,
                                             YearCallback const& on_year) const
{
    auto const& members = place_.members;
    std::vector<GrowingTree> trees;
    for (std::size_t i = 0; i < members.size(); ++i)
        trees.push_back(
            TRY(grow_tree(members[i].tree, options, i == watched ? on_year : YearCallback {})));
    if (!still_)
        still_ = TRY(points_of_others(options));
    for (int year = 0; year < place_.years; ++year) {
        std::vector<std::vector<Vec3>> buds;
        for (auto const& tree : trees)
            buds.push_back(bud_places(tree));
        for (std::size_t i = 0; i < members.size(); ++i) {
            auto const box = reach_of_shade(trees[i], members[i].tree.habit);
            std::vector<Vec3> shading;
            add_within(box, (*still_)[i], Vec3::Zero(), shading);
            for (std::size_t k = 0; k < members.size(); ++k)
                if (k != i)
                    add_within(box, buds[k],
                               (members[k].stands_at_mm - members[i].stands_at_mm) / place_.scale,
                               shading);
            Surroundings surroundings { .shading = shading, .seed = members[i].tree.seed };
            TRY(grow_year(trees[i], surroundings, members[i].tree.habit));
            if (i == watched && on_year)
                on_year(trees[i]);
        }
    }
    return trees;
}

} // namespace tractus::self_organising
