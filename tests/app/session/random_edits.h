#pragma once

#include "engine/scene/derive_anew.h"
#include "engine/scene/edit.h"
#include "engine/scene/limb_edits.h"

#include <bit>
#include <cstdint>
#include <rapidcheck.h>
#include <string>
#include <vector>

namespace tractus::session {

// Returns a random double, which may be infinite or NaN.
inline double random_double()
{
    if (*rc::gen::arbitrary<bool>())
        return *rc::gen::arbitrary<double>();
    return std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
}

inline Vec3 random_vec3()
{
    double const x = random_double();
    double const y = random_double();
    return { x, y, random_double() };
}

// Returns random bytes, since texts of models and names of files need not be UTF-8.
inline std::string random_bytes()
{
    return *rc::gen::arbitrary<std::string>();
}

// Returns a random file name. It has no folders, because a session keeps only the last part of a
// path.
inline std::string random_file_name()
{
    auto name = random_bytes();
    if (name.starts_with('/'))
        name.front() = '.';
    return name;
}

template<typename Enum> Enum random_enum(int count)
{
    return static_cast<Enum>(*rc::gen::inRange(0, count));
}

inline Stroke random_stroke()
{
    Stroke stroke;
    stroke.tips.own().resize(*rc::gen::inRange<std::size_t>(0, 6));
    for (auto& tip : stroke.tips.own()) {
        tip.time = timestamp_ns(*rc::gen::arbitrary<std::int64_t>());
        tip.position_mm = random_vec3();
        tip.pressure = random_double();
        tip.touching = *rc::gen::arbitrary<bool>();
        tip.eraser = *rc::gen::arbitrary<bool>();
        tip.height_source = random_enum<TipSample::HeightSource>(2);
        tip.outside_calibration = *rc::gen::arbitrary<bool>();
        if (*rc::gen::arbitrary<bool>())
            tip.tilt_rad = Vec2(random_double(), random_double());
    }
    return stroke;
}

inline variation::MotionIndicator random_indicator()
{
    variation::MotionIndicator indicator;
    indicator.start_mm = random_vec3();
    indicator.end_mm = random_vec3();
    indicator.kind = random_enum<variation::MotionIndicator::Kind>(2);
    indicator.below = *rc::gen::arbitrary<std::vector<SegmentId>>();
    if (*rc::gen::arbitrary<bool>())
        indicator.reach_mm = random_double();
    indicator.is_orphaned = *rc::gen::arbitrary<bool>();
    return indicator;
}

inline variation::GrowthParameters random_growth()
{
    variation::GrowthParameters growth;
    growth.steps = random_enum<variation::GrowthParameters::Steps>(2);
    for (auto* const value :
         { &growth.steps_per_axis, &growth.strength, &growth.gain, &growth.noise_rad,
           &growth.noise_memory, &growth.indicator_gain, &growth.circumnutation_rad,
           &growth.circumnutation_period_steps, &growth.maturation_bending,
           &growth.maturation_straightening, &growth.sag })
        *value = random_double();
    growth.delay_steps = *rc::gen::arbitrary<int>();
    growth.growth_zone_steps = *rc::gen::arbitrary<int>();
    growth.prevailing = random_vec3();
    return growth;
}

inline scene::ItemId random_id()
{
    return *rc::gen::arbitrary<scene::ItemId>();
}

// If the edit adds a plant, gives the plant a random position and id.
template<typename T> void give_place(T& edit)
{
    if (edit.drawn != scene::Drawn::Beside)
        return;
    edit.stands_at_mm = random_vec3();
    edit.id = random_id();
}

inline scene::LoadModel random_model()
{
    scene::LoadModel edit;
    edit.source = { random_file_name(), random_bytes(), random_file_name(), random_bytes() };
    edit.includes = *rc::gen::arbitrary<std::map<std::string, std::string>>();
    if (*rc::gen::arbitrary<bool>())
        edit.steps = *rc::gen::arbitrary<int>();
    edit.seed = *rc::gen::arbitrary<std::uint64_t>();
    edit.drawn = random_enum<scene::Drawn>(3);
    give_place(edit);
    return edit;
}

inline scene::LoadSkeleton random_skeleton()
{
    scene::LoadSkeleton edit;
    edit.name = random_file_name();
    edit.lines.resize(*rc::gen::inRange<std::size_t>(0, 5));
    for (auto& line : edit.lines)
        line = { random_vec3(), random_vec3() };
    edit.drawn = random_enum<scene::Drawn>(3);
    give_place(edit);
    return edit;
}

inline scene::LoadMeasured random_measured()
{
    scene::LoadMeasured edit { .name = random_file_name(), .text = random_bytes() };
    edit.format = random_enum<scene::LoadMeasured::Format>(3);
    edit.drawn = random_enum<scene::Drawn>(3);
    give_place(edit);
    return edit;
}

// Returns items named by ids, or by numbers as in sessions of formats before 4.
inline scene::Items random_items()
{
    auto const numbers = *rc::gen::arbitrary<std::vector<std::uint64_t>>();
    return *rc::gen::arbitrary<bool>() ? scene::Items { .numbers = numbers }
                                       : scene::Items { .ids = numbers };
}

inline std::vector<PathAddress> random_paths()
{
    std::vector<PathAddress> paths(*rc::gen::inRange<std::size_t>(0, 3));
    for (auto& path : paths)
        path = { *rc::gen::arbitrary<SegmentAddress>(), *rc::gen::arbitrary<SegmentAddress>() };
    return paths;
}

// Returns a random edit of the plants of a document or of their parts.
inline scene::Edit random_plant_edit()
{
    switch (*rc::gen::inRange(0, 13)) {
    case 0:
        return scene::ActivatePlant { random_id() };
    case 1:
        return scene::MovePlant { random_id(), random_vec3() };
    case 2:
        return scene::CopyPlant { random_id(), random_vec3(), random_id() };
    case 3:
        return scene::HidePlant { random_id(), *rc::gen::arbitrary<bool>() };
    case 4:
        return scene::NamePlant { random_id(), random_bytes() };
    case 5:
        return scene::RemovePlant { random_id() };
    case 6:
        return scene::SetScale { random_double() };
    case 7:
        return scene::GraftPlant { random_id(), random_id(), *rc::gen::arbitrary<SegmentAddress>(),
                                   random_vec3(), random_vec3() };
    case 8:
        return scene::TakeOffGraft { random_id(), random_id(), random_vec3(), random_id() };
    case 9: {
        scene::DrawLimb edit { .plant = random_id(), .at = *rc::gen::arbitrary<SegmentAddress>() };
        edit.joint = random_double();
        edit.joint_mm = random_vec3();
        edit.turn_rad = random_vec3();
        edit.scale = random_double();
        edit.width_mm = random_double();
        edit.stroke = random_stroke();
        edit.id = random_id();
        return edit;
    }
    case 10:
        return scene::EraseLimb { random_id(), random_id() };
    case 11:
        return scene::DeriveAnew { random_id(), *rc::gen::arbitrary<std::vector<std::uint64_t>>(),
                                   *rc::gen::arbitrary<std::vector<std::uint64_t>>(),
                                   random_paths() };
    default:
        return scene::HideBranch { random_id(), *rc::gen::arbitrary<SegmentAddress>(),
                                   *rc::gen::arbitrary<bool>() };
    }
}

// Returns an edit of random kind with random values. A scene need not accept it.
inline scene::Edit random_edit()
{
    auto const numbers = [] { return *rc::gen::arbitrary<std::vector<std::size_t>>(); };
    switch (*rc::gen::inRange<std::size_t>(0, scene::core_edit_kinds().size())) {
    case 0:
        return random_model();
    case 1:
        return random_skeleton();
    case 2:
        return scene::Select { *rc::gen::arbitrary<variation::Selection>(), random_paths() };
    case 3:
        return scene::Associate { random_stroke(),
                                  random_enum<variation::Propagation>(3),
                                  random_enum<variation::StrokeFit>(3),
                                  random_double(),
                                  random_enum<variation::StrokeLaying>(2),
                                  random_id(),
                                  *rc::gen::arbitrary<bool>() };
    case 4:
        return scene::Oversketch { random_items(), random_stroke() };
    case 5:
        return scene::SmoothStroke { random_items(), random_double() };
    case 6:
        return scene::DeleteStroke { random_items() };
    case 7:
        return scene::Indicate { random_indicator(),
                                 *rc::gen::arbitrary<std::vector<SegmentAddress>>(), random_id() };
    case 8:
        return scene::ChangeIndicator { random_id(), *rc::gen::arbitrary<std::uint64_t>(),
                                        random_indicator() };
    case 9:
        return scene::DeleteIndicator { random_id(), *rc::gen::arbitrary<std::uint64_t>() };
    case 10: {
        scene::EraseTips edit { random_items(), {} };
        for (auto const number : numbers())
            edit.ranges.push_back({ number, *rc::gen::arbitrary<std::size_t>() });
        return edit;
    }
    case 11:
        return scene::SetGrowth { random_growth(), *rc::gen::arbitrary<std::uint64_t>(),
                                  random_double(), random_double() };
    case 12:
        return random_measured();
    case 13:
        return scene::TurnStroke { random_items() };
    default:
        return random_plant_edit();
    }
}

} // namespace tractus::session
