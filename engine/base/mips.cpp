#include "engine/base/mips.h"

#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace tractus {

namespace {

constexpr int kCut = 128; // Pixels with at least this alpha pass the alpha test.

std::size_t size(int value)
{
    return static_cast<std::size_t>(value);
}

// Size of the level below a level of this size, along one side.
int half_of(int side)
{
    return std::max(1, side / 2);
}

// Calls work(index of the pixel, indices of the four larger pixels that it covers) for each pixel
// of the level below one of `width` by `height` pixels.
template<typename Work> void for_quads(int width, int height, Work const& work)
{
    int const columns = half_of(width);
    int const rows = half_of(height);
    auto const right = size(width > 1 ? 1 : 0);
    auto const down = size(height > 1 ? width : 0);
    for (int y = 0; y < rows; ++y) {
        auto from = size(2 * y) * size(width);
        auto to = size(y) * size(columns);
        for (int x = 0; x < columns; ++x, from += 2, ++to)
            work(to, std::array { from, from + right, from + down, from + down + right });
    }
}

// Scales alphas so that exactly `count` pixels pass the alpha test. Of pixels that are equal at the
// threshold, evenly distributed ones pass.
void scale_to_keep(std::vector<std::uint8_t>& alphas, std::size_t count)
{
    auto const there = std::ranges::count_if(alphas, [](int alpha) { return alpha >= kCut; });
    if (static_cast<std::size_t>(there) == count)
        return;
    std::array<std::size_t, 256> histogram {};
    for (auto const alpha : alphas)
        ++histogram[alpha];
    // The picture may have fewer than `count` non-zero pixels.
    count = std::min(count, alphas.size() - histogram[0]);
    if (count == 0)
        return;
    std::size_t last = 255;
    std::size_t above = 0;
    for (; above + histogram[last] < count; --last)
        above += histogram[last];
    auto const kept = count - above;
    std::size_t met = 0;
    for (auto& alpha : alphas) {
        bool is_left_out = false;
        if (alpha == last) {
            is_left_out = (met + 1) * kept / histogram[last] == met * kept / histogram[last];
            ++met;
        }
        long const scaled = std::lround(double(kCut) * alpha / double(last));
        alpha = static_cast<std::uint8_t>(is_left_out ? kCut - 1 : std::min(scaled, 255l));
    }
}

// Changes alphas so that their mean is as near as possible to `wanted`, 0 to 1, without changing
// which of them pass the alpha test. Zeros stay, as they are outside the mask.
void keep_mean_alpha(std::vector<std::uint8_t>& alphas, double wanted)
{
    double const target = 255 * wanted * double(alphas.size());
    double sum = 0;
    double reach = 0; // Change of the sum if all pixels were moved to the end of their range.
    for (int const alpha : alphas)
        sum += alpha;
    bool const grows = target > sum;
    auto const end_of
        = [&](int alpha) { return alpha >= kCut ? (grows ? 255 : kCut) : (grows ? kCut - 1 : 0); };
    for (int const alpha : alphas)
        reach += alpha == 0 ? 0 : end_of(alpha) - alpha;
    if (reach == 0)
        return;
    double const share = std::clamp((target - sum) / reach, 0.0, 1.0);
    double carry = 0;
    for (auto& alpha : alphas) {
        if (alpha == 0)
            continue;
        double const exact = alpha + share * (end_of(alpha) - alpha) + carry;
        int const low = alpha >= kCut ? kCut : 0;
        alpha = static_cast<std::uint8_t>(
            std::clamp(std::lround(exact), long(low), long(alpha >= kCut ? 255 : kCut - 1)));
        carry = exact - alpha;
    }
}

AlphaMips::Level half_level(AlphaMips::Level const& level)
{
    AlphaMips::Level made { .width = half_of(level.width), .height = half_of(level.height) };
    made.mean.resize(size(made.width) * size(made.height));
    for_quads(level.width, level.height, [&](std::size_t to, std::array<std::size_t, 4> const& at) {
        auto const& from = level.mean;
        made.mean[to] = 0.25f * (from[at[0]] + from[at[1]] + from[at[2]] + from[at[3]]);
    });
    return made;
}

} // namespace

AlphaMips::AlphaMips(std::span<std::uint8_t const> alpha, int width, int height, int min_side)
{
    auto const count = size(width) * size(height);
    CHECK(width > 0 && height > 0 && min_side > 0 && (alpha.empty() || alpha.size() == count));
    Level first { .width = width, .height = height };
    first.shown.assign(alpha.begin(), alpha.end());
    if (alpha.empty())
        first.shown.assign(count, 255);
    double sum = 0;
    std::size_t there = 0;
    first.mean.reserve(count);
    for (auto const value : first.shown) {
        first.mean.push_back(static_cast<float>(value) / 255);
        sum += value;
        there += value >= kCut;
    }
    double const mean = sum / (255 * double(count));
    double const coverage = double(there) / double(count);
    levels_.push_back(std::move(first));
    while (std::max(levels_.back().width, levels_.back().height) > min_side) {
        auto made = half_level(levels_.back());
        made.shown.reserve(made.mean.size());
        for (float const value : made.mean)
            made.shown.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
        auto const pixels = double(made.shown.size());
        scale_to_keep(made.shown, static_cast<std::size_t>(std::lround(coverage * pixels)));
        keep_mean_alpha(made.shown, mean);
        levels_.push_back(std::move(made));
    }
}

namespace {

std::array<float, 256> const& linear_table()
{
    static std::array<float, 256> const table = [] {
        std::array<float, 256> made {};
        for (std::size_t i = 0; i < made.size(); ++i) {
            double const c = double(i) / 255;
            made[i]
                = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
        }
        return made;
    }();
    return table;
}

// The sRGB byte nearest to a linear value.
std::uint8_t srgb_byte_of(float linear)
{
    constexpr int kSteps = 1 << 15;
    static std::vector<std::uint8_t> const table = [] {
        std::vector<std::uint8_t> made;
        for (int i = 0; i <= kSteps; ++i) {
            double const c = double(i) / kSteps;
            double const srgb = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
            made.push_back(static_cast<std::uint8_t>(std::lround(255 * srgb)));
        }
        return made;
    }();
    return table[static_cast<std::size_t>(std::clamp(linear, 0.0f, 1.0f) * kSteps + 0.5f)];
}

// One level of a picture, with values that can be averaged: linear light, components of normals
// from -1 to 1, or shares from 0 to 1.
class Averages {
public:
    Averages(PixelMap const& picture, MapKind kind)
        : kind_(kind)
        , channels_(kind == MapKind::Color ? std::min(picture.channels, 3) : picture.channels)
        , width_(picture.width)
        , height_(picture.height)
    {
        auto const pixels = size(picture.width) * size(picture.height);
        auto const step = size(picture.channels);
        values_.reserve(pixels * size(channels_));
        for (std::size_t i = 0; i < pixels; ++i)
            for (std::size_t c = 0; c < size(channels_); ++c)
                values_.push_back(value_of(picture.pixels[i * step + c]));
    }

    void halve(std::vector<float> const& weights)
    {
        // Outside the mask, where all weights are 0, pixels count alike.
        constexpr float kLeast = 1e-4f;
        auto const channels = size(channels_);
        std::vector<float> made(size(half_of(width_)) * size(half_of(height_)) * channels);
        for_quads(width_, height_, [&](std::size_t to, std::array<std::size_t, 4> const& at) {
            std::array<float, 4> weight {};
            float sum = 0;
            for (std::size_t k = 0; k < 4; ++k)
                sum += weight[k] = weights[at[k]] + kLeast;
            for (std::size_t c = 0; c < channels; ++c) {
                float total = 0;
                for (std::size_t k = 0; k < 4; ++k)
                    total += weight[k] * values_[at[k] * channels + c];
                made[to * channels + c] = total / sum;
            }
        });
        values_ = std::move(made);
        width_ = half_of(width_);
        height_ = half_of(height_);
        if (kind_ == MapKind::Normal)
            straighten();
    }

    // Mean of each channel over the pixels that pass the alpha test; empty if none does.
    std::vector<double> mean(std::vector<std::uint8_t> const& alpha) const
    {
        std::vector<double> sums(size(channels_));
        std::size_t count = 0;
        for (std::size_t i = 0; i < alpha.size(); ++i) {
            if (alpha[i] < kCut)
                continue;
            ++count;
            for (std::size_t c = 0; c < sums.size(); ++c)
                sums[c] += double(values_[i * sums.size() + c]);
        }
        for (auto& sum : sums)
            sum /= double(std::max<std::size_t>(count, 1));
        return count > 0 ? sums : std::vector<double>();
    }

    // Scales each channel so that mean() becomes `wanted`.
    void keep_mean(std::vector<std::uint8_t> const& alpha, std::vector<double> const& wanted)
    {
        auto const found = mean(alpha);
        if (wanted.empty() || found.empty() || kind_ == MapKind::Normal)
            return;
        for (std::size_t c = 0; c < found.size(); ++c) {
            auto const scale = static_cast<float>(found[c] > 0 ? wanted[c] / found[c] : 1);
            for (std::size_t i = c; i < values_.size(); i += found.size())
                values_[i] = std::min(1.0f, values_[i] * scale);
        }
    }

    // The level as bytes. The rounding errors of pixels that pass the alpha test are carried to the
    // next of them, so that the mean of few pixels stays exact.
    PixelMap bytes(std::vector<std::uint8_t> const& alpha, int channels) const
    {
        PixelMap made { .width = width_, .height = height_, .channels = channels };
        made.pixels.reserve(alpha.size() * size(channels));
        std::array<float, 4> carries {};
        for (std::size_t i = 0; i < alpha.size(); ++i) {
            for (std::size_t c = 0; c < size(channels_); ++c) {
                bool const is_seen = alpha[i] >= kCut && kind_ != MapKind::Normal;
                float const exact = values_[i * size(channels_) + c] + (is_seen ? carries[c] : 0);
                made.pixels.push_back(byte_of(exact));
                if (is_seen)
                    carries[c] = exact - value_of(made.pixels.back());
            }
            if (channels_ < channels)
                made.pixels.push_back(alpha[i]);
        }
        return made;
    }

private:
    float value_of(std::uint8_t byte) const
    {
        if (kind_ == MapKind::Color)
            return linear_table()[byte];
        float const share = static_cast<float>(byte) / 255;
        return kind_ == MapKind::Normal ? 2 * share - 1 : share;
    }

    std::uint8_t byte_of(float value) const
    {
        if (kind_ == MapKind::Color)
            return srgb_byte_of(value);
        float const share = kind_ == MapKind::Normal ? 0.5f + 0.5f * value : value;
        return static_cast<std::uint8_t>(255 * std::clamp(share, 0.0f, 1.0f) + 0.5f);
    }

    void straighten()
    {
        for (std::size_t i = 0; i + 2 < values_.size(); i += size(channels_)) {
            float const length = std::hypot(values_[i], values_[i + 1], values_[i + 2]);
            for (std::size_t c = 0; c < 3 && length > 0; ++c)
                values_[i + c] /= length;
        }
    }

    MapKind kind_;
    int channels_; // Number of averaged channels; alpha is not one of them.
    int width_;
    int height_;
    std::vector<float> values_;
};

} // namespace

std::vector<PixelMap> mip_levels(PixelMap const& picture, MapKind kind, AlphaMips const& alpha)
{
    auto const& levels = alpha.levels();
    CHECK(levels.front().width == picture.width && levels.front().height == picture.height);
    CHECK(kind != MapKind::Normal || picture.channels == 3 || picture.channels == 4);
    Averages averages(picture, kind);
    auto const wanted = averages.mean(levels.front().shown);
    std::vector<PixelMap> made;
    for (std::size_t i = 1; i < levels.size(); ++i) {
        averages.halve(levels[i - 1].mean);
        auto kept = averages;
        kept.keep_mean(levels[i].shown, wanted);
        made.push_back(kept.bytes(levels[i].shown, picture.channels));
    }
    return made;
}

} // namespace tractus
