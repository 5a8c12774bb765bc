#include "engine/methods/self_organising/sag.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace tractus::self_organising {

namespace {

constexpr double kGravity_m_per_ss = 9.81;
constexpr double kLargestTurn_rad = 0.1; // Largest rotation of one internode in one year.

struct Load {
    double mass_kg = 0;
    Vec3 moment_kg_mm = Vec3::Zero(); // Sum of mass times position.
};

// The load that each internode carries: its own mass and that of everything above it.
std::vector<Load> loads_of(GrowingTree const& tree, std::vector<double> const& diameters,
                           SagLaws const& laws)
{
    constexpr double kPerCubicMillimetre = 1e-9;
    std::vector<Load> loads(tree.size());
    for (std::size_t i = tree.size(); i-- > 1;) {
        auto const& node = tree.links[i];
        Vec3 const& base = tree.places[node.parent].position;
        Vec3 const& tip = tree.places[i].position;
        double const volume = kPi / 4 * diameters[i] * diameters[i] * (tip - base).norm();
        bool const is_leafy = tree.step - node.step < laws.leaf_years;
        double const mass
            = volume * kPerCubicMillimetre * laws.density_kg_per_m3 + (is_leafy ? laws.leaf_kg : 0);
        loads[i].mass_kg += mass;
        loads[i].moment_kg_mm += mass * 0.5 * (base + tip);
        loads[node.parent].mass_kg += loads[i].mass_kg;
        loads[node.parent].moment_kg_mm += loads[i].moment_kg_mm;
    }
    return loads;
}

// Rotation of an internode, as a rotation vector, under a moment given in kg mm.
Vec3 turn_by(Vec3 const& moment_kg_mm, double length_mm, double diameter_mm, SagLaws const& laws)
{
    constexpr double kMetre = 1000;
    constexpr double kGiga = 1e9;
    double const d = diameter_mm / kMetre;
    double const rigidity = laws.stiffness_gpa * kGiga * kPi * d * d * d * d / 64;
    double const newtons = laws.weight * kGravity_m_per_ss / kMetre;
    Vec3 const turn_rad = moment_kg_mm * (newtons * length_mm / kMetre / rigidity);
    double const size = turn_rad.norm();
    return size > kLargestTurn_rad ? Vec3(turn_rad * (kLargestTurn_rad / size)) : turn_rad;
}

Quat rotation_by(Vec3 const& turn_rad)
{
    double const angle = turn_rad.norm();
    if (angle < 1e-12)
        return Quat::Identity();
    Quat rotation;
    rotation.w() = std::cos(angle / 2);
    rotation.vec() = turn_rad * (std::sin(angle / 2) / angle);
    return rotation;
}

// Moment of a load about the base of its internode, as a vector along the axis of rotation.
Vec3 moment_of(Load const& load, Vec3 const& base)
{
    Vec3 const arm = load.moment_kg_mm - load.mass_kg * base;
    return { -arm.y(), arm.x(), 0 }; // Cross product of the arm and -z.
}

} // namespace

void set_wood(GrowingTree& tree, std::vector<double> const& diameters, SagLaws const& laws)
{
    CHECK(diameters.size() == tree.size());
    auto const loads = loads_of(tree, diameters, laws);
    for (std::size_t i = 1; i < tree.size(); ++i)
        tree.bent_by[i] = moment_of(loads[i], tree.places[tree.links[i].parent].position);
}

void sag(GrowingTree& tree, std::vector<double> const& diameters, SagLaws const& laws)
{
    CHECK(diameters.size() == tree.size());
    if (laws.weight <= 0)
        return;
    auto const loads = loads_of(tree, diameters, laws);
    std::vector<Quat> turns(tree.size(), Quat::Identity());
    std::vector<Vec3> before(tree.size());
    for (std::size_t i = 0; i < tree.size(); ++i)
        before[i] = tree.places[i].position;
    for (std::size_t i = 1; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        auto& place = tree.places[i];
        Vec3 const internode = before[i] - before[node.parent];
        Vec3 const moment = moment_of(loads[i], before[node.parent]);
        Vec3 turn_rad = turn_by(moment - tree.bent_by[i], internode.norm(), diameters[i], laws);
        if (node.order == 0)
            turn_rad = Vec3::Zero();
        // Remove the torsional part: wood hardly twists.
        turn_rad -= place.direction * turn_rad.dot(place.direction);
        tree.bent_by[i] = moment;
        turns[i] = (rotation_by(turn_rad) * turns[node.parent]).normalized();
        place.position = tree.places[node.parent].position + turns[i] * internode;
        place.direction = unit_or_zero(turns[i] * place.direction);
        place.normal = turns[i] * place.normal;
        place.normal
            = unit_or_zero(place.normal - place.direction * dot(place.normal, place.direction));
        for (auto k = node.first_lateral; k < node.first_lateral + node.lateral_count; ++k)
            if (tree.laterals[k].has_bud)
                tree.laterals[k].direction = turns[i] * tree.laterals[k].direction;
    }
}

} // namespace tractus::self_organising
