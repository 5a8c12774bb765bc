#include "engine/methods/silhouettes/tree.h"

#include "engine/methods/silhouettes/crown_surface.h"
#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/styled_places.h"
#include "engine/plant/pipe_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <tuple>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr std::uint32_t kSprayVariants = 8;
constexpr double kLargestAdded = 1.5; // Of the branch that it is a copy of.
constexpr double kMostTurned = 1.41;  // So much longer a branch may become as it turns away.
constexpr double kOverSurface = 1.02; // And so far beyond the crown's surface it may go.

// Shares of the tree's height: a bearer with the usual number of twigs, and twigs.
constexpr double kBearer = 0.07;
constexpr double kLongestSpray = 0.055;
constexpr double kShortestSpray = 0.016;

using Space = Eigen::Affine3d; // From a plane (x, y, 0) to the plant.

Space in_space(Similarity const& way)
{
    double const flip = way.mirrors ? -1 : 1;
    Space space = Space::Identity();
    space.linear() << way.turn.x(), -flip * way.turn.y(), 0, way.turn.y(), flip * way.turn.x(), 0,
        0, 0, flip * way.turn.norm();
    Vec3 const from(way.from.x(), way.from.y(), 0);
    space.translation() = Vec3(way.to.x(), way.to.y(), 0) - space.linear() * from;
    return space;
}

// A branch of a system where it stands around its bearer.
struct Standing {
    std::size_t branch = 0; // Of the system: itself, or the one that it is a copy of.
    std::string name;
    double u = 0;
    double theta_deg = 0;
    Similarity way; // In the system's plane, before it is turned around the bearer.
};

// A system's branches in space, the same for all bearers that have the system.
struct Crowd {
    Line bearer { { Vec2::Zero(), Vec2::UnitY() } };
    std::vector<Standing> branches; // By u.
};

class Grower {
public:
    Grower(Skeleton const& skeleton, TreeOptions const& options)
        : skeleton_(skeleton)
        , options_(options)
    {
        for (std::uint32_t level = 0; level < options.levels.size(); ++level)
            styled_.emplace_back(options.levels[level].style, options.levels[level].pattern,
                                 options.seed, level);
    }

    Tree run()
    {
        auto const& tree = skeleton_.systems[0];
        Vec2 const foot = tree.trunk.front();
        double const scale = options_.height_mm / std::max(drawn_height(skeleton_), 1e-9);
        Space space = Space::Identity();
        space.linear() << scale, 0, 0, 0, 0, -scale, 0, scale, 0;
        space.translation() = -(space.linear() * Vec3(foot.x(), foot.y(), 0));
        add_looks();
        grow({ .system = 0, .space = space, .line = Line(tree.whole_trunk()) });
        apply_pipe_model(tree_.plant, 2.2, options_.tip_radius_of_height * options_.height_mm);
        for (auto& [level, places] : told_)
            tree_.arrangements.push_back(std::move(places));
        return std::move(tree_);
    }

private:
    // An axis to be made.
    struct Bearer {
        std::size_t system = kNoSystem; // Whose trunk it is.
        Space space;
        Line line;
        std::vector<Vec2> crown {};
        std::string name {};
        SegmentId parent_segment = kNone;
        AxisId parent_axis = kNone;
        std::uint32_t level = 0;
    };

    void add_looks()
    {
        auto& plant = tree_.plant;
        plant.materials.push_back({ .name = "bark", .base_color = options_.bark_color });
        plant.materials.push_back({ .name = "leaf",
                                    .kind = Material::Kind::Leaf,
                                    .base_color = options_.leaf_color,
                                    .roughness = 0.6f,
                                    .translucency = 0.4f });
        for (std::uint32_t variant = 0; variant < kSprayVariants; ++variant)
            plant.organ_shapes.push_back(leaf_spray(options_.leaf, 1, variant));
        plant.organ_shapes.push_back(spray_twig(0));
    }

    // Of the levels that options speak of the last one goes on.
    std::size_t options_of(std::uint32_t level) const
    {
        return std::min<std::size_t>(level, options_.levels.size() - 1);
    }

    LevelOptions const& level_options(std::uint32_t level) const
    {
        return options_.levels[options_of(level)];
    }

    // Depth first: an axis comes after its bearer.
    void grow(Bearer const& bearer)
    {
        std::optional<Crowd> own;
        Crowd const* crowd = nullptr;
        if (bearer.system != kNoSystem && level_options(bearer.level).style.is_set())
            crowd = styled_crowd(bearer, own);
        else if (bearer.system != kNoSystem)
            crowd = &crowd_of(bearer.system, bearer.level);
        auto const places = node_places(bearer, crowd);
        auto const axis = add_axis(bearer, places);
        if (!crowd || bearer.level > 0)
            add_sprays(bearer, axis, places, crowd ? 0.5 : 0.0);
        if (!crowd)
            return;
        std::size_t node = 0;
        for (auto const& standing : crowd->branches) {
            while (node + 1 < places.size() && places[node + 1] < standing.u - 1e-9)
                ++node;
            grow_branch(bearer, axis, standing, own ? std::min(node, places.size() - 2) : node);
        }
    }

    void grow_branch(Bearer const& bearer, AxisId axis, Standing const& standing,
                     std::size_t segment)
    {
        auto const& system = skeleton_.systems[bearer.system];
        auto const& branch = system.branches[standing.branch];
        Vec2 const base = standing.way.point(branch.path.curve.base);
        Vec2 const along = bearer.line.direction(standing.u);
        double const reference = branch.path.side == Side::Right ? 0 : 180;
        Vec3 const pivot = bearer.space * Vec3(base.x(), base.y(), 0);
        Vec3 const direction = (bearer.space.linear() * Vec3(along.x(), along.y(), 0)).normalized();
        Eigen::AngleAxisd const turn(radians(standing.theta_deg - reference), direction);
        Space around = Space::Identity();
        around.linear() = turn.toRotationMatrix();
        around.translation() = pivot - around.linear() * pivot;
        Space const own = around * bearer.space * in_space(standing.way);
        // A copy's own branches are its model's, seen through the way from there.
        auto const below = skeleton_.system_of[bearer.system][standing.branch];
        auto const& model = branch.model ? system.branches[*branch.model] : branch;
        Space const to_model = branch.model ? own * in_space(branch.from_model) : own;
        grow({ .system = below,
               .space = to_model,
               .line = Line(line_of(model, below)),
               .crown = model.crown,
               .name = bearer.name.empty() ? standing.name : bearer.name + "/" + standing.name,
               .parent_segment
               = tree_.plant.axes[axis].first_segment + static_cast<SegmentId>(segment),
               .parent_axis = axis,
               .level = bearer.level + 1 });
    }

    // Shares of the bearer's length where it has nodes: its own, and where branches stand.
    std::vector<double> node_places(Bearer const& bearer, Crowd const* crowd) const
    {
        constexpr std::array kSegments { 16, 8, 4, 3 };
        constexpr int kStyled = 8; // At least: angles are those of an eighth.
        int own = kSegments[std::min<std::size_t>(bearer.level, kSegments.size() - 1)];
        if (bearer.level > 0 && level_options(bearer.level - 1).style.is_set())
            own = std::max(own, kStyled);
        std::vector<double> places;
        for (int i = 0; i <= own; ++i)
            places.push_back(static_cast<double>(i) / own);
        if (crowd)
            for (auto const& branch : crowd->branches)
                places.push_back(std::clamp(branch.u, 0.002, 1.0));
        std::sort(places.begin(), places.end());
        std::vector<double> apart { 0 };
        for (auto const place : places)
            if (place > apart.back() + 1e-4)
                apart.push_back(place);
        return apart;
    }

    AxisId add_axis(Bearer const& bearer, std::vector<double> const& places)
    {
        auto& plant = tree_.plant;
        auto const id = static_cast<AxisId>(plant.axes.size());
        plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                               .first_segment = static_cast<SegmentId>(plant.segment_count()),
                               .segment_count = static_cast<std::uint32_t>(places.size() - 1),
                               .parent_segment = bearer.parent_segment,
                               .parent_axis = bearer.parent_axis,
                               .order = bearer.level });
        for (auto const place : places) {
            Vec2 const point = bearer.line.at(place);
            plant.node_position_mm.emplace_back(bearer.space * Vec3(point.x(), point.y(), 0));
            plant.node_radius_mm.push_back(0);
        }
        plant.segment_material.resize(plant.segment_count() + places.size() - 1, 0);
        tree_.axis_names.push_back(bearer.name.empty() ? kTrunkName : bearer.name);
        return id;
    }

    // How far it is from a place to the crown's edge.
    static double reach(std::vector<Vec2> const& crown, Vec2 const& from, Vec2 const& way)
    {
        double least = 1e300;
        for (std::size_t i = 0; i < crown.size(); ++i) {
            Vec2 const edge = crown[(i + 1) % crown.size()] - crown[i];
            double const over = cross(way, edge);
            double const far = cross(crown[i] - from, edge) / over;
            double const along = cross(crown[i] - from, way) / over;
            if (over != 0 && far > 0 && along >= 0 && along <= 1)
                least = std::min(least, far);
        }
        return least;
    }

    // Twigs of about one length, whatever bears them: more on a longer bearer, from the share
    // `from` of its length on.
    void add_sprays(Bearer const& bearer, AxisId axis, std::vector<double> const& places,
                    double from)
    {
        constexpr double kBare = 0.15;
        constexpr double kSpiral_deg = 137.5;
        double const start = std::max(from, kBare);
        double const length = bearer.line.length();
        double const height = options_.height_mm / unit_of(bearer.space); // In the plane's unit.
        double const usual
            = static_cast<double>(options_.sprays) * (1 - start) * length / (kBearer * height);
        auto const count = std::clamp<std::size_t>(static_cast<std::size_t>(usual),
                                                   options_.sprays / 3 + 1, 6 * options_.sprays);
        Random random({ .seed = options_.seed, .stream = 3, .substream = axis });
        double const first_deg = random.uniform(0, 360);
        std::size_t node = 0;
        for (std::size_t i = 0; i <= count; ++i) {
            double const u
                = start + (1 - start) * static_cast<double>(i) / static_cast<double>(count);
            while (node + 2 < places.size() && places[node + 1] < u)
                ++node;
            Vec2 const at = bearer.line.at(u);
            Vec2 const along = bearer.line.direction(u);
            double const lean = i == count ? 0 : radians(random.uniform(38, 58));
            double far = kLongestSpray * height;
            for (double const side : { 1.0, -1.0 })
                if (!bearer.crown.empty())
                    far = std::min(far, 0.95 * reach(bearer.crown, at, turned(along, side * lean)));
            add_spray({ bearer, axis, node, at, along },
                      { lean, radians(first_deg + static_cast<double>(i) * kSpiral_deg),
                        std::max(far, kShortestSpray * height) },
                      random);
        }
    }

    // Millimetres of the plant to one of the plane.
    static double unit_of(Space const& space)
    {
        return std::cbrt(std::fabs(space.linear().determinant()));
    }

    struct SprayPlace {
        Bearer const& bearer;
        AxisId axis;
        std::size_t segment;
        Vec2 at;
        Vec2 along;
    };
    struct SprayWay {
        double lean;
        double around;
        double length; // In the plane's unit.
    };

    void add_spray(SprayPlace const& place, SprayWay const& way, Random& random)
    {
        auto const& space = place.bearer.space;
        Vec3 const forward
            = (space.linear() * Vec3(place.along.x(), place.along.y(), 0)).normalized();
        Vec3 const across
            = (space.linear() * Vec3(-place.along.y(), place.along.x(), 0)).normalized();
        Vec3 const out
            = std::cos(way.around) * across + std::sin(way.around) * forward.cross(across);
        Vec3 const heading = (std::cos(way.lean) * forward + std::sin(way.lean) * out).normalized();
        Vec3 side = heading.cross(Vec3::UnitZ());
        side = side.norm() > 1e-3 ? Vec3(side.normalized()) : across;
        Eigen::Matrix3d frame;
        frame << side, heading, side.cross(heading);
        auto const size = static_cast<float>(way.length * unit_of(space) / kSprayLength_mm
                                             * random.uniform(0.85, 1.1));
        Organ organ { .shape = static_cast<OrganShapeId>(random.next_u32() % kSprayVariants),
                      .segment = tree_.plant.axes[place.axis].first_segment
                          + static_cast<SegmentId>(place.segment),
                      .position_mm = space * Vec3(place.at.x(), place.at.y(), 0),
                      .orientation = Quat(frame).normalized(),
                      .scale = Vec3f::Constant(size) };
        tree_.plant.organs.push_back(organ);
        organ.shape = kSprayVariants;
        tree_.plant.organs.push_back(organ);
        ++tree_.sprays;
        tree_.leaves += static_cast<std::size_t>(options_.leaf.per_spray);
    }

    Crowd const& crowd_of(std::size_t system, std::uint32_t level)
    {
        auto const found = crowds_.find(system);
        if (found != crowds_.end())
            return found->second;
        auto& crowd = crowds_[system];
        crowd = make_crowd(system, level);
        tell(level, crowd);
        return crowd;
    }

    void tell(std::uint32_t level, Crowd const& crowd)
    {
        if (!told_.contains(level))
            for (auto const& branch : crowd.branches)
                told_[level].push_back({ branch.name, { branch.u, branch.theta_deg } });
    }

    // How far a branch may turn away from the plane: long ones hardly, so that the outline stays.
    static double most_off_deg(double span, double greatest)
    {
        constexpr double kShort_deg = 45;
        constexpr double kLong_deg = 20;
        double const share = greatest > 0 ? std::min(1.0, span / greatest) : 0;
        return kShort_deg + (kLong_deg - kShort_deg) * share;
    }

    Crowd make_crowd(std::size_t index, std::uint32_t level)
    {
        auto const& system = skeleton_.systems[index];
        auto const& options = level_options(level);
        Crowd crowd { .bearer = Line(system.whole_trunk()), .branches = {} };
        CrownSurface const surface(system.outline, system.trunk);
        auto const drawn = drawn_places(crowd.bearer, surface, system);
        double first_u = 1;
        for (auto const& place : drawn)
            first_u = std::min(first_u, place.u);
        auto const added = static_cast<std::size_t>(
            std::lround(options.added * static_cast<double>(drawn.size())));
        auto const arrangement = arrange(
            drawn,
            { .pattern = options.pattern,
              .count = drawn.size() + added,
              .first_u = first_u,
              .proposals = options.proposals },
            { .seed = options_.seed, .stream = 2, .substream = static_cast<std::uint32_t>(index) });
        Model const model { system, surface, drawn };
        for (std::size_t i = 0; i < arrangement.places.size(); ++i) {
            auto const& place = arrangement.places[i];
            if (i < drawn.size())
                stand(crowd, model, i, place, place.u);
            else
                stand_added(crowd, model, place);
        }
        finish(crowd, system);
        return crowd;
    }

    // The trunk's end last.
    static void finish(Crowd& crowd, BranchingSystem const& system)
    {
        if (system.has_apex_branch())
            crowd.branches.push_back({ system.branches.size() - 1, "apex", 1, 0, {} });
        std::stable_sort(crowd.branches.begin(), crowd.branches.end(),
                         [](Standing const& a, Standing const& b) { return a.u < b.u; });
    }

    // Of all branches in the plane but the apex.
    static std::vector<DrawnPlace> drawn_places(Line const& bearer, CrownSurface const& surface,
                                                BranchingSystem const& system)
    {
        std::array<double, 2> greatest {};
        auto const span = [&](Branch const& branch) {
            return std::fabs(surface.to_trunk(branch.path.curve.end).x());
        };
        auto const flat = system.branches.size() - (system.has_apex_branch() ? 1 : 0);
        for (std::size_t i = 0; i < flat; ++i) {
            auto const& branch = system.branches[i];
            auto& most = greatest[branch.path.side == Side::Left];
            most = std::max(most, span(branch));
        }
        std::vector<DrawnPlace> drawn;
        for (std::size_t i = 0; i < flat; ++i) {
            auto const& branch = system.branches[i];
            bool const is_left = branch.path.side == Side::Left;
            drawn.push_back({ bearer.place_of(branch.path.curve.base), is_left ? 180.0 : 0.0,
                              most_off_deg(span(branch), greatest[is_left]) });
        }
        return drawn;
    }

    struct Model {
        BranchingSystem const& system;
        CrownSurface const& surface;
        std::vector<DrawnPlace> const& drawn;
    };

    // One in the plane, where it was inferred or at the place to which it moves.
    void stand(Crowd& crowd, Model const& model, std::size_t i, Place const& place,
               double moves_to) const
    {
        auto const& branch = model.system.branches[i];
        Vec2 const base = branch.path.curve.base;
        double const off = radians(place.theta_deg - model.drawn[i].theta_deg);
        double const longer = std::min(kMostTurned, 1 / std::max(0.1, std::cos(off)));
        Similarity way { .from = base, .to = base, .turn = Vec2(longer, 0) };
        Vec2 as_it_is = Vec2::UnitX();
        if (moves_to != place.u) {
            // Its end stays where the outline wants it.
            way = way_to_end(branch, crowd.bearer.at(moves_to));
            as_it_is = way.turn;
            way.turn *= longer;
        }
        if (longer > 1) {
            double const size = as_it_is.norm();
            way.turn = largest_inside(model, branch, way, place.theta_deg,
                                      { size, longer * size, kOverSurface })
                * direction_of(as_it_is);
        }
        crowd.branches.push_back({ i, name_of(branch), moves_to, place.theta_deg, way });
    }

    // How an added branch leaves its bearer, and how small it may be, of the one it is a copy of.
    struct Lean {
        Vec2 from = Vec2::UnitX(); // Which way of its model has the angle.
        double angle_deg = 0;
        double least = 0.15;
        enum class Smaller { LeftOut, Least } smaller = Smaller::LeftOut;
    };

    void stand_added(Crowd& crowd, Model const& model, Place const& place) const
    {
        auto const nearest = nearest_drawn(model, place);
        if (!nearest)
            return;
        auto const& branch = model.system.branches[*nearest];
        stand_added(crowd, model, place, *nearest,
                    { .from = branch.path.curve.base_tangent,
                      .angle_deg = options_.angles.at_deg(place.u) });
    }

    void stand_added(Crowd& crowd, Model const& model, Place const& place, std::size_t nearest,
                     Lean const& lean) const
    {
        auto const& branch = model.system.branches[nearest];
        Vec2 const along = crowd.bearer.direction(place.u);
        Vec2 const start = turned(along, sign_of(branch.path.side) * radians(lean.angle_deg));
        Vec2 const from = direction_of(lean.from);
        Vec2 const unit(start.dot(from), cross(from, start));
        Similarity way { .from = branch.path.curve.base,
                         .to = crowd.bearer.at(place.u),
                         .turn = unit };
        double size = largest_inside(model, branch, way, place.theta_deg, { 0, kLargestAdded, 1 });
        if (size < lean.least && lean.smaller == Lean::Smaller::LeftOut)
            return;
        size = std::max(size, lean.least);
        way.turn = size * unit;
        crowd.branches.push_back(
            { nearest, name_of_added(crowd, place), place.u, place.theta_deg, way });
    }

    // After its place around the bearer, so that the one that stands there after a change has the
    // name: they are arranged anew as a whole.
    static std::string name_of_added(Crowd const& crowd, Place const& place)
    {
        constexpr double kSteps = 12; // Along the bearer, and around it.
        auto const name = fmt::format("a{}.{}", std::lround(place.u * kSteps),
                                      std::lround(place.theta_deg / 360 * kSteps) % 12);
        auto const taken = [&](std::string const& other) {
            return std::any_of(crowd.branches.begin(), crowd.branches.end(),
                               [&](Standing const& one) { return one.name == other; });
        };
        auto unique = name;
        for (int n = 2; taken(unique); ++n)
            unique = fmt::format("{}.{}", name, n);
        return unique;
    }

    // The branches of a bearer in the style of its level; null: it bears none.
    Crowd const* styled_crowd(Bearer const& bearer, std::optional<Crowd>& own)
    {
        auto const& system = skeleton_.systems[bearer.system];
        auto& styled = styled_[options_of(bearer.level)];
        if (!styled.next_bears())
            return nullptr;
        auto& crowd = own.emplace(Crowd { .bearer = bearer.line, .branches = {} });
        CrownSurface const surface(system.outline, system.trunk);
        auto const drawn = drawn_places(crowd.bearer, surface, system);
        auto const id = static_cast<std::uint32_t>(tree_.plant.axes.size());
        // On the trunk nothing stands below the crown; where the crowns of branches begin, which
        // nobody drew, the style decides.
        double const crown_u = crowd.bearer.place_of(system.trunk[system.inside.first]);
        double const style_u = level_options(bearer.level).style.unbranched;
        auto const drawn_by_hand = std::count_if(
            system.branches.begin(), system.branches.end(),
            [](Branch const& branch) { return branch.origin == Branch::Origin::Drawn; });
        auto const places = styled.next({ bearer.level == 0 ? crown_u : std::min(crown_u, style_u),
                                          static_cast<std::size_t>(drawn_by_hand), id });
        auto const kept = kept_branches(system, drawn, places.size());
        std::vector<std::optional<std::size_t>> branch_at(places.size());
        std::vector<double> at;
        for (auto const i : kept)
            at.push_back(drawn[i].u);
        auto const nearest = nearest_in_order(at, places);
        for (std::size_t k = 0; k < kept.size(); ++k)
            branch_at[nearest[k]] = kept[k];
        Model const model { system, surface, drawn };
        auto const thetas = styled_arrangement(model, bearer.level, branch_at, id);
        double const extent = std::max(places.back() - places.front(), 1e-9);
        // First those that have their ends, which the angles of the others make up for.
        for (auto const has_end : { true, false })
            for (std::size_t k = 0; k < places.size(); ++k) {
                double const share = (places[k] - places.front()) / extent;
                StyledPlace const place { branch_at[k], { places[k], thetas[k].theta_deg }, share };
                if (has_end == keeps_end(bearer, model, place))
                    stand_styled(bearer, crowd, model, place);
            }
        finish(crowd, system);
        tell(bearer.level, crowd);
        return &crowd;
    }

    // As many of the branches in the plane as there are places, by their places; those that were
    // drawn before those of bumps, these before copies, and the largest before others.
    static std::vector<std::size_t> kept_branches(BranchingSystem const& system,
                                                  std::vector<DrawnPlace> const& drawn,
                                                  std::size_t most)
    {
        constexpr std::array kRanks { 1, 2, 3, 0, 4 }; // Of origins in their order.
        std::vector<std::tuple<int, double, std::size_t>> ranks;
        for (std::size_t i = 0; i < drawn.size(); ++i)
            ranks.emplace_back(kRanks[static_cast<std::size_t>(system.branches[i].origin)],
                               -std::fabs(signed_area(system.branches[i].crown)), i);
        std::sort(ranks.begin(), ranks.end());
        std::vector<std::size_t> kept;
        for (std::size_t k = 0; k < std::min(most, ranks.size()); ++k)
            kept.push_back(std::get<2>(ranks[k]));
        std::sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) {
            return std::pair(drawn[a].u, a) < std::pair(drawn[b].u, b);
        });
        return kept;
    }

    // Places are taken as if nodes stood at equal distances, so that the pattern counts nodes.
    std::vector<Place> styled_arrangement(Model const& model, std::uint32_t level,
                                          std::vector<std::optional<std::size_t>> const& branch_at,
                                          std::uint32_t id) const
    {
        constexpr double kAnywhere_deg = 180;
        auto const& options = level_options(level);
        auto const count = branch_at.size();
        auto const whorl = node_size(options.pattern);
        double const node = node_distance(options.pattern, count);
        std::vector<DrawnPlace> free;
        for (std::size_t k = 0; k < count; ++k) {
            double const u = (static_cast<double>(k / whorl) + 0.5) * node;
            auto place = branch_at[k] ? model.drawn[*branch_at[k]]
                                      : DrawnPlace { 0, k % 2 == 0 ? 0.0 : 180.0, kAnywhere_deg };
            place.u = std::min(u, 1.0);
            free.push_back(place);
        }
        return arrange(
                   free,
                   { .pattern = options.pattern, .count = count, .proposals = options.proposals },
                   { .seed = options_.seed, .stream = 2, .substream = id })
            .places;
    }

    // One of the places that a style gives.
    struct StyledPlace {
        std::optional<std::size_t> branch; // In the plane, that takes it; no value: one is added.
        Place at;
        double share; // Of the way from the bearer's first place to its last.
    };

    // A branch that was drawn or ends in a bump goes there from its new place, too, if that makes
    // it neither far longer nor shorter, nor takes it far from the style's angle. No other end is
    // the outline's.
    bool keeps_end(Bearer const& bearer, Model const& model, StyledPlace const& place) const
    {
        constexpr double kMostStretched = 1.5;
        constexpr double kMostTurned_deg = 30;
        if (!place.branch)
            return false;
        double const u = place.at.u;
        auto const& branch = model.system.branches[*place.branch];
        if (branch.origin != Branch::Origin::Bump)
            return branch.origin == Branch::Origin::Drawn;
        auto const way = way_to_end(branch, bearer.line.at(u));
        double const size = way.turn.norm();
        double const angle_deg = angle_between_deg(
            bearer.line.direction(u), way.vector(way_of(bearer.system, *place.branch)));
        double const wanted_deg = level_options(bearer.level).style.angle_at_deg(place.share);
        return size < kMostStretched && 1 < kMostStretched * size
            && std::fabs(angle_deg - wanted_deg) < kMostTurned_deg;
    }

    // From a branch as it is to one from another place to the same end.
    static Similarity way_to_end(Branch const& branch, Vec2 const& from)
    {
        auto const& curve = branch.path.curve;
        Vec2 const before = curve.end - curve.base;
        Vec2 const after = curve.end - from;
        Vec2 const turn(before.dot(after), cross(before, after));
        return { .from = curve.base,
                 .to = from,
                 .turn = turn / std::max(before.squaredNorm(), 1e-300) };
    }

    static double angle_between_deg(Vec2 const& a, Vec2 const& b)
    {
        return degrees(std::fabs(std::atan2(cross(a, b), a.dot(b))));
    }

    void stand_styled(Bearer const& bearer, Crowd& crowd, Model const& model,
                      StyledPlace const& place)
    {
        auto& styled = styled_[options_of(bearer.level)];
        auto const& branch = place.branch;
        if (keeps_end(bearer, model, place)) {
            bool const is_drawn = model.system.branches[*branch].origin == Branch::Origin::Drawn;
            double const as_inferred = model.drawn[*branch].u;
            double const moves_to = is_drawn ? as_inferred : place.at.u;
            stand(crowd, model, *branch, { as_inferred, place.at.theta_deg }, moves_to);
            auto const& way = crowd.branches.back().way;
            styled.take_angle(place.share,
                              angle_between_deg(crowd.bearer.direction(moves_to),
                                                way.vector(way_of(bearer.system, *branch))));
            return;
        }
        double const angle_deg = styled.next_angle_deg(place.share);
        auto const copied = branch ? branch : nearest_drawn(model, place.at);
        if (!copied)
            return;
        stand_added(crowd, model, place.at, *copied,
                    { .from = way_of(bearer.system, *copied),
                      .angle_deg = angle_deg,
                      .smaller = Lean::Smaller::Least });
        if (branch)
            crowd.branches.back().name = name_of(model.system.branches[*branch]);
    }

    // Over the share of its axis that angles are of, in its system's plane.
    Vec2 way_of(std::size_t index, std::size_t i) const
    {
        auto const& system = skeleton_.systems[index];
        auto const& branch = system.branches[i];
        auto const below = skeleton_.system_of[index][i];
        auto const& model = branch.model ? system.branches[*branch.model] : branch;
        Line const line(line_of(model, below));
        Vec2 const way = line.at(kAngleOver) - line.at(0);
        return branch.model ? branch.from_model.vector(way) : way;
    }

    std::vector<Vec2> line_of(Branch const& model, std::size_t below) const
    {
        return below == kNoSystem ? model.path.curve.points(9)
                                  : skeleton_.systems[below].whole_trunk();
    }

    static std::optional<std::size_t> nearest_drawn(Model const& model, Place const& place)
    {
        bool const is_right = std::cos(radians(place.theta_deg)) >= 0;
        std::optional<std::size_t> best;
        double least = 1e300;
        for (std::size_t i = 0; i < model.drawn.size(); ++i) {
            bool const same = (model.drawn[i].theta_deg < 90) == is_right;
            double const far = std::fabs(model.drawn[i].u - place.u) + (same ? 0 : 1);
            if (far < least) {
                least = far;
                best = i;
            }
        }
        return best;
    }

    struct Scales {
        double low;
        double high;
        double surface; // The section is so much larger.
    };

    // The largest scale at which the branch's crown is inside of the crown's surface.
    static double largest_inside(Model const& model, Branch const& branch, Similarity way,
                                 double theta_deg, Scales scales)
    {
        auto section = model.surface.section(theta_deg);
        for (auto& point : section)
            point.x() *= scales.surface;
        Vec2 const unit = way.turn.normalized();
        double const sign = branch.path.side == Side::Left ? -1 : 1;
        auto const is_in = [&](Vec2 const& point) {
            Vec2 at = model.surface.to_trunk(way.point(point));
            at.x() *= sign;
            return is_inside(section, at);
        };
        for (int i = 0; i < 10; ++i) {
            double const middle = (scales.low + scales.high) / 2;
            way.turn = middle * unit;
            // Most of it: a crown that touches the surface in a corner may stand out there.
            std::size_t outside = 0;
            std::size_t tried = 0;
            for (std::size_t c = 0; c < branch.crown.size(); c += 3, ++tried)
                outside += !is_in(branch.crown[c]);
            (10 * outside <= tried ? scales.low : scales.high) = middle;
        }
        return scales.low;
    }

    Skeleton const& skeleton_;
    TreeOptions const& options_;
    Tree tree_;
    std::map<std::size_t, Crowd> crowds_;
    std::map<std::uint32_t, std::vector<PlacedBranch>> told_;
    std::vector<StyledPlaces> styled_; // Of each level.
};

} // namespace

double drawn_height(Skeleton const& skeleton)
{
    auto const& tree = skeleton.systems[0];
    auto const box = box_of(tree.outline);
    Vec2 const foot = tree.trunk.front();
    return std::max(box.high.y(), foot.y()) - std::min(box.low.y(), foot.y());
}

Tree make_tree(Skeleton const& skeleton, TreeOptions const& options)
{
    return Grower(skeleton, options).run();
}

} // namespace tractus::silhouette
