#include "engine/methods/silhouettes/branching_system.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/spaced_ends.h"
#include "engine/methods/silhouettes/tree_form.h"
#include "engine/methods/silhouettes/tree_preset.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::silhouette {
namespace {

// Returns a tall column with shallow bumps, like the crown of a Lombardy poplar.
Drawing rough_column()
{
    Drawing drawing { { {} }, upright(0, 205) };
    auto& outline = drawing.outline[0];
    auto const half_width = [](double height, double phase) {
        double const taper = std::sqrt(std::max(0.0, 1 - std::pow(height / 115 - 1, 6)));
        return 2 + 12 * taper + 1.1 * std::sin(height / 4.1 + phase);
    };
    for (double height = 4; height <= 228; height += 1)
        outline.emplace_back(half_width(height, 0.3), height);
    for (double height = 228; height >= 4; height -= 1)
        outline.emplace_back(-half_width(height, 1.7), height);
    return drawing;
}

// Adds noise that is correlated over several neighbouring points, like the tremor of a hand.
Drawing with_tremor(Drawing drawing, double size_mm, std::uint32_t seed)
{
    Random random({ 49, 7, seed });
    for (auto& stroke : drawing.outline) {
        Vec2 off = Vec2::Zero();
        for (auto& point : stroke) {
            off = 0.7 * off + 0.71 * size_mm * Vec2(random.normal(), random.normal());
            point += off;
        }
    }
    return drawing;
}

Drawing with_gap(Drawing drawing, double share)
{
    auto& stroke = drawing.outline[0];
    auto const count = static_cast<std::ptrdiff_t>(static_cast<double>(stroke.size()) * share);
    stroke.erase(stroke.end() - count, stroke.end());
    return drawing;
}

Drawing with_overshoot(Drawing drawing)
{
    auto& stroke = drawing.outline[0];
    for (std::size_t i = 0; i < 12; ++i)
        stroke.push_back(stroke[i] + Vec2(0.1 * static_cast<double>(i), 0.4));
    return drawing;
}

InferenceOptions spaced(int branches)
{
    return skeleton_options({ .plane_branches = branches }).tree;
}

std::size_t count(Drawing const& drawing, InferenceOptions const& options)
{
    auto const system = infer_system(drawing, options);
    EXPECT_TRUE(system) << system.error().message;
    return system ? system->branches.size() - (system->has_apex_branch() ? 1 : 0) : 0;
}

// Returns the angles between the trunk and the first quarters of a system's branches, by position
// along the trunk.
std::vector<std::pair<double, double>> angles_deg(BranchingSystem const& system)
{
    std::vector<std::pair<double, double>> angles;
    auto const last = system.trunk.size() - 1;
    for (auto const& branch : system.branches) {
        auto const k = branch.path.trunk_sample;
        if (branch.origin == Branch::Origin::Apex || k == 0 || k >= last)
            continue;
        Vec2 const along = system.trunk[k + 1] - system.trunk[k - 1];
        Vec2 const way = chord_to_share(branch.path.curve, 0.25);
        angles.emplace_back(branch.path.t,
                            degrees(std::fabs(std::atan2(cross(along, way), along.dot(way)))));
    }
    return angles;
}

// Returns outlines that a tree of this form has, as a hand draws them.
std::vector<Drawing> outlines_of(std::string_view form)
{
    if (form == "poplar")
        return { rough_column(), with_tremor(rough_column(), 0.35, 1) };
    if (form == "umbrella_pine" || form == "acacia") {
        auto flat = ellipse(70, 24);
        flat.trunk = upright(-130, 12);
        return { flat, with_tremor(flat, 0.35, 1) };
    }
    if (form == "birch" || form == "eucalyptus" || form == "willow")
        return { ellipse(30, 90), with_tremor(ellipse(34, 90), 0.35, 1) };
    return { with_tremor(ellipse(45, 90), 0.35, 1), with_tremor(lobed_crown(7), 0.2, 2),
             lobed_crown(11) };
}

TEST(SpacedEnds, BranchesLeaveTheTrunkAtTheAnglesOfTheForm)
{
    for (auto const& ready : tree_presets()) {
        if (ready.form.base_angle_deg == 0)
            continue;
        auto form = ready.form;
        form.bases_by_angle = true;
        for (auto const& drawing : outlines_of(ready.name)) {
            auto const system = infer_system(drawing, skeleton_options(form).tree);
            ASSERT_TRUE(system);
            // Mean deviation from the form's law in each fifth of the trunk.
            std::array<double, 5> sum {};
            std::array<int, 5> count {};
            for (auto const& [t, angle_deg] : angles_deg(*system)) {
                double const law_deg = std::lerp(form.base_angle_deg, form.tip_angle_deg, t);
                auto const fifth = static_cast<std::size_t>(std::min(4.0, 5 * t));
                sum[fifth] += angle_deg - law_deg;
                ++count[fifth];
            }
            EXPECT_GT(std::accumulate(count.begin(), count.end(), 0), 8) << ready.name;
            for (std::size_t i = 0; i < 5; ++i)
                if (count[i] > 1) {
                    EXPECT_LE(std::fabs(sum[i] / count[i]), 10) << ready.name << i;
                }
        }
    }
}

TEST(SpacedEnds, GiveASmoothOutlineAsManyBranchesAsAHandDrewRoughly)
{
    for (auto const& drawing :
         { rough_column(), ellipse(45, 90), ellipse(60, 60), lobed_crown(4), lobed_crown(7) }) {
        auto const clean = count(drawing, spaced(26));
        EXPECT_GE(clean, 20U);
        EXPECT_LE(clean, 27U);
        std::vector<Drawing> drawn { with_gap(drawing, 0.08), with_overshoot(drawing) };
        for (std::uint32_t seed = 0; seed < 6; ++seed)
            drawn.push_back(with_tremor(drawing, seed < 3 ? 0.2 : 0.35, seed));
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            auto const rough = static_cast<double>(count(drawn[i], spaced(26)));
            EXPECT_LE(rough, 1.2 * static_cast<double>(clean)) << i;
            EXPECT_GE(rough, 0.8 * static_cast<double>(clean)) << i;
        }
    }
}

TEST(SpacedEnds, AreAsManyAsTheFormHas)
{
    for (int const wanted : { 12, 20, 36 }) {
        auto const branches = static_cast<double>(count(rough_column(), spaced(wanted)));
        EXPECT_GE(branches, 0.8 * wanted);
        EXPECT_LE(branches, 1.05 * wanted);
    }
    // All bumps must keep their branches, even if there are more bumps than the form has branches.
    EXPECT_GE(count(star(13, 70, 105), spaced(5)), 12U);
}

TEST(SpacedEnds, StayInsideAndHaveNames)
{
    for (auto const& drawing :
         { rough_column(), ellipse(45, 90), lobed_crown(5), scribble(4), star(5, 40, 100) }) {
        auto const system = infer_system(drawing, spaced(30)).value();
        std::set<std::string> names;
        double const most = 0.01 * box_of(system.outline).diagonal();
        for (auto const& branch : system.branches) {
            EXPECT_TRUE(names.insert(name_of(branch)).second) << name_of(branch);
            if (branch.origin != Branch::Origin::Spaced)
                continue;
            EXPECT_LE(excursion(system.outline, branch.path.curve.points(17)), most);
            EXPECT_TRUE(is_inside(system.outline, branch.path.curve.base));
            EXPECT_GE(branch.path.trunk_sample, system.inside.first);
            EXPECT_LE(branch.path.trunk_sample, system.inside.last);
        }
    }
}

TEST(SpacedEnds, AreMirroredWithTheDrawing)
{
    auto drawing = rough_column();
    auto const one = count(drawing, spaced(24));
    for (auto& point : drawing.outline[0])
        point.x() = -point.x();
    std::reverse(drawing.outline[0].begin(), drawing.outline[0].end());
    auto const other = count(drawing, spaced(24));
    EXPECT_NEAR(static_cast<double>(one), static_cast<double>(other), 1);
}

// The lobes are discs. Whatever the tremor, the end of a bump's branch must be near the centre of
// its disc.
TEST(SpacedEnds, EndsOfRoundLobesAreTheirCentres)
{
    auto const drawing = lobed_crown(4);
    double const most = 0.02 * box_of(drawing.outline[0]).diagonal();
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        auto rough = with_tremor(drawing, 0.05 * seed, seed);
        std::rotate(rough.outline[0].begin(), rough.outline[0].begin() + 37 * seed,
                    rough.outline[0].end());
        auto const system = infer_system(rough, spaced(26)).value();
        for (int lobe = 0; lobe < 4; ++lobe) {
            double const angle = radians(-25 + lobe * 230.0 / 3);
            Vec2 const centre(62 * std::cos(angle), 62 * std::sin(angle));
            double least = 1e9;
            for (auto const& bump : system.bumps)
                least = std::min(least, (bump.end - centre).norm());
            EXPECT_LE(least, most) << "lobe " << lobe << ", seed " << seed;
        }
    }
}

TEST(SpacedEnds, AreNoneInTreesFromBefore)
{
    EXPECT_EQ(TreeForm().plane_branches, 0);
    auto const options = skeleton_options({});
    EXPECT_EQ(options.tree.branches, 0U);
    EXPECT_EQ(options.tree.bumps.ends, BumpThresholds::Ends::OfTriangles);
    EXPECT_FALSE(check_form({ .plane_branches = kMaxPlaneBranches + 1 }));
    EXPECT_FALSE(check_form({ .base_angle_deg = 190 }));
}

TEST(SilhouetteSystemCorpus, APoplarHasTheBranchesOfItsForm)
{
    std::ifstream stream(corpus() / "faults" / "lombardy_poplar.json");
    auto const file = nlohmann::json::parse(stream);
    Drawing const poplar { { points_in(file["outline"]) }, points_in(file["trunk"]) };
    auto const clean = static_cast<double>(count(poplar, spaced(30)));
    EXPECT_NEAR(clean, 30, 3);
    for (auto const& drawn : { with_gap(poplar, 0.1), with_overshoot(poplar),
                               with_tremor(poplar, 0.35, 1), with_tremor(poplar, 0.6, 2) })
        EXPECT_NEAR(static_cast<double>(count(drawn, spaced(30))), clean, 0.2 * clean);
}

} // namespace
} // namespace tractus::silhouette
