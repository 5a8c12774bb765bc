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

// What the texts of models with one stem and with several have in common.

// In six digits. A negative number must not run into the sign before it, where a macro is replaced.
std::string number_text(double value);

void replace_all(std::string& text, std::string_view word, std::string_view with);

// "array NAME[2] = {1, 2}".
std::string array_text(char const* name, std::vector<double> const& values);

// The longest piece that a stem may be drawn in, by its length.
double longest_piece(DrawnStem const& stem);

// What the rules read of a stem (line_rules.h), as expressions of cpfg's.
struct StemDefinitions {
    std::string length;
    char const* of = ""; // Which stem's length that is, for a comment.
    std::string width;
    std::string layers;
    double longest_piece = 0;
    std::string sides {};        // Where sizes follow half-ellipses.
    bool rolls_by_layer = false; // Then ROLL is not there.
};
std::string definitions_text(StemDefinitions const& stem, Pattern const& pattern);

// What a model of the construction needs of its sizes around the stem: none where organs stand only
// on its left and right, and those of these two where they are to follow half-ellipses.
Construction with_sizes_around(Construction construction, Pattern const& pattern);

// 360 degrees behind the first of a construction's azimuths they begin again.
std::vector<double> azimuths_of(Construction const& construction);

// How many steps of a derivation make the nodes of a stem: one for each, and one more for each
// layer that has none.
std::size_t count_steps(Construction const& construction);

// A stem's lines, of at[], nodes[] and azimuth[], as the definitions of an L-system.
std::vector<std::string> arrays_of(Construction const& construction);

// The tables of what layers bear, as definitions: none where all bear the same leaves.
std::vector<std::string> arrays_of(LayerTables const& layers);

// An organ's shape in a view, a leaf, by its letter.
std::string leaf_text(char letter, Pattern const& pattern);

// The model of a text, with its functions by the names of their files, in the order of their
// numbers, and their texts.
LineModel model_with(std::string text,
                     std::vector<std::pair<std::string, std::string>> const& functions,
                     Pattern const& pattern, std::string const& name);

} // namespace tractus::lines
