#include "engine/plant/ply_skeleton.h"

#include "engine/plant/measured_plant.h"
#include "engine/plant/skeleton_lines.h"
#include "engine/plant/table_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace tractus {

namespace {

struct PlyType {
    std::string_view name;
    std::string_view other_name;
    std::size_t size;
    char kind; // 'i' signed, 'u' unsigned, 'f' floating-point.
};
constexpr std::array kPlyTypes {
    PlyType { "char", "int8", 1, 'i' },     PlyType { "uchar", "uint8", 1, 'u' },
    PlyType { "short", "int16", 2, 'i' },   PlyType { "ushort", "uint16", 2, 'u' },
    PlyType { "int", "int32", 4, 'i' },     PlyType { "uint", "uint32", 4, 'u' },
    PlyType { "float", "float32", 4, 'f' }, PlyType { "double", "float64", 8, 'f' },
};

PlyType const* find_ply_type(std::string_view name)
{
    auto const found = std::find_if(kPlyTypes.begin(), kPlyTypes.end(), [&](PlyType const& type) {
        return type.name == name || type.other_name == name;
    });
    return found == kPlyTypes.end() ? nullptr : &*found;
}

struct PlyProperty {
    std::string name;
    PlyType const* type = nullptr;
    // Type of the element count of a list property; null if the property is not a list.
    PlyType const* count_type = nullptr;
};
struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

constexpr std::size_t kMaxPlyList = 1000;
constexpr double kMaxPlyRadius_mm = 1e6; // Larger or invalid radii are ignored.

class PlyReader {
public:
    PlyReader(std::string const& name, std::string_view text)
        : name_(name)
        , rest_(text)
    {
    }

    Result<Plant> read()
    {
        TRY(read_header());
        for (auto const& element : elements_)
            TRY(read_element(element));
        return plant();
    }

private:
    enum class Format { Ascii, Little, Big };

    Result<void> read_header();
    Result<void> read_property(std::vector<std::string_view> const& words);
    Result<void> read_element(PlyElement const& element);
    Result<double> scalar(PlyType const& type);
    Result<Plant> plant() const;
    void set_radii(Plant& plant, double scale) const;

    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}: {}", name_, what));
    }

    std::string const& name_;
    std::string_view rest_;
    Format format_ = Format::Ascii;
    std::vector<PlyElement> elements_;
    std::vector<Vec3> vertices_; // Positions in the file's units.
    std::vector<double> radii_;  // Radius of each vertex; empty if the file has no radii.
    std::vector<std::array<double, 2>> edges_;
};

Result<void> PlyReader::read_header()
{
    if (take_text_line(rest_) != "ply")
        return error("this is no PLY file: its first line is not \"ply\"");
    while (true) {
        if (rest_.empty())
            return error("the header of this PLY file has no end_header");
        auto const words = words_of(take_text_line(rest_));
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
            continue;
        if (words[0] == "end_header")
            return {};
        if (words[0] == "format" && words.size() > 1) {
            format_ = words[1] == "binary_little_endian" ? Format::Little
                : words[1] == "binary_big_endian"        ? Format::Big
                                                         : Format::Ascii;
        } else if (words[0] == "element" && words.size() > 2) {
            auto const count = number_in(words[2]);
            if (!count || !(*count >= 0 && *count <= 4e9))
                return error(fmt::format("found {} elements, expected a number", words[2]));
            elements_.push_back({ std::string(words[1]), static_cast<std::size_t>(*count), {} });
        } else if (words[0] == "property") {
            TRY(read_property(words));
        } else {
            return error(fmt::format("found {} in the header of this PLY file, expected element or "
                                     "property",
                                     words[0]));
        }
    }
}

Result<void> PlyReader::read_property(std::vector<std::string_view> const& words)
{
    bool const is_list = words.size() > 4 && words[1] == "list";
    if (elements_.empty() || words.size() < 3)
        return error("a property in the header of this PLY file belongs to no element");
    PlyProperty property;
    property.name = words.back();
    property.count_type = is_list ? find_ply_type(words[2]) : nullptr;
    property.type = find_ply_type(words[is_list ? 3 : 1]);
    if (!property.type || (is_list && !property.count_type))
        return error(fmt::format("property {} has a type that PLY does not have", property.name));
    elements_.back().properties.push_back(std::move(property));
    return {};
}

Result<double> PlyReader::scalar(PlyType const& type)
{
    if (format_ == Format::Ascii) {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
        auto const word = rest_.substr(0, rest_.find_first_of(" \t\r\n"));
        rest_.remove_prefix(word.size());
        auto const value = number_in(word);
        if (!value)
            return word.empty() ? error("the file ends before its last element")
                                : error(fmt::format("found {}, expected a number", word));
        return *value;
    }
    if (rest_.size() < type.size)
        return error("the file ends before its last element");
    std::array<char, 8> bytes {};
    std::copy_n(rest_.begin(), type.size, bytes.begin());
    rest_.remove_prefix(type.size);
    if ((format_ == Format::Big) == (std::endian::native == std::endian::little))
        std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.size));
    auto const as = [&]<typename T>(T value) {
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<double>(value);
    };
    if (type.kind == 'f')
        return type.size == 4 ? as(float {}) : as(double {});
    if (type.kind == 'u')
        return type.size == 1 ? as(std::uint8_t {})
            : type.size == 2  ? as(std::uint16_t {})
                              : as(std::uint32_t {});
    return type.size == 1 ? as(std::int8_t {})
        : type.size == 2  ? as(std::int16_t {})
                          : as(std::int32_t {});
}

// Reads all items of an element. Vertices and edges are kept; elements with other names are
// skipped.
Result<void> PlyReader::read_element(PlyElement const& element)
{
    std::array<std::string_view, 4> constexpr kVertex { "x", "y", "z", "radius" };
    bool const is_vertex = element.name == "vertex";
    bool const is_edge = element.name == "edge";
    bool const has_radius = std::any_of(element.properties.begin(), element.properties.end(),
                                        [](auto const& each) { return each.name == "radius"; });
    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        std::array<double, 4> vertex {};
        std::vector<double> ends;
        for (auto const& property : element.properties) {
            double const count = property.count_type ? TRY(scalar(*property.count_type)) : 1;
            if (!(count >= 0 && count <= static_cast<double>(kMaxPlyList)))
                return error(
                    fmt::format("a list has {} members, expected at most {}", count, kMaxPlyList));
            for (double k = 0; k < count; ++k) {
                double const value = TRY(scalar(*property.type));
                auto const place = std::find(kVertex.begin(), kVertex.end(), property.name);
                if (is_vertex && place != kVertex.end())
                    vertex[static_cast<std::size_t>(place - kVertex.begin())] = value;
                if (is_edge && ends.size() < 2)
                    ends.push_back(value);
            }
        }
        if (is_vertex)
            vertices_.emplace_back(vertex[0], vertex[1], vertex[2]);
        if (is_vertex && has_radius)
            radii_.push_back(vertex[3]);
        if (is_edge && ends.size() == 2)
            edges_.push_back({ ends[0], ends[1] });
    }
    return {};
}

Result<Plant> PlyReader::plant() const
{
    Bounds box;
    for (auto const& vertex : vertices_)
        box.add(vertex);
    double const scale = millimetres_per_unit(box);
    std::vector<SkeletonPiece> pieces;
    for (auto const& edge : edges_) {
        std::array<Vec3, 2> ends;
        for (std::size_t i = 0; i < 2; ++i) {
            if (!(edge[i] >= 0 && edge[i] < static_cast<double>(vertices_.size())))
                return error(fmt::format("an edge ends at vertex {}, but there are {}", edge[i],
                                         vertices_.size()));
            ends[i] = vertices_[static_cast<std::size_t>(edge[i])] * scale;
        }
        pieces.push_back({ ends[0], ends[1] });
    }
    if (pieces.empty())
        return error("there are no edges in it: export the skeleton, not its surface or points");
    auto plant = TRY(plant_from_lines(name_, pieces));
    if (radii_.size() == vertices_.size()) // Radii are ignored unless every vertex has one.
        set_radii(plant, scale);
    return plant;
}

// Sets the radius of each node to that of the vertex at its position. A joint of several vertices
// is at the first of them, and the plant is moved so that its first node is at the origin.
void PlyReader::set_radii(Plant& plant, double scale) const
{
    std::map<std::array<double, 3>, double> radius_at;
    Vec3 lowest = Vec3::Constant(std::numeric_limits<double>::infinity());
    auto const key = [](Vec3 const& at) { return std::array { at.x(), at.y(), at.z() }; };
    std::vector<bool> has_edge(vertices_.size());
    for (auto const& edge : edges_)
        for (double const end : edge)
            has_edge[static_cast<std::size_t>(end)] = true;
    for (std::size_t i = 0; i < vertices_.size(); ++i)
        if (has_edge[i] && vertices_[i].z() < lowest.z())
            lowest = vertices_[i];
    for (std::size_t i = 0; i < vertices_.size(); ++i)
        radius_at.emplace(key(Vec3(vertices_[i] * scale - lowest * scale)), radii_[i] * scale);
    for (NodeId node = 0; node < plant.node_position_mm.size(); ++node) {
        auto const found = radius_at.find(key(plant.node_position_mm[node]));
        if (found != radius_at.end() && found->second >= 0 && found->second <= kMaxPlyRadius_mm)
            plant.node_radius_mm[node] = static_cast<float>(found->second);
    }
}

} // namespace

Result<Plant> parse_ply_skeleton(std::string const& name, std::span<std::byte const> bytes)
{
    return PlyReader(name, { reinterpret_cast<char const*>(bytes.data()), bytes.size() }).read();
}

} // namespace tractus
