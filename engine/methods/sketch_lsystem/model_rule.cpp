#include "engine/methods/sketch_lsystem/model_rule.h"

#include "engine/methods/sketch_lsystem/stroke_resampler.h"
#include "engine/scene/lsystem_source.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tractus::sketch {

namespace {

constexpr double kUnit_mm = 10; // Millimetres of the plant per turtle unit, which is a centimetre.

// The lengths of all segments that a drawn axis can have at most, in the model's unit.
std::vector<double> all_lengths(AxisContract const& contract)
{
    // Minimum length of an added segment, as a share of the first length.
    constexpr double kShortest = 0.02;
    std::vector<double> lengths;
    for (double const length : contract.lengths)
        lengths.push_back(rounded_as_text(length));
    auto const given = lengths.size();
    double const ratio = given > 1 ? lengths[given - 1] / lengths[given - 2] : 1;
    while (lengths.size() < kMaxModelSegments) {
        double const next = rounded_as_text(lengths.back() * ratio);
        if (!(next >= kShortest * lengths.front()) || !std::isfinite(next))
            break;
        lengths.push_back(next);
    }
    lengths.resize(std::min<std::size_t>(lengths.size(), kMaxModelSegments));
    return lengths;
}

std::string array_of(std::span<double const> values)
{
    std::string text;
    for (double const value : values)
        text += fmt::format("{}{:g}", text.empty() ? "" : ", ", value);
    return fmt::format("{{{}}}", text);
}

} // namespace

SegmentLengths lengths_on_desk(AxisContract const& contract, double scale)
{
    auto lengths = all_lengths(contract);
    int const most = static_cast<int>(lengths.size());
    for (double& length : lengths)
        length *= kUnit_mm * scale;
    return { std::move(lengths), 1, 0, most };
}

Result<lsystem::ModelSource> model_along(ModelRule const& model, std::span<Vec3 const> nodes_mm,
                                         double scale)
{
    auto const contract = TRY(contract_of(model.source.name, model.source.text));
    auto const axis = aim_axis(lengths_on_desk(contract, scale), nodes_mm);
    auto const lengths = all_lengths(contract);
    auto const count = axis.turns.size();
    auto source = model.source;
    source.text = with_values(source.text, contract,
                              { .count = count,
                                .length = array_of(std::span(lengths).first(count)),
                                .plane = array_of(axis.turns, &Turn::plane_deg),
                                .bend = array_of(axis.turns, &Turn::bend_deg) });
    return source;
}

Result<ModelAxis> axis_along(ModelRule const& model, std::span<Vec3 const> nodes_mm, double scale)
{
    auto const contract = TRY(contract_of(model.source.name, model.source.text));
    auto const lengths = lengths_on_desk(contract, scale);
    ModelAxis result { .axis = aim_axis(lengths, nodes_mm) };
    result.nodes_mm = nodes_of(result.axis, lengths);
    return result;
}

Result<void> check_follows(std::string const& name, Plant const& plant,
                           std::span<Vec3 const> nodes_mm)
{
    constexpr double kOff = 1e-3;
    std::span<Vec3 const> axis_mm;
    if (!plant.axes.empty())
        axis_mm = plant.positions(plant.axes.front());
    for (std::size_t i = 1; i < nodes_mm.size(); ++i) {
        if (i < axis_mm.size()
            && (axis_mm[i] - nodes_mm[i]).norm() <= kOff * (nodes_mm[i] - nodes_mm[i - 1]).norm())
            continue;
        return fail(Fault::User,
                    fmt::format("{}: its first axis leaves the stroke at segment {}: the drawn "
                                "segments begin where the turtle does, each is one F, and between "
                                "them nothing rolls, bends, is left to chance or to tropism but "
                                "in brackets",
                                name, i));
    }
    return {};
}

// The nodes of a short, increasingly bent test stroke, in millimetres on the desk.
static std::vector<Vec3> short_nodes_mm(SegmentLengths const& lengths)
{
    constexpr std::size_t kSegments = 6;
    std::vector<Vec3> nodes_mm { Vec3::Zero() };
    Vec3 way(0.2, 0.1, 1);
    for (std::size_t i = 0; i < std::min(kSegments, lengths.first_mm.size()); ++i) {
        nodes_mm.push_back(nodes_mm.back() + lengths.first_mm[i] * way.normalized());
        way += Vec3(0.3, -0.15 * static_cast<double>(i), 0);
    }
    return nodes_mm;
}

std::vector<std::string> missing_for_stroke(ModelRule const& model,
                                            scene::LoadOptions const& options)
{
    auto const reading = read_contract(model.source.name, model.source.text);
    if (!reading.lacks.empty())
        return reading.lacks;
    constexpr double kScale = 1; // The test plant is as large as its stroke.
    auto const nodes_mm = short_nodes_mm(lengths_on_desk(reading.contract, kScale));
    auto const source = model_along(model, nodes_mm, kScale);
    if (!source)
        return { source.error().message };
    for (std::uint64_t const seed : { 1u, 2u }) {
        auto const built = scene::build_lsystem(
            { .source = *source, .includes = model.includes, .seed = seed }, options);
        if (!built)
            return { built.error().message };
        if (auto const follows = check_follows(model.source.name, built->plant, nodes_mm); !follows)
            return { follows.error().message };
    }
    return {};
}

} // namespace tractus::sketch
