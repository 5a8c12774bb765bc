#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Names of several letters in a book's productions, such as Fl and F_r, and the single letters that
// replace these names in cpfg's language.
class BookNames {
public:
    // Adds the name in the strict predecessor of a production, if it has several letters.
    // `predecessor` may include contexts and parameters.
    void add_predecessor(std::string_view predecessor);
    // Chooses a letter for each name, among the letters that do not occur in the text. If no letter
    // is left, a name is not replaced.
    void choose_letters(std::string_view text);

    // Returns a string of modules in which letters replace the names.
    std::string in_modules(std::string_view modules) const;

    // Returns homomorphism rules by which the turtle draws names that begin with F, f, G or g like
    // that letter; empty if there are no such names.
    std::string homomorphism_rules() const;

private:
    struct Name {
        char letter = 0; // Letter that replaces the name; 0 if none was free.
        std::size_t parameter_count = 0;
    };

    // Names in descending order, so that a name comes before its own prefixes.
    std::map<std::string, Name, std::greater<>> names_;
};

} // namespace tractus::lsystem
