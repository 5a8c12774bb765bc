#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/model.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::sketch {

// Any model in cpfg's language can be grown along a stroke whose text keeps this contract:
//
//     #define SEGMENTS 0        how many segments the stroke has; the model's own plant without one
//     define: { array length[2] = {9, 8.8};    their lengths in the model's unit, plain numbers;
//               array plane[1] = {0};          past its end each by the one before it as the last
//               array bend[1] = {0}; }         two are; and the turns before them
//     K(i) : i < SEGMENTS --> /(plane[i])+(bend[i])\(plane[i])F(length[i]) ... K(i + 1)
//
// The drawn axis begins where the turtle does and has a counter of its own. Nothing else turns it:
// what stands along it rolls, bends and asks for chance between brackets. The segment may be drawn
// by homomorphism, and N may stand for SEGMENTS.

// A part of a text.
struct TextSpan {
    std::size_t begin = 0;
    std::size_t size = 0;
};

// Where a text keeps the contract. Spans are in their order in the text.
struct AxisContract {
    std::string count_name {}; // "SEGMENTS" or "N".
    TextSpan count {};         // Its number.
    TextSpan length {};        // From the array's '[' to its '}', as the next two.
    TextSpan plane {};
    TextSpan bend {};
    std::vector<double> lengths {}; // The numbers of length[], in the model's unit.
};

// What a text lacks of the contract: one sentence each, with file and line. Empty: it keeps it, as
// far as its text shows.
struct ContractReading {
    AxisContract contract {}; // Whole only where nothing lacks.
    std::vector<std::string> lacks {};
};
ContractReading read_contract(std::string const& name, std::string_view text);

// Where a text keeps the contract. Fails, as the user's fault, with the first that lacks.
Result<AxisContract> contract_of(std::string const& name, std::string_view text);

// Values for the places of a contract, as they stand in the text.
struct ContractValues {
    std::size_t count = 0;
    std::string length {}; // "{9, 8.8}"
    std::string plane {};
    std::string bend {};
};

// The text with these values in its contract's places, and otherwise byte for byte.
std::string with_values(std::string_view text, AxisContract const& contract,
                        ContractValues const& values);

} // namespace tractus::sketch
