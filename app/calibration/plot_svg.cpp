#include "app/calibration/plot_svg.h"

#include "engine/base/markup.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <iterator>
#include <string_view>

namespace tractus::calibration {

namespace {

constexpr double kPlotWidth = 600;
constexpr double kPlotHeight = 430;
constexpr double kSheetTop = 96;
constexpr double kLeft = 76; // Margins between a plot's frame and the edges of its cell, in pixels.
constexpr double kRight = 24;
constexpr double kTop = 66;
constexpr double kBottom = 58;

// Okabe and Ito's colours as in the window, darkened for white paper, in the order of PlotTone.
constexpr std::array<std::string_view, 7> kColors { "#007d5b", "#0072b2", "#d08700", "#777777",
                                                    "#d0342c", "#c9d6df", "#7fb3d5" };

std::string_view color_of(PlotTone tone)
{
    return kColors[static_cast<std::size_t>(tone)];
}

// Draws one plot at its place on the sheet.
class SvgPlot {
public:
    SvgPlot(Plot const& plot, Vec2 const& corner)
        : plot_(plot)
        , corner_(corner)
        , size_(kPlotWidth - kLeft - kRight, kPlotHeight - kTop - kBottom)
    {
    }

    std::string print()
    {
        print_grid();
        for (auto const& series : plot_.series)
            print_series(series);
        print_frame();
        print_legend();
        return std::move(text_);
    }

private:
    template<typename... Values> void add(fmt::format_string<Values...> format, Values&&... values)
    {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    }

    Vec2 place(Vec2 const& value) const
    {
        Vec2 const part = (value - plot_.low).cwiseQuotient(plot_.high - plot_.low);
        return { corner_.x() + kLeft + part.x() * size_.x(),
                 corner_.y() + kTop + (1 - part.y()) * size_.y() };
    }

    std::string path(std::vector<Vec2> const& points) const
    {
        std::string text;
        for (auto const& point : points) {
            auto const at = place(point);
            text += fmt::format("{:.1f},{:.1f} ", at.x(), at.y());
        }
        return text;
    }

    void print_grid()
    {
        for (double const x : ticks_between(plot_.low.x(), plot_.high.x(), 7)) {
            auto const top = place({ x, plot_.high.y() });
            add("<path class=\"grid\" d=\"M{:.1f},{:.1f}v{:.1f}\"/>\n", top.x(), top.y(),
                size_.y());
            add("<text class=\"tick\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                top.x(), top.y() + size_.y() + 18, tick_text(x));
        }
        for (double const y : ticks_between(plot_.low.y(), plot_.high.y(), 6)) {
            auto const left = place({ plot_.low.x(), y });
            bool const is_zero = std::abs(y) < 1e-9 * (plot_.high.y() - plot_.low.y());
            add("<path class=\"{}\" d=\"M{:.1f},{:.1f}h{:.1f}\"/>\n", is_zero ? "zero" : "grid",
                left.x(), left.y(), size_.x());
            add("<text class=\"tick\" text-anchor=\"end\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                left.x() - 8, left.y() + 4.5, tick_text(y));
        }
    }

    void print_series(PlotSeries const& series)
    {
        auto const color = color_of(series.tone);
        switch (series.kind) {
        case PlotSeries::Kind::Line:
            add("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"2\" points=\"{}\"/>\n", color,
                path(series.points));
            break;
        case PlotSeries::Kind::Band: {
            auto outline = series.points;
            outline.insert(outline.end(), series.upper.rbegin(), series.upper.rend());
            add("<polygon fill=\"{}\" fill-opacity=\"{}\" points=\"{}\"/>\n", color,
                series.tone == PlotTone::Expected ? 0.45 : 0.18, path(outline));
            break;
        }
        case PlotSeries::Kind::Bars:
            for (auto const& point : series.points)
                print_bar(point, series.bar_width, color);
            break;
        case PlotSeries::Kind::Dots:
        case PlotSeries::Kind::Crosses:
            for (auto const& point : series.points)
                print_mark(series.kind, place(point), color);
            break;
        }
    }

    void print_bar(Vec2 const& point, double width, std::string_view color)
    {
        auto const low = place({ point.x() - width / 2, 0 });
        auto const high = place({ point.x() + width / 2, point.y() });
        add("<rect fill=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
            color, low.x() + 0.5, high.y(), std::max(0.5, high.x() - low.x() - 1),
            std::max(0.0, low.y() - high.y()));
    }

    void print_mark(PlotSeries::Kind kind, Vec2 const& at, std::string_view color)
    {
        if (kind == PlotSeries::Kind::Crosses)
            add("<path stroke=\"{}\" stroke-width=\"3\" "
                "d=\"M{:.1f},{:.1f}l12,12m-12,0l12,-12\"/>\n",
                color, at.x() - 6, at.y() - 6);
        else
            add("<circle fill=\"{}\" stroke=\"#fff\" stroke-width=\"1.5\" cx=\"{:.1f}\" "
                "cy=\"{:.1f}\" r=\"5.5\"/>\n",
                color, at.x(), at.y());
    }

    void print_frame()
    {
        Vec2 const middle = corner_ + Vec2(kLeft + size_.x() / 2, kTop + size_.y() / 2);
        add("<path class=\"axis\" d=\"M{:.1f},{:.1f}v{:.1f}h{:.1f}\"/>\n", corner_.x() + kLeft,
            corner_.y() + kTop, size_.y(), size_.x());
        add("<text class=\"title\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", corner_.x() + kLeft,
            corner_.y() + 28, escape_markup(plot_.title));
        add("<text class=\"label\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
            middle.x(), corner_.y() + kPlotHeight - 16, escape_markup(plot_.x_label));
        add("<text class=\"label\" text-anchor=\"middle\" transform=\"translate({:.1f},{:.1f}) "
            "rotate(-90)\">{}</text>\n",
            corner_.x() + 20, middle.y(), escape_markup(plot_.y_label));
    }

    void print_legend()
    {
        constexpr double kLetter = 6.9; // Approximate width of a letter, in pixels.
        double x = corner_.x() + kLeft;
        double const y = corner_.y() + 48;
        for (auto const& series : plot_.series) {
            if (series.label.empty())
                continue;
            print_key(series, { x + 8, y });
            add("<text class=\"key\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + 22, y + 4.5,
                escape_markup(series.label));
            x += 38 + kLetter * static_cast<double>(series.label.size());
        }
    }

    void print_key(PlotSeries const& series, Vec2 const& at)
    {
        auto const color = color_of(series.tone);
        switch (series.kind) {
        case PlotSeries::Kind::Line:
            add("<path stroke=\"{}\" stroke-width=\"2\" d=\"M{:.1f},{:.1f}h16\"/>\n", color,
                at.x() - 8, at.y());
            break;
        case PlotSeries::Kind::Band:
        case PlotSeries::Kind::Bars:
            add("<rect fill=\"{}\" fill-opacity=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" "
                "height=\"12\"/>\n",
                color, series.tone == PlotTone::Model ? 0.3 : 0.8, at.x() - 7, at.y() - 6);
            break;
        case PlotSeries::Kind::Dots:
        case PlotSeries::Kind::Crosses:
            print_mark(series.kind, at, color);
            break;
        }
    }

    Plot const& plot_;
    Vec2 corner_;
    Vec2 size_;
    std::string text_;
};

} // namespace

std::string print_svg(PlotSheet const& sheet, std::span<Plot const> plots)
{
    constexpr double kMargin = 20;
    double const width = 2 * kPlotWidth + 2 * kMargin;
    double const rows = static_cast<double>((plots.size() + 1) / 2);
    double const height = kSheetTop + rows * kPlotHeight + kMargin;
    auto text = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}">
<style>
text {{ font-family: "DejaVu Sans", Verdana, sans-serif; fill: #222; }}
.sheet {{ font-size: 24px; font-weight: bold; }}
.subtitle {{ font-size: 14px; fill: #555; }}
.title {{ font-size: 16px; font-weight: bold; }}
.label {{ font-size: 13px; fill: #444; }}
.key, .tick {{ font-size: 12px; fill: #555; }}
.grid {{ stroke: #e6e6e6; stroke-width: 1; fill: none; }}
.zero {{ stroke: #999; stroke-width: 1.2; fill: none; }}
.axis {{ stroke: #444; stroke-width: 1.2; fill: none; }}
</style>
<rect width="100%" height="100%" fill="#fff"/>
<text class="sheet" x="{2}" y="44">{3}</text>
<text class="subtitle" x="{2}" y="72">{4}</text>
)",
        width, height, kMargin + 20, escape_markup(sheet.title), escape_markup(sheet.subtitle));
    for (std::size_t i = 0; i < plots.size(); ++i) {
        Vec2 const corner(kMargin + kPlotWidth * static_cast<double>(i % 2),
                          kSheetTop + kPlotHeight * static_cast<double>(i / 2));
        text += SvgPlot(plots[i], corner).print();
    }
    return text + "</svg>\n";
}

} // namespace tractus::calibration
