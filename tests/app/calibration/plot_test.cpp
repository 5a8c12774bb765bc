#include "app/calibration/height_plots.h"
#include "app/calibration/plot_svg.h"
#include "sim/simulated_person.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::calibration {
namespace {

TEST(Plot, HasRoundTicks)
{
    EXPECT_EQ(ticks_between(-0.5, 4.2, 5), (std::vector<double> { 0, 1, 2, 3, 4 }));
    EXPECT_EQ(ticks_between(0, 0.35, 4), (std::vector<double> { 0, 0.1, 0.2, 0.1 * 3 }));
    EXPECT_EQ(tick_text(0.1 * 3), "0.3");
    EXPECT_EQ(tick_text(-1e-17), "0");
}

TEST(Plot, ShowsEverything)
{
    Plot plot;
    plot.series = { { .points = { { 0, -1 }, { 10, 3 } } } };
    fit_range(plot, PlotRange::SymmetricY);
    EXPECT_LT(plot.low.x(), 0);
    EXPECT_GT(plot.high.x(), 10);
    EXPECT_LT(plot.low.y(), -3);
    EXPECT_NEAR(plot.low.y(), -plot.high.y(), 1e-12);
}

TEST(Plot, ShowsNothingWithoutHarm)
{
    Plot plot;
    fit_range(plot, PlotRange::Tight);
    EXPECT_LT(plot.low.x(), plot.high.x());
    EXPECT_NE(print_svg({}, std::vector { plot }).find("</svg>"), std::string::npos);
}

struct Calibrated {
    std::vector<calib::HeightCapture> captures;
    calib::HeightFit fit;
};

Calibrated calibrated_with_a_slip()
{
    double const heights[] { 0, 60, 200, 400, 300, 120, 20 };
    auto captures = sim::simulate_captures(
        {}, heights, { .slip = sim::Slip { .capture = 2, .wrong_by_mm = 20 } });
    auto fit = calib::fit_height(captures).value();
    return { std::move(captures), std::move(fit) };
}

std::size_t count_points(Plot const& plot, PlotSeries::Kind kind)
{
    std::size_t count = 0;
    for (auto const& series : plot.series)
        if (series.kind == kind)
            count += series.points.size();
    return count;
}

TEST(HeightPlots, ShowFitResidualsHysteresisAndNoise)
{
    auto const [captures, fit] = calibrated_with_a_slip();
    auto const plots = height_plots(fit, captures, 4095);
    ASSERT_EQ(plots.size(), 4u);
    EXPECT_EQ(plots[0].title, "Fit: string");
    for (std::size_t i : { 0u, 1u }) {
        EXPECT_EQ(count_points(plots[i], PlotSeries::Kind::Dots), 6u);
        EXPECT_EQ(count_points(plots[i], PlotSeries::Kind::Crosses), 1u) << "the slip";
    }
    EXPECT_LT(plots[1].high.y(), 5) << "a slip does not hide the others";
    double readings = 0;
    for (auto const& bar : plots[3].series[0].points)
        readings += bar.y();
    EXPECT_EQ(readings, 7 * 500);
}

TEST(PlotSvg, DrawsTheSamePictureAgain)
{
    auto const [captures, fit] = calibrated_with_a_slip();
    auto const plots = height_plots(fit, captures, 4095);
    auto const svg = print_svg({ .title = "A & B <C>" }, plots);
    EXPECT_EQ(svg, print_svg({ .title = "A & B <C>" }, plots));
    EXPECT_NE(svg.find("A &amp; B &lt;C&gt;"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_NE(svg.find("slipped, left out"), std::string::npos);
}

} // namespace
} // namespace tractus::calibration
