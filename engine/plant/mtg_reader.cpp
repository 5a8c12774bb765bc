#include "engine/plant/measured_plant.h"
#include "engine/plant/mtg.h"
#include "engine/plant/mtg_organ_reader.h"
#include "engine/plant/mtg_organs.h"
#include "engine/plant/table_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tractus {

namespace {

constexpr std::size_t kMaxScales = 64;
constexpr std::size_t kMaxGraphColumns = 100'000;
// Maximum number of entities in a file for which the abbreviations << and ++ stand.
constexpr long kMaxRepeats = 1'000'000;

constexpr std::array<std::string_view, 5> kTopDiameters { "topdiameter", "topdia", "diameter",
                                                          "diam", "diasom" };
constexpr std::array<std::string_view, 4> kBaseDiameters { "bottomdiameter", "bottomdia", "botdia",
                                                           "diabase" };
constexpr std::array<std::string_view, 1> kRadii { "radius" };

// The current position in the graph, to which the next entity is attached.
struct GraphPlace {
    // For each scale, true if the position is in an entity of it.
    std::array<bool, kMaxScales> has_entity {};
    std::uint32_t node = kNone; // Node of the last entity that has a position.
    bool is_branch = false;     // True if a + has been read since the entity of `node`.
};

// The last entity in a column of the file, and the last branch that the same column has begun on
// that entity. The column keeps the branch until another one begins, or until an entity without +
// follows in the column.
struct GraphColumn {
    GraphPlace place;
    std::optional<GraphPlace> branch;

    GraphPlace const& last() const { return branch ? *branch : place; }
};

class MtgReader {
public:
    explicit MtgReader(std::string const& name)
        : name_(name)
    {
    }

    Result<void> read(std::string_view line);
    Result<MtgPlant> take();

private:
    struct Class {
        std::size_t scale = 0;
        // The class in MtgOrganReader; no value if it is not a class of organs.
        std::optional<MtgOrganReader::ClassId> organ {};
    };
    struct Entity {
        char relation = '/';
        Class kind {};
        bool is_last = false; // True for the last entity of a line, which has the line's features.
    };
    enum class Section { None, Classes, Other, Header, Graph };

    bool begins_section(std::string_view line);
    Result<void> read_class(std::string_view line);
    Result<void> read_header(std::string_view line);
    Result<void> read_entities(std::string_view line);
    Result<std::vector<Entity>> entities_in(std::string_view code);
    Result<Class> take_label(std::string_view& code, std::optional<long>& index);
    Result<void> go_on(std::size_t column, std::span<Entity const> entities,
                       std::vector<std::string_view> const& cells);
    Result<void> walk(GraphPlace& place, std::span<Entity const> entities,
                      std::vector<std::string_view> const& cells);
    Result<void> add_node(GraphPlace& place, std::vector<std::string_view> const& cells);
    void find_organ_columns(std::vector<std::string_view> const& names);
    void add_organ(GraphPlace const& place, Entity const& entity,
                   std::vector<std::string_view> const& cells);
    Result<std::optional<double>> feature(std::optional<std::size_t> column,
                                          std::vector<std::string_view> const& cells) const;
    std::optional<std::size_t> column_of(std::span<std::string_view const> names,
                                         std::vector<std::string_view> const& cells) const;

    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}:{}: {}", name_, line_, what));
    }

    std::string const& name_;
    std::size_t line_ = 0;
    Section section_ = Section::None;
    bool is_in_millimetres_ = false;
    std::map<std::string, Class, std::less<>> classes_;
    std::size_t entity_columns_ = 0;
    std::array<std::optional<std::size_t>, 3> position_;
    std::optional<std::size_t> top_diameter_, base_diameter_, radius_;
    std::vector<GraphColumn> columns_;
    long repeats_ = 0;
    std::vector<MeasuredNode> nodes_;
    MtgOrganReader organs_;
};

Result<void> MtgReader::read(std::string_view line)
{
    ++line_;
    auto const comment = line.find('#');
    if (comment != std::string_view::npos) {
        is_in_millimetres_ |= line.substr(comment).find("in millimetres") != std::string_view::npos;
        line = line.substr(0, comment);
    }
    if (without_blanks(line).empty() || begins_section(line))
        return {};
    switch (section_) {
    case Section::Classes:
        return read_class(line);
    case Section::Header:
        return read_header(line);
    case Section::Graph:
        return read_entities(line);
    case Section::None:
        return error("this is no MTG: expected CODE: before anything else");
    case Section::Other:
        break;
    }
    return {};
}

// True if the line is CODE, CLASSES, DESCRIPTION, FEATURES or MTG, followed by a colon.
bool MtgReader::begins_section(std::string_view line)
{
    if (section_ == Section::Header || section_ == Section::Graph)
        return false;
    auto const word = without_blanks(line.substr(0, line.find(':')));
    if (line.find(':') == std::string_view::npos)
        return false;
    if (word == "MTG")
        section_ = Section::Header;
    else if (word == "CLASSES")
        section_ = Section::Classes;
    else if (word == "CODE" || word == "DESCRIPTION" || word == "FEATURES")
        section_ = Section::Other;
    else
        return false;
    return true;
}

Result<void> MtgReader::read_class(std::string_view line)
{
    auto const words = words_of(line);
    if (words.front() == "SYMBOL")
        return {};
    auto const scale = words.size() > 1 ? number_in(words[1]) : std::nullopt;
    if (!scale || !(*scale >= 0) || *scale >= static_cast<double>(kMaxScales))
        return error(
            fmt::format("class {} has no scale from 0 to {}", words.front(), kMaxScales - 1));
    auto& read = classes_[std::string(words.front())];
    read = { .scale = static_cast<std::size_t>(*scale) };
    read.organ = organs_.class_of_name(words.front());
    return {};
}

std::optional<std::size_t> MtgReader::column_of(std::span<std::string_view const> names,
                                                std::vector<std::string_view> const& cells) const
{
    for (auto const name : names)
        for (auto i = entity_columns_; i < cells.size(); ++i)
            if (lower_letters(cells[i]) == name)
                return i;
    return std::nullopt;
}

// Reads the header: "ENTITY-CODE", a tab for each column of entities, then the names of the
// features.
Result<void> MtgReader::read_header(std::string_view line)
{
    auto const cells = columns_of(line, '\t');
    for (entity_columns_ = 1; entity_columns_ < cells.size() && cells[entity_columns_].empty();)
        ++entity_columns_;
    constexpr std::array<std::array<std::string_view, 2>, 3> kNames {
        { { "xx", "x" }, { "yy", "y" }, { "zz", "z" } }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        position_[i] = column_of(kNames[i], cells);
        if (!position_[i])
            return error(fmt::format("there is no column {0}{0}: a plant needs positions, XX, YY "
                                     "and ZZ",
                                     "XYZ"[i]));
    }
    top_diameter_ = column_of(kTopDiameters, cells);
    base_diameter_ = column_of(kBaseDiameters, cells);
    radius_ = column_of(kRadii, cells);
    find_organ_columns(cells);
    section_ = Section::Graph;
    return {};
}

// Finds the organ columns. In files that have them, such as those of write_mtg(), the classes L, F
// and O are organs; in others they may be internodes.
void MtgReader::find_organ_columns(std::vector<std::string_view> const& names)
{
    if (!organs_.find_columns(names, entity_columns_))
        return;
    for (auto const kind : { MtgOrganClass::Leaf, MtgOrganClass::Flower, MtgOrganClass::Other }) {
        std::string const symbol(1, mtg_symbol(kind));
        if (auto const found = classes_.find(symbol); found != classes_.end())
            found->second.organ = organs_.add_class(symbol, kind);
    }
}

Result<void> MtgReader::read_entities(std::string_view line)
{
    auto const cells = columns_of(line, '\t');
    std::size_t column = 0;
    while (column < cells.size() && cells[column].empty())
        ++column;
    if (column >= std::min(entity_columns_, cells.size()) || column > kMaxGraphColumns)
        return error("there is no entity in the columns for them");
    if (column > columns_.size())
        return error(fmt::format("the entity is in column {}, expected one of the first {}",
                                 column + 1, columns_.size() + 1));
    auto code = cells[column];
    bool const goes_on = code.front() == '^';
    if (goes_on)
        code.remove_prefix(1);
    auto const entities = TRY(entities_in(code));
    if (goes_on) {
        if (column >= columns_.size())
            return error("^ stands for the entity above it, and there is none");
        columns_.resize(column + 1);
        return go_on(column, entities, cells);
    }
    GraphColumn next;
    bool const is_new = column == 0 && entities.front().relation == '/';
    if (!is_new && columns_.empty())
        return error("the first entity begins with /");
    if (!is_new)
        next.place = columns_[column == 0 ? 0 : column - 1].last();
    columns_.resize(column);
    TRY(walk(next.place, entities, cells));
    columns_.push_back(std::move(next));
    return {};
}

// Adds the entities of a line that begins with ^, which stands for the last entity of the column.
// After ^+ they are a branch on that entity, and a further ^+ begins another branch on the same
// entity.
Result<void> MtgReader::go_on(std::size_t column, std::span<Entity const> entities,
                              std::vector<std::string_view> const& cells)
{
    auto& [place, branch] = columns_[column];
    auto const& first = entities.front();
    if (first.relation == '+') {
        auto on_branch = place;
        TRY(walk(on_branch, entities, cells));
        branch = on_branch;
        return {};
    }
    bool const is_of_branch
        = branch && (first.relation == '/' || !place.has_entity[first.kind.scale]);
    if (is_of_branch)
        place = *branch;
    branch.reset();
    return walk(place, entities, cells);
}

Result<MtgReader::Class> MtgReader::take_label(std::string_view& code, std::optional<long>& index)
{
    auto const end = std::min(code.find_first_of("/<+^"), code.size());
    auto const label = code.substr(0, end);
    code.remove_prefix(end);
    auto name = label.substr(0, label.find_last_not_of("0123456789") + 1);
    auto const digits = label.substr(name.size());
    long value = 0;
    if (!digits.empty()
        && std::from_chars(digits.data(), digits.data() + digits.size(), value).ec == std::errc {})
        index = value;
    auto const found = classes_.find(name);
    if (found == classes_.end())
        return error(fmt::format("entity {}: CLASSES has no class {}", label, name));
    return found->second;
}

// Returns the entities of a code, expanding abbreviations: "/A1/U2<U3<<U9" is A1, U2, U3, and U4 to
// U9.
Result<std::vector<MtgReader::Entity>> MtgReader::entities_in(std::string_view code)
{
    std::vector<Entity> result;
    std::optional<long> before;
    while (!code.empty()) {
        char const relation = code.front();
        if (relation != '/' && relation != '<' && relation != '+')
            return error(fmt::format("found {}, expected /, < or + and an entity", code));
        code.remove_prefix(1);
        bool const is_range = !code.empty() && code.front() == relation && relation != '/';
        if (is_range)
            code.remove_prefix(1);
        std::optional<long> index;
        auto const kind = TRY(take_label(code, index));
        long const count = is_range && index && before ? *index - *before : 1;
        if (count < 1 || (repeats_ += count) > kMaxRepeats)
            return error("<< and ++ stand for entities with the numbers between, rising");
        result.insert(result.end(), static_cast<std::size_t>(count), { relation, kind, false });
        before = index;
    }
    if (result.empty())
        return error("^ is followed by /, < or + and an entity");
    result.back().is_last = true;
    return result;
}

Result<void> MtgReader::walk(GraphPlace& place, std::span<Entity const> entities,
                             std::vector<std::string_view> const& cells)
{
    for (auto const& entity : entities) {
        auto const scale = entity.kind.scale;
        if (entity.relation != '/' && !place.has_entity[scale])
            return error(fmt::format("found {}, but there is no entity of this scale for it to "
                                     "stand on",
                                     entity.relation));
        place.has_entity[scale] = true;
        std::fill(place.has_entity.begin() + static_cast<std::ptrdiff_t>(scale) + 1,
                  place.has_entity.end(), false);
        place.is_branch |= entity.relation == '+';
        if (entity.kind.organ)
            add_organ(place, entity, cells);
        else if (entity.is_last)
            TRY(add_node(place, cells));
    }
    return {};
}

// Never fails: an organ with too little data is only counted as left out.
void MtgReader::add_organ(GraphPlace const& place, Entity const& entity,
                          std::vector<std::string_view> const& cells)
{
    if (!entity.is_last)
        return organs_.leave_out(*entity.kind.organ);
    std::array<std::optional<double>, 3> position;
    for (std::size_t i = 0; i < 3; ++i)
        if (*position_[i] < cells.size())
            position[i] = number_in(cells[*position_[i]]);
    organs_.add(*entity.kind.organ, place.node, position, cells);
}

Result<std::optional<double>> MtgReader::feature(std::optional<std::size_t> column,
                                                 std::vector<std::string_view> const& cells) const
{
    if (!column || *column >= cells.size() || cells[*column].empty())
        return std::nullopt;
    auto const value = number_in(cells[*column]);
    if (!value)
        return error(
            fmt::format("found {} in column {}, expected a number", cells[*column], *column + 1));
    return value;
}

Result<void> MtgReader::add_node(GraphPlace& place, std::vector<std::string_view> const& cells)
{
    MeasuredNode node;
    for (std::size_t i = 0; i < 3; ++i) {
        auto const coordinate = TRY(feature(position_[i], cells));
        if (!coordinate && i == 0)
            return {};
        if (!coordinate)
            return error("the position is not complete: XX, YY and ZZ go together");
        node.position_mm[static_cast<int>(i)] = *coordinate;
    }
    if (auto const diameter = TRY(feature(top_diameter_, cells)))
        node.radius_mm = *diameter / 2;
    else if (auto const radius = TRY(feature(radius_, cells)))
        node.radius_mm = *radius;
    if (auto const diameter = TRY(feature(base_diameter_, cells)))
        node.base_radius_mm = *diameter / 2;
    node.below = place.node;
    node.continues = !place.is_branch;
    place.node = static_cast<std::uint32_t>(nodes_.size());
    place.is_branch = false;
    nodes_.push_back(node);
    return {};
}

Result<MtgPlant> MtgReader::take()
{
    if (section_ != Section::Graph)
        return fail(Fault::User, fmt::format("{}: there is no section MTG: in it", name_));
    Bounds box;
    for (auto const& node : nodes_)
        box.add(node.position_mm);
    double const scale = is_in_millimetres_ ? 1 : millimetres_per_unit(box);
    for (auto& node : nodes_) {
        node.position_mm *= scale;
        for (auto* const radius_mm : { &node.radius_mm, &node.base_radius_mm })
            if (*radius_mm)
                **radius_mm *= scale;
    }
    auto measured = TRY(measured_plant_from_nodes(name_, nodes_));
    organs_.place(measured, scale);
    MtgPlant result { .plant = std::move(measured.plant) };
    if (auto warning = organs_.describe_omitted(name_); !warning.empty())
        result.warnings.push_back(std::move(warning));
    return result;
}

} // namespace

Result<MtgPlant> parse_mtg_with_warnings(std::string const& name, std::string_view text)
{
    MtgReader reader(name);
    while (!text.empty())
        TRY(reader.read(take_text_line(text)));
    return reader.take();
}

Result<Plant> parse_mtg(std::string const& name, std::string_view text)
{
    return TRY(parse_mtg_with_warnings(name, text)).plant;
}

} // namespace tractus
