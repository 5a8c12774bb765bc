// The word of a tool or of a kind of edit may occur only in the file that defines it and in the
// list of methods.

#include "app/methods/all_methods.h"
#include "engine/base/file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::methods {
namespace {

namespace fs = std::filesystem;

struct SourceText {
    std::string path; // Path from the root of the sources.
    std::string text; // The source's text without its comments.
};

std::string without_comments(std::string const& text)
{
    std::string code;
    for (std::size_t i = 0; i < text.size();) {
        auto const end = std::min(text.find('\n', i), text.size());
        auto const line = text.substr(i, end - i);
        code += line.substr(0, line.find("//")) + '\n';
        i = end + 1;
    }
    return code;
}

std::vector<SourceText> sources()
{
    std::vector<SourceText> all;
    for (auto const* const folder : { "app", "calib", "drivers", "engine", "sim" })
        for (auto const& entry : fs::recursive_directory_iterator(fs::path(TRACTUS_ROOT) / folder))
            if (auto const ending = entry.path().extension(); ending == ".cpp" || ending == ".h")
                all.push_back({ fs::relative(entry.path(), TRACTUS_ROOT).generic_string(),
                                without_comments(read_file(entry.path()).value()) });
    return all;
}

// True if the source defines `word` as a tool, .word = "draw", or as an edit,
// make_edit_kind<...>("draw").
bool defines(SourceText const& source, std::string const& word)
{
    constexpr std::string_view kStart = "make_edit_kind<";
    auto const& text = source.text;
    auto const literal = fmt::format("\"{}\"", word);
    if (text.find(".word = " + literal) != std::string::npos)
        return true;
    for (auto at = text.find(literal); at != std::string::npos; at = text.find(literal, at + 1)) {
        auto const start = text.rfind(kStart, at);
        if (start == std::string::npos)
            continue;
        auto const between = text.substr(start, at - start);
        if (between.find(">(") != std::string::npos && between.find(';') == std::string::npos)
            return true;
    }
    return false;
}

// Returns the headers of this program that a source file includes, such as "app/tools/tool.h".
std::vector<fs::path> includes_of(SourceText const& source)
{
    constexpr std::string_view kInclude = "\n#include \"";
    std::vector<fs::path> included;
    auto const text = "\n" + source.text;
    for (auto at = text.find(kInclude); at != std::string::npos; at = text.find(kInclude, at + 1)) {
        auto const begin = at + kInclude.size();
        included.emplace_back(text.substr(begin, text.find('"', begin) - begin));
    }
    return included;
}

// Returns the method in whose folder a file is; empty if it belongs to no method.
std::string method_of(fs::path const& file)
{
    std::vector<std::string> const parts(file.begin(), file.end());
    for (std::size_t i = 0; i + 2 < parts.size(); ++i)
        if (parts[i] == "methods" && parts[i + 1] != "commands")
            return parts[i + 1];
    return "";
}

// True if a file uses a word in another sense, as part of another language, or is a script.
bool is_another_language(std::string const& path, std::string const& word)
{
    static std::set<std::pair<std::string, std::string>> const others {
        { "sim/gesture_script.cpp", "select" }, // A command in the scripts of simulated hands.
        { "sim/gesture_script.cpp", "draw" },
        { "app/commands/window.cpp", "draw" }, // The subcommand of "tractus draw".
        // The subcommand of "tractus leaves draw".
        { "app/methods/leaves/commands/leaves_command.cpp", "draw" },
        // A block in the grammar of a leaf.
        { "engine/methods/leaves/read_directive.cpp", "outline" },
        // The tour, which like a hand's script asks for tools by their words.
        { "app/controllers/tour.cpp", "draw_limb" },
        { "app/controllers/tour.cpp", "indicate" },
        // The log's tool "calibrate" also has this word.
        { "app/controllers/calibration_panel_controller.cpp", "press" },
        { "app/calibration/calibration_controller.cpp", "press" },
    };
    return others.contains({ path, word });
}

std::vector<std::string> all_words()
{
    std::vector<std::string> words { "press" };
    for (auto const* const kind : all_methods().tools)
        words.emplace_back(kind->word);
    for (auto const* const kind : all_methods().edits)
        words.emplace_back(kind->word);
    return words;
}

TEST(MethodWords, StandInTheFilesOfTheirRowsAlone)
{
    auto const files = sources();
    ASSERT_GT(files.size(), 300u);
    for (auto const& word : all_words()) {
        auto const literal = fmt::format("\"{}\"", word);
        int definitions = 0;
        std::set<std::string> methods; // Methods that define the word.
        for (auto const& file : files)
            if (defines(file, word)) {
                ++definitions;
                methods.insert(method_of(file.path));
            }
        methods.erase("");
        for (auto const& file : files) {
            bool const is_own = defines(file, word) || methods.contains(method_of(file.path));
            if (!is_own && !is_another_language(file.path, word)) {
                EXPECT_EQ(file.text.find(literal), std::string::npos)
                    << file.path << " names " << literal;
            }
        }
        EXPECT_GE(definitions, 1) << word;
    }
}

// True for a file beside the list of all methods. Such files may combine several methods.
bool is_beside_list(fs::path const& path)
{
    return path.parent_path() == "app/methods"
        || path.string().starts_with("app/methods/commands/all_");
}

// A tool's header may be included only in the tool's folder, in its method's folder, and beside the
// list of methods. Eraser tools are excepted, since any tool may use them for the pen's other end.
TEST(MethodWords, ToolsAreIncludedByTheirFolderAndTheList)
{
    int count = 0;
    for (auto const& file : sources()) {
        auto const home = [](fs::path const& path) {
            auto const method = method_of(path);
            return method.empty() ? path.parent_path().string() : method;
        };
        for (auto const& header : includes_of(file)) {
            if (!header.stem().string().ends_with("_tool"))
                continue;
            ++count;
            bool const is_eraser
                = header.stem() == "erase_tool" && file.path.starts_with("app/methods/");
            EXPECT_TRUE(home(header) == home(file.path) || is_eraser || is_beside_list(file.path))
                << file.path << " includes " << header;
        }
    }
    EXPECT_GT(count, 10);
}

// Headers in the folders of methods may be included only in these folders and beside the list of
// methods.
TEST(MethodWords, MethodsAreIncludedByTheListAlone)
{
    int count = 0;
    for (auto const& file : sources())
        for (auto const& header : includes_of(file)) {
            auto const method = method_of(header);
            if (method.empty())
                continue;
            ++count;
            EXPECT_TRUE(method_of(file.path) == method || is_beside_list(file.path))
                << file.path << " includes " << header;
        }
    EXPECT_GT(count, 10);
}

} // namespace
} // namespace tractus::methods
