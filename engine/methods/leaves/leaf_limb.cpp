// This file makes the limb, the surface of the blade between the veins.
#include "engine/methods/leaves/leaf.h"

#include <algorithm>

namespace tractus::leaf {

void Leaf::remove_limb()
{
    if (limb_begin_)
        map_.truncate(*limb_begin_);
    limb_begin_.reset();
    limb_faces_ = 0;
    limb_ = {};
}

Result<void> Leaf::fill()
{
    remove_limb();
    limb_begin_ = map_.dart_count();
    auto const border = map_.border(border_start());
    auto const at = [&](std::size_t i) { return border.begin() + static_cast<std::ptrdiff_t>(i); };
    std::vector<std::size_t> tips;
    for (std::size_t i = 0; i < border.size(); ++i)
        if (map_.label(border[i]) == EdgeLabel::Extremity)
            tips.push_back(i);
    // With #base in the grammar, the end of the stalk counts as a vein tip at the beginning and at
    // the end of the border.
    if (grammar_->has_base && !tips.empty()) {
        tips.insert(tips.begin(), 0);
        tips.push_back(border.size());
    }
    auto const is_bare = [&](Dart d) {
        return grammar_->bare.contains(faces_[static_cast<std::size_t>(map_.face(d))].name);
    };
    for (std::size_t i = 0; i + 1 < tips.size(); ++i) {
        std::vector<Dart> const way(at(tips[i] + 1), at(tips[i + 1]));
        auto const first_bare = std::ranges::find_if(way, is_bare);
        if (first_bare == way.end()) {
            TRY(fill_along_border(way));
            // The limbs of leaflets are separate, so the chain is filled in two parts, before and
            // behind the faces without a limb.
        } else if (grammar_->has_base) {
            auto const behind_last = std::find_if(way.rbegin(), way.rend(), is_bare).base();
            TRY(fill_along_border({ way.begin(), first_bare }));
            TRY(fill_along_border({ behind_last, way.end() }));
        }
    }
    std::ranges::sort(limb_.sizes);
    return {};
}

// Fills the area beside a chain of border edges with limb faces. Where the chain bulges beyond the
// straight line between its ends, it is divided at the vertex farthest from this line.
Result<void> Leaf::fill_along_border(std::vector<Dart> const& way)
{
    constexpr double kInside = -1e-9;
    std::vector<std::span<Dart const>> pending { way };
    while (!pending.empty()) {
        auto const part = pending.back();
        pending.pop_back();
        if (part.size() < 2 && (outline_.empty() || part.empty()))
            continue;
        TRY(spend(part.size()));
        // The outline is defined in the flat leaf, so with an outline the flat positions count,
        // even if the leaf is curled.
        auto const shape = outline_.empty() ? Shape::Grown : Shape::Flat;
        Vec3 const from = place_of(part.front(), shape);
        Vec3 const chord = place_of(LeafMap::a0(part.back()), shape) - from;
        std::size_t worst = 0;
        double worst_side = 0;
        for (std::size_t i = 1; i < part.size(); ++i) {
            Vec3 const corner = place_of(part[i], shape) - from;
            double const side = chord.x() * corner.y() - chord.y() * corner.x();
            if (worst == 0 || side < worst_side) {
                worst = i;
                worst_side = side;
            }
        }
        if (worst_side < kInside) {
            ++limb_.cuts;
            pending.push_back(part.subspan(worst));
            pending.push_back(part.first(worst));
            continue;
        }
        // Vein tips may have crossed, for example beside a heart-shaped base. Then only the whole
        // chain may follow the outline; a part of the chain would follow a wrong piece of it.
        bool const follows = part.size() == way.size() || is_along_outline(way);
        add_limb_face(part, follows ? Margin::Outline : Margin::Straight);
    }
    return {};
}

bool Leaf::is_along_outline(std::span<Dart const> way) const
{
    auto const first = way.front();
    auto const& blade = blades_[blade_on(first)];
    return outline_.goes_forward(blade.to_outline(map_.flat_of(first)),
                                 blade.to_outline(map_.flat_of(LeafMap::a0(way.back()))));
}

// Adds the part of the outline between the ends of a chain to a limb face. In space, this part
// keeps its position relative to the straight line between these ends.
void Leaf::add_margin(std::span<Dart const> way, std::vector<Vertex>& corners,
                      std::vector<EdgeLabel>& labels)
{
    // Maximum distance of vein tips from the outline, as a share of the blade's length. It is above
    // 0 because tips have a width.
    constexpr double kTolerance = 0.03;
    auto const& line = outline_.line();
    if (line.empty())
        return;
    auto const first = way.front();
    auto const last = LeafMap::a0(way.back());
    Vec2 const from = map_.flat_of(first);
    Vec2 const chord = map_.flat_of(last) - from;
    double const length = chord.norm();
    if (!(length > 0))
        return;
    double const tolerance = kTolerance * grammar_->outline.points.back().at.y();
    auto const& blade = blades_[blade_on(first)];
    Vec3 const begin = map_.position_of(first);
    Vec3 const step = map_.position_of(last) - begin;
    auto const& upper = faces_[static_cast<std::size_t>(map_.face(first))].frame.z;
    Vec3 const left = upper.cross(step).normalized();
    for (auto const& place : outline_.between(blade.to_outline(from),
                                              blade.to_outline(map_.flat_of(last)), tolerance)) {
        Vec2 const flat = blade.to_flat(place);
        Vec2 const at = flat - from;
        double const along = at.dot(chord) / (length * length);
        double const aside = (chord.x() * at.y() - chord.y() * at.x()) / length;
        corners.push_back(map_.add_vertex(begin + along * step + aside * left, flat));
        labels.push_back(EdgeLabel::LimbEnd);
    }
}

void Leaf::add_limb_face(std::span<Dart const> way, Margin margin)
{
    std::vector<Vertex> corners { map_.vertex(way.front()) };
    std::vector<EdgeLabel> labels { EdgeLabel::LimbEnd };
    if (margin == Margin::Outline)
        add_margin(way, corners, labels);
    corners.push_back(map_.vertex(LeafMap::a0(way.back())));
    // A single edge and its chord enclose no area, so there is nothing to fill.
    if (corners.size() + way.size() < 4)
        return;
    auto const closing = static_cast<Dart>(labels.size());
    for (std::size_t i = way.size(); i-- > 0;) {
        labels.push_back(EdgeLabel::LimbSide);
        if (i > 0)
            corners.push_back(map_.vertex(way[i]));
    }
    auto const face = static_cast<FaceId>(faces_.size()) + limb_faces_++;
    auto const first = map_.add_face(corners, face, labels);
    for (std::size_t i = 0; i < way.size(); ++i)
        map_.sew_in_place(first + static_cast<Dart>(2 * i) + 2 * closing,
                          LeafMap::a0(way[way.size() - 1 - i]));
    limb_.sizes.push_back(static_cast<int>(labels.size()));
}

std::vector<Leaf::Midrib> Leaf::midribs() const
{
    if (grammar_->outline.points.empty())
        return {};
    std::vector<bool> has_veins(blades_.size());
    for (std::size_t i = 1; i < faces_.size(); ++i)
        if (!grammar_->bare.contains(faces_[i].name) && faces_[i].blade < blades_.size())
            has_veins[faces_[i].blade] = true;
    double const tip = grammar_->outline.points.back().at.y();
    std::vector<Midrib> made;
    for (std::size_t i = 0; i < blades_.size(); ++i)
        if (has_veins[i])
            made.push_back({ blades_[i].base, blades_[i].to_flat({ 0, tip }) });
    return made;
}

} // namespace tractus::leaf
