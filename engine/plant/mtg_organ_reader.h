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

// A word in small letters, without what is neither letter nor digit: how columns and classes of
// graphs are compared.
std::string lower_letters(std::string_view text);

// Gathers the organs of a multiscale tree graph while it is read (mtg.h), and counts those that the
// file says too little of to place them. Lengths are in the file's unit.
class MtgOrganReader {
public:
    using ClassId = std::uint32_t;

    // A new class of organs, by whose name those that are left out are counted.
    ClassId add_class(std::string_view name, MtgOrganClass kind);

    // Adds the class if its name is the word for an organ.
    std::optional<ClassId> class_of_name(std::string_view name);

    // Finds the columns of organs from `first` on; false if there are none.
    bool find_columns(std::span<std::string_view const> names, std::size_t first);

    // Adds the organ of a row, if that says enough. `node` bears it.
    void add(ClassId of, std::uint32_t node, std::array<std::optional<double>, 3> const& position,
             std::span<std::string_view const> cells);
    void leave_out(ClassId of) { ++classes_[of].left_out; }

    // Puts the organs on the plant, `scale` times as large.
    void place(MeasuredPlant& measured, double scale);

    // A warning; empty if there are no organs that were left out.
    std::string said_of_left_out(std::string const& file) const;

private:
    struct Class {
        std::string name;
        MtgOrganClass kind = MtgOrganClass::Other;
        std::size_t left_out = 0; // How many organs cannot be placed.
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
