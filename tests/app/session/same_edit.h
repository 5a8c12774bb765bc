#pragma once

#include "engine/scene/derive_anew.h"
#include "engine/scene/edit.h"
#include "engine/scene/limb_edits.h"

#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::session {

// The functions same() compare edits, and the values in them, bit by bit. So a NaN is equal to
// itself.

inline bool same(double one, double other)
{
    return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

inline bool same(Vec3 const& one, Vec3 const& other)
{
    return same(one.x(), other.x()) && same(one.y(), other.y()) && same(one.z(), other.z());
}

inline bool same(Stroke const& one, Stroke const& other)
{
    if (one.tips.size() != other.tips.size())
        return false;
    for (std::size_t i = 0; i < one.tips.size(); ++i) {
        auto const& a = one.tips[i];
        auto const& b = other.tips[i];
        if (a.time != b.time || !same(a.position_mm, b.position_mm) || !same(a.pressure, b.pressure)
            || a.touching != b.touching || a.eraser != b.eraser
            || a.tilt_rad.has_value() != b.tilt_rad.has_value()
            || (a.tilt_rad && !same(a.tilt_rad->x(), b.tilt_rad->x()))
            || (a.tilt_rad && !same(a.tilt_rad->y(), b.tilt_rad->y()))
            || a.height_source != b.height_source || a.outside_calibration != b.outside_calibration)
            return false;
    }
    return true;
}

inline bool same(variation::MotionIndicator const& one, variation::MotionIndicator const& other)
{
    return same(one.start_mm, other.start_mm) && same(one.end_mm, other.end_mm)
        && one.kind == other.kind && one.below == other.below
        && one.reach_mm.has_value() == other.reach_mm.has_value()
        && same(one.reach_mm.value_or(0), other.reach_mm.value_or(0))
        && one.is_orphaned == other.is_orphaned;
}

inline bool same(variation::GrowthParameters const& one, variation::GrowthParameters const& other)
{
    auto const values = [](variation::GrowthParameters const& growth) {
        std::vector<std::uint64_t> bits;
        for (double const value :
             { growth.steps_per_axis, growth.strength, growth.gain, growth.noise_rad,
               growth.noise_memory, growth.indicator_gain, growth.circumnutation_rad,
               growth.circumnutation_period_steps, growth.maturation_bending,
               growth.maturation_straightening, growth.sag })
            bits.push_back(std::bit_cast<std::uint64_t>(value));
        return bits;
    };
    return values(one) == values(other) && one.steps == other.steps
        && one.delay_steps == other.delay_steps && one.growth_zone_steps == other.growth_zone_steps
        && same(one.prevailing, other.prevailing);
}

inline bool same(scene::LoadModel const& one, scene::LoadModel const& other)
{
    return one.source.name == other.source.name && one.source.text == other.source.text
        && one.source.view_name == other.source.view_name
        && one.source.view_text == other.source.view_text && one.includes == other.includes
        && one.steps == other.steps && one.seed == other.seed && one.drawn == other.drawn
        && same(one.stands_at_mm, other.stands_at_mm) && one.id == other.id;
}

inline bool same(scene::LoadSkeleton const& one, scene::LoadSkeleton const& other)
{
    if (one.name != other.name || one.drawn != other.drawn || one.id != other.id
        || !same(one.stands_at_mm, other.stands_at_mm) || one.lines.size() != other.lines.size())
        return false;
    for (std::size_t i = 0; i < one.lines.size(); ++i)
        if (!same(one.lines[i].from_mm, other.lines[i].from_mm)
            || !same(one.lines[i].to_mm, other.lines[i].to_mm))
            return false;
    return true;
}

inline bool same(scene::LoadMeasured const& one, scene::LoadMeasured const& other)
{
    return one.name == other.name && one.text == other.text && one.format == other.format
        && one.drawn == other.drawn && same(one.stands_at_mm, other.stands_at_mm)
        && one.id == other.id;
}

inline bool same(scene::Items const& one, scene::Items const& other)
{
    return one.ids == other.ids && one.numbers == other.numbers;
}

inline bool same(scene::Select const& one, scene::Select const& other)
{
    return one.paths == other.paths && one.at == other.at;
}

inline bool same(scene::Associate const& one, scene::Associate const& other)
{
    return same(one.stroke, other.stroke) && one.propagation == other.propagation
        && one.fit == other.fit && same(one.detail_weight, other.detail_weight)
        && one.laying == other.laying && one.id == other.id
        && one.is_drawn_reversed == other.is_drawn_reversed;
}

inline bool same(scene::Oversketch const& one, scene::Oversketch const& other)
{
    return same(one.strokes, other.strokes) && same(one.over, other.over);
}

inline bool same(scene::SmoothStroke const& one, scene::SmoothStroke const& other)
{
    return same(one.strokes, other.strokes) && same(one.detail_weight, other.detail_weight);
}

inline bool same(scene::TurnStroke const& one, scene::TurnStroke const& other)
{
    return same(one.strokes, other.strokes);
}

inline bool same(scene::DeleteStroke const& one, scene::DeleteStroke const& other)
{
    return same(one.strokes, other.strokes);
}

inline bool same(scene::EraseTips const& one, scene::EraseTips const& other)
{
    return same(one.strokes, other.strokes) && one.ranges == other.ranges;
}

inline bool same(scene::Indicate const& one, scene::Indicate const& other)
{
    return same(one.indicator, other.indicator) && one.below == other.below && one.id == other.id;
}

inline bool same(scene::ChangeIndicator const& one, scene::ChangeIndicator const& other)
{
    return one.which == other.which && one.number == other.number
        && same(one.indicator, other.indicator);
}

inline bool same(scene::DeleteIndicator const& one, scene::DeleteIndicator const& other)
{
    return one.which == other.which && one.number == other.number;
}

inline bool same(scene::SetGrowth const& one, scene::SetGrowth const& other)
{
    return same(one.parameters, other.parameters) && one.seed == other.seed
        && same(one.variability, other.variability) && same(one.age, other.age);
}

inline bool same(scene::ActivatePlant const& one, scene::ActivatePlant const& other)
{
    return one.plant == other.plant;
}

inline bool same(scene::MovePlant const& one, scene::MovePlant const& other)
{
    return one.plant == other.plant && same(one.to_mm, other.to_mm);
}

inline bool same(scene::CopyPlant const& one, scene::CopyPlant const& other)
{
    return one.plant == other.plant && same(one.stands_at_mm, other.stands_at_mm)
        && one.id == other.id;
}

inline bool same(scene::HidePlant const& one, scene::HidePlant const& other)
{
    return one.plant == other.plant && one.hidden == other.hidden;
}

inline bool same(scene::NamePlant const& one, scene::NamePlant const& other)
{
    return one.plant == other.plant && one.name == other.name;
}

inline bool same(scene::RemovePlant const& one, scene::RemovePlant const& other)
{
    return one.plant == other.plant;
}

inline bool same(scene::SetScale const& one, scene::SetScale const& other)
{
    return same(one.scale, other.scale);
}

inline bool same(scene::GraftPlant const& one, scene::GraftPlant const& other)
{
    return one.plant == other.plant && one.onto == other.onto && one.at == other.at
        && same(one.turn_rad, other.turn_rad) && same(one.base_mm, other.base_mm);
}

inline bool same(scene::TakeOffGraft const& one, scene::TakeOffGraft const& other)
{
    return one.plant == other.plant && one.graft == other.graft
        && same(one.stands_at_mm, other.stands_at_mm) && one.id == other.id;
}

inline bool same(scene::HideBranch const& one, scene::HideBranch const& other)
{
    return one.plant == other.plant && one.at == other.at && one.hidden == other.hidden;
}

inline bool same(scene::DrawLimb const& one, scene::DrawLimb const& other)
{
    return one.plant == other.plant && one.at == other.at && same(one.joint, other.joint)
        && same(one.joint_mm, other.joint_mm) && same(one.turn_rad, other.turn_rad)
        && same(one.scale, other.scale) && same(one.width_mm, other.width_mm)
        && same(one.stroke, other.stroke) && one.id == other.id
        && one.is_drawn_reversed == other.is_drawn_reversed;
}

inline bool same(scene::EraseLimb const& one, scene::EraseLimb const& other)
{
    return one.plant == other.plant && one.limb == other.limb;
}

inline bool same(scene::DeriveAnew const& one, scene::DeriveAnew const& other)
{
    return one.plant == other.plant && one.seeds == other.seeds && one.strokes == other.strokes
        && one.at == other.at;
}

inline bool same(scene::UnknownEdit const& one, scene::UnknownEdit const& other)
{
    return one.word == other.word && one.fields == other.fields && one.numbers == other.numbers;
}

template<typename T> bool same_of(scene::Edit const& one, scene::Edit const& other)
{
    auto const* const a = one.get<T>();
    auto const* const b = other.get<T>();
    return a && b && same(*a, *b);
}

inline bool same(scene::Edit const& one, scene::Edit const& other)
{
    return same_of<scene::LoadModel>(one, other) || same_of<scene::LoadSkeleton>(one, other)
        || same_of<scene::LoadMeasured>(one, other) || same_of<scene::Select>(one, other)
        || same_of<scene::Associate>(one, other) || same_of<scene::Oversketch>(one, other)
        || same_of<scene::SmoothStroke>(one, other) || same_of<scene::DeleteStroke>(one, other)
        || same_of<scene::EraseTips>(one, other) || same_of<scene::Indicate>(one, other)
        || same_of<scene::ChangeIndicator>(one, other)
        || same_of<scene::DeleteIndicator>(one, other) || same_of<scene::SetGrowth>(one, other)
        || same_of<scene::ActivatePlant>(one, other) || same_of<scene::MovePlant>(one, other)
        || same_of<scene::CopyPlant>(one, other) || same_of<scene::HidePlant>(one, other)
        || same_of<scene::NamePlant>(one, other) || same_of<scene::RemovePlant>(one, other)
        || same_of<scene::SetScale>(one, other) || same_of<scene::GraftPlant>(one, other)
        || same_of<scene::TakeOffGraft>(one, other) || same_of<scene::HideBranch>(one, other)
        || same_of<scene::DrawLimb>(one, other) || same_of<scene::EraseLimb>(one, other)
        || same_of<scene::DeriveAnew>(one, other) || same_of<scene::TurnStroke>(one, other)
        || same_of<scene::UnknownEdit>(one, other);
}

} // namespace tractus::session
