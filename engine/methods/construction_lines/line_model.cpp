#include "engine/methods/construction_lines/line_model.h"

#include "engine/methods/construction_lines/function_curves.h"
#include "engine/methods/construction_lines/line_rules.h"
#include "engine/methods/construction_lines/model_text.h"

#include <fmt/format.h>
#include <utility>
#include <vector>

namespace tractus::lines {

namespace {

std::string arrays(Construction const& construction)
{
    return fmt::format("define: {{ {}; }}\n", fmt::join(arrays_of(construction), ";\n          "));
}

// Writes the part of the model's comment about the functions of sizes around the stem; empty if
// there are none.
std::string around_text(Construction const& construction)
{
    if (construction.around.empty())
        return "";
    return fmt::format(
        "   is for other models; 8 to {} sizes, too, at the azimuths around the stem "
        "in the table, of which\n"
        "   the last one is the first one again. A step makes a node. */\n",
        kFunctionsOfSides + construction.around.size());
}

} // namespace

LineModel write_model(Construction const& measured, Pattern const& pattern, std::string const& name)
{
    auto const construction = with_sizes_around(measured, pattern);
    auto const sizes
        = construction.around.empty() ? Pattern::Sizes::Linear : Pattern::Sizes::HalfEllipses;
    std::vector<std::pair<std::string, std::string>> functions;
    for (auto const& curve : function_curves(construction))
        functions.emplace_back(fmt::format("{}_{}.func", name, curve.name), function_file(curve));
    StemDefinitions const stem { .length = fmt::format("{:.6g}", construction.stem.length_mm()),
                                 .of = "the stem",
                                 .width = "(LEN / 60)",
                                 .layers = std::to_string(construction.nodes_per_layer.size()),
                                 .longest_piece = longest_piece(construction.stem),
                                 .sides = construction.around.empty()
                                     ? ""
                                     : std::to_string(construction.around.size()) };
    auto const around = around_text(construction);
    auto text = fmt::format(
        "/* A plant from construction lines, its organs {}. The functions of the place x on the "
        "stem,\n"
        "   0 to 1, are files that the view names: 1 the stem's heading, 2 its depth, 3 and 4 the\n"
        "   organs' angles on the left and the right, 5 and 6 their sizes; 7, the way to the next "
        "node,\n"
        "{}{}\n"
        "Lsystem: 1\n"
        "derivation length: {}\n"
        "{}Axiom: +(func(1, 0))^(func(2, 0))A(0, 0, 0, 0)\n\n"
        "{}endlsystem\n",
        name_of(pattern.kind),
        around.empty() ? "   is for other models. A step makes a node. */\n" : around,
        definitions_text(stem, pattern), count_steps(construction), arrays(construction),
        stem_rules(pattern, Stems::One, sizes));
    return model_with(std::move(text), functions, pattern, name);
}

std::vector<Vec3> organ_tips(Construction const& construction, Plant const& plant)
{
    constexpr double kPlantScale = 10; // Plant millimetres per millimetre of the sheet.
    Vec3 const base = construction.stem.point(0);
    std::vector<Vec3> tips;
    for (auto const& organ : plant.organs) {
        double const length_mm
            = plant.organ_shapes[organ.shape].length_mm * static_cast<double>(organ.scale.y());
        Vec3 const tip_mm = organ.position_mm + organ.orientation * Vec3(0, length_mm, 0);
        tips.emplace_back(base + Vec3(tip_mm.x(), tip_mm.z(), -tip_mm.y()) / kPlantScale);
    }
    return tips;
}

} // namespace tractus::lines
