#include "engine/plant/qsm.h"

#include "engine/plant/measured_plant.h"
#include "engine/plant/table_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace tractus {

namespace {

enum QsmColumn : std::size_t {
    Radius,
    Length,
    StartX,
    StartY,
    StartZ,
    AxisX,
    AxisY,
    AxisZ,
    Parent,
    Extension, // All versions of TreeQSM have the same columns up to this one.
    Branch,
    EndX,
    EndY,
    EndZ,
    Id,
    QsmColumnCount
};

struct QsmColumnName {
    std::string_view name; // Lower case, letters and digits only.
    QsmColumn column;
};
constexpr std::array kQsmNames {
    QsmColumnName { "radius", Radius },
    QsmColumnName { "radiuscyl", Radius },
    QsmColumnName { "radiusm", Radius },
    QsmColumnName { "length", Length },
    QsmColumnName { "lengthm", Length },
    QsmColumnName { "startx", StartX },
    QsmColumnName { "starty", StartY },
    QsmColumnName { "startz", StartZ },
    QsmColumnName { "axisx", AxisX },
    QsmColumnName { "axisy", AxisY },
    QsmColumnName { "axisz", AxisZ },
    QsmColumnName { "endx", EndX },
    QsmColumnName { "endy", EndY },
    QsmColumnName { "endz", EndZ },
    QsmColumnName { "parent", Parent },
    QsmColumnName { "parentid", Parent },
    QsmColumnName { "extension", Extension },
    QsmColumnName { "extensionid", Extension },
    QsmColumnName { "branch", Branch },
    QsmColumnName { "branchid", Branch },
    QsmColumnName { "axisid", Branch },
    QsmColumnName { "id", Id },
    QsmColumnName { "cylid", Id },
    QsmColumnName { "cylinderid", Id },
};

struct QsmCylinder {
    Vec3 start = Vec3::Zero(); // Lengths and positions are in the file's units.
    Vec3 end = Vec3::Zero();
    double radius = 0;
    double id = 0;
    double parent = 0;
    double extension = 0;
    double branch = 0;
};

class QsmReader {
public:
    explicit QsmReader(std::string const& name)
        : name_(name)
    {
        for (std::size_t i = 0; i <= Extension; ++i)
            columns_[i] = i;
    }

    Result<void> read(std::string_view line)
    {
        ++line_;
        if (without_blanks(line).empty() || line.front() == '#')
            return {};
        if (cylinders_.empty() && !separator_) {
            constexpr std::string_view kSeparators = "\t;,";
            auto const found = std::find_if(kSeparators.begin(), kSeparators.end(), [&](char c) {
                return line.find(c) != std::string_view::npos;
            });
            separator_ = found == kSeparators.end() ? ' ' : *found;
            auto const cells = cells_of(line);
            if (!number_in(cells.front()))
                return read_names(cells);
        }
        return read_cylinder(cells_of(line));
    }

    Result<Plant> take() const;

private:
    std::vector<std::string_view> cells_of(std::string_view line) const
    {
        return *separator_ == ' ' ? words_of(line) : columns_of(line, *separator_);
    }

    Result<void> read_names(std::vector<std::string_view> const& cells);
    Result<void> read_cylinder(std::vector<std::string_view> const& cells);
    Result<double> number(QsmColumn column, std::vector<std::string_view> const& cells) const;
    Result<Vec3> vector(QsmColumn x, std::vector<std::string_view> const& cells) const;
    std::vector<std::size_t> parents() const;
    std::vector<bool> continued(std::span<std::size_t const> parents) const;
    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}:{}: {}", name_, line_, what));
    }

    static constexpr std::size_t kGround = static_cast<std::size_t>(-1);

    std::string const& name_;
    std::size_t line_ = 0;
    std::optional<char> separator_;
    std::array<std::optional<std::size_t>, QsmColumnCount> columns_;
    bool is_named_ = false; // True if the first line of the file names its columns.
    std::vector<QsmCylinder> cylinders_;
};

// Reads the names of the columns. The default order is kept if none is named start_x, as with
// TreeQSM's own names, some of which stand for three columns.
Result<void> QsmReader::read_names(std::vector<std::string_view> const& cells)
{
    std::array<std::optional<std::size_t>, QsmColumnCount> named;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::string name;
        for (char const c : cells[i])
            if (std::isalnum(static_cast<unsigned char>(c)))
                name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        for (auto const& known : kQsmNames)
            if (known.name == name && !named[known.column])
                named[known.column] = i;
    }
    if (!named[StartX])
        return {};
    bool const has_end = named[EndX] || (named[AxisX] && named[Length]);
    if (!has_end || !named[Radius] || !named[Parent])
        return error(
            "the columns need radius, parent, start_x, start_y, start_z, and end_x, end_y, "
            "end_z or axis_x, axis_y, axis_z and length");
    columns_ = named;
    is_named_ = true;
    return {};
}

Result<double> QsmReader::number(QsmColumn column, std::vector<std::string_view> const& cells) const
{
    auto const at = columns_[column];
    if (!at || *at >= cells.size())
        return error(fmt::format("the line has {} columns, expected {}", cells.size(),
                                 is_named_ ? "one for each name in the first line"
                                           : "at least 10: radius, length, start (3), axis (3), "
                                             "parent and extension"));
    auto const value = number_in(cells[*at]);
    if (!value || !std::isfinite(*value))
        return error(fmt::format("found {} in column {}, expected a number", cells[*at], *at + 1));
    return *value;
}

Result<Vec3> QsmReader::vector(QsmColumn x, std::vector<std::string_view> const& cells) const
{
    Vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] = TRY(number(static_cast<QsmColumn>(x + static_cast<std::size_t>(i)), cells));
    return result;
}

Result<void> QsmReader::read_cylinder(std::vector<std::string_view> const& cells)
{
    auto const optional = [&](QsmColumn column) -> Result<double> {
        return columns_[column] ? number(column, cells) : 0;
    };
    QsmCylinder cylinder;
    cylinder.start = TRY(vector(StartX, cells));
    if (columns_[EndX]) {
        cylinder.end = TRY(vector(EndX, cells));
    } else {
        Vec3 const axis = TRY(vector(AxisX, cells));
        double const length = TRY(number(Length, cells));
        cylinder.end = cylinder.start + axis.normalized() * length;
    }
    cylinder.radius = TRY(number(Radius, cells));
    cylinder.parent = TRY(number(Parent, cells));
    cylinder.id
        = columns_[Id] ? TRY(number(Id, cells)) : static_cast<double>(cylinders_.size() + 1);
    cylinder.extension = TRY(optional(Extension));
    cylinder.branch = TRY(optional(Branch));
    cylinders_.push_back(cylinder);
    return {};
}

std::vector<std::size_t> QsmReader::parents() const
{
    std::map<double, std::size_t> by_id;
    for (std::size_t i = 0; i < cylinders_.size(); ++i)
        by_id.emplace(cylinders_[i].id, i);
    std::vector<std::size_t> result(cylinders_.size(), kGround);
    for (std::size_t i = 0; i < cylinders_.size(); ++i)
        if (auto const found = by_id.find(cylinders_[i].parent); found != by_id.end())
            result[i] = found->second;
    return result;
}

// Returns, for each cylinder, whether it continues the axis of its parent.
std::vector<bool> QsmReader::continued(std::span<std::size_t const> parents) const
{
    bool const has_extensions
        = std::any_of(cylinders_.begin(), cylinders_.end(),
                      [](QsmCylinder const& cylinder) { return cylinder.extension > 0; });
    std::vector<bool> result(cylinders_.size());
    std::vector<std::size_t> thickest(cylinders_.size(), kGround);
    for (std::size_t i = 0; i < cylinders_.size(); ++i) {
        auto const parent = parents[i];
        if (parent == kGround)
            continue;
        auto& best = thickest[parent];
        if (best == kGround || cylinders_[i].radius > cylinders_[best].radius)
            best = i;
        if (has_extensions)
            result[i] = cylinders_[parent].extension == cylinders_[i].id;
        else if (columns_[Branch])
            result[i] = cylinders_[i].branch == cylinders_[parent].branch;
    }
    if (!has_extensions && !columns_[Branch])
        for (auto const best : thickest)
            if (best != kGround)
                result[best] = true;
    return result;
}

Result<Plant> QsmReader::take() const
{
    auto const parent = parents();
    auto const goes_on = continued(parent);
    std::vector<std::vector<std::size_t>> children(cylinders_.size());
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < cylinders_.size(); ++i)
        if (parent[i] == kGround)
            order.push_back(i);
        else
            children[parent[i]].push_back(i);
    for (std::size_t next = 0; next < order.size(); ++next)
        order.insert(order.end(), children[order[next]].begin(), children[order[next]].end());
    if (order.size() != cylinders_.size())
        return fail(Fault::User,
                    fmt::format("{}: {} of {} cylinders stand on each other and not on the ground",
                                name_, cylinders_.size() - order.size(), cylinders_.size()));
    Bounds box;
    for (auto const& cylinder : cylinders_) {
        box.add(cylinder.start);
        box.add(cylinder.end);
    }
    double const scale = millimetres_per_unit(box);
    std::vector<MeasuredNode> nodes;
    std::vector<std::uint32_t> node_of(cylinders_.size());
    for (auto const i : order) {
        auto const& cylinder = cylinders_[i];
        double const radius_mm = cylinder.radius * scale;
        if (parent[i] == kGround)
            nodes.push_back({ .position_mm = cylinder.start * scale, .radius_mm = radius_mm });
        auto const below = parent[i] == kGround ? static_cast<std::uint32_t>(nodes.size() - 1)
                                                : node_of[parent[i]];
        node_of[i] = static_cast<std::uint32_t>(nodes.size());
        nodes.push_back({ .below = below,
                          .continues = parent[i] == kGround || goes_on[i],
                          .position_mm = cylinder.end * scale,
                          .radius_mm = radius_mm });
    }
    return plant_from_nodes(name_, nodes);
}

} // namespace

Result<Plant> parse_qsm(std::string const& name, std::string_view text)
{
    QsmReader reader(name);
    while (!text.empty())
        TRY(reader.read(take_text_line(text)));
    return reader.take();
}

} // namespace tractus
