#pragma once

#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/pattern.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::lines {

// Functions for parts of the text that models with one stem and with several stems have in common.

// Formats a number with six digits. Negative numbers are in parentheses, so that a macro expands
// correctly after a minus sign.
std::string format_model_number(double value);

void replace_all(std::string& text, std::string_view word, std::string_view with);

// Formats an array, such as "array NAME[2] = {1, 2}".
std::string array_text(char const* name, std::vector<double> const& values);

// Maximum length of the pieces in which a model draws the stem, as a share of the stem's length:
// kShortPiece or kLongPiece.
double longest_piece(DrawnStem const& stem);

// The properties of a stem that the rules use (line_rules.h), as expressions in cpfg's language.
struct StemDefinitions {
    std::string length;
    char const* of = ""; // Name of the stem with this length, for a comment in the model.
    std::string width;
    std::string layers;
    double longest_piece = 0;
    // Number of boundaries around the stem, if sizes follow half-ellipses; otherwise empty.
    std::string sides {};
    bool rolls_by_layer = false; // True: layers have their own rolls, so ROLL is not defined.
};
std::string definitions_text(StemDefinitions const& stem, Pattern const& pattern);

// Returns the construction with the sizes around the stem that its model needs. There are none if
// organs occur only on the left and right. If sizes are to follow half-ellipses and there are no
// boundaries in space, they are the sizes on these two sides.
Construction with_sizes_around(Construction construction, Pattern const& pattern);

// Azimuths of Construction::around in degrees, followed by the first of them plus 360.
std::vector<double> azimuths_of(Construction const& construction);

// Number of derivation steps that make the nodes of a stem: one for each node, and one for each
// layer without nodes.
std::size_t count_steps(Construction const& construction);

// Returns a stem's arrays at[], nodes[] and azimuth[] as definitions of an L-system.
std::vector<std::string> arrays_of(Construction const& construction);

// Returns the tables of the layers' organs as definitions of an L-system, without tables that are
// empty.
std::vector<std::string> arrays_of(LayerTables const& layers);

// Returns the statement by which a view defines the plain leaf that rules call with this letter.
std::string leaf_statement(char letter, Pattern const& pattern);

// Makes the model from its text and its function files, pairs of name and contents, in the order in
// which the text numbers them.
LineModel model_with(std::string text,
                     std::vector<std::pair<std::string, std::string>> const& functions,
                     Pattern const& pattern, std::string const& name);

} // namespace tractus::lines
