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

// A model in cpfg's language can grow along a stroke if its text keeps this contract:
//
//     #define SEGMENTS 0        number of segments; this value is used without a stroke
//     define: { array length[2] = {9, 8.8};    segment lengths: plain numbers, in the model's unit
//               array plane[1] = {0};          turn before each segment, in degrees: its plane ...
//               array bend[1] = {0}; }         ... and its angle
//     K(i) : i < SEGMENTS --> /(plane[i])+(bend[i])\(plane[i])F(length[i]) ... K(i + 1)
//
// Segments beyond the end of length[] continue with the ratio of its last two numbers. The drawn
// axis begins where the turtle starts and has its own counter, here i. Nothing else may turn the
// axis: all other commands that roll, bend or use random numbers are in brackets. A homomorphism
// may draw the segment, and N may stand for SEGMENTS.

// A range of characters of a text.
struct TextSpan {
    std::size_t begin = 0;
    std::size_t size = 0;
};

// The parts of a model's text that a stroke fills in, if the text keeps the contract described at
// the top of this file.
struct AxisContract {
    std::string count_name {}; // Name of the segment count in the text: "SEGMENTS" or "N".
    TextSpan count {};         // Span of the number of segments, which follows `count_name`.
    // Spans of the arrays `length`, `plane` and `bend`, each from '[' to '}'.
    TextSpan length {};
    TextSpan plane {};
    TextSpan bend {};
    std::vector<double> lengths {}; // Values of the length array, in the model's unit.
};

// Result of checking a model's text against the contract described at the top of this file. `lacks`
// has one sentence for each violation found in the text, with file and line; empty: the contract is
// kept.
struct ContractReading {
    AxisContract contract {}; // Spans found in the text; complete only if `lacks` is empty.
    std::vector<std::string> lacks {};
};
ContractReading read_contract(std::string const& name, std::string_view text);

// Finds the spans that a stroke fills in, in a model's text that keeps the contract of this file.
// Fails with a user error that describes the first violation.
Result<AxisContract> contract_of(std::string const& name, std::string_view text);

// Values to be written to the spans of an AxisContract.
struct ContractValues {
    std::size_t count = 0;
    // Text of the length array, such as "{9, 8.8}"; `plane` and `bend`: texts of these arrays.
    std::string length {};
    std::string plane {};
    std::string bend {};
};

// Returns a model's text with new values in the spans of `contract`; all other bytes stay the same.
std::string with_values(std::string_view text, AxisContract const& contract,
                        ContractValues const& values);

} // namespace tractus::sketch
