#include "engine/methods/construction_lines/organ_text.h"

#include "engine/methods/construction_lines/model_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>

namespace tractus::lines {

namespace {

// Material of leaves; material 1 is that of the stem. Surfaces need it because by default a surface
// has the turtle's current colour, which is the stem's.
constexpr std::size_t kLeafMaterial = 2;

char letter_of_surface(std::size_t number)
{
    constexpr std::string_view kLetters = "abcdefghijk";
    static_assert(kLetters.size() == kMaxSurfaces);
    return kLetters[number];
}

// Returns the material number of a surface. Surfaces that are organs of layers are numbered first,
// then those that replace leaves.
std::size_t material_of_surface(std::size_t number)
{
    return kLeafMaterial + 1 + number;
}

std::string name_of_model(LineModel const& model)
{
    auto const& name = model.source.name;
    return name.substr(0, name.rfind('.'));
}

std::string ending_of(char letter, std::string const& word)
{
    return letter == 'l' ? word : fmt::format("{}_{}", word, letter);
}

// True if a surface has its own material, because it has a colour or a picture.
bool is_colored(OrganSurface const& surface)
{
    return surface.color || surface.picture;
}

// Adds a surface's own material, and its picture as a file beside the surface's file.
void add_material(LineModel& model, OrganSurface const& surface, std::size_t material,
                  std::string const& name, std::string const& surface_file)
{
    auto const color = surface.color.value_or(Vec3(0.26, 0.46, 0.16));
    std::string texture;
    if (surface.picture) {
        auto const file = surface_file.substr(0, surface_file.rfind('.')) + ".png";
        texture = " texture=" + file;
        model.functions[file] = *surface.picture;
    }
    model.source.view_text += fmt::format(
        "material: {} {} kind=leaf color={:.4g},{:.4g},{:.4g} roughness=0.5 translucency=0.45{}\n",
        material, name, color.x(), color.y(), color.z(), texture);
}

} // namespace

std::string format_surface(std::vector<BezierPatch> const& patches)
{
    Vec3 low = patches.front().control[0];
    Vec3 high = low;
    for (auto const& patch : patches)
        for (auto const& point : patch.control) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    double const length
        = (patches[patches.size() - kAcross].control[12] + patches.back().control[15]).y() / 2;
    // UP along -z makes z in the file point to the lower side, as in cpfg's editor.
    auto text = fmt::format(
        "{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\nCONTACT POINT  X: 0 Y: 0 Z: 0\n"
        "END POINT  X: 0 Y: 0 Z: 0\nHEADING  X: 0 Y: 1 Z: 0\nUP  X: 0 Y: 0 Z: -1\nSIZE: {:.6g}\n",
        low.x(), high.x(), low.y(), high.y(), low.z(), high.z(), length);
    auto const name = [](std::uint16_t number) {
        return number == BezierPatch::kNoPatch ? "~" : fmt::format("p{}", number);
    };
    for (std::size_t i = 0; i < patches.size(); ++i) {
        auto const& sides = patches[i].neighbors;
        text += fmt::format("p{}\nTOP COLOR: 0 DIFFUSE: 0.00 BOTTOM COLOR: 0 DIFFUSE: 0.00\n"
                            "AL: ~ A: {} AR: ~\nL: {} R: {}\nBL: ~ B: {} BR: ~\n",
                            i, name(sides[BezierPatch::Above]), name(sides[BezierPatch::Left]),
                            name(sides[BezierPatch::Right]), name(sides[BezierPatch::Below]));
        auto const number = [&](double value) { // Replaces rounding residues by 0.
            return std::fabs(value) < 1e-9 * length ? 0 : value;
        };
        for (std::size_t k = 0; k < 16; ++k) {
            auto const& point = patches[i].control[k];
            text += fmt::format("{:.6g} {:.6g} {:.6g}{}", number(point.x()), number(point.y()),
                                number(point.z()), k % 4 == 3 ? "\n" : "  ");
        }
    }
    return text;
}

void put_leaf(LineModel& model, OrganSurface const& surface, char letter)
{
    auto& view = model.source.view_text;
    auto const file = name_of_model(model) + ending_of(letter, "_organ") + ".s";
    auto const begin = view.find(fmt::format("organ: {} ", letter));
    view.replace(begin, view.find('\n', begin) - begin,
                 fmt::format("surface: {} {} 1", letter, file));
    auto material = kLeafMaterial;
    if (is_colored(surface)) {
        material = material_of_surface(kMaxSurfaces) + static_cast<std::size_t>(letter - 'a');
        add_material(model, surface, material, fmt::format("leaf_{}", letter), file);
    }
    replace_all(model.source.text, fmt::format("~{}(", letter),
                fmt::format(";({})~{}(", material, letter));
    model.functions[file] = format_surface(surface.patches);
}

// Returns the surface of a plain blade. `width` is a share of the blade's length; the blade is
// widest at two fifths of its length.
static std::vector<BezierPatch> blade_surface(double width)
{
    constexpr double kLength_mm = 100;
    constexpr int kPoints = 24;
    double const power = std::log(0.5) / std::log(0.4);
    OrganViews views;
    for (int i = 0; i <= kPoints; ++i) {
        double const t = static_cast<double>(i) / kPoints;
        double const half_mm = width * kLength_mm / 2 * std::sin(kPi * std::pow(t, power));
        views.left.emplace_back(-half_mm, kLength_mm * t);
        views.right.emplace_back(half_mm, kLength_mm * t);
    }
    return organ_surface(views).value();
}

void add_blade_surfaces(LineModel& model)
{
    constexpr std::string_view kOrgan = "organ: ";
    constexpr std::string_view kWidth = "width=";
    auto& view = model.source.view_text;
    std::string surfaces;
    for (auto at = view.find(kOrgan); at != std::string::npos; at = view.find(kOrgan, at + 1)) {
        char const letter = view[at + kOrgan.size()];
        double const width
            = std::strtod(view.c_str() + view.find(kWidth, at) + kWidth.size(), nullptr);
        auto const file = name_of_model(model) + ending_of(letter, "_leaf") + ".s";
        surfaces += fmt::format("surface: {} {} 1\n", letter, file);
        model.functions[file] = format_surface(blade_surface(width));
    }
    view += surfaces;
}

std::size_t count_surfaces(std::span<LineOrgan const> organs)
{
    return static_cast<std::size_t>(std::count_if(
        organs.begin(), organs.end(), [](LineOrgan const& organ) { return !organ.sketch; }));
}

std::string surface_rules(std::span<LineOrgan const> organs, std::size_t before,
                          std::string const& place)
{
    std::string text;
    for (std::size_t i = 0; i < organs.size(); ++i) {
        if (organs[i].sketch)
            continue;
        auto const material
            = is_colored(organs[i].surface) ? material_of_surface(before) : kLeafMaterial;
        text += fmt::format("Q({}, h) : organ[z] == {} --> ;({})~{}(LEN * h)\n", place, i + 1,
                            material, letter_of_surface(before));
        ++before;
    }
    return text;
}

Result<void> add_surfaces(LineModel& model, std::span<LineOrgan const> organs, std::size_t before)
{
    for (auto const& organ : organs) {
        if (organ.sketch)
            continue;
        if (before >= kMaxSurfaces)
            return fail(Fault::User,
                        fmt::format("layers of the plant bear more than {} drawn organs: leave "
                                    "some out",
                                    kMaxSurfaces));
        auto const file = fmt::format("{}_organ_{}.s", name_of_model(model), before + 1);
        if (is_colored(organ.surface))
            add_material(model, organ.surface, material_of_surface(before),
                         fmt::format("organ_{}", before + 1), file);
        model.source.view_text
            += fmt::format("surface: {} {} 1\n", letter_of_surface(before), file);
        model.functions[file] = format_surface(organ.surface.patches);
        ++before;
    }
    return {};
}

} // namespace tractus::lines
