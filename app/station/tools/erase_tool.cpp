#include "app/station/tools/tool.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tractus {

namespace {

// How far beside a line the eraser may be and still touch it, and how far above the surface a line
// may lie that is still seen. Millimetres.
constexpr double kEraserRadius_mm = 4;
constexpr double kSeenAbove_mm = 1;

// The height of a polyline where it passes under the eraser, the highest that is not above the
// surface; no value if it passes beside it.
class UnderEraser {
public:
    explicit UnderEraser(Vec3 const& eraser_mm)
        : eraser_mm_(eraser_mm)
    {
    }

    void look_at(Vec3 const& from_mm, Vec3 const& to_mm)
    {
        Vec2 const along = (to_mm - from_mm).head<2>();
        Vec2 const to_eraser = (eraser_mm_ - from_mm).head<2>();
        double const length2 = along.squaredNorm();
        double const share = length2 > 0 ? std::clamp(to_eraser.dot(along) / length2, 0.0, 1.0) : 0;
        Vec3 const nearest_mm = from_mm + share * (to_mm - from_mm);
        bool const is_seen = nearest_mm.z() <= eraser_mm_.z() + kSeenAbove_mm;
        bool const is_near = (nearest_mm - eraser_mm_).head<2>().norm() <= kEraserRadius_mm;
        if (is_seen && is_near)
            height_mm_ = std::max(height_mm_.value_or(nearest_mm.z()), nearest_mm.z());
    }

    std::optional<double> height_mm() const { return height_mm_; }

private:
    Vec3 eraser_mm_;
    std::optional<double> height_mm_;
};

std::optional<double> height_under(Vec3 const& eraser_mm, std::vector<TipSample> const& tips)
{
    UnderEraser under(eraser_mm);
    for (std::size_t i = 1; i < tips.size(); ++i)
        under.look_at(tips[i - 1].position_mm, tips[i].position_mm);
    return under.height_mm();
}

std::optional<double> height_under(Vec3 const& eraser_mm, MotionIndicator const& indicator)
{
    UnderEraser under(eraser_mm);
    under.look_at(indicator.start_mm, indicator.end_mm);
    return under.height_mm();
}

// A stroke that can be erased: its association, and its tips for as long as that takes.
struct SeenStroke {
    std::size_t number = 0;
    SharedVector<TipSample> tips;
};

// What the eraser has touched: numbers of associations and of indicators.
struct Touched {
    std::vector<std::size_t> associations;
    std::vector<std::size_t> indicators;
};

void add(std::vector<std::size_t>& numbers, std::vector<std::size_t> const& more)
{
    for (auto const number : more)
        if (std::find(numbers.begin(), numbers.end(), number) == numbers.end())
            numbers.push_back(number);
}

// Of what lies above each other only the topmost goes, as with ink on paper, however long the
// eraser stays. A stroke that shapes several branches is in the scene once for each, and goes as a
// whole.
void touch(Vec3 const& eraser_mm, Scene const& scene, std::span<SeenStroke const> strokes,
           Touched& touched)
{
    std::optional<double> top_mm;
    Touched here;
    auto const take = [&](std::optional<double> height_mm, std::vector<std::size_t>& numbers,
                          std::size_t number) {
        if (!height_mm || (top_mm && *height_mm < *top_mm))
            return;
        if (!top_mm || *height_mm > *top_mm)
            here = {};
        top_mm = height_mm;
        numbers.push_back(number);
    };
    for (auto const& stroke : strokes)
        take(height_under(eraser_mm, stroke.tips), here.associations, stroke.number);
    for (std::size_t i = 0; i < scene.indicators.size(); ++i)
        take(height_under(eraser_mm, scene.indicators[i]), here.indicators, i);
    add(touched.associations, here.associations);
    add(touched.indicators, here.indicators);
}

} // namespace

Result<std::vector<Edit>> erase_edits(Stroke const& stroke, Scene const& scene)
{
    Touched touched;
    std::vector<SeenStroke> seen;
    for (auto const number : shaping_numbers(scene)) // The pad shows no others.
        seen.push_back({ number, scene.associations[number].stroke.tips.in_memory() });
    for (auto const& tip : stroke.tips)
        touch(tip.position_mm, scene, seen, touched);
    std::vector<Edit> edits;
    if (!touched.associations.empty())
        edits.push_back(DeleteStroke { touched.associations });
    // The last first: the others keep their numbers.
    std::sort(touched.indicators.begin(), touched.indicators.end(), std::greater<>());
    for (auto const number : touched.indicators)
        edits.push_back(DeleteIndicator { number });
    if (edits.empty())
        return fail(Fault::User,
                    "the eraser touched nothing: move it over a stroke or an indicator that is "
                    "seen on the pad");
    return edits;
}

} // namespace tractus
