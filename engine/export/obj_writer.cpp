#include "engine/export/obj_writer.h"

#include "engine/export/gltf_frame.h"
#include "engine/export/material_names.h"
#include "engine/export/texture.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::exports {
namespace {

// Returns a name as one word: in OBJ files a name ends at a space.
std::string name_word(std::string const& name)
{
    std::string word = name.empty() ? "unnamed" : name;
    for (auto& c : word)
        if (static_cast<unsigned char>(c) <= ' ' || c == '#' || c == '\x7f')
            c = '_';
    return word;
}

class ObjText {
public:
    explicit ObjText(std::ostream& out)
        : out_(out)
    {
    }

    void add(PlacedMesh const& placed, mesh::Mesh const& mesh)
    {
        out_ << "o " << name_word(placed.name) << '\n';
        place_ = Eigen::Translation3d(placed.position_mm)
            * Eigen::AngleAxisd(placed.rotation_rad, Vec3::UnitZ());
        for (auto const& surface : mesh.surfaces) {
            use(mesh.materials[surface.material]);
            add_triangles(surface, {});
        }
        for (auto const& organ : mesh.organs) {
            use(mesh.materials[organ.prototype.material]);
            for (auto const& instance : organ.instances)
                add_triangles(organ.prototype, instance);
        }
    }

private:
    void use(Material const& material)
    {
        auto const name = names_.name_of(material).name;
        if (name != used_)
            out_ << "usemtl " << name << '\n';
        used_ = name;
    }

    void add_triangles(mesh::TriangleMesh const& mesh, mesh::InstanceTransform const& instance)
    {
        Quat const turn = instance.rotation.cast<double>();
        Vec3 const scale = instance.scale.cast<double>();
        fmt::memory_buffer text;
        auto const to = std::back_inserter(text);
        for (auto const& position : mesh.positions_mm) {
            Vec3 const stretched = scale.cwiseProduct(position.cast<double>());
            Vec3 const placed
                = place_ * Vec3(instance.translation_mm.cast<double>() + turn * stretched);
            Vec3 const at = to_gltf(placed);
            fmt::format_to(to, "v {:.6f} {:.6f} {:.6f}\n", at.x(), at.y(), at.z());
        }
        // The first row of a picture is at v = 0 in our meshes, but at v = 1 in OBJ files.
        for (auto const& texture : mesh.texture_coordinates)
            fmt::format_to(to, "vt {:.5f} {:.5f}\n", texture.x(), 1 - texture.y());
        for (auto const& normal : mesh.normals) {
            Vec3 const n = turn_to_gltf(Vec3(place_.linear()
                                             * (turn * normal.cast<double>().cwiseQuotient(scale))))
                               .normalized();
            fmt::format_to(to, "vn {:.4f} {:.4f} {:.4f}\n", n.x(), n.y(), n.z());
        }
        std::size_t const swap = scale.prod() < 0 ? 1 : 0; // Mirroring turns triangles inside out.
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            auto const a = next_ + mesh.indices[i];
            auto const b = next_ + mesh.indices[i + 1 + swap];
            auto const c = next_ + mesh.indices[i + 2 - swap];
            fmt::format_to(to, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a, b, c);
        }
        next_ += mesh.positions_mm.size();
        out_.write(text.data(), static_cast<std::streamsize>(text.size()));
    }

    std::ostream& out_;
    Eigen::Isometry3d place_ = Eigen::Isometry3d::Identity();
    MaterialNames names_ { name_word, '.' };
    std::string used_;
    std::size_t next_ = 1; // Number of the next vertex; OBJ counts from 1 throughout the file.
};

Result<void> check(std::ostream& out)
{
    if (!out.flush())
        return fail(Fault::User,
                    "cannot write the OBJ file: the disk is full or the stream failed");
    return {};
}

} // namespace

Result<void> write_obj(std::ostream& out, std::span<PlacedMesh const> plants,
                       std::string_view library)
{
    out << "# tractus: metres, y up\n";
    if (!library.empty())
        out << "mtllib " << library << '\n';
    ObjText text(out);
    for (auto const& placed : plants) {
        std::optional<mesh::Mesh> made;
        text.add(placed, mesh_of(placed.mesh, made));
        TRY(check(out));
    }
    return check(out);
}

namespace {

// The text of one .mtl file, and the pictures to which it refers.
class MtlText {
public:
    MtlText(std::ostream& out, std::string_view stem)
        : out_(out)
        , stem_(stem)
    {
    }

    void add(std::string const& name, Material const& material)
    {
        auto const& color = material.base_color;
        // Ns is the Blinn-Phong exponent that is commonly derived from a roughness: 2 / roughness^4
        // - 2.
        double const alpha = std::max(0.05, double { material.roughness } * material.roughness);
        out_ << fmt::format("newmtl {}\nKd {:.4f} {:.4f} {:.4f}\nKs 0.04 0.04 0.04\nNs {:.2f}\n"
                            "Pr {:.4f}\nPm 0\nillum 2\n",
                            name, color.x(), color.y(), color.z(),
                            std::max(0.0, 2 / (alpha * alpha) - 2), double { material.roughness });
        if (stem_.empty())
            return;
        auto const textures = textures_of(material);
        if (auto const png = colored_picture(material); !png.empty()) {
            auto const picture = add_picture(name + "-color", png);
            out_ << "map_Kd " << picture << '\n';
            if (textures.alpha == MaterialTextures::Alpha::Mask)
                out_ << "map_d " << picture << '\n';
        }
        if (textures.normal) {
            auto const picture = add_picture(name + "-normal", textures.normal->bytes);
            // Blender reads the normal map from map_Bump.
            out_ << "norm " << picture << "\nmap_Bump " << picture << '\n';
        }
    }

    std::vector<PictureFile> take_pictures() { return std::move(pictures_); }

private:
    std::string add_picture(std::string const& name, std::string const& png)
    {
        pictures_.push_back({ fmt::format("{}-{}.png", stem_, file_word(name)), png });
        return pictures_.back().name;
    }

    static std::string file_word(std::string name)
    {
        for (auto& c : name)
            if (c == '/')
                c = '_';
        return name;
    }

    std::ostream& out_;
    std::string stem_;
    std::vector<PictureFile> pictures_;
};

} // namespace

Result<std::vector<PictureFile>> write_mtl(std::ostream& out, std::span<PlacedMesh const> plants,
                                           std::string_view stem)
{
    MaterialNames names(name_word, '.');
    MtlText text(out, stem);
    out << "# tractus\n";
    for (auto const& placed : plants) {
        std::optional<mesh::Mesh> made;
        auto const& mesh = mesh_of(placed.mesh, made);
        // Adds the materials of the triangles, in the same order as write_obj(), so that both files
        // use the same names.
        auto const add = [&](mesh::TriangleMesh const& part) {
            auto const& material = mesh.materials[part.material];
            if (auto const [name, is_new] = names.name_of(material); is_new)
                text.add(name, material);
        };
        for (auto const& surface : mesh.surfaces)
            add(surface);
        for (auto const& organ : mesh.organs)
            add(organ.prototype);
    }
    TRY(check(out));
    return text.take_pictures();
}

} // namespace tractus::exports
