#include "engine/plant/leaf_spray.h"

#include "engine/base/random.h"

#include <algorithm>
#include <fmt/format.h>

namespace tractus {

// A flat patch with these four corners in order.
static BezierPatch lozenge(Vec3 const& base, Vec3 const& right, Vec3 const& tip, Vec3 const& left)
{
    BezierPatch patch;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            double const s = static_cast<double>(row) / 3;
            double const t = static_cast<double>(column) / 3;
            patch.control[4 * row + column]
                = (1 - s) * ((1 - t) * base + t * right) + s * ((1 - t) * left + t * tip);
        }
    return patch;
}

OrganShape leaf_spray(SprayForm const& form, MaterialId material, std::uint32_t variant)
{
    constexpr std::uint32_t kStream = 0x5a1;
    constexpr double kSpiral_deg = 137.5;
    Random random({ .seed = 1, .stream = kStream, .substream = variant });
    OrganShape spray;
    spray.name = fmt::format("spray {}", variant + 1);
    spray.kind = OrganShape::Kind::Surface;
    spray.material = material;
    spray.length_mm = kSprayLength_mm;
    spray.width_mm = kSprayLength_mm;
    double const first_deg = random.uniform(0, 360);
    for (int i = 0; i < form.per_spray; ++i) {
        double const share = (i + 0.5) / form.per_spray;
        double const along
            = form.first_share + (1 - form.first_share) * share * (1 - 0.5 * form.length);
        double const turn = radians(first_deg + i * kSpiral_deg + random.uniform(-25, 25));
        // The leaf angle decreases towards the tip.
        double const lean = radians(form.lean_deg * (1.15 - 0.6 * share) + random.uniform(-8, 8));
        double const length_mm
            = kSprayLength_mm * form.length * random.uniform(0.8, 1.15) * (1.1 - 0.4 * share);
        Vec3 const out(std::cos(turn), 0, std::sin(turn));
        Vec3 const way = std::cos(lean) * Vec3::UnitY() + std::sin(lean) * out;
        Vec3 across = way.cross(Vec3::UnitZ() + 0.3 * out);
        across = across.norm() > 1e-6 ? Vec3(across.normalized()) : Vec3(Vec3::UnitX());
        Vec3 const base(0, along * kSprayLength_mm, 0);
        Vec3 const middle = base + 0.45 * length_mm * way;
        Vec3 const half = 0.5 * form.width * length_mm * across;
        spray.patches.push_back(
            lozenge(base, middle + half, base + length_mm * way, middle - half));
        Eigen::Matrix3d axes;
        axes << across, way, across.cross(way);
        spray.spray.push_back({ .base_mm = base,
                                .orientation = Quat(axes).normalized(),
                                .length_mm = length_mm,
                                .width_mm = form.width * length_mm });
    }
    return spray;
}

OrganShape spray_twig(MaterialId material)
{
    OrganShape twig;
    twig.name = "twig";
    twig.kind = OrganShape::Kind::Needle;
    twig.material = material;
    twig.length_mm = 0.95 * kSprayLength_mm;
    twig.width_mm = 0.012 * kSprayLength_mm;
    twig.curl_rad = 0;
    return twig;
}

} // namespace tractus
