#include "app/render/leaf_parts.h"
#include "engine/base/random.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/plant/leaf_spray.h"
#include "tests/app/render/renderer_fixture.h"
#include "tests/engine/mesh/bent_leaf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>

namespace tractus::render {

namespace {

// The picture of a leaf with deep lobes: about a third of it is opaque.
TextureSlot lobed_leaf()
{
    constexpr int kSide = 128;
    Image image(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            double const across = std::abs(x + 0.5 - kSide / 2.0);
            double const lobe = 28 + 24 * std::sin(0.35 * y);
            double const alpha = std::clamp(lobe - across + 0.5, 0.0, 1.0);
            image.at(x, y) = Color { static_cast<std::uint8_t>(70 + y / 3), 130, 40,
                                     static_cast<std::uint8_t>(std::lround(255 * alpha)) };
        }
    std::ostringstream png;
    EXPECT_TRUE(write_png(png, image));
    return std::make_shared<TexturePicture const>(
        TexturePicture { png.str(), TexturePicture::Edges::Clamp });
}

enum class Leaves { Pictured, Plain, Bent, Needles };

// A leaf of 30 mm of four triangles, folded along its midrib.
mesh::TriangleMesh folded_leaf()
{
    mesh::TriangleMesh leaf;
    for (float const x : { -10.0f, 0.0f, 10.0f })
        for (float const y : { 0.0f, 30.0f }) {
            leaf.positions_mm.emplace_back(x, y, std::abs(x) * 0.3f);
            leaf.normals.emplace_back(Vec3f(-x * 0.03f, 0, 1).normalized());
            leaf.texture_coordinates.emplace_back(0.5f + x / 20, 1 - y / 30);
        }
    leaf.indices = { 0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5 };
    return leaf;
}

// A shoot of 64 needles, 1 mm wide.
mesh::TriangleMesh needles()
{
    Plant plant;
    plant.materials = { Material { .kind = Material::Kind::Leaf } };
    plant.organ_shapes = { leaf_spray(
        { .per_spray = 64, .length = 0.3, .width = 1.0 / 30, .first_share = 0 }, 0, 1) };
    plant.organs = { Organ { .scale = Vec3f::Constant(0.5f) } };
    return mesh::make_prototype(plant, 0);
}

// A crown of leaves of 30 mm, or of shoots, in a ball.
mesh::Mesh crown(Leaves kind)
{
    mesh::Mesh made;
    made.materials.push_back(
        { .name = "leaf", .kind = Material::Kind::Leaf, .base_color = { 0.25f, 0.5f, 0.15f } });
    if (kind != Leaves::Plain && kind != Leaves::Needles)
        made.materials[0].textures = { .base_color = lobed_leaf(),
                                       .alpha = MaterialTextures::Alpha::Mask,
                                       .color = MaterialTextures::Color::Replaced };
    auto& organ = made.organs.emplace_back();
    organ.prototype = kind == Leaves::Bent ? mesh::bent_leaf()
        : kind == Leaves::Needles          ? needles()
                                           : folded_leaf();
    Random random({ .seed = 4, .stream = 1 });
    while (organ.instances.size() < 4000) {
        Vec3 const place(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        Vec3 const axis(random.normal(), random.normal(), random.normal());
        if (place.norm() > 1 || axis.norm() < 0.1)
            continue;
        organ.instances.push_back(
            { .translation_mm = (220 * place + Vec3(0, 0, 240)).cast<float>(),
              .rotation = Quatf(Eigen::AngleAxisf(static_cast<float>(random.uniform(-3, 3)),
                                                  axis.normalized().cast<float>())),
              .scale = Vec3f::Constant(static_cast<float>(random.uniform(0.7, 1.3))) });
    }
    return made;
}

// Returns the crown with its leaves merged into one surface.
mesh::Mesh merged(mesh::Mesh const& crown)
{
    mesh::Mesh made { .materials = crown.materials };
    auto& surface = made.surfaces.emplace_back();
    auto const& organ = crown.organs[0];
    for (auto const& instance : organ.instances) {
        auto const first = static_cast<std::uint32_t>(surface.positions_mm.size());
        for (auto const& position : organ.prototype.positions_mm)
            surface.positions_mm.push_back(mesh::placed(instance, position));
        for (auto const& normal : organ.prototype.normals)
            surface.normals.push_back(instance.rotation * normal);
        surface.texture_coordinates.insert(surface.texture_coordinates.end(),
                                           organ.prototype.texture_coordinates.begin(),
                                           organ.prototype.texture_coordinates.end());
        for (auto const index : organ.prototype.indices)
            surface.indices.push_back(first + index);
    }
    return made;
}

int most_different(Color const& a, Color const& b)
{
    return std::max(
        { std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue) });
}

} // namespace

class FarLeaves : public RendererTest {
protected:
    Image drawn(mesh::Mesh const& mesh, int width, bool has_ground = true)
    {
        GpuMesh const on_card(mesh);
        Stage stage;
        stage.meshes.push_back({ &on_card });
        stage.backdrop.has_ground = has_ground;
        return renderer_->picture(stage, camera(), width, width * 3 / 4);
    }
};

TEST_F(FarLeaves, LookAlikeMergedAndInstanced)
{
    for (auto const kind : { Leaves::Pictured, Leaves::Plain }) {
        auto const mesh = crown(kind);
        auto const instanced = drawn(mesh, 330);
        auto const one = drawn(merged(mesh), 330);
        std::size_t different = 0;
        for (std::size_t i = 0; i < instanced.pixels().size(); ++i)
            different += most_different(instanced.pixels()[i], one.pixels()[i]) > 8;
        EXPECT_LT(double(different), 0.02 * double(instanced.pixels().size()));
    }
}

TEST_F(FarLeaves, HaveTheSameMeanColorInSmallPictures)
{
    auto const mesh = crown(Leaves::Pictured);
    auto const mean = [&](int width) {
        Vec3 sum = Vec3::Zero();
        auto const picture = drawn(mesh, width, false);
        for (auto const& pixel : picture.pixels())
            sum += Vec3(pixel.red, pixel.green, pixel.blue);
        return Vec3(sum / double(picture.pixels().size()));
    };
    Vec3 const large = mean(1600);
    for (int const width : { 800, 320 })
        EXPECT_LT((mean(width) - large).cwiseAbs().maxCoeff(), 2.5) << width;
}

// Returns a picture that is smaller by a whole factor.
Image smaller(Image const& picture, int factor)
{
    Image made(picture.width() / factor, picture.height() / factor);
    for (int y = 0; y < made.height(); ++y)
        for (int x = 0; x < made.width(); ++x) {
            Vec3 sum = Vec3::Zero();
            for (int j = 0; j < factor; ++j)
                for (int i = 0; i < factor; ++i) {
                    auto const& pixel = picture.at(x * factor + i, y * factor + j);
                    sum += Vec3(pixel.red, pixel.green, pixel.blue);
                }
            Vec3 const mean = sum / (factor * factor);
            auto const byte = [](double value) { return static_cast<std::uint8_t>(value + 0.5); };
            made.at(x, y) = Color { byte(mean.x()), byte(mean.y()), byte(mean.z()), 255 };
        }
    return made;
}

// Merged leaves are drawn with all their triangles, instances with few of them.
TEST_F(FarLeaves, LookInSmallPicturesAsLargeOnesMadeSmaller)
{
    for (auto const kind : { Leaves::Bent, Leaves::Needles })
        for (int const width : { 160, 320 }) {
            auto const mesh = crown(kind);
            auto const one = merged(mesh);
            auto const truth = smaller(drawn(one, 4 * width), 4);
            auto const difference = [&](mesh::Mesh const& drawn_mesh) {
                auto const picture = drawn(drawn_mesh, width);
                double sum = 0;
                for (std::size_t i = 0; i < truth.pixels().size(); ++i)
                    sum += most_different(picture.pixels()[i], truth.pixels()[i]);
                return sum / static_cast<double>(truth.pixels().size());
            };
            double const of_all = difference(one);
            // Other needles are left than those that all of them show.
            EXPECT_LT(difference(mesh), kind == Leaves::Needles ? 1.1 * of_all : of_all + 0.3)
                << "all: " << of_all;
        }
}

TEST_F(FarLeaves, HaveFewTrianglesInSmallPictures)
{
    auto const mesh = crown(Leaves::Bent);
    GLuint query = 0;
    glGenQueries(1, &query);
    auto const triangles_in = [&](int width) {
        glBeginQuery(GL_PRIMITIVES_GENERATED, query);
        drawn(mesh, width);
        glEndQuery(GL_PRIMITIVES_GENERATED);
        GLuint count = 0;
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
        return count;
    };
    // The leaves are drawn twice, for their shadow, too. Its map is finer than a small picture.
    auto const all = 2 * mesh.organs[0].instances.size() * mesh::bent_leaf().indices.size() / 3;
    EXPECT_LT(triangles_in(160), all / 8);
    glDeleteQueries(1, &query);
}

TEST(LeafParts, AreConnectedByTriangles)
{
    auto const mesh = merged(crown(Leaves::Plain));
    auto const parts = connected_parts(mesh.surfaces[0]);
    ASSERT_EQ(parts.counts.size(), 4000u);
    EXPECT_EQ(std::ranges::count(parts.counts, 6u), 4000);
    EXPECT_EQ(parts.part[6], 1u);
    auto const& surface = mesh.surfaces[0];
    Vec3f sum = Vec3f::Zero();
    for (std::size_t i = 6; i < 12; ++i)
        sum += surface.positions_mm[i] / 6;
    EXPECT_LT((parts.middles_mm[1] - sum).norm(), 1e-3f);
}

TEST(LeafParts, ThinnedKeepTheirArea)
{
    auto const shoot = needles();
    auto with_wide = shoot;
    auto const versions = thinned_versions(with_wide);
    ASSERT_EQ(versions.size(), 3u);
    auto const area_mm2 = [&](auto const& indices) {
        double sum = 0;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            auto const& a = with_wide.positions_mm[indices[i]];
            Vec3f const b = with_wide.positions_mm[indices[i + 1]] - a;
            Vec3f const c = with_wide.positions_mm[indices[i + 2]] - a;
            sum += double(b.cross(c).norm()) / 2;
        }
        return sum;
    };
    auto former = shoot.indices.size();
    for (auto const& version : versions) {
        EXPECT_EQ(version.indices.size(), former / 2);
        EXPECT_NEAR(area_mm2(version.indices), area_mm2(shoot.indices),
                    0.05 * area_mm2(shoot.indices));
        former = version.indices.size();
    }
    EXPECT_TRUE(std::equal(shoot.positions_mm.begin(), shoot.positions_mm.end(),
                           with_wide.positions_mm.begin()));
    auto leaf = mesh::bent_leaf();
    EXPECT_TRUE(thinned_versions(leaf).empty());
}

TEST(LeafParts, DifferFromEachOther)
{
    std::array<int, 4> quarters {};
    for (int i = 0; i < 1000; ++i) {
        auto const values = individual_at(Vec3f(static_cast<float>(i) * 7, 3, -50));
        EXPECT_GE(values.minCoeff(), 0);
        EXPECT_LE(values.maxCoeff(), 1);
        ++quarters[static_cast<std::size_t>(2 * (values.x() < 0.5f) + (values.y() < 0.5f))];
    }
    EXPECT_GT(std::ranges::min(quarters), 180);
}

} // namespace tractus::render
