#include "engine/lsystem/notations/book_text.h"

#include "engine/lsystem/notations/book_lines.h"
#include "engine/lsystem/notations/book_names.h"
#include "engine/lsystem/text/placed_text.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::lsystem {

namespace {

std::vector<std::string_view> book_lines_of(std::string_view text)
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        lines.push_back(text.substr(0, text.find('\n')));
        text.remove_prefix(std::min(lines.back().size() + 1, text.size()));
    }
    return lines;
}

class BookReader {
public:
    BookModel read(std::string_view text);

private:
    void add_line(std::string_view written);
    bool add_figure(std::string_view line);
    bool add_directive(std::string_view line);
    void add_production(BookProduction const& production);
    void add_statement(std::string_view line);
    void add_end();
    std::string modules(std::string_view text) const
    {
        return names_.in_modules(book_modules(text));
    }

    BookNames names_;
    std::vector<std::string> lines_;
    std::string steps_; // Derivation length from a caption; not yet written to the model.
    std::string angle_;
    bool has_head_ = false; // True if the text has "Lsystem:".
    bool has_seed_ = false;
    bool has_probability_ = false;
    bool has_homomorphism_ = false;
    bool is_ended_ = false;     // True after "endlsystem".
    bool is_in_string_ = false; // True if the next line may continue an axiom or a production.
    long open_braces_ = 0;      // Number of open braces in cpfg's statements.
};

// Reads a line such as "n=5, δ=22.5°", as in the captions of figures. Returns false for other
// lines.
bool BookReader::add_figure(std::string_view line)
{
    auto const figure = book_figure(line);
    if (!figure)
        return false;
    if (!figure->angle.empty())
        angle_ = figure->angle;
    bool const has_place = has_head_ && !figure->steps.empty();
    if (!has_place && !figure->steps.empty())
        steps_ = figure->steps;
    lines_.push_back(has_place ? "derivation length: " + figure->steps : "");
    return true;
}

// Reads #ignore, #consider and #include of a surface, which are statements of the book and not
// directives of the preprocessor.
bool BookReader::add_directive(std::string_view line)
{
    if (line.substr(0, 1) != "#")
        return false;
    auto rest = trimmed_line(line.substr(1));
    auto const word = first_name(rest);
    rest = trimmed_line(rest.substr(word.size()));
    bool const is_surface = word == "include" && rest.find_first_of("\"<") == rest.npos;
    if (word == "ignore" || word == "consider") {
        rest.remove_prefix(rest.substr(0, 1) == ":" ? 1 : 0);
        lines_.push_back(fmt::format("{}: {}", word, modules(trimmed_line(rest))));
    } else {
        lines_.emplace_back(is_surface ? "" : line);
    }
    return true;
}

void BookReader::add_production(BookProduction const& production)
{
    auto line = modules(production.predecessor);
    if (!production.condition.empty())
        line += " : " + book_condition(production.condition);
    line += " --> " + modules(production.successor);
    if (!production.probability.empty())
        line += fmt::format(" : {}", production.probability);
    has_probability_ = has_probability_ || !production.probability.empty();
    lines_.push_back(std::move(line));
}

void BookReader::add_statement(std::string_view line)
{
    has_head_ = has_head_ || begins_with_word(line, "lsystem:");
    has_seed_ = has_seed_ || begins_with_word(line, "seed:");
    has_homomorphism_ = has_homomorphism_ || begins_with_word(line, "homomorphism");
    open_braces_ += std::count(line.begin(), line.end(), '{');
    open_braces_ -= std::count(line.begin(), line.end(), '}');
    if (begins_with_word(line, "endlsystem") && !is_ended_)
        return add_end();
    lines_.emplace_back(line);
}

// Adds the statements that the text lacks, and "endlsystem".
void BookReader::add_end()
{
    is_ended_ = true;
    std::string text;
    if (has_head_ && !steps_.empty())
        text += fmt::format("derivation length: {}\n", std::exchange(steps_, {}));
    if (has_probability_ && !has_seed_ && !has_homomorphism_)
        text += "Seed: 0\n";
    if (auto const rules = names_.homomorphism_rules(); !rules.empty())
        text += (has_homomorphism_ ? "" : "homomorphism\n") + rules;
    lines_.push_back(text + "endlsystem");
}

void BookReader::add_line(std::string_view written)
{
    auto const line = trimmed_line(book_without_comment(written));
    bool const is_in_block = open_braces_ > 0;
    if (is_in_block || (is_cpfg_statement(line) && line.substr(0, 1) != "#")) {
        is_in_string_ = false;
        return add_statement(line);
    }
    auto const axiom = book_axiom(line);
    auto const production = axiom ? std::nullopt : book_production(line);
    bool const continues = is_in_string_ && !line.empty() && is_blank(written.front());
    if (axiom || production || !continues)
        is_in_string_ = axiom || production;
    if (add_directive(line))
        return;
    if (axiom)
        lines_.push_back("Axiom: " + modules(*axiom));
    else if (production)
        add_production(*production);
    else if (is_in_string_)
        lines_.push_back("\t" + modules(line));
    else if (!add_figure(line))
        lines_.emplace_back(line);
}

BookModel BookReader::read(std::string_view text)
{
    auto const without = without_block_comments(text);
    auto const lines = book_lines_of(without);
    for (auto const line : lines)
        if (auto const production = book_production(trimmed_line(book_without_comment(line))))
            names_.add_predecessor(production->predecessor);
    names_.choose_letters(without);
    for (auto const line : lines)
        add_line(line);
    if (!is_ended_)
        add_end();
    BookModel result;
    result.text = has_head_ ? "" : "Lsystem: 1\n";
    if (!steps_.empty())
        result.text += fmt::format("derivation length: {}\n", steps_);
    // Gives the following lines the line numbers of the book's text.
    if (!result.text.empty())
        result.text += "#line 1\n";
    for (auto const& line : lines_)
        result.text += line + '\n';
    if (!angle_.empty())
        result.view = fmt::format("angle increment: {}\n", angle_);
    return result;
}

} // namespace

BookModel read_book_model(std::string_view text)
{
    return BookReader().read(text);
}

} // namespace tractus::lsystem
