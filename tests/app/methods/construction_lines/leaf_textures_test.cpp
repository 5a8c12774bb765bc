#include "app/methods/construction_lines/line_organ_tool.h"
#include "app/methods/construction_lines/traced_picture.h"
#include "app/render/read_picture.h"
#include "app/session/edit_record.h"
#include "engine/lsystem/view/view_texture.h"
#include "engine/mesh/make_mesh.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/organ_edits.h"
#include "engine/scene/back_picture.h"
#include "tests/app/methods/construction_lines/construct_folder.h"
#include "tests/app/methods/construction_lines/drawn_frond.h"

#include <algorithm>
#include <sstream>

// Tests of pictures as textures of leaves that are drawn in three views.

namespace tractus::lines {
namespace {

using namespace line_tests;
using Leaf = LineOrganTool::What;

constexpr render::Color kRed { 200, 30, 20, 255 };
constexpr render::Color kGreen { 20, 160, 40, 255 };
constexpr render::Color kBlue { 30, 40, 220, 255 };

std::string png_of(render::Image const& image)
{
    std::ostringstream out;
    EXPECT_TRUE(render::write_png(out, image));
    return out.str();
}

// Returns a picture whose left half is green, right half red, and upper quarter blue.
render::Image flag(int width, int height)
{
    render::Image image(width, height, kGreen);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (4 * y < height)
                image.at(x, y) = kBlue;
            else if (2 * x >= width)
                image.at(x, y) = kRed;
    return image;
}

// Returns a curve 40 mm long, from (60, 0) upwards, that bulges by 8 mm to one side.
std::vector<Vec3> bow(double side)
{
    std::vector<Vec3> places;
    for (int i = 0; i <= 20; ++i) {
        double const t = i / 20.0;
        places.emplace_back(60 + side * 32 * t * (1 - t), 40 * t, 50);
    }
    return places;
}

class ConstructTextures : public ConstructFolder {
protected:
    void write_sketch(std::string const& texture)
    {
        std::ofstream(folder_ / "petals.json")
            << R"({"pattern":"spiral","nodes_per_layer":[5],"stem":[[0,0],[0,200]],
                "left":[[-40,-9],[-40,350]],
                "inclinations":[[[-60,75],[0,40],[60,75]],[[-60,195],[0,160],[60,195]]],
                "organ":{"left":[[-5,0],[-20,30],[0,80]],"right":[[5,0],[20,30],[0,80]],
                "midrib":[[0,0],[40,12],[80,0]],"section":[[-10,4],[0,0],[10,4]],
                "texture":)"
            << texture << "}}";
    }
    void write_picture(std::string const& bytes)
    {
        std::ofstream(folder_ / "petal.png", std::ios::binary) << bytes;
    }
    commands::Outcome construct(std::string const& output)
    {
        return commands::run({ "construct", path("petals.json"), "-o", path(output) });
    }
};

// The exported folder must contain the picture, and the exported text must give the same plant.
TEST_F(ConstructTextures, AreWrittenBesideTheModel)
{
    write_sketch("\"petal.png\"");
    auto const picture = png_of(flag(40, 80));
    write_picture(picture);
    auto const made = construct("out");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_NE(made.out.find("1 .s, 1 texture, .png, .glb"), std::string::npos) << made.out;
    EXPECT_TRUE(file_bytes(path("out/petals_organ.png")) == picture);
    EXPECT_EQ(commands::run({ "lsystem", "check", path("out/petals.l") }).err, "");
    ASSERT_EQ(commands::run({ "grow", path("out/petals.l"), "-o", path("again.glb") }).exit_code,
              0);
    auto const written = file_bytes(path("out/petals.glb"));
    EXPECT_TRUE(written == file_bytes(path("again.glb")));
    EXPECT_NE(written.find("\x89PNG"), std::string::npos);
    EXPECT_NE(written.find("\"baseColorFactor\":[1.0,1.0,1.0,1]"), std::string::npos)
        << "the picture stands for the colour";
}

// A session must contain the picture, so that it opens without the files of the model and the
// picture.
TEST_F(ConstructTextures, AreInTheSession)
{
    write_sketch("\"petal.png\"");
    write_picture(png_of(flag(40, 80)));
    ASSERT_EQ(commands::run({ "construct", path("petals.json"), "-o", path("out"), "--session" })
                  .exit_code,
              0);
    auto const written = file_bytes(path("out/petals.glb"));
    fs::rename(folder_ / "out/petals.tractus", folder_ / "alone.tractus");
    fs::remove_all(folder_ / "out");
    fs::remove(folder_ / "petal.png");
    auto const again = commands::run({ "grow", path("alone.tractus"), "-o", path("again.glb") });
    ASSERT_EQ(again.exit_code, 0) << again.err;
    auto const picture_in = [](std::string const& bytes) {
        auto const begin = std::min(bytes.find("\x89PNG"), bytes.size());
        return bytes.substr(begin, bytes.find("IEND", begin) - begin);
    };
    EXPECT_GT(picture_in(written).size(), 50U);
    EXPECT_TRUE(picture_in(written) == picture_in(file_bytes(path("again.glb"))));
}

TEST_F(ConstructTextures, SayWhatIsWrongWithThem)
{
    auto const said = [&](std::string const& texture) {
        write_sketch(texture);
        auto const made = construct("out");
        EXPECT_EQ(made.exit_code, 1);
        EXPECT_FALSE(fs::exists(folder_ / "out"));
        return made.err.substr(std::min(made.err.find("texture"), made.err.size()));
    };
    EXPECT_EQ(said("7"),
              "texture of the organ is no file: give the name of a PNG picture beside the sketch, "
              "such as \"petal.png\"\n");
    EXPECT_NE(said("\"none.png\"").find("none.png: No such file"), std::string::npos);
    write_picture("\xff\xd8\xff and no PNG");
    EXPECT_EQ(said("\"petal.png\""),
              "texture \"petal.png\" of the organ: it is no PNG picture: save it as one\n");
    write_picture(png_of(flag(40, 80)).substr(0, 60));
    EXPECT_NE(said("\"petal.png\"").find("the picture is damaged: "), std::string::npos);
}

class PenTextures : public ::testing::Test {
protected:
    PenTextures() { draw_frond(document_); }

    // Puts the flag, 20 mm wide and 40 mm high, behind the place where the leaf is drawn.
    void lay_picture(double x_mm = 60, double turn_deg = 0)
    {
        scene::LayPicture const lay {
            "flag.png",
            png_of(flag(200, 400)),
            { .x_mm = x_mm, .y_mm = 20, .width_mm = 20, .turn_deg = turn_deg }
        };
        change(lay);
        ASSERT_TRUE(document_.newest()->scene.state.picture);
    }
    void change(scene::Edit const& edit)
    {
        document_.make({ [edit](scene::Scene const&) {
            return Result<document::StepRequest::Change>({ { edit }, "" });
        } });
    }
    std::string leaf(std::vector<Vec3> const& places_mm, Leaf what,
                     OrganColor color = OrganColor::Picture)
    {
        document_.take_finished_strokes();
        document_.draw({ stroke_through(places_mm), LineOrganTool { what, color } });
        auto const drawn = document_.take_finished_strokes().back();
        return drawn.refusal.empty() ? drawn.message : drawn.refusal;
    }
    PenSketch const& sketch() { return *active_pen_sketch(document_.newest()->scene.state); }
    Plant const& plant() { return *document_.newest()->scene.base; }
    render::Image picture()
    {
        auto const& bytes = sketch().organs.back().picture;
        EXPECT_TRUE(bytes);
        return bytes ? render::read_picture(*bytes).value() : render::Image(1, 1);
    }

    document::Document document_ { scene::Scene {}, document::Document::Working::AtOnce };
};

// Returns the distance between two colours, as the sum of the differences of their channels.
int distance(render::Color const& one, render::Color const& other)
{
    return std::abs(one.red - other.red) + std::abs(one.green - other.green)
        + std::abs(one.blue - other.blue) + std::abs(one.alpha - other.alpha);
}

// The leaf's midrib is on the middle of the flag, and its base on the flag's lower edge. So the
// leaf's left half is green, its right half red, and the quarter at its tip blue.
TEST_F(PenTextures, AreWhatLiesBehindTheLeaf)
{
    lay_picture();
    leaf(bow(1), Leaf::Edge);
    auto const taken = picture();
    ASSERT_EQ(taken.height(), kLeafPictureLength);
    EXPECT_NEAR(taken.width(), kLeafPictureLength * 16.0 / 40, 2) << "by the leaf's breadth";
    int wrong = 0;
    for (int y = 0; y < taken.height(); ++y)
        for (int x = 0; x < taken.width(); ++x) {
            bool const is_near_seam
                = std::abs(4 * y - taken.height()) < 12 || std::abs(2 * x - taken.width()) < 8;
            auto const& expected = 4 * y < taken.height() ? kBlue
                : 2 * x >= taken.width()                  ? kRed
                                                          : kGreen;
            if (!is_near_seam && distance(taken.at(x, y), expected) > 0)
                ++wrong;
        }
    EXPECT_EQ(wrong, 0);
}

// On the plant's mesh, the left boundary must show the picture's left edge, and the base its lower
// edge.
TEST_F(PenTextures, LieBetweenTheBoundaries)
{
    lay_picture();
    leaf(bow(1), Leaf::Edge);
    auto const mesh = mesh::make_mesh(plant(), {});
    ASSERT_EQ(mesh.organs.size(), 1U);
    auto const& leaf_mesh = mesh.organs[0].prototype;
    auto const& material = plant().materials[leaf_mesh.material];
    ASSERT_TRUE(material.textures.base_color);
    EXPECT_EQ(material.textures.color, MaterialTextures::Color::Replaced);
    double const length = plant().organ_shapes[mesh.organs[0].shape].length_mm;
    for (std::size_t i = 0; i < leaf_mesh.positions_mm.size(); ++i) {
        double const t = leaf_mesh.positions_mm[i].y() / length;
        double const half = 0.8 * t * (1 - t) * length;
        double const u = leaf_mesh.texture_coordinates[i].x();
        EXPECT_NEAR(leaf_mesh.positions_mm[i].x(), (2 * u - 1) * half, 0.01 * length);
        EXPECT_NEAR(leaf_mesh.texture_coordinates[i].y(), t, 0.06);
    }
    // The first rows are at the leaf's base: they are green and red. The last rows are blue.
    auto const shown = render::read_picture(material.textures.base_color->bytes).value();
    EXPECT_EQ(shown.at(5, 20), kGreen);
    EXPECT_EQ(shown.at(shown.width() - 5, 20), kRed);
    EXPECT_EQ(shown.at(5, shown.height() - 10), kBlue);
}

// If the picture is rotated by half a turn, the leaf must show the other end of the picture.
TEST_F(PenTextures, GoWithHowThePictureLies)
{
    lay_picture(60, 180);
    leaf(bow(1), Leaf::Edge);
    auto const taken = picture();
    EXPECT_EQ(taken.at(5, 20), kRed);
    EXPECT_EQ(taken.at(taken.width() - 5, 20), kGreen);
    EXPECT_EQ(taken.at(5, taken.height() - 10), kBlue);
}

TEST_F(PenTextures, StayWhenThePictureIsTakenAway)
{
    lay_picture();
    leaf(bow(1), Leaf::Edge);
    auto const before = *sketch().organs.back().picture;
    change(scene::RemovePicture {});
    ASSERT_FALSE(document_.newest()->scene.state.picture);
    EXPECT_EQ(*sketch().organs.back().picture, before);
    leaf({ { 60, -40, 50 }, { 80, -34, 50 }, { 100, -40, 50 } }, Leaf::Midrib);
    EXPECT_EQ(sketch().organs.back().lines.size(), 2U) << "the midrib needs none";
    EXPECT_EQ(*sketch().organs.back().picture, before);
    EXPECT_TRUE(plant().materials.back().textures.base_color);
    leaf(bow(1), Leaf::Edge, OrganColor::Pink);
    EXPECT_FALSE(surface_of(sketch().organs.back())->picture);
}

TEST_F(PenTextures, NeedAPictureBehindTheLeaf)
{
    EXPECT_EQ(leaf(bow(1), Leaf::Edge),
              "no picture lies behind the leaf: lay one there, or choose a colour");
    lay_picture(-60);
    EXPECT_EQ(leaf(bow(1), Leaf::Edge),
              "the leaf lies beside the picture: draw it over the picture, or choose a colour");
    EXPECT_TRUE(sketch().organs.empty());
}

// The same strokes over the same picture must give equal bytes each time, and a session must keep
// them.
TEST_F(PenTextures, AreTheSameAgainAndInASession)
{
    lay_picture();
    leaf(bow(1), Leaf::Edge);
    auto const& organ = sketch().organs.back();
    auto const& back = *document_.newest()->scene.state.picture;
    EXPECT_EQ(traced_picture(organ, organ.lines.front().line.sheet, back).value(), *organ.picture);
    PaintOrgan const paint { .plant = 1, .picture = *organ.picture };
    auto const read = session::edit_of(session::record_of(paint), methods::all_methods().edits);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->get<PaintOrgan>()->picture, *organ.picture);
}

TEST_F(PenTextures, OfADamagedSessionAreRefused)
{
    lay_picture();
    leaf(bow(1), Leaf::Edge);
    auto const& scene = document_.newest()->scene;
    auto const refused
        = scene::apply_edit(scene, PaintOrgan { .plant = scene.state.active, .picture = "no PNG" });
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the leaf's picture: it is no PNG picture: save it as one");
}

TEST(LineOrganToolInLogs, SaysThatItsColourIsThePictures)
{
    EXPECT_EQ(line_of(LineOrganTool { Leaf::Edge, OrganColor::Picture }),
              "line_organ from_picture");
}

} // namespace
} // namespace tractus::lines
