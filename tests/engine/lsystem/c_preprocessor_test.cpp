#include "engine/lsystem/text/placed_text.h"
#include "engine/lsystem/text/source_text.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

// Compares the results of preprocessing random programs with the output of gcc.

namespace tractus::lsystem {
namespace {

constexpr int kProgramCount = 600;

bool has_gcc()
{
    return std::system("gcc --version >/dev/null 2>&1") == 0;
}

std::string tokens(std::string const& text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        auto const end = token_end(text, i);
        if (!is_blank(text[i]) && text[i] != '\n')
            result += text.substr(i, end - i) + ' ';
        i = end;
    }
    return result;
}

// A set of independent programs that gcc preprocesses in one run, since starting gcc takes longer
// than its work.
class Programs {
public:
    void add(std::string const& program)
    {
        // This line marks the beginning of the program's results in gcc's output.
        std::string text = fmt::format("@@ {}\n", lines_.size());
        for (auto const* name : { "A", "B", "C", "D", "f", "g", "h" })
            text += fmt::format("#undef {}\n", name);
        auto const line = line_count_ + std::count(text.begin(), text.end(), '\n') + 1;
        // Sets the line number again, whatever earlier programs have set.
        text += fmt::format("#line {} \"model.l\"\n", line + 1);
        lines_.push_back(line);
        programs_.push_back(program);
        text += program;
        line_count_ += std::count(text.begin(), text.end(), '\n');
        text_ += text;
    }

    // Compares the programs in which gcc found no error, and returns the number of these programs.
    int compare_with_gcc() const
    {
        auto const folder
            = std::filesystem::path(testing::TempDir()) / fmt::format("tractus_cpp_{}", getpid());
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "model.l") << text_;
        auto const command
            = "cd '" + folder.string() + "' && LC_ALL=C gcc -E -P -w -x c model.l >out 2>messages";
        EXPECT_NE(std::system(command.c_str()), -1);
        auto const wrong = wrong_programs(file_bytes(folder / "messages"));
        auto const results = file_bytes(folder / "out");
        std::filesystem::remove_all(folder);
        int count = 0;
        for (std::size_t i = 0; i < programs_.size(); ++i)
            if (!wrong.contains(i)) {
                compare(i, results);
                ++count;
            }
        return count;
    }

private:
    std::set<std::size_t> wrong_programs(std::string const& messages) const
    {
        std::set<std::size_t> result;
        std::regex const error("model\\.l:([0-9]+):[0-9]+: error:");
        for (std::sregex_iterator found(messages.begin(), messages.end(), error), end; found != end;
             ++found) {
            auto const line = std::stol((*found)[1]);
            auto const next = std::lower_bound(lines_.begin(), lines_.end(), line);
            result.insert(static_cast<std::size_t>(next - lines_.begin()) - 1);
        }
        return result;
    }

    void compare(std::size_t index, std::string const& results) const
    {
        auto const mark = fmt::format("@@ {}\n", index);
        auto const begin = results.find(mark);
        ASSERT_NE(begin, std::string::npos) << mark;
        auto const from = begin + mark.size();
        auto const expected = results.substr(from, results.find("@@", from) - from);
        auto const before = fmt::format("#line {}\n", lines_[index] + 1);
        auto const ours = preprocess("model.l", before + programs_[index], {});
        ASSERT_TRUE(ours) << ours.error().message << '\n' << programs_[index];
        EXPECT_EQ(tokens(ours->text), tokens(expected)) << programs_[index];
    }

    std::string text_;
    std::ptrdiff_t line_count_ = 0; // Number of lines in the text so far.
    std::vector<std::string> programs_;
    std::vector<std::ptrdiff_t> lines_; // Number of lines in the text before each program.
};

std::mt19937& random_numbers()
{
    static std::mt19937 numbers(1);
    return numbers;
}

int number_below(int end)
{
    return static_cast<int>(random_numbers()() % static_cast<unsigned>(end));
}

template<typename Item> Item one_of(std::vector<Item> const& items)
{
    return items[static_cast<std::size_t>(number_below(static_cast<int>(items.size())))];
}
std::string one_of(std::initializer_list<std::string> texts)
{
    return one_of(std::vector(texts));
}

// Macros with parameters: one, two, and any number of them. The macros A to D have none.
struct Signature {
    std::string name;
    std::vector<std::string> parameters;
};
std::vector<Signature> const kFunctions { { "f", { "x" } },
                                          { "g", { "x", "y" } },
                                          { "h", { "x", "..." } } };

class RandomTokens {
public:
    // Generates tokens for the body of a macro with the given parameters.
    explicit RandomTokens(std::vector<std::string> parameters, bool is_in_body = true)
        : parameters_(std::move(parameters))
        , is_in_body_(is_in_body)
    {
        for (auto& parameter : parameters_)
            if (parameter == "...")
                parameter = "__VA_ARGS__";
    }

    std::string text(int depth, bool has_commas)
    {
        std::string result;
        for (int count = number_below(depth == 0 ? 4 : 2); count >= 0; --count)
            result += token(depth, has_commas) + one_of({ "", " ", " ", "  " });
        return result;
    }

private:
    std::string name() const
    {
        if (!parameters_.empty() && number_below(2) == 0)
            return one_of(parameters_);
        return one_of({ "A", "B", "C", "D", "u", "v", "f", "g", "h" });
    }

    std::string token(int depth, bool has_commas)
    {
        auto const kind = number_below(depth > 1 ? 8 : parameters_.empty() ? 12 : 9);
        if (kind < 4)
            return ' ' + name() + ' ';
        if (kind == 4)
            return one_of({ "1", "23", ".5", " \"a,b\" " });
        if (kind == 5)
            return one_of({ "+", "-", "*", "[", "]", has_commas ? "," : ";" });
        if (kind == 6)
            return depth == 0 && !is_in_body_ ? " __LINE__ " : " __FILE__ ";
        if (kind == 7)
            return parameters_.empty() ? " u " : of_parameters();
        if (kind == 8)
            return '(' + text(depth + 1, has_commas) + ')';
        return call(depth);
    }

    std::string of_parameters() const
    {
        auto const parameter = one_of(parameters_);
        switch (number_below(4)) {
        case 0:
            return '#' + one_of({ "", " " }) + parameter;
        case 1:
            return parameter + one_of({ "##", " ## " }) + one_of({ "1", "u", parameters_.back() });
        case 2:
            return " u ## " + parameter;
        default:
            return parameters_.back() == "__VA_ARGS__" ? ", ## __VA_ARGS__" : parameter;
        }
    }

    std::string call(int depth)
    {
        auto const& function = one_of(kFunctions);
        auto result = ' ' + function.name + one_of({ "", " " }) + '(';
        for (std::size_t i = 0; i < function.parameters.size(); ++i)
            result += (i == 0 ? "" : ",")
                + (number_below(6) == 0 ? "" : text(depth + 1, function.parameters[i] == "..."));
        return result + ')';
    }

    std::vector<std::string> parameters_;
    bool is_in_body_;
};

std::string random_program()
{
    std::string program;
    for (auto const* name : { "A", "B", "C", "D" })
        if (number_below(4) != 0)
            program += fmt::format("#define {} {}\n", name, RandomTokens({}).text(0, true));
    for (auto const& [name, parameters] : kFunctions)
        if (number_below(5) != 0)
            program += fmt::format("#define {}({}) {}\n", name, fmt::join(parameters, ", "),
                                   RandomTokens(parameters).text(0, true));
    for (int lines = 1 + number_below(4); lines > 0; --lines) {
        if (number_below(5) == 0)
            program += "#undef " + one_of({ "A", "B", "f", "u" }) + '\n';
        auto line = RandomTokens({}, false).text(0, true);
        for (auto& c : line) // Breaks the line, also within the call of a macro.
            if (c == ' ' && number_below(12) == 0)
                c = '\n';
        program += line + ";\n";
    }
    return program;
}

TEST(CPreprocessor, ReplacesMacrosAsGcc)
{
    if (!has_gcc())
        GTEST_SKIP() << "there is no gcc";
    Programs programs;
    for (int i = 0; i < kProgramCount; ++i)
        programs.add(random_program());
    EXPECT_GT(programs.compare_with_gcc(), kProgramCount / 4);
}

std::string random_condition(int depth)
{
    auto const kind = number_below(depth > 4 ? 3 : 9);
    if (kind < 2)
        return one_of({ "0", "1", "2", "3u", "7", "010", "0x1F", "9223372036854775807",
                        "18446744073709551615u", "64", "A", "B", "nothing", "f(2)" });
    if (kind == 2)
        return one_of({ "defined A", "defined(nothing)", "defined ( f )", "defined(A)" });
    if (kind == 3)
        return '(' + random_condition(depth + 1) + ')';
    if (kind == 4)
        return one_of({ "-", "+", "!", "~" }) + ' ' + random_condition(depth + 1);
    if (kind == 5)
        return random_condition(depth + 1) + '?' + random_condition(depth + 1) + ':'
            + random_condition(depth + 1);
    return random_condition(depth + 1)
        + one_of({ "+", " - ", "*", "/", "%", "<<", ">>", "<", ">", "<=", ">=", "==", "!=", "&",
                   "|", "^", "&&", "||" })
        + ' ' + random_condition(depth + 1);
}

TEST(CPreprocessor, ComputesConditionsAsGcc)
{
    if (!has_gcc())
        GTEST_SKIP() << "there is no gcc";
    Programs programs;
    for (int i = 0; i < 2 * kProgramCount; ++i)
        programs.add(fmt::format("#define A 5\n#define B (A - 7)\n#define f(x) (x * A)\n"
                                 "#if {}\nif\n#elif {}\nelif\n#else\nelse\n#endif\n",
                                 random_condition(0), random_condition(2)));
    EXPECT_GT(programs.compare_with_gcc(), kProgramCount);
}

// Generates nested conditional parts of a program, with definitions in all of their branches.
class RandomParts {
public:
    std::string lines(int depth)
    {
        std::string result;
        for (int count = number_below(4); count >= 0; --count)
            result += number_below(3) == 0 && depth < 4 ? conditional(depth) : line();
        return result;
    }

private:
    static std::string name() { return one_of({ "A", "B", "C", "f" }); }

    static std::string hash()
    {
        return one_of({ "#", "#", "  #", "# ", "#\t", "/* a */ #", "# /* a */ " });
    }

    // Returns a random text that may follow a directive, up to the end of its line.
    static std::string end_of_line()
    {
        return one_of({ "\n", "\n", "\n", " // a\n", " /* a */\n", " /* a\n#else\n*/\n" });
    }

    static std::string condition()
    {
        auto const text = number_below(3) == 0
            ? one_of({ "A", "B > 2", "__LINE__ % 2", "f(1) == 4", "defined A", "!defined(f)" })
            : random_condition(3);
        return number_below(6) == 0 ? "\\\n" + text + " \\\n" : text;
    }

    static std::string line()
    {
        switch (number_below(5)) {
        case 0:
            return hash() + "define " + one_of({ "A", "B", "C", "f(x)" })
                + one_of({ "", " 1", " A", " (B + 1)", " 4 \\\n - 2", " /* a\nb */ 3" })
                + end_of_line();
        case 1:
            return hash() + "undef " + name() + end_of_line();
        default:
            return one_of({ "A", "B C", "f(A)", "u f", "[f (B)]", "a /* b\n c */ d", "e // A",
                            "/*\n#endif\n*/", "\"/* A */\" B", "" })
                + " __LINE__\n";
        }
    }

    std::string conditional(int depth)
    {
        auto const first = one_of({ "if", "if", "ifdef", "ifndef" });
        auto result = hash() + first + ' ' + (first == "if" ? condition() : name()) + end_of_line();
        result += lines(depth + 1);
        for (int count = number_below(3); count > 0; --count)
            result += hash() + "elif " + condition() + end_of_line() + lines(depth + 1);
        if (number_below(2) == 0)
            result += hash() + "else" + end_of_line() + lines(depth + 1);
        return result + hash() + "endif" + end_of_line();
    }
};

TEST(CPreprocessor, ChoosesPartsAsGcc)
{
    if (!has_gcc())
        GTEST_SKIP() << "there is no gcc";
    Programs programs;
    for (int i = 0; i < kProgramCount; ++i)
        programs.add(RandomParts().lines(0));
    EXPECT_GT(programs.compare_with_gcc(), kProgramCount / 3);
}

TEST(CPreprocessor, ReadsWhatIsRareAsGcc)
{
    if (!has_gcc())
        GTEST_SKIP() << "there is no gcc";
    std::vector<std::string> const texts {
        "#line 40\n__LINE__\n__LINE__\n",
        "#line 40 \"other.l\"\n__LINE__ __FILE__\n#if __LINE__ == 41\nB\n#endif\n__LINE__\n",
        "#line 7 /* a\nb */\n__LINE__ \n",
        "# 50 \"other.l\"\n__LINE__ __FILE__\n#line 3\n__LINE__ __FILE__\n",
        "#if 0\n#line 9\n#endif\n__LINE__ __FILE__\n",
        "#define A 12\n#define B \"other.l\"\n#line A B\n\n__LINE__ __FILE__\n",
        "#define f(args...) F(args)\nf(1,2) f() f(3)\n",
        "#define f(x, args ...) F(x, ## args) #args\nf(1) f(1,2, 3) f(1,)\n",
        "\"a // b\" c // d\n",
        "\"a \\\" /* b */ \\\\\" d /* e */ \"\"/* f */\n",
        "#define A \"/*\" /* a */ \"*/\"\nA B\n",
        "#define B\n#if 0\n#elifdef A\na\n#elifndef B\nb\n#elifdef B\nc\n#else\nd\n#endif\n",
        "#define B 3\n#if 'B' == 66\nA\n#endif\n#if '\\n' == 10 && '\\0' == 0 && '\\x41' == 65\nB\n"
        "#endif\n#if '\\377' == -1 && '\\'' == 39 && '\\\\' == 92 && '\"' == 34\nC\n#endif\n",
        "#if 'ab' == 24930 && '\\377a' == 65377 && 'abcd' == 1633837924\nA\n#else\nB\n#endif\n",
        "#define A\n#if 1\na\n#elifdef A\nb\n#elifndef\n#endif\n",
    };
    Programs programs;
    for (auto const& text : texts)
        programs.add(text);
    EXPECT_EQ(programs.compare_with_gcc(), static_cast<int>(texts.size()));
}

} // namespace
} // namespace tractus::lsystem
