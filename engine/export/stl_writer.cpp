#include "engine/export/stl_writer.h"

#include "engine/export/binary_stream.h"

#include <array>
#include <limits>
#include <string_view>

namespace tractus::exports {

Result<void> write_stl(std::ostream& out, mesh::ClosedMesh const& mesh)
{
    if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
        return fail(Fault::User, "an STL file cannot have more than 4,294,967,295 triangles");
    std::array<char, 80> header {}; // It must not begin with "solid", as STL in text form does.
    std::string_view("tractus: millimetres, z up").copy(header.data(), header.size());
    {
        BinaryStream to(out);
        to.write_vector(header);
        to.write(static_cast<std::uint32_t>(mesh.triangles.size()));
        for (auto const& triangle : mesh.triangles) {
            auto const& a = mesh.positions_mm[triangle[0]];
            auto const& b = mesh.positions_mm[triangle[1]];
            auto const& c = mesh.positions_mm[triangle[2]];
            Vec3f const across = Vec3f(b - a).cross(Vec3f(c - a));
            float const length = across.norm();
            to.write_vector(length > 0 ? Vec3f(across / length) : Vec3f(Vec3f::Zero()));
            for (auto const& corner : { a, b, c })
                to.write_vector(corner);
            to.write(std::uint16_t { 0 });
        }
    }
    if (!out.flush())
        return fail(Fault::User,
                    "cannot write the STL file: the disk is full or the stream failed");
    return {};
}

} // namespace tractus::exports
