#include "engine/export/stroke_svg.h"

#include <fmt/format.h>
#include <iterator>
#include <string>

namespace tractus::exports {

namespace {

constexpr double kMargin_mm = 5;

// Returns where a position is on the page, in millimetres with y downwards.
Vec2 on_page(Vec3 const& position_mm, StrokeView view)
{
    switch (view) {
    case StrokeView::Front:
        return { position_mm.x(), -position_mm.z() };
    case StrokeView::Side:
        return { position_mm.y(), -position_mm.z() };
    case StrokeView::Top:
        return { position_mm.x(), -position_mm.y() };
    }
    return Vec2::Zero();
}

double width_mm(Stroke const& stroke)
{
    double sum = 0;
    for (auto const& tip : stroke.tips)
        sum += tip.pressure;
    return 0.2 + 0.8 * sum / static_cast<double>(stroke.tips.size());
}

// Returns a number with three decimals; -0.000 becomes 0.000.
std::string decimals(double number)
{
    auto text = fmt::format("{:.3f}", number);
    return text == "-0.000" ? "0.000" : text;
}

std::string polyline(Stroke const& stroke, std::size_t number, StrokeView view)
{
    auto text = fmt::format("<polyline id=\"stroke-{}\" stroke-width=\"{}\" points=\"", number,
                            decimals(width_mm(stroke)));
    for (auto const& tip : stroke.tips) {
        auto const point = on_page(tip.position_mm, view);
        fmt::format_to(std::back_inserter(text), "{}{},{}", text.back() == '"' ? "" : " ",
                       decimals(point.x()), decimals(point.y()));
    }
    return text + "\"/>\n";
}

std::string page_begin(Eigen::AlignedBox2d const& page_mm)
{
    auto const low = page_mm.min();
    auto const size = page_mm.sizes();
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}mm\" "
                       "height=\"{1}mm\" viewBox=\"{2} {3} {0} {1}\">\n"
                       "<g fill=\"none\" stroke=\"#000000\" stroke-linecap=\"round\" "
                       "stroke-linejoin=\"round\">\n",
                       decimals(size.x()), decimals(size.y()), decimals(low.x()),
                       decimals(low.y()));
}

} // namespace

Result<void> write_strokes_svg(std::ostream& out, std::span<Stroke const> strokes, StrokeView view)
{
    Eigen::AlignedBox2d page_mm;
    for (auto const& stroke : strokes)
        for (auto const& tip : stroke.tips) {
            if (!tip.position_mm.allFinite())
                return fail(Fault::Station, "a stroke has a tip that is nowhere");
            page_mm.extend(on_page(tip.position_mm, view));
        }
    if (page_mm.isEmpty())
        page_mm.extend(Vec2(0, 0));
    page_mm.extend(Vec2(page_mm.min() - Vec2::Constant(kMargin_mm)));
    page_mm.extend(Vec2(page_mm.max() + Vec2::Constant(kMargin_mm)));
    out << page_begin(page_mm);
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (strokes[i].tips.size() > 1)
            out << polyline(strokes[i], i + 1, view);
    out << "</g>\n</svg>\n";
    if (!out)
        return fail(Fault::User, "cannot write the drawing: is the disk full?");
    return {};
}

} // namespace tractus::exports
