#include "engine/methods/leaves/grammar_reader.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace tractus::leaf {

namespace {

// Parses a directive, a line of a grammar that is not a rule, such as "#define A(4,1)" or "#axiom :
// A".
class Directive {
public:
    explicit Directive(GrammarReader& reader)
        : reader_(reader)
        , text_(reader.text)
        , grammar_(reader.grammar)
    {
    }

    Result<void> read()
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("define, axiom, base or another directive"));
        if (word == "define")
            return define();
        if (word == "axiom" || word == "axiome")
            return axiom();
        if (word == "base") {
            grammar_.has_base = true;
            return {};
        }
        if (word == "bare")
            return faces(grammar_.bare);
        if (word == "reach")
            return faces(grammar_.reaching);
        if (word == "outline" || word == "left")
            return outline(word == "left" ? grammar_.left : grammar_.outline.points);
        if (word == "young" || word == "old")
            return color(word == "young" ? grammar_.young : grammar_.old);
        if (word == "steps" || word == "size")
            return adult(word);
        if (word == "margin")
            return margin();
        return text_.fail_at(
            place,
            fmt::format("#{} is none of define, axiom, base, bare, margin, outline, "
                        "left, reach, steps, size, young, old",
                        word));
    }

private:
    Result<void> define()
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("a name"));
        if (text_.next_is("("))
            return define_face(word, place);
        text_.stay_in_line(true);
        TRY(text_.expect("="));
        auto const value_place = text_.place();
        auto const value = TRY(read_expression(text_, grammar_.names));
        if (!text_.is_over())
            return text_.fail_expected("the line's end");
        text_.stay_in_line(false);
        auto const number = grammar_.names.number_of(word);
        grammar_.variables[number] = TRY(reader_.constant(value, value_place));
        return {};
    }

    Result<void> define_face(std::string_view word, TextPlace const& place)
    {
        if (!is_face(word))
            return text_.fail_at(
                place, fmt::format("\"{}\" is no face: a face has one capital letter", word));
        TRY(text_.expect("("));
        Attributes attributes {};
        for (std::size_t i = 0; i < kAttributes; ++i) {
            if (i > 0)
                TRY(text_.expect(","));
            auto const value_place = text_.place();
            auto const value = TRY(read_expression(text_, grammar_.names));
            attributes[i] = TRY(reader_.constant(value, value_place));
        }
        TRY(text_.expect(")"));
        if (attributes[kEdgeCount] < 3 || attributes[kEdgeCount] > kMaxSides)
            return text_.fail_at(place,
                                 fmt::format("a face has 3 to {} edges, and {} has {}", kMaxSides,
                                             word, attributes[kEdgeCount]));
        attributes[kEdgeCount] = std::trunc(attributes[kEdgeCount]);
        grammar_.faces[word[0]] = attributes;
        return {};
    }

    Result<void> axiom()
    {
        TRY(text_.expect(":"));
        grammar_.axiom = TRY(reader_.known_face());
        grammar_.axiom_fields = TRY(reader_.fields());
        reader_.has_axiom = true;
        return {};
    }

    Result<void> faces(std::set<char>& to)
    {
        TRY(text_.expect(":"));
        do
            to.insert(TRY(reader_.known_face()));
        while (text_.take(","));
        return {};
    }

    // Parses the directive #margin, the shape of the margin; it has no effect without an outline.
    Result<void> margin()
    {
        TRY(text_.expect(":"));
        auto const place = text_.place();
        auto const kind = TRY(text_.word("teeth, scallops or sinus"));
        if (kind != "teeth" && kind != "scallops" && kind != "sinus")
            return text_.fail_at(place,
                                 fmt::format("\"{}\" is none of teeth, scallops, sinus", kind));
        auto const values
            = TRY(reader_.numbers(2, 3, "a margin has a number, a depth and, if wanted, a lean"));
        auto& outline = grammar_.outline;
        outline.margin
            = kind == "teeth" ? HalfOutline::Margin::Teeth : HalfOutline::Margin::Scallops;
        constexpr double kMaxTeeth = 500;
        outline.count = static_cast<int>(std::clamp(values[0], 0.0, kMaxTeeth));
        outline.depth = kind == "sinus" ? -values[1] : values[1];
        outline.lean = values.size() > 2 ? values[2] : 0;
        return {};
    }

    // Parses the points of a half outline, from the end of the stalk at (0,0) to the tip, such as
    // "(0.1,0.2) (0.3,0.5,1)". A third number of 1 makes the point a corner.
    Result<void> outline(std::vector<HalfOutline::Point>& points)
    {
        constexpr std::size_t kMaxPoints = 500;
        auto const place = text_.place();
        TRY(text_.expect(":"));
        points = { { .is_corner = true } };
        while (text_.next_is("(")) {
            auto const values
                = TRY(reader_.numbers(2, 3, "a point is (x,y), or (x,y,1) at a corner"));
            points.push_back({ .at = { values[0], values[1] },
                               .is_corner = values.size() > 2 && values[2] != 0 });
            if (points.size() > kMaxPoints)
                return text_.fail_here(
                    fmt::format("an outline has no more than {} points", kMaxPoints));
        }
        if (points.size() < 3 || points.back().at.x() != 0 || points.back().at.y() <= 0)
            return text_.fail_at(place,
                                 "an outline has two points and more; the last is the tip, whose x "
                                 "is 0 and whose y is above 0");
        if (&points == &grammar_.left)
            reader_.left_place = place;
        return {};
    }

    Result<void> color(Vec3& to)
    {
        auto const place = text_.place();
        auto const values
            = TRY(reader_.numbers(3, 3, "a colour is (red,green,blue), each 0 to 255"));
        for (Eigen::Index i = 0; i < 3; ++i) {
            double const value = values[static_cast<std::size_t>(i)];
            if (value < 0 || value > 255)
                return text_.fail_at(place, "a colour is (red,green,blue), each 0 to 255");
            to[i] = value / 255;
        }
        return {};
    }

    // Parses a directive about the adult leaf, such as "#steps(9)" or "#size(80)".
    Result<void> adult(std::string_view what)
    {
        constexpr double kMax = 1000;
        auto const place = text_.place();
        auto const message = fmt::format("#{} has one number above 0 and up to {}", what, kMax);
        auto const values = TRY(reader_.numbers(1, 1, message));
        if (!(values[0] > 0 && values[0] <= kMax))
            return text_.fail_at(place, message);
        if (what == "steps")
            grammar_.steps = static_cast<int>(values[0]);
        else
            grammar_.size_mm = values[0];
        return {};
    }

    GrammarReader& reader_;
    GrammarText& text_;
    Grammar& grammar_;
};

} // namespace

Result<void> read_directive(GrammarReader& reader)
{
    return Directive(reader).read();
}

} // namespace tractus::leaf
