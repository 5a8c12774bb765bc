#include "engine/plant/mtg.h"
#include "engine/plant/mtg_organs.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus {

namespace {

constexpr std::string_view kHeader = "# Lengths, diameters and positions are in millimetres.\n"
                                     "CODE:\tFORM-A\n"
                                     "\n"
                                     "CLASSES:\n"
                                     "SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
                                     "$\t0\tFREE\tFREE\tIMPLICIT\n"
                                     "P\t1\tFREE\tFREE\tEXPLICIT\n"
                                     "A\t2\tFREE\tFREE\tEXPLICIT\n"
                                     "S\t3\tFREE\tFREE\tEXPLICIT\n"
                                     "L\t3\tFREE\tFREE\tEXPLICIT\n"
                                     "F\t3\tFREE\tFREE\tEXPLICIT\n"
                                     "O\t3\tFREE\tFREE\tEXPLICIT\n"
                                     "\n"
                                     "DESCRIPTION:\n"
                                     "LEFT\tRIGHT\tRELTYPE\tMAX\n"
                                     "A\tA\t+\t?\n"
                                     "S\tS\t<\t1\n"
                                     "S\tS,L,F,O\t+\t?\n"
                                     "\n"
                                     "FEATURES:\n"
                                     "NAME\tTYPE\n"
                                     "XX\tREAL\n"
                                     "YY\tREAL\n"
                                     "ZZ\tREAL\n"
                                     "Length\tREAL\n"
                                     "TopDiameter\tREAL\n"
                                     "BottomDiameter\tREAL\n";

// Names of the columns of segments after XX, YY and ZZ; organs share the first, Length.
constexpr std::string_view kSegmentColumns = "Length\tTopDiameter\tBottomDiameter";
// Names of the columns that only organs have.
constexpr auto kOwnColumns = std::span(kMtgOrganColumns).subspan<1>();

// Rounds a component of a unit vector.
double rounded(double value)
{
    constexpr double kSteps = 1e6;
    return std::round(value * kSteps) / kSteps + 0.0; // Adding 0.0 turns -0 into 0.
}

class MtgWriter {
public:
    MtgWriter(std::ostream& out, Plant const& plant)
        : out_(out)
        , plant_(plant)
        , standing_(plant.segment_count())
        , organs_(plant.segment_count())
    {
        std::uint32_t orders = 0;
        for (AxisId i = 0; i < plant.axes.size(); ++i) {
            orders = std::max(orders, plant.axes[i].order);
            if (plant.axes[i].parent_segment == kNone)
                trunks_.push_back(i);
            else
                standing_[plant.axes[i].parent_segment].push_back(i);
        }
        for (std::size_t i = 0; i < plant.organs.size(); ++i)
            (plant.organs[i].segment == kNone ? on_ground_ : organs_[plant.organs[i].segment])
                .push_back(i);
        trunk_column_ = trunks_.size() > 1 ? 1 : 0;
        // The last column is for organs on axes of the highest order.
        columns_ = trunk_column_ + orders + 2;
    }

    void write()
    {
        out_ << kHeader;
        for (auto const column : kOwnColumns)
            out_ << column << (column == kMtgOrganColumns.back() ? "\tALPHA\n" : "\tREAL\n");
        out_ << "\nMTG:\nENTITY-CODE" << std::string(columns_, '\t') << "XX\tYY\tZZ\t"
             << kSegmentColumns << '\t' << fmt::format("{}\n", fmt::join(kOwnColumns, "\t"));
        if (!trunks_.empty())
            out_ << "/P1\n";
        for (auto const trunk : trunks_)
            write_trunk(trunk);
    }

private:
    // Writes a trunk with its branches and organs, using an explicit stack of axes and their
    // progress instead of recursion, since plants can be deep.
    void write_trunk(AxisId trunk)
    {
        std::vector<std::pair<AxisId, std::uint32_t>> open;
        begin_axis(trunk, '/');
        auto const base = plant_.axes[trunk].first_node;
        write_entity(trunk_column_, "^/S0", plant_.node_position_mm[base]);
        out_ << fmt::format("\t0\t{0}\t{0}\n", diameter_mm(base));
        for (auto const organ : std::exchange(on_ground_, {}))
            write_organ(trunk_column_ + 1, organ);
        open.emplace_back(trunk, 0);
        while (!open.empty()) {
            auto& [axis, segment] = open.back();
            if (segment == plant_.axes[axis].segment_count) {
                open.pop_back();
                continue;
            }
            auto const id = plant_.axes[axis].first_segment + segment;
            write_segment(axis, segment++);
            for (auto const organ : organs_[id])
                write_organ(column_of(axis) + 1, organ);
            // Laterals are pushed last to first, so that the first one is written first.
            auto const& standing = standing_[id];
            if (!standing.empty())
                write_standing(standing, open);
        }
    }

    // Pushes the lateral axes of one segment; the parent axis continues when they have been
    // written.
    void write_standing(std::vector<AxisId> const& standing,
                        std::vector<std::pair<AxisId, std::uint32_t>>& open)
    {
        for (auto i = standing.rbegin(); i != standing.rend(); ++i)
            open.emplace_back(*i, 0);
    }

    // Writes the entity of an axis. Several trunks are components of the plant, in a column of
    // their own. A single trunk is in the plant's column, where ^ refers to the plant above it.
    void begin_axis(AxisId id, char relation)
    {
        bool const continues_plant = relation == '/' && trunk_column_ == 0;
        write_code(column_of(id),
                   fmt::format("{}{}A{}", continues_plant ? "^" : "", relation, id + 1));
        out_ << '\n';
    }

    std::uint32_t column_of(AxisId id) const { return trunk_column_ + plant_.axes[id].order; }

    void write_segment(AxisId id, std::uint32_t segment)
    {
        auto const& axis = plant_.axes[id];
        bool const is_trunk = axis.parent_segment == kNone;
        if (segment == 0 && !is_trunk)
            begin_axis(id, '+');
        auto const from = axis.first_node + segment;
        auto const& top_mm = plant_.node_position_mm[from + 1];
        write_entity(column_of(id),
                     fmt::format("^{}S{}", segment == 0 && !is_trunk ? '/' : '<', segment + 1),
                     top_mm);
        out_ << fmt::format("\t{}\t{}\t{}\n", (top_mm - plant_.node_position_mm[from]).norm(),
                            diameter_mm(from + 1), diameter_mm(from));
    }

    void write_organ(std::uint32_t column, std::size_t id)
    {
        auto const organ = mtg_organ(plant_, plant_.organs[id]);
        write_code(column, fmt::format("+{}{}", mtg_symbol(organ.kind), id + 1));
        auto const& at_mm = organ.position;
        out_ << std::string(columns_ - column, '\t')
             << fmt::format("{:.9g}\t{:.9g}\t{:.9g}\t{:.6g}\t\t\t{:.6g}\t", at_mm.x(), at_mm.y(),
                            at_mm.z(), organ.length, organ.width)
             << (organ.depth ? fmt::format("{:.6g}", *organ.depth) : "") << '\t'
             << (organ.petiole != 0 ? fmt::format("{:.6g}", organ.petiole) : "");
        for (Vec3 const& direction : { organ.direction, organ.normal })
            out_ << fmt::format("\t{}\t{}\t{}", rounded(direction.x()), rounded(direction.y()),
                                rounded(direction.z()));
        out_ << '\t' << mtg_shape_name(plant_, plant_.organs[id].shape) << '\n';
    }

    void write_code(std::uint32_t column, std::string const& code)
    {
        out_ << std::string(column, '\t') << code;
    }

    void write_entity(std::uint32_t column, std::string const& code, Vec3 const& position_mm)
    {
        write_code(column, code);
        out_ << std::string(columns_ - column, '\t')
             << fmt::format("{}\t{}\t{}", position_mm.x(), position_mm.y(), position_mm.z());
    }

    double diameter_mm(NodeId node) const
    {
        return 2 * static_cast<double>(plant_.node_radius_mm[node]);
    }

    std::ostream& out_;
    Plant const& plant_;
    std::vector<AxisId> trunks_;                // Axes on the ground.
    std::vector<std::vector<AxisId>> standing_; // Axes attached to the end of each segment.
    std::vector<std::vector<std::size_t>> organs_;
    std::vector<std::size_t> on_ground_; // Organs on the ground that have not been written yet.
    std::uint32_t trunk_column_ = 0;     // Column of the entities of trunks, counted from 0.
    std::uint32_t columns_ = 0;          // Number of columns for entities.
};

} // namespace

void write_mtg(std::ostream& out, Plant const& plant)
{
    MtgWriter(out, plant).write();
}

} // namespace tractus
