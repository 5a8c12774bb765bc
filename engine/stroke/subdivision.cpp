#include "engine/stroke/subdivision.h"

#include "engine/base/check.h"

namespace tractus {

std::vector<Vec3> subdivide(std::span<Vec3 const> coarse)
{
    auto const n = coarse.size();
    CHECK(n >= 2);
    if (n == 2)
        return { coarse[0], coarse[1] };

    std::vector<Vec3> fine;
    fine.reserve(2 * n - 2);
    fine.push_back(coarse[0]);
    fine.push_back((coarse[0] + coarse[1]) / 2);
    for (std::size_t i = 1; i + 2 < n; ++i) {
        fine.push_back(0.75 * coarse[i] + 0.25 * coarse[i + 1]);
        fine.push_back(0.25 * coarse[i] + 0.75 * coarse[i + 1]);
    }
    fine.push_back((coarse[n - 2] + coarse[n - 1]) / 2);
    fine.push_back(coarse[n - 1]);
    return fine;
}

std::vector<Vec3> reverse_subdivide(std::span<Vec3 const> fine)
{
    auto const count = fine.size();
    CHECK(count >= 4 && count % 2 == 0);
    auto const f = [&](std::size_t i) -> Vec3 const& { return fine[i]; };
    auto const n = count / 2 + 1;
    if (n == 3) // Too short for the filters: the middle point is solved for directly.
        return { f(0), f(1) + f(2) - (f(0) + f(3)) / 2, f(3) };

    std::vector<Vec3> coarse;
    coarse.reserve(n);
    coarse.push_back(f(0));
    coarse.push_back(-0.5 * f(0) + f(1) + 0.75 * f(2) - 0.25 * f(3));
    for (std::size_t i = 2; i + 2 < n; ++i)
        coarse.push_back(-0.25 * f(2 * i - 2) + 0.75 * f(2 * i - 1) + 0.75 * f(2 * i)
                         - 0.25 * f(2 * i + 1));
    coarse.push_back(-0.25 * f(count - 4) + 0.75 * f(count - 3) + f(count - 2)
                     - 0.5 * f(count - 1));
    coarse.push_back(f(count - 1));
    return coarse;
}

} // namespace tractus
