#pragma once

#include "engine/scene/edit.h"

#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::session {

// Whether two edits are the same in every bit: numbers that are not numbers, too.

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

inline bool same(LoadModel const& one, LoadModel const& other)
{
    return one.source.name == other.source.name && one.source.text == other.source.text
        && one.source.view_name == other.source.view_name
        && one.source.view_text == other.source.view_text && one.includes == other.includes
        && one.steps == other.steps && one.seed == other.seed && one.drawn == other.drawn
        && same(one.stands_at_mm, other.stands_at_mm) && one.id == other.id;
}

inline bool same(LoadSkeleton const& one, LoadSkeleton const& other)
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

inline bool same(LoadMeasured const& one, LoadMeasured const& other)
{
    return one.name == other.name && one.text == other.text && one.format == other.format
        && one.drawn == other.drawn && same(one.stands_at_mm, other.stands_at_mm)
        && one.id == other.id;
}

inline bool same(Items const& one, Items const& other)
{
    return one.ids == other.ids && one.numbers == other.numbers;
}

inline bool same(Select const& one, Select const& other)
{
    return one.paths == other.paths && one.at == other.at;
}

inline bool same(Associate const& one, Associate const& other)
{
    return same(one.stroke, other.stroke) && one.propagation == other.propagation
        && one.fit == other.fit && same(one.detail_weight, other.detail_weight)
        && one.id == other.id;
}

inline bool same(Oversketch const& one, Oversketch const& other)
{
    return same(one.strokes, other.strokes) && same(one.over, other.over);
}

inline bool same(SmoothStroke const& one, SmoothStroke const& other)
{
    return same(one.strokes, other.strokes) && same(one.detail_weight, other.detail_weight);
}

inline bool same(DeleteStroke const& one, DeleteStroke const& other)
{
    return same(one.strokes, other.strokes);
}

inline bool same(EraseTips const& one, EraseTips const& other)
{
    return same(one.strokes, other.strokes) && one.ranges == other.ranges;
}

inline bool same(Indicate const& one, Indicate const& other)
{
    return same(one.indicator, other.indicator) && one.below == other.below && one.id == other.id;
}

inline bool same(ChangeIndicator const& one, ChangeIndicator const& other)
{
    return one.which == other.which && one.number == other.number
        && same(one.indicator, other.indicator);
}

inline bool same(DeleteIndicator const& one, DeleteIndicator const& other)
{
    return one.which == other.which && one.number == other.number;
}

inline bool same(SetGrowth const& one, SetGrowth const& other)
{
    return same(one.parameters, other.parameters) && one.seed == other.seed
        && same(one.variability, other.variability) && same(one.age, other.age);
}

inline bool same(ActivatePlant const& one, ActivatePlant const& other)
{
    return one.plant == other.plant;
}

inline bool same(MovePlant const& one, MovePlant const& other)
{
    return one.plant == other.plant && same(one.to_mm, other.to_mm);
}

inline bool same(CopyPlant const& one, CopyPlant const& other)
{
    return one.plant == other.plant && same(one.stands_at_mm, other.stands_at_mm)
        && one.id == other.id;
}

inline bool same(HidePlant const& one, HidePlant const& other)
{
    return one.plant == other.plant && one.hidden == other.hidden;
}

inline bool same(NamePlant const& one, NamePlant const& other)
{
    return one.plant == other.plant && one.name == other.name;
}

inline bool same(RemovePlant const& one, RemovePlant const& other)
{
    return one.plant == other.plant;
}

inline bool same(SetScale const& one, SetScale const& other)
{
    return same(one.scale, other.scale);
}

inline bool same(GraftPlant const& one, GraftPlant const& other)
{
    return one.plant == other.plant && one.onto == other.onto && one.at == other.at
        && same(one.turn_rad, other.turn_rad) && same(one.base_mm, other.base_mm);
}

inline bool same(TakeOffGraft const& one, TakeOffGraft const& other)
{
    return one.plant == other.plant && one.graft == other.graft
        && same(one.stands_at_mm, other.stands_at_mm) && one.id == other.id;
}

inline bool same(HideBranch const& one, HideBranch const& other)
{
    return one.plant == other.plant && one.at == other.at && one.hidden == other.hidden;
}

inline bool same(UnknownEdit const& one, UnknownEdit const& other)
{
    return one.word == other.word && one.fields == other.fields && one.numbers == other.numbers;
}

template<typename T> bool same_of(Edit const& one, Edit const& other)
{
    auto const* const a = one.get<T>();
    auto const* const b = other.get<T>();
    return a && b && same(*a, *b);
}

inline bool same(Edit const& one, Edit const& other)
{
    return same_of<LoadModel>(one, other) || same_of<LoadSkeleton>(one, other)
        || same_of<LoadMeasured>(one, other) || same_of<Select>(one, other)
        || same_of<Associate>(one, other) || same_of<Oversketch>(one, other)
        || same_of<SmoothStroke>(one, other) || same_of<DeleteStroke>(one, other)
        || same_of<EraseTips>(one, other) || same_of<Indicate>(one, other)
        || same_of<ChangeIndicator>(one, other) || same_of<DeleteIndicator>(one, other)
        || same_of<SetGrowth>(one, other) || same_of<ActivatePlant>(one, other)
        || same_of<MovePlant>(one, other) || same_of<CopyPlant>(one, other)
        || same_of<HidePlant>(one, other) || same_of<NamePlant>(one, other)
        || same_of<RemovePlant>(one, other) || same_of<SetScale>(one, other)
        || same_of<GraftPlant>(one, other) || same_of<TakeOffGraft>(one, other)
        || same_of<HideBranch>(one, other) || same_of<UnknownEdit>(one, other);
}

} // namespace tractus::session
