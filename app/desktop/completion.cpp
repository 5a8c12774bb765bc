#include "app/desktop/completion.h"

#include "app/options/checks.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::desktop {

namespace {

bool begins_with(std::string const& text, std::string const& start)
{
    return text.compare(0, start.size(), start) == 0;
}

bool is_option(std::string const& word)
{
    return word.size() > 1 && word.front() == '-';
}

std::vector<std::string> names_of(CLI::Option const& option)
{
    std::vector<std::string> names;
    for (auto const& name : option.get_snames())
        names.push_back("-" + name);
    for (auto const& name : option.get_lnames())
        names.push_back("--" + name);
    return names;
}

CLI::Option* find_option(CLI::App& command, std::string const& name)
{
    for (auto* const option : command.get_options({})) {
        auto const names = names_of(*option);
        if (std::find(names.begin(), names.end(), name) != names.end())
            return option;
    }
    return nullptr;
}

CLI::App* find_command(CLI::App& parent, std::string const& name)
{
    for (auto* const command : parent.get_subcommands([](CLI::App*) { return true; }))
        if (command->get_name() == name)
            return command;
    return nullptr;
}

// State of the command line's parser after all words but the last.
struct Place {
    CLI::App* command;
    // Option whose value is the next word. If the option has all values that it requires, the next
    // word may also be another option. Null: no option expects a value.
    CLI::Option* option = nullptr;
    int values = 0; // Number of values that the option has already received.
    std::size_t positionals = 0;

    bool needs_value() const { return option && values < option->get_items_expected_min(); }

    void read(std::string const& word)
    {
        if (is_option(word) && !needs_value()) {
            option = find_option(*command, word.substr(0, word.find('=')));
            values = word.find('=') == std::string::npos ? 0 : 1;
        } else if (option) {
            ++values;
        } else if (auto* const below = positionals == 0 ? find_command(*command, word) : nullptr) {
            command = below;
        } else {
            ++positionals;
        }
        if (option && values >= option->get_items_expected_max())
            option = nullptr;
    }
};

// Rejoins the words of "--option=value", which bash splits at "=". A final "=" becomes an empty
// word.
std::vector<std::string> without_equals_signs(std::vector<std::string> typed)
{
    if (!typed.empty() && typed.back() == "=")
        typed.back().clear();
    typed.erase(std::remove(typed.begin(), typed.end(), "="), typed.end());
    return typed;
}

class Offer {
public:
    Offer(std::string typed, std::vector<std::string> const& models)
        : typed_(std::move(typed))
        , models_(models)
    {
    }

    void word(std::string const& text, std::string const& about = {})
    {
        if (begins_with(text, typed_))
            completion.words.push_back({ text, about });
    }

    // Offers the possible values of an option or argument, each with `prefix` before it.
    void values_of(CLI::Option& option, std::string const& prefix = {})
    {
        auto const words = options::completion_words(option);
        for (auto const& text : words)
            word(prefix + text);
        auto const kind
            = (option.get_positional() ? option.get_name(true) : "") + option.get_type_name();
        auto const has = [&](char const* part) { return kind.find(part) != std::string::npos; };
        bool const is_plant = has("MODEL") || has("PLANT");
        if (is_plant && words.empty())
            for (auto const& model : models_)
                word(prefix + model);
        if (has("DEVICE"))
            word(prefix + "simulated", "The simulated rig");
        if (has("FILE") || has("LOG") || has("SCRIPT") || has("DEVICE") || is_plant)
            completion.names = Completion::Names::Files;
        else if (has("FOLDER"))
            completion.names = Completion::Names::Folders;
    }

    void commands_of(CLI::App& command)
    {
        for (auto* const below : command.get_subcommands([](CLI::App*) { return true; }))
            if (!below->get_group().empty())
                word(below->get_name(), below->get_description());
    }

    void options_of(CLI::App& command)
    {
        for (auto* const option : command.get_options({}))
            if (!option->get_lnames().empty())
                word("--" + option->get_lnames().front(), option->get_description());
    }

    void positional_of(CLI::App& command, std::size_t place)
    {
        for (auto* const option : command.get_options({}))
            if (option->get_positional() && place-- == 0)
                values_of(*option);
    }

    Completion completion;

private:
    std::string typed_;
    std::vector<std::string> const& models_;
};

} // namespace

Completion complete(CLI::App& root, std::vector<std::string> typed,
                    std::vector<std::string> const& models)
{
    typed = without_equals_signs(std::move(typed));
    auto const last = typed.empty() ? std::string() : typed.back();
    Place place { &root };
    for (std::size_t i = 0; i + 1 < typed.size(); ++i)
        place.read(typed[i]);

    Offer offer(last, models);
    if (auto const equals = last.find('='); is_option(last) && equals != std::string::npos) {
        if (auto* const option = find_option(*place.command, last.substr(0, equals)))
            offer.values_of(*option, last.substr(0, equals + 1));
    } else if (place.needs_value()) {
        offer.values_of(*place.option);
    } else if (!last.empty() && last.front() == '-') {
        offer.options_of(*place.command);
    } else if (place.option) {
        offer.values_of(*place.option);
    } else {
        if (place.positionals == 0)
            offer.commands_of(*place.command);
        offer.positional_of(*place.command, place.positionals);
        if (offer.completion.words.empty() && offer.completion.names == Completion::Names::None)
            offer.options_of(*place.command);
    }
    return std::move(offer.completion);
}

std::string print_completion(Completion const& completion)
{
    std::string lines;
    for (auto const& word : completion.words)
        lines += word.about.empty() ? word.text + "\n"
                                    : fmt::format("{}\t{}\n", word.text, word.about);
    switch (completion.names) {
    case Completion::Names::None:
        break;
    case Completion::Names::Folders:
        lines += ":folders\n";
        break;
    case Completion::Names::Files:
        lines += ":files\n";
        break;
    }
    return lines;
}

} // namespace tractus::desktop
