#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Names of several letters in a book's productions, such as Fl and F_r, and the single letters that
// replace them in cpfg's language.
class BookNames {
public:
    // Notes the name that a production replaces, if it has several letters. `predecessor` may have
    // contexts and parameters.
    void add_predecessor(std::string_view predecessor);
    // Chooses letters that do not occur in the text. Names for which none is left stay.
    void choose_letters(std::string_view text);

    // Returns a string of modules with names replaced by their letters.
    std::string in_modules(std::string_view modules) const;

    // Rules by which the turtle draws the letters of names that begin with F, f, G or g as those;
    // empty if there are none.
    std::string homomorphism_rules() const;

private:
    struct Name {
        char letter = 0; // 0: none was free.
        std::size_t parameter_count = 0;
    };

    std::map<std::string, Name, std::greater<>> names_; // Longer names before their beginnings.
};

} // namespace tractus::lsystem
