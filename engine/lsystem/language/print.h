#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>

namespace tractus::lsystem {

// Returns the number of modules of the turtle symbol that begins with kinds[0]: 2 for ~S and ?P, 2
// or 3 for @-symbols such as @o and @Ts, otherwise 1.
std::size_t symbol_length(Alphabet const& alphabet, std::span<KindId const> kinds);

// Formats a string as cpfg does: without line breaks, and with parameters as by C's %g.
std::string to_string(Model const& model, ModuleString const& string);

// Number of modules of each kind, indexed by KindId.
using KindCounts = std::array<std::size_t, 256>;
KindCounts count_kinds(std::span<KindId const> modules);

// Counts the symbols of the string, whatever their parameters. An @-symbol, ~S or ?P counts as one
// symbol.
std::map<std::string, std::size_t> count_symbols(Model const& model, ModuleString const& string);

} // namespace tractus::lsystem
