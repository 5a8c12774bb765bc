#pragma once

#include "engine/base/vectors.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace tractus {

// Reads strokes that people drew in space. In the text, a line `S <points> <brush> <size>` precedes
// as many lines `x y z pressure t_ms` (x right, y up, z forward, about 1 dm per unit). The result
// is in the world frame, in millimetres. Strokes with a single point are left out.
inline std::vector<std::vector<Vec3>> read_strokes(std::filesystem::path const& file)
{
    std::vector<std::vector<Vec3>> strokes;
    std::ifstream in(file);
    std::string letter;
    std::size_t count = 0;
    double brush = 0;
    double size = 0;
    while (in >> letter >> count >> brush >> size) {
        std::vector<Vec3> points(count);
        double pressure = 0;
        double time_ms = 0;
        for (auto& point : points) {
            Vec3 read;
            in >> read.x() >> read.y() >> read.z() >> pressure >> time_ms;
            point = 100 * Vec3(read.x(), read.z(), read.y());
        }
        if (points.size() >= 2)
            strokes.push_back(std::move(points));
    }
    return strokes;
}

} // namespace tractus
