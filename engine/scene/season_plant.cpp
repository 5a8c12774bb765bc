#include "engine/base/random.h"
#include "engine/scene/foliated_plant.h"
#include "engine/scene/season.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace tractus::scene {

namespace {

// Standard deviation of the age of leaves about the age that their calendar gives.
constexpr double kSpread = 0.08;
// Leaf ages, 0 to 1, are rounded to this many steps to find a sheet.
constexpr double kSheetAges = 50;
constexpr double kDecayed = 3;    // Month by which the leaves of the previous year have decayed.
constexpr int kPlainVariants = 4; // Number of age variants of a leaf that is not from a sheet.
// Horizontal drift of falling leaves, as a share of the height of fall.
constexpr double kDrift = 0.12;
constexpr std::uint32_t kFallStream = 0x5ea5;

double eased(double share)
{
    double const s = std::clamp(share, 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

OrganCalendar calendar_of(Plant const& plant, OrganShape const& shape)
{
    if (shape.calendar)
        return *shape.calendar;
    bool const is_petal = plant.materials[shape.material].kind == Material::Kind::Petal;
    return { .is_evergreen = !is_petal && !is_leaf(plant, shape) };
}

// True if the leaves that fell last still lie below the bare plant in that month.
bool lies_below(OrganCalendar const& calendar, double month)
{
    return !calendar.is_evergreen && (month >= calendar.bare || month < kDecayed);
}

// Returns the order by which the leaves of this shape are grown at another age, or no value if the
// shape is not from a leaf sheet.
std::optional<lsystem::LeafOrder> order_at(OrganShape const& shape, double age)
{
    auto order = shape.cut ? lsystem::parse_leaf_sheet_name(shape.cut->sheet) : std::nullopt;
    if (!order)
        return std::nullopt;
    order->age = std::round(age * kSheetAges) / kSheetAges;
    order->spread = kSpread;
    return order;
}

// Returns the age at which organs with this calendar are displayed, on the plant or on the ground.
// Returns no value if they are not displayed in that month.
std::optional<double> age_to_show(OrganCalendar const& calendar, double month)
{
    if (auto const age = age_in_season(calendar, month))
        return age;
    return lies_below(calendar, month) ? std::optional(1.0) : std::nullopt;
}

// Returns the colour of a leaf at this age from its fully grown colour.
Vec3f aged_color(Vec3f const& grown_up, double age)
{
    Vec3f const fresh(0.62f, 0.76f, 0.32f);
    Vec3f const turned(0.84f, 0.66f, 0.18f);
    Vec3f const dead(0.43f, 0.30f, 0.18f);
    auto const mixed = [](Vec3f const& from, Vec3f const& to, double share) {
        return Vec3f(from + static_cast<float>(share) * (to - from));
    };
    auto const young = mixed(fresh, grown_up, 0.3 + 0.7 * eased(age / 0.4));
    return mixed(mixed(young, turned, eased((age - 0.58) / 0.24)), dead, eased((age - 0.8) / 0.2));
}

// Returns the size of a leaf at this age, relative to its full size.
float size_at(double age)
{
    return static_cast<float>(0.15 + 0.85 * eased(age / 0.4));
}

// Returns the share of the leaves of age `age` that have fallen when the mean age of the plant's
// leaves is `mean_age`. Older leaves fall sooner; at mean age 1 all have fallen.
double fallen_share(double age, double mean_age)
{
    return std::max(eased((age - 0.88) / 0.12), eased((mean_age - 0.9) / 0.1));
}

class Seasoner {
public:
    Seasoner(Plant const& plant, Season const& season, LeafSheets const& sheets)
        : from_(plant)
        , season_(season)
        , sheets_(sheets)
        , plant_(plant)
    {
        plant_.organs.clear();
        plant_.organs.reserve(plant.organs.size());
    }

    Plant run()
    {
        for (std::size_t i = 0; i < from_.organ_shapes.size(); ++i)
            looks_.push_back(look_of(from_.organ_shapes[i], static_cast<OrganShapeId>(i)));
        for (std::size_t i = 0; i < from_.organs.size(); ++i)
            place(from_.organs[i], i);
        age_polygons();
        return std::move(plant_);
    }

private:
    // An organ shape at one age.
    struct Aged {
        OrganShapeId shape = 0;
        double age = 0;
        float scale = 1;
    };
    struct Look {
        // Variants, one of which is chosen at random for each organ; empty if the organ is not
        // present.
        std::vector<Aged> ages {};
        bool falls = false;
        double mean_age = 0; // Mean age of the organs of this shape; at 1 all have fallen.
    };

    Look look_of(OrganShape const& shape, OrganShapeId id)
    {
        auto const calendar = calendar_of(from_, shape);
        if (calendar.is_evergreen)
            return { .ages = { { .shape = id } } };
        auto const age = age_to_show(calendar, season_.month);
        if (!age)
            return {};
        Look look { .falls = is_leaf(from_, shape), .mean_age = *age };
        if (!look.falls) {
            if (age_in_season(calendar, season_.month))
                look.ages.push_back({ .shape = id });
            return look;
        }
        auto const order = order_at(shape, *age);
        auto const sheet = order ? sheets_.find(lsystem::leaf_sheet_name(*order)) : sheets_.end();
        if (sheet != sheets_.end()
            && shape.cut->number < static_cast<int>(sheet->second->leaves.size()))
            look.ages.push_back(grown_leaf(shape, id, *order, *sheet->second));
        else
            look.ages = plain_ages(shape, *age);
        return look;
    }

    // Replaces the shape by the leaf with the same number on `sheet`, which was grown at another
    // age.
    Aged grown_leaf(OrganShape const& shape, OrganShapeId id, lsystem::LeafOrder const& order,
                    lsystem::LeafSheet const& sheet)
    {
        double const age = lsystem::leaf_age(order, shape.cut->number);
        auto const& leaf = sheet.leaves[static_cast<std::size_t>(shape.cut->number)];
        double const blade_mm = shape.length_mm / box_of(*shape.cut).max().y();
        auto& aged = plant_.organ_shapes[id];
        aged.cut = leaf;
        aged.length_mm = blade_mm * box_of(*leaf).max().y();
        aged.width_mm = blade_mm * box_of(*leaf).sizes().x();
        bend(aged, age);
        show_sheet(plant_.materials[shape.material], sheet);
        return { .shape = id, .age = age, .scale = size_at(age) };
    }

    // Makes variants of a leaf with ages about `age`, each with its own colour and shape.
    std::vector<Aged> plain_ages(OrganShape const& shape, double age)
    {
        lsystem::LeafOrder const order { .variants = kPlainVariants,
                                         .age = age,
                                         .spread = kSpread };
        std::vector<Aged> ages;
        for (int i = 0; i < kPlainVariants; ++i) {
            double const own = lsystem::leaf_age(order, i);
            auto aged = shape;
            bend(aged, own);
            aged.material = aged_material(shape.material, own, shape.cut != nullptr);
            plant_.organ_shapes.push_back(std::move(aged));
            ages.push_back({ .shape = static_cast<OrganShapeId>(plant_.organ_shapes.size() - 1),
                             .age = own,
                             .scale = size_at(own) });
        }
        return ages;
    }

    // Returns a material of the colour at this age. Textures are kept while that colour is nearly
    // the original. Textures of grown leaves show a single age and are always removed.
    MaterialId aged_material(MaterialId material, double age, bool is_of_grown_leaf = false)
    {
        auto const [known, is_new]
            = materials_.try_emplace({ material, std::lround(age * 1000) }, MaterialId { 0 });
        if (is_new) {
            auto aged = from_.materials[material];
            aged.base_color = aged_color(aged.base_color, age);
            constexpr float kAsGreen = 0.03F;
            auto const turned = (aged.base_color - from_.materials[material].base_color).norm();
            if (is_of_grown_leaf || turned > kAsGreen)
                aged.textures = {}; // The textures show leaves of another age.
            plant_.materials.push_back(std::move(aged));
            known->second = static_cast<MaterialId>(plant_.materials.size() - 1);
        }
        return known->second;
    }

    // Bends a leaf as it is at this age: folded in the bud, drooping and rolled up when old.
    static void bend(OrganShape& shape, double age)
    {
        double const young = 1 - eased(age / 0.35);
        double const decay = eased((age - 0.65) / 0.35);
        shape.fold_rad += 0.9 * young + 0.3 * decay;
        shape.curl_rad += 0.9 * decay - 0.4 * young;
    }

    static void show_sheet(Material& material, lsystem::LeafSheet const& sheet)
    {
        material.base_color = sheet.mean_color;
        material.textures = lsystem::leaf_textures(sheet);
    }

    void place(Organ organ, std::size_t number)
    {
        auto const& look = looks_[organ.shape];
        if (look.ages.empty())
            return;
        Random random({ 0, kFallStream, static_cast<std::uint32_t>(number) });
        auto const& aged
            = look.ages[static_cast<std::size_t>(random.uniform() * double(look.ages.size()))];
        organ.scale *= aged.scale;
        organ.shape = aged.shape;
        bool const has_fallen
            = look.falls && random.uniform() < fallen_share(aged.age, look.mean_age);
        if (has_fallen && random.uniform() >= season_.fallen)
            return;
        if (has_fallen)
            lay_down(organ, random);
        plant_.organs.push_back(organ);
    }

    // Lays an organ on the ground with either side up, at random.
    void lay_down(Organ& organ, Random& random)
    {
        auto const [known, is_new] = fallen_.try_emplace(organ.shape, OrganShapeId { 0 });
        if (is_new) {
            auto shape = plant_.organ_shapes[organ.shape];
            shape.curl_rad *= 0.5;
            plant_.organ_shapes.push_back(std::move(shape));
            known->second = static_cast<OrganShapeId>(plant_.organ_shapes.size() - 1);
        }
        auto const& shape = plant_.organ_shapes[known->second];
        double const aside_mm = kDrift * std::max(organ.position_mm.z(), 0.0);
        double const above_mm = 0.1 * shape.length_mm * std::abs(double(organ.scale.z()));
        organ.shape = known->second;
        organ.segment = kNone;
        organ.position_mm.x() += aside_mm * random.normal();
        organ.position_mm.y() += aside_mm * random.normal();
        organ.position_mm.z() = above_mm * random.uniform(0.3, 1);
        bool const is_face_down = random.uniform() < 0.5;
        // Drawn in separate statements, since the order of evaluation within an expression differs
        // between compilers.
        double const about_y = (is_face_down ? std::numbers::pi : 0) + 0.2 * random.normal();
        double const about_x = 0.2 * random.normal();
        double const about_z = random.uniform(0, 2 * std::numbers::pi);
        organ.orientation = Eigen::AngleAxisd(about_z, Vec3::UnitZ())
            * Eigen::AngleAxisd(about_x, Vec3::UnitX()) * Eigen::AngleAxisd(about_y, Vec3::UnitY());
    }

    // Ages the polygons that the turtle drew with a leaf material. They have no calendar of their
    // own, so the default one, of deciduous leaves, applies.
    void age_polygons()
    {
        if (from_.polygons.empty())
            return;
        auto const age = age_in_season({}, season_.month);
        plant_.polygons.clear();
        plant_.polygon_vertices_mm.clear();
        for (auto polygon : from_.polygons) {
            bool const is_aging = from_.materials[polygon.material].kind == Material::Kind::Leaf;
            if (is_aging && !age)
                continue;
            if (is_aging)
                polygon.material = aged_material(polygon.material, *age);
            auto const* const first = from_.polygon_vertices_mm.data() + polygon.first_vertex;
            polygon.first_vertex = static_cast<std::uint32_t>(plant_.polygon_vertices_mm.size());
            plant_.polygon_vertices_mm.insert(plant_.polygon_vertices_mm.end(), first,
                                              first + polygon.vertex_count);
            plant_.polygons.push_back(polygon);
        }
    }

    Plant const& from_;
    Season const& season_;
    LeafSheets const& sheets_;
    Plant plant_;
    std::vector<Look> looks_; // Appearance of each organ shape.
    // New materials, by original material and age in thousandths.
    std::map<std::pair<MaterialId, long>, MaterialId> materials_;
    std::map<OrganShapeId, OrganShapeId> fallen_;
};

} // namespace

std::set<std::string> missing_leaves(Plant const& plant, Season const& season,
                                     LeafSheets const& sheets)
{
    std::set<std::string> missing;
    for (auto const& shape : plant.organ_shapes) {
        auto const calendar = calendar_of(plant, shape);
        auto const age = age_to_show(calendar, season.month);
        auto const order = age && !calendar.is_evergreen ? order_at(shape, *age) : std::nullopt;
        if (auto const name = order ? lsystem::leaf_sheet_name(*order) : std::string();
            order && !sheets.contains(name))
            missing.insert(name);
    }
    return missing;
}

Plant in_season(Plant const& plant, Season const& season, LeafSheets const& sheets)
{
    return Seasoner(plant, season, sheets).run();
}

} // namespace tractus::scene
