#include "engine/plant/mtg_organs.h"

#include "engine/plant/table_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace tractus {

namespace {

constexpr double kLargestOrgan_mm = 1e7;
// Maximum number of shapes in a plant. A file may name one for every organ, but each shape needs a
// mesh.
constexpr std::size_t kMaxMtgShapes = 1000;

// Indices into kMtgOrganColumns; for a vector, the index of its x component.
enum MtgColumn : std::size_t {
    LengthColumn,
    WidthColumn,
    DepthColumn,
    PetioleColumn,
    DirectionColumn,
    NormalColumn = DirectionColumn + 3,
    ShapeColumn = NormalColumn + 3,
};

// Names of the kinds of shape in a file, in the order of OrganShape::Kind.
constexpr std::array<std::string_view, 6> kShapeWords { "blade", "needle",  "disc",
                                                        "ball",  "surface", "leaf" };

MtgOrganClass class_of(Plant const& plant, OrganShape const& shape)
{
    auto const material = plant.materials[shape.material].kind;
    bool const is_flat
        = shape.kind == OrganShape::Kind::Blade || shape.kind == OrganShape::Kind::Leaf;
    if (material == Material::Kind::Petal)
        return MtgOrganClass::Flower;
    return material == Material::Kind::Leaf || is_flat ? MtgOrganClass::Leaf : MtgOrganClass::Other;
}

// Returns the kind of shape that the file names. If it names none, or a surface or grown leaf,
// whose form the file does not hold, returns Ball for organs of class O and Blade for others.
OrganShape::Kind nearest_kind(MtgOrganClass organ_class, std::string_view shape)
{
    auto const word = shape.substr(0, shape.find('-'));
    auto const found = std::find(kShapeWords.begin(), kShapeWords.end(), word);
    auto const kind = static_cast<OrganShape::Kind>(found - kShapeWords.begin());
    bool const is_told = found != kShapeWords.end() && kind != OrganShape::Kind::Surface
        && kind != OrganShape::Kind::Leaf;
    if (is_told)
        return kind;
    return organ_class == MtgOrganClass::Other ? OrganShape::Kind::Ball : OrganShape::Kind::Blade;
}

Material material_of(MtgOrganClass organ_class)
{
    switch (organ_class) {
    case MtgOrganClass::Leaf:
        return { .name = "leaf",
                 .kind = Material::Kind::Leaf,
                 .base_color = { 0.30f, 0.48f, 0.17f },
                 .translucency = 0.4f };
    case MtgOrganClass::Flower:
        return { .name = "petal",
                 .kind = Material::Kind::Petal,
                 .base_color = { 0.93f, 0.87f, 0.90f },
                 .translucency = 0.3f };
    case MtgOrganClass::Other:
        break;
    }
    return { .name = "organ",
             .kind = Material::Kind::Solid,
             .base_color = { 0.55f, 0.35f, 0.20f },
             .roughness = 0.6f };
}

// Returns part / whole, or `otherwise` if that ratio is too large or `whole` is not above 0.
float share_of(double part, double whole, float otherwise)
{
    constexpr double kGreatest = 1e6;
    double const share = part / whole;
    return whole > 0 && std::abs(share) <= kGreatest ? static_cast<float>(share) : otherwise;
}

// Returns the rotation from the organ frame to the plant frame.
Quat orientation_of(MtgOrgan const& organ)
{
    Vec3 const along = organ.direction.normalized();
    auto const across
        = [&](Vec3 const& normal) -> Vec3 { return along.cross(normal.normalized()); };
    constexpr double kMinSine = 1e-6;
    Vec3 right = across(organ.normal);
    if (!(right.norm() > kMinSine)) // The normal is missing or parallel to the organ.
        right = across(Vec3::UnitZ());
    if (!(right.norm() > kMinSine))
        right = along.unitOrthogonal();
    right.normalize();
    Eigen::Matrix3d axes;
    axes << right, along, right.cross(along);
    return Quat(axes);
}

// The organ shapes that the organs of a file add to a plant.
class MtgShapes {
public:
    explicit MtgShapes(Plant& plant)
        : plant_(plant)
    {
    }

    // Adds the organ's shape, or enlarges it for the organ. Must be called for all organs before
    // the first one is placed.
    void count(MtgOrgan const& organ)
    {
        auto const [found, is_new] = ids_.try_emplace(key_of(organ));
        if (is_new) {
            found->second = static_cast<OrganShapeId>(plant_.organ_shapes.size());
            plant_.organ_shapes.push_back(new_shape(organ));
        }
        auto& shape = plant_.organ_shapes[found->second];
        if (std::abs(organ.length) > shape.length_mm) {
            shape.length_mm = std::abs(organ.length);
            if (shape.kind == OrganShape::Kind::Blade)
                shape.petiole_mm = std::min(std::abs(organ.petiole), shape.length_mm);
        }
        shape.width_mm = std::max(shape.width_mm, std::abs(organ.width));
    }

    void place(MtgOrgan const& organ, Organ& placed) const
    {
        auto const found = ids_.find(key_of(organ));
        placed.shape = found->second;
        auto const& shape = plant_.organ_shapes[placed.shape];
        placed.scale.y() = share_of(organ.length, shape.length_mm, 1);
        placed.scale.x() = share_of(organ.width, shape.width_mm, 1);
        placed.scale.z() = organ.depth ? share_of(*organ.depth, shape.width_mm, placed.scale.x())
                                       : placed.scale.x();
    }

private:
    using Key = std::pair<MtgOrganClass, std::string_view>;

    // Returns the key of an organ's shape. Once there are kMaxMtgShapes shapes, organs with a new
    // shape share one unnamed shape for each class.
    Key key_of(MtgOrgan const& organ) const
    {
        Key const key { organ.kind, organ.shape };
        return ids_.size() < kMaxMtgShapes || ids_.contains(key) ? key : Key { organ.kind, {} };
    }

    OrganShape new_shape(MtgOrgan const& organ)
    {
        auto& material = materials_[static_cast<std::size_t>(organ.kind)];
        if (!material) {
            material = static_cast<MaterialId>(plant_.materials.size());
            plant_.materials.push_back(material_of(organ.kind));
        }
        OrganShape shape { .name = fmt::format("{} {}", plant_.materials[*material].name,
                                               plant_.organ_shapes.size() + 1),
                           .kind = nearest_kind(organ.kind, organ.shape),
                           .material = *material };
        shape.length_mm = 0;
        shape.width_mm = 0;
        return shape;
    }

    Plant& plant_;
    std::map<Key, OrganShapeId> ids_;
    std::array<std::optional<MaterialId>, 3> materials_ {};
};

} // namespace

char mtg_symbol(MtgOrganClass kind)
{
    constexpr std::string_view kSymbols = "LFO";
    return kSymbols[static_cast<std::size_t>(kind)];
}

MtgOrgan mtg_organ(Plant const& plant, Organ const& organ)
{
    auto const& shape = plant.organ_shapes[organ.shape];
    Vec3 const scale = organ.scale.cast<double>();
    Quat const turn = organ.orientation.normalized();
    MtgOrgan result { .kind = class_of(plant, shape),
                      .position = organ.position_mm,
                      .direction = turn * Vec3::UnitY(),
                      .normal = turn * Vec3::UnitZ(),
                      .length = shape.length_mm * scale.y(),
                      .width = shape.width_mm * scale.x(),
                      .petiole = shape.petiole_mm * scale.y() };
    if (scale.z() != scale.x())
        result.depth = shape.width_mm * scale.z();
    return result;
}

std::string mtg_shape_name(Plant const& plant, OrganShapeId shape)
{
    auto const kind = plant.organ_shapes[shape].kind;
    return fmt::format("{}-{}", kShapeWords[static_cast<std::size_t>(kind)], shape + 1);
}

std::optional<MtgOrganColumns> MtgOrganColumns::find(std::span<std::string_view const> names,
                                                     std::size_t first)
{
    MtgOrganColumns result;
    for (std::size_t i = 0; i < kMtgOrganColumns.size(); ++i)
        for (auto column = first; column < names.size() && !result.columns_[i]; ++column)
            if (names[column] == kMtgOrganColumns[i])
                result.columns_[i] = column;
    for (auto const needed : { LengthColumn, DirectionColumn, MtgColumn { DirectionColumn + 1 },
                               MtgColumn { DirectionColumn + 2 } })
        if (!result.columns_[needed])
            return std::nullopt;
    return result;
}

std::optional<MtgOrgan> MtgOrganColumns::read(std::span<std::string_view const> cells) const
{
    auto const cell = [&](std::size_t which) {
        auto const column = columns_[which];
        return column && *column < cells.size() ? cells[*column] : std::string_view {};
    };
    auto const coordinate = [&](std::size_t which) {
        return number_in(cell(which)).value_or(std::numeric_limits<double>::quiet_NaN());
    };
    auto const vector = [&](std::size_t which) {
        return Vec3(coordinate(which), coordinate(which + 1), coordinate(which + 2));
    };
    constexpr double kGreatest = 1e9; // Limit of coordinates, so that their squares are finite.
    auto const is_vector = [&](Vec3 const& v) {
        return v.allFinite() && v.cwiseAbs().maxCoeff() < kGreatest && v.norm() > 1 / kGreatest;
    };
    MtgOrgan organ { .direction = vector(DirectionColumn), .normal = vector(NormalColumn) };
    auto const length = number_in(cell(LengthColumn));
    if (!length || !is_vector(organ.direction))
        return std::nullopt;
    if (!is_vector(organ.normal))
        organ.normal.setZero();
    organ.length = *length;
    organ.width = number_in(cell(WidthColumn)).value_or(0.5 * *length);
    organ.depth = number_in(cell(DepthColumn));
    organ.petiole = number_in(cell(PetioleColumn)).value_or(0);
    organ.shape = cell(ShapeColumn);
    return organ;
}

bool is_plausible_organ(MtgOrgan const& organ, Vec3 const& base_mm)
{
    auto const is_size = [](double size_mm) { return std::abs(size_mm) <= kLargestOrgan_mm; };
    return is_size(organ.length) && is_size(organ.width) && is_size(organ.depth.value_or(0))
        && is_size(organ.petiole) && organ.position.allFinite()
        && is_size((organ.position - base_mm).cwiseAbs().maxCoeff());
}

void add_mtg_organs(MeasuredPlant& measured, std::span<MtgOrgan const> organs)
{
    auto& plant = measured.plant;
    MtgShapes shapes(plant);
    for (auto const& organ : organs)
        shapes.count(organ);
    for (auto const& organ : organs) {
        Organ placed { .segment = organ.node == kNone ? kNone : measured.segments[organ.node],
                       .position_mm = organ.position - measured.base_mm,
                       .orientation = orientation_of(organ) };
        shapes.place(organ, placed);
        plant.organs.push_back(placed);
    }
}

} // namespace tractus
