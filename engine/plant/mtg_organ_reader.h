#pragma once

#include "engine/plant/measured_plant.h"
#include "engine/plant/mtg_organs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// Returns a word in lower case with only its letters and digits, for comparing the names of columns
// and classes.
std::string lower_letters(std::string_view text);

// Collects the organs of a multiscale tree graph while it is read (mtg.h), and counts those with
// too little data to place them. Lengths are in the file's unit.
class MtgOrganReader {
public:
    using ClassId = std::uint32_t;

    // Adds a class of organs; its name is used in the warning about omitted organs.
    ClassId add_class(std::string_view name, MtgOrganClass kind);

    // Adds a class of organs if `name` is a known word for an organ, and returns it; otherwise
    // returns no value.
    std::optional<ClassId> class_of_name(std::string_view name);

    // Looks for organ columns from column `first` on; returns false if there are none.
    bool find_columns(std::span<std::string_view const> names, std::size_t first);

    // Adds the organ of a row. If the row's data do not suffice, the organ is only counted as left
    // out. `node`: the graph node to which the organ is attached.
    void add(ClassId of, std::uint32_t node, std::array<std::optional<double>, 3> const& position,
             std::span<std::string_view const> cells);
    void leave_out(ClassId of) { ++classes_[of].left_out; }

    // Adds the organs to the plant, with lengths multiplied by `scale`.
    void place(MeasuredPlant& measured, double scale);

    // Returns a warning about omitted organs, or an empty string if there are none.
    std::string describe_omitted(std::string const& file) const;

private:
    struct Class {
        std::string name;
        MtgOrganClass kind = MtgOrganClass::Other;
        std::size_t left_out = 0; // Number of organs that cannot be placed.
    };
    struct ReadOrgan {
        MtgOrgan organ;
        ClassId of_class = 0;
    };

    std::vector<Class> classes_;
    std::optional<MtgOrganColumns> columns_;
    std::vector<ReadOrgan> organs_;
};

} // namespace tractus
