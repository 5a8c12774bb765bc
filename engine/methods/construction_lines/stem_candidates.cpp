#include "engine/methods/construction_lines/stem_candidates.h"

#include "engine/methods/construction_lines/hand_line.h"
#include "engine/methods/construction_lines/stroke_position.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <cmath>

namespace tractus::lines {

namespace {

double sheet_diagonal_mm(std::span<Polyline const> lines)
{
    Vec2 low = lines.front().front().head<2>();
    Vec2 high = low;
    for (auto const& line : lines)
        for (auto const& point : line) {
            low = low.cwiseMin(point.head<2>());
            high = high.cwiseMax(point.head<2>());
        }
    return (high - low).norm();
}

double cost_as_stem(StemCandidate const& stem, double diagonal_mm)
{
    Vec2 const chord = (stem.line.back() - stem.line.front()).head<2>();
    double const length_mm = polyline_length_mm(stem.line);
    bool const is_first
        = std::find(stem.strokes.begin(), stem.strokes.end(), 0U) != stem.strokes.end();
    double const lies = std::fabs(chord.x()) / std::max(chord.norm(), 1e-9);
    return (is_first ? 0 : 0.3) + 1.2 * ramp(chord.norm() / length_mm, 0.85, 0.4)
        + 1.5 * ramp(length_mm / diagonal_mm, 0.5, 0.15) + 0.8 * ramp(lies, 0.5, 1)
        + 0.1 * static_cast<double>(stem.strokes.size() - 1);
}

// Extends a stroke at both ends by the strokes that continue it.
StemCandidate chain_from(std::size_t seed, std::span<Polyline const> lines)
{
    // Largest gap between two strokes, as a share of the sum of their lengths.
    constexpr double kMaxGap = 0.1;
    StemCandidate chain { .strokes = { seed }, .line = lines[seed] };
    while (true) {
        Junction best;
        std::size_t next = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (std::find(chain.strokes.begin(), chain.strokes.end(), i) != chain.strokes.end())
                continue;
            double const both_mm = polyline_length_mm(chain.line) + polyline_length_mm(lines[i]);
            auto const junction = junction_of(chain.line, lines[i], kMaxGap * both_mm);
            if (junction.quality > best.quality) {
                best = junction;
                next = i;
            }
        }
        if (best.quality < 0.25)
            return chain;
        chain.line = joined(chain.line, lines[next], best);
        chain.strokes.push_back(next);
    }
}

} // namespace

std::vector<StemCandidate> stem_candidates(std::span<Polyline const> lines,
                                           std::span<StrokeToExplain const> strokes)
{
    constexpr std::size_t kMax = 24;
    double const diagonal_mm = sheet_diagonal_mm(lines);
    std::vector<StemCandidate> result;
    auto const add = [&](StemCandidate candidate) {
        std::sort(candidate.strokes.begin(), candidate.strokes.end());
        bool const is_there
            = std::any_of(result.begin(), result.end(), [&](StemCandidate const& other) {
                  return other.strokes == candidate.strokes;
              });
        if (is_there)
            return;
        candidate.cost = cost_as_stem(candidate, diagonal_mm);
        result.push_back(std::move(candidate));
    };
    auto const is_assigned
        = [](StrokeToExplain const& stroke) { return stroke.assigned == Role::Stem; };
    bool const one_is_assigned = std::any_of(strokes.begin(), strokes.end(), is_assigned);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        auto const& assigned = strokes[i].assigned;
        if (one_is_assigned ? !is_assigned(strokes[i]) : assigned.has_value())
            continue;
        add({ .strokes = { i }, .line = lines[i] });
        if (!one_is_assigned)
            add(chain_from(i, lines));
    }
    if (result.empty()) // The user has given every stroke another role.
        add({ .strokes = { 0 }, .line = lines[0] });
    std::stable_sort(
        result.begin(), result.end(),
        [](StemCandidate const& a, StemCandidate const& b) { return a.cost < b.cost; });
    result.resize(std::min(result.size(), kMax));
    return result;
}

CorrectedStem corrected_stem(StemCandidate const& stem, std::span<Polyline const> lines,
                             std::span<Part const> parts)
{
    constexpr std::size_t kAxisPoints = 120;
    StemAxis const axis(resample(stem.line, kAxisPoints));
    struct Drawn {
        std::vector<std::size_t> strokes;
        Polyline line;
    };
    std::vector<Drawn> drawn { { stem.strokes, stem.line } };
    auto const& own = stem.strokes;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i] == Part::Stem && std::find(own.begin(), own.end(), i) == own.end())
            drawn.push_back({ { i }, rising(lines[i], axis) });
    std::sort(drawn.begin(), drawn.end(),
              [](Drawn const& a, Drawn const& b) { return a.strokes.front() < b.strokes.front(); });
    CorrectedStem result { .line = drawn.front().line, .strokes = {}, .replaced = {} };
    for (auto const& each : drawn) {
        if (&each != &drawn.front()) {
            result.line = merge_correction(result.line, each.line, axis);
            if (result.line.size() == without_repeats(each.line).size())
                result.replaced = result.strokes;
        }
        result.strokes.insert(result.strokes.end(), each.strokes.begin(), each.strokes.end());
    }
    // Smooths the small jumps where the pieces of the stem meet.
    if (result.strokes.size() > 1 && is_drawn_by_hand(result.line))
        result.line = remove_tremor(result.line);
    return result;
}

} // namespace tractus::lines
