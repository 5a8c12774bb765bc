#include "engine/plant/bark.h"

namespace tractus {

namespace {

struct BarkNumbers {
    Vec3f young_color;
    Vec3f old_color;
    double old_mm;
};

// In the order of BarkKind.
std::array<BarkNumbers, kBarkNames.size()> const kNumbers { {
    { { 0.34f, 0.28f, 0.22f }, { 0.34f, 0.28f, 0.22f }, 100 },
    { { 0.46f, 0.43f, 0.37f }, { 0.36f, 0.32f, 0.27f }, 160 },
    { { 0.50f, 0.44f, 0.38f }, { 0.45f, 0.39f, 0.34f }, 100 },
    { { 0.59f, 0.58f, 0.52f }, { 0.49f, 0.46f, 0.40f }, 180 },
    { { 0.62f, 0.62f, 0.59f }, { 0.62f, 0.62f, 0.59f }, 300 },
    { { 0.84f, 0.80f, 0.75f }, { 0.78f, 0.75f, 0.70f }, 200 },
    { { 0.44f, 0.32f, 0.27f }, { 0.35f, 0.28f, 0.24f }, 220 },
    { { 0.55f, 0.54f, 0.50f }, { 0.53f, 0.52f, 0.49f }, 250 },
    { { 0.57f, 0.48f, 0.39f }, { 0.46f, 0.34f, 0.28f }, 130 },
    { { 0.52f, 0.48f, 0.42f }, { 0.44f, 0.42f, 0.37f }, 180 },
    { { 0.52f, 0.48f, 0.42f }, { 0.46f, 0.43f, 0.38f }, 180 },
    { { 0.54f, 0.53f, 0.48f }, { 0.39f, 0.36f, 0.31f }, 130 },
    { { 0.75f, 0.47f, 0.28f }, { 0.42f, 0.31f, 0.24f }, 170 },
    { { 0.66f, 0.63f, 0.51f }, { 0.63f, 0.61f, 0.49f }, 250 },
    { { 0.59f, 0.58f, 0.51f }, { 0.37f, 0.35f, 0.32f }, 160 },
    { { 0.49f, 0.39f, 0.31f }, { 0.46f, 0.37f, 0.33f }, 150 },
    { { 0.55f, 0.51f, 0.40f }, { 0.39f, 0.35f, 0.30f }, 130 },
} };

BarkNumbers const& numbers_of(BarkKind kind)
{
    return kNumbers.at(static_cast<std::size_t>(kind));
}

} // namespace

Vec3f bark_color(Bark const& bark)
{
    auto const& numbers = numbers_of(bark.kind);
    switch (bark.age) {
    case BarkAge::Young:
        return numbers.young_color;
    case BarkAge::Half:
        return (numbers.young_color + numbers.old_color) / 2;
    case BarkAge::Old:
        break;
    }
    return numbers.old_color;
}

double old_bark_mm(BarkKind kind)
{
    return numbers_of(kind).old_mm;
}

BarkAge bark_age(BarkKind kind, double diameter_mm)
{
    double const share = diameter_mm / old_bark_mm(kind);
    return share >= 1 ? BarkAge::Old : share >= kHalfOldBark ? BarkAge::Half : BarkAge::Young;
}

} // namespace tractus
