#include "engine/methods/leaves/grammar_reader.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

namespace {

Result<void> check_left_half(GrammarReader const& reader)
{
    auto const& right = reader.grammar.outline.points;
    auto const& left = reader.grammar.left;
    if (left.empty() || (!right.empty() && left.back().at == right.back().at))
        return {};
    return reader.text.fail_at(reader.left_place, "#left ends at the tip at which #outline ends");
}

Result<void> check_edge(GrammarReader const& reader, GrammarReader::EdgeUse const& use)
{
    auto const count = static_cast<int>(reader.grammar.faces.at(use.face)[kEdgeCount]);
    if (!has_edge(count, use.edge))
        return reader.text.fail_at(
            use.place, fmt::format("a face {} has {} edges and no {}", use.face, count, use.word));
    bool const is_side = use.edge != EdgeLabel::Origin && use.edge != EdgeLabel::Extremity;
    if (use.splits && (count < 4 || (count % 2 == 1 && is_side)))
        return reader.text.fail_at(use.place,
                                   fmt::format("a face {} of {} edges cannot be split along {}",
                                               use.face, count, use.word));
    return {};
}

void add_fields(std::vector<Child> const& children, std::vector<Expression const*>& to)
{
    for (auto const& child : children) {
        for (auto const& field : child.fields)
            to.push_back(&field);
        add_fields(child.children, to);
    }
}

// Fails with a user error if a rule reads a name that has no value there. Built-in names,
// variables, attributes of the rule's face and names that the rule assigns have values.
Result<void> check_names(GrammarReader const& reader, Rule const& rule)
{
    std::vector<bool> has_value(reader.grammar.names.count());
    for (auto const name : { NameTable::kStep, NameTable::kFinalStep, NameTable::kAge,
                             NameTable::kBlade, NameTable::kVariation })
        has_value[name] = true;
    for (auto const& [name, value] : reader.grammar.variables)
        has_value[name] = true;
    for (auto const& name : rule.formal)
        if (name)
            has_value[*name] = true;
    std::vector<Expression const*> read { &rule.condition };
    for (auto const* block : { &rule.always, &rule.if_met })
        for (auto const& statement : *block) {
            has_value[statement.name] = true;
            read.push_back(&statement.value);
        }
    if (auto const* const growing = std::get_if<Growing>(&rule.kind)) {
        for (auto const& field : growing->fields)
            read.push_back(&field);
        add_fields(growing->children, read);
    }
    for (auto const* const expression : read)
        for (auto const& operation : expression->operations)
            if (operation.kind == Operation::Kind::Name && !has_value[operation.target])
                return reader.text.fail_at(
                    rule.place,
                    fmt::format("rule {} reads {}, to which nothing gives a "
                                "value",
                                rule.name, reader.grammar.names.name(operation.target)));
    return {};
}

} // namespace

Result<Grammar> parse_grammar(std::string_view text, std::string const& name)
{
    GrammarReader reader(text, name);
    while (!reader.text.is_over()) {
        if (reader.text.take("#"))
            TRY(read_directive(reader));
        else
            TRY(read_rule(reader));
    }
    if (!reader.has_axiom)
        return reader.text.fail_here("there is no axiom: \"#axiom : A\" names the first face");
    TRY(check_left_half(reader));
    for (auto const& [face, place] : reader.named_faces)
        if (!reader.grammar.faces.contains(face))
            return reader.text.fail_at(place,
                                       fmt::format("no face {} is defined: \"#define "
                                                   "{}(4,1,0,0,0,1,1)\" makes it a quad",
                                                   face, face));
    for (auto const& use : reader.named_edges)
        TRY(check_edge(reader, use));
    for (auto const& rule : reader.grammar.rules)
        TRY(check_names(reader, rule));
    return std::move(reader.grammar);
}

} // namespace tractus::leaf
