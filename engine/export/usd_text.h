#pragma once

#include <cstddef>
#include <fmt/format.h>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// Returns a name as USD allows for prims: ASCII letters, digits and underscores, not beginning with
// a digit. Every other byte becomes an underscore.
std::string usd_name(std::string const& name);

// Names that differ: of the children of one prim.
class UsdNames {
public:
    // Returns usd_name(wanted), with a number after it if the name is in use.
    std::string unused(std::string const& wanted);

private:
    std::set<std::string> used_;
};

// Writes the text of a USD file (.usda), prim by prim.
class UsdText {
public:
    // Writes the header: metres, +y up. `default_prim`: name of the prim that other files refer to.
    UsdText(std::ostream& out, std::string_view default_prim);

    // Begins a prim inside the last one that has begun and not ended. `metadata`: lines within the
    // parentheses after its name.
    void begin(std::string_view type, std::string_view name,
               std::span<std::string const> metadata = {});
    void end();

    // Path of the prim that has begun last.
    std::string path() const;

    // Writes a line, as fmt::format() does.
    template<typename... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments)
    {
        indent();
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
        end_line();
    }

    // Writes an array: `declaration` is its type and name, write(to, i) appends element i to a
    // buffer. `interpolation`: how it lies on a mesh; empty: not stated.
    template<typename Write>
    void array(std::string_view declaration, std::size_t count, Write const& write,
               std::string_view interpolation = {})
    {
        indent();
        append(declaration);
        append(" = [");
        for (std::size_t i = 0; i < count; ++i) {
            append(i == 0 ? "" : i % kRow == 0 ? ",\n" : ", ");
            write(std::back_inserter(text_), i);
            if (text_.size() > kFull)
                flush();
        }
        append("]");
        end_array(interpolation);
    }

    // Writes what is still in memory to the stream.
    void flush();

private:
    static constexpr std::size_t kRow = 8; // Elements on one line.
    static constexpr std::size_t kFull = std::size_t { 1 } << 20;

    void append(std::string_view text) { text_.append(text); }
    void indent();
    void end_line();
    void end_array(std::string_view interpolation);

    std::ostream& out_;
    fmt::memory_buffer text_;
    std::vector<std::string> open_; // Names of the prims that have begun, outermost first.
};

} // namespace tractus::exports
