#include "engine/methods/leaves/leaf_mips.h"

#include "engine/base/check.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace tractus::leaf {

namespace {

constexpr int kCut = 128; // Pixels with at least this alpha pass the alpha test.

std::size_t bytes(int value)
{
    return static_cast<std::size_t>(value);
}

std::array<double, 256> const& linear_table()
{
    static std::array<double, 256> const table = [] {
        std::array<double, 256> made {};
        for (std::size_t i = 0; i < made.size(); ++i) {
            double const c = double(i) / 255;
            made[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        }
        return made;
    }();
    return table;
}

// Returns the sRGB byte nearest to the mean, in linear light, of four sRGB bytes.
std::uint8_t mean_color(std::array<std::uint8_t, 4> const& bytes)
{
    auto const& table = linear_table();
    double sum = 0;
    for (auto const byte : bytes)
        sum += table[byte];
    double const mean = 0.25 * sum;
    auto const above = std::ranges::lower_bound(table, mean);
    auto const i = static_cast<std::size_t>(above - table.begin());
    bool const is_lower = i > 0 && (i == table.size() || mean - table[i - 1] < table[i] - mean);
    return static_cast<std::uint8_t>(is_lower ? i - 1 : i);
}

std::uint8_t mean(std::array<std::uint8_t, 4> const& bytes)
{
    return static_cast<std::uint8_t>((bytes[0] + bytes[1] + bytes[2] + bytes[3] + 2) / 4);
}

void straighten(std::uint8_t* pixel)
{
    Vec3 const n = Vec3(pixel[0], pixel[1], pixel[2]) / 127.5 - Vec3::Ones();
    if (!(n.norm() > 0))
        return;
    for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(std::lround(127.5 * (n.normalized()[c] + 1)));
}

} // namespace

CellPage half_page(CellPage const& page, PageKind kind)
{
    CHECK(page.cell >= 2);
    CellPage made { .side = page.side / 2, .cell = page.cell / 2, .channels = page.channels };
    auto const channels = bytes(page.channels);
    auto const row = bytes(page.side) * channels;
    made.pixels.resize(bytes(made.side) * bytes(made.side) * channels);
    auto* to = made.pixels.data();
    for (int y = 0; y < made.side; ++y)
        for (int x = 0; x < made.side; ++x, to += channels) {
            auto const* const from
                = page.pixels.data() + 2 * (bytes(y) * row + bytes(x) * channels);
            for (std::size_t c = 0; c < channels; ++c) {
                std::array const four { from[c], from[c + channels], from[c + row],
                                        from[c + row + channels] };
                bool const is_light = kind == PageKind::Color && c < 3;
                to[c] = is_light ? mean_color(four) : mean(four);
            }
            if (kind == PageKind::Normal)
                straighten(to);
        }
    return made;
}

namespace {

// Calls work(cell index, alphas) for each cell of a page. Unless `back` is null, the alphas are
// then written to it, as pixels of the page, because `work` may change them.
void for_cells(CellPage const& page, std::vector<std::uint8_t>* back,
               std::function<void(std::size_t, std::vector<std::uint8_t>&)> const& work)
{
    CHECK(page.channels == 4);
    int const columns = page.side / page.cell;
    std::vector<std::uint8_t> alphas(bytes(page.cell) * bytes(page.cell));
    for (int row = 0; row < columns; ++row)
        for (int column = 0; column < columns; ++column) {
            auto const index = [&](std::size_t i) {
                auto const y = bytes(row * page.cell) + i / bytes(page.cell);
                auto const x = bytes(column * page.cell) + i % bytes(page.cell);
                return 4 * (y * bytes(page.side) + x) + 3;
            };
            for (std::size_t i = 0; i < alphas.size(); ++i)
                alphas[i] = page.pixels[index(i)];
            work(bytes(row * columns + column), alphas);
            for (std::size_t i = 0; back && i < alphas.size(); ++i)
                (*back)[index(i)] = alphas[i];
        }
}

// Scales alphas so that exactly `count` pixels pass the alpha test. Of pixels that are equal at the
// threshold, evenly distributed ones pass.
void scale_to_keep(std::vector<std::uint8_t>& alphas, std::size_t count)
{
    auto const there = std::ranges::count_if(alphas, [](int alpha) { return alpha >= kCut; });
    if (static_cast<std::size_t>(there) == count)
        return;
    auto sorted = alphas;
    std::ranges::sort(sorted, std::ranges::greater());
    // A cell may have fewer than `count` non-zero pixels.
    while (count > 0 && sorted[count - 1] == 0)
        --count;
    if (count == 0)
        return;
    auto const last = sorted[count - 1];
    auto const above = std::ranges::count_if(sorted, [&](auto alpha) { return alpha > last; });
    auto const alike = static_cast<std::size_t>(std::ranges::count(sorted, last));
    auto const kept = count - static_cast<std::size_t>(above);
    std::size_t met = 0;
    for (auto& alpha : alphas) {
        bool is_left_out = false;
        if (alpha == last) {
            is_left_out = (met + 1) * kept / alike == met * kept / alike;
            ++met;
        }
        long const scaled = std::lround(double(kCut) * alpha / last);
        alpha = static_cast<std::uint8_t>(is_left_out ? kCut - 1 : std::min(scaled, 255l));
    }
}

} // namespace

std::vector<double> alpha_coverage(CellPage const& page)
{
    std::vector<double> made;
    for_cells(page, nullptr, [&](std::size_t, std::vector<std::uint8_t> const& alphas) {
        auto const there = std::ranges::count_if(alphas, [](int alpha) { return alpha >= kCut; });
        made.push_back(double(there) / double(alphas.size()));
    });
    return made;
}

void keep_coverage(CellPage& page, std::span<double const> wanted)
{
    for_cells(page, &page.pixels, [&](std::size_t cell, std::vector<std::uint8_t>& alphas) {
        auto const count
            = static_cast<std::size_t>(std::lround(wanted[cell] * double(alphas.size())));
        scale_to_keep(alphas, count);
    });
}

} // namespace tractus::leaf
