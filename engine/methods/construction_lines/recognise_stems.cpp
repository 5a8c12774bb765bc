#include "engine/methods/construction_lines/recognise_stems.h"

#include <utility>

namespace tractus::lines {

namespace {

// How well a stroke fits a stem, from best to worst. A stroke along the whole of a stem is that
// stem's boundary, even if it crosses another stem.
enum class Rank { DrawnAgain, AlongStem, AtStem, OpenSide, TakenSide, Unknown };

Rank rank_of(RecognisedLine const& line)
{
    if (line.is_drawn_again)
        return Rank::DrawnAgain;
    switch (line.role) {
    case Role::Left:
    case Role::Right:
    case Role::Around:
        if (line.replaces)
            return Rank::TakenSide;
        return line.is_along_stem ? Rank::AlongStem : Rank::OpenSide;
    case Role::Stem:
    case Role::Inclination:
    case Role::HalfInclination:
        return Rank::AtStem;
    case Role::Unsure:
    case Role::Outline: // A closed outline is only recognised when strokes are read together.
        break;
    }
    return Rank::Unknown;
}

LineRecogniser::Lies lies_as(StemRecogniser::Says says)
{
    return says == StemRecogniser::Says::InSpace ? LineRecogniser::Lies::InSpace
                                                 : LineRecogniser::Lies::OnSheet;
}

} // namespace

KnownLine StemRecogniser::nearest(std::vector<Vec3> const& stroke, LineRecogniser::Lies lies) const
{
    KnownLine best;
    std::optional<std::pair<Rank, double>> least;
    for (std::size_t i = 0; i < stems_.size(); ++i) {
        auto const& stem = stems_[i];
        auto const line = stem.lines.recognised(stroke, lies);
        std::pair const its_rank(rank_of(line), stem.lines.distance_mm(stroke));
        if (least && *least <= its_rank)
            continue;
        least = its_rank;
        best = { .line = line, .stem = i, .parent = std::nullopt };
        if (line.replaces)
            best.line.replaces = stem.strokes[*line.replaces];
        if (line.role == Role::Stem)
            best.parent = stem.parent;
    }
    return best;
}

KnownLine StemRecogniser::recognise(std::vector<Vec3> const& stroke, Says says) const
{
    if (stems_.empty())
        return { .line = { .role = Role::Stem } };
    if (says == Says::AnotherStem)
        return { .line = { .role = Role::Stem },
                 .stem = stems_.size(),
                 .parent = parent_at(stems(), stroke.front().head<2>()) };
    return nearest(stroke, lies_as(says));
}

KnownLine const& StemRecogniser::add(std::vector<Vec3> const& stroke, Says says)
{
    auto const known = recognise(stroke, says);
    if (known.stem == stems_.size())
        stems_.emplace_back().parent = known.parent;
    auto& stem = stems_[known.stem];
    stem.lines.add(stroke, lies_as(says));
    stem.strokes.push_back(lines_.size());
    return lines_.emplace_back(known);
}

void StemRecogniser::add_known(std::vector<Vec3> const& stroke, KnownLine line)
{
    if (line.stem >= stems_.size())
        stems_.resize(line.stem + 1);
    auto& stem = stems_[line.stem];
    if (line.line.role == Role::Stem)
        stem.parent = line.parent;
    stem.lines.add_known(stroke, line.line.role);
    stem.strokes.push_back(lines_.size());
    lines_.push_back(std::move(line));
}

std::vector<StemLines> StemRecogniser::stems() const
{
    std::vector<StemLines> result;
    for (auto const& stem : stems_)
        result.push_back({ .sketch = stem.lines.sketch(), .parent = stem.parent });
    return result;
}

std::vector<std::size_t> StemRecogniser::inclination_strokes(std::size_t stem) const
{
    auto const& its = stems_[stem];
    auto strokes = its.lines.inclination_strokes();
    for (auto& stroke : strokes)
        stroke = its.strokes[stroke];
    return strokes;
}

} // namespace tractus::lines
