#include "engine/methods/leaves/leaf.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

namespace {

constexpr double kMaxEdges = 9'999; // Largest number of edges of a face.
constexpr std::size_t kMaxDarts = 2'000'000;
// Maximum number of darts visited for one leaf, which takes a few seconds.
constexpr std::size_t kMaxWork = 500'000'000;

Vec3 unit_or_x(Vec3 const& v)
{
    double const length = v.norm();
    return length > 1e-12 ? Vec3(v / length) : Vec3(Vec3::UnitX());
}

// Rotates two perpendicular unit vectors in their plane, the first towards the second.
void turn_pair(Vec3& first, Vec3& second, double angle_deg)
{
    double const c = std::cos(radians(angle_deg));
    double const s = std::sin(radians(angle_deg));
    Vec3 const turned = c * first + s * second;
    second = c * second - s * first;
    first = turned;
}

} // namespace

// Rotates the frame by gamma about its z axis, then by beta about the new y axis, then by alpha
// about the new x axis.
void Leaf::Frame::turn(double alpha_deg, double beta_deg, double gamma_deg)
{
    turn_pair(x, y, gamma_deg);
    turn_pair(z, x, beta_deg);
    turn_pair(y, z, alpha_deg);
}

Result<Leaf> Leaf::begin(Grammar const& grammar, Options const& options)
{
    Leaf leaf(grammar, options);
    TRY(leaf.make_face(grammar.axiom, grammar.axiom_fields, std::nullopt, {}));
    return leaf;
}

namespace {

constexpr std::uint32_t kOutlineStream = 1;
constexpr std::uint32_t kPoseStream = 4;

Outline make_outline(Grammar const& grammar, Leaf::Options const& options)
{
    Random random({ .seed = options.seed, .stream = kOutlineStream });
    Outline::Variation const usual;
    return { grammar.outline,
             grammar.left_outline(),
             { .width = options.variation * usual.width, .point = options.variation * usual.point },
             random };
}

} // namespace

Leaf::Leaf(Grammar const& grammar, Options const& options)
    : grammar_(&grammar)
    , values_(grammar.names.count(), std::nan(""))
    , random_({ .seed = options.seed })
    , outline_(make_outline(grammar, options))
    , pose_(options.pose)
    , unevenness_({ .seed = options.seed, .stream = kPoseStream })
{
    values_[NameTable::kBlade] = 1;
    for (auto const& [name, value] : grammar.variables)
        values_[name] = value;
    values_[NameTable::kStep] = 0;
    values_[NameTable::kFinalStep] = options.final_step;
    values_[NameTable::kAge] = options.age;
    values_[NameTable::kVariation] = options.variation;
}

tl::unexpected<Error> Leaf::fail_at(TextPlace const& place, std::string const& what) const
{
    return fail(Fault::User,
                fmt::format("{}:{}:{}: at step {} {}", grammar_->name, place.line, place.column,
                            step_, what));
}

// Adds `work` visited darts to the count. Fails with a user error if the derivation takes too long
// (kMaxWork).
Result<void> Leaf::spend(std::size_t work)
{
    work_ += work;
    if (work_ > kMaxWork)
        return fail(Fault::User,
                    fmt::format("{}: step {} takes too long: the leaf has {} faces", grammar_->name,
                                step_, faces_.size()));
    return {};
}

Result<Attributes> Leaf::attributes_of(char face, Fields const& fields, TextPlace const& place)
{
    auto attributes = grammar_->faces.at(face);
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (!fields[i].empty())
            attributes[i] = fields[i].value(values_, random_);
    if (!std::ranges::all_of(attributes, [](double value) { return std::isfinite(value); }))
        return fail_at(place,
                       fmt::format("an attribute of a face {} is not a finite number", face));
    attributes[kEdgeCount] = std::trunc(attributes[kEdgeCount]);
    if (attributes[kEdgeCount] < 3 || attributes[kEdgeCount] > kMaxEdges)
        return fail_at(place,
                       fmt::format("a face {} has {} edges, and may have 3 to {}", face,
                                   attributes[kEdgeCount], kMaxEdges));
    return attributes;
}

// Returns the attachment of a child face to an edge of its parent. The child's edge O runs opposite
// to the parent's edge, its x axis points away from the parent, and its z axis follows the
// parent's.
Leaf::Stand Leaf::stand_on(Dart edge, Shape shape) const
{
    auto const& parent = faces_[static_cast<std::size_t>(map_.face(edge))];
    Stand stand;
    stand.left = place_of(LeafMap::a0(edge), shape);
    stand.right = place_of(edge, shape);
    Vec3 const upper = shape == Shape::Flat ? Vec3(Vec3::UnitZ()) : parent.frame.z;
    Vec3 const across
        = stand.left == stand.right ? Vec3(Vec3::UnitY()) : unit_or_x(stand.left - stand.right);
    stand.frame.x = unit_or_x(across.cross(upper));
    stand.frame.z = unit_or_x(stand.frame.x.cross(across));
    stand.frame.y = stand.frame.z.cross(stand.frame.x);
    return stand;
}

Vec3 Leaf::place_of(Dart d, Shape shape) const
{
    if (shape == Shape::Grown)
        return map_.position_of(d);
    auto const& flat = map_.flat_of(d);
    return { flat.x(), flat.y(), 0 };
}

Leaf::Stand Leaf::attachment_for(Attributes const& attributes, std::optional<Dart> on,
                                 Shape shape) const
{
    auto const [count, along, alpha, beta, gamma, length, width] = attributes;
    bool const is_flat = shape == Shape::Flat;
    auto stand = on ? stand_on(*on, shape) : Stand {};
    stand.frame.turn(is_flat ? 0 : alpha, is_flat ? 0 : beta, gamma);
    if (!on) {
        stand.left = 0.5 * width * stand.frame.y;
        stand.right = -stand.left;
    }
    return stand;
}

// Returns the corners of a face, counter-clockwise from the start of edge O: the two ends of O,
// then the other corners of the right side and of the left side.
std::vector<Vec3> Leaf::corners_of(Attributes const& attributes, Stand const& stand) const
{
    auto const [count, along, alpha, beta, gamma, length, width] = attributes;
    auto const edges = static_cast<int>(count);
    int const rights = (edges - 1) / 2;
    int const lefts = edges - 2 - rights;
    Vec3 const middle = 0.5 * (stand.left + stand.right) + along * length * stand.frame.x;
    Vec3 const left = middle + 0.5 * width * stand.frame.y;
    Vec3 const right = middle - 0.5 * width * stand.frame.y;
    std::vector<Vec3> corners { stand.left, stand.right };
    if (lefts == 0) // The right side of a triangle ends at its tip.
        corners.push_back(left);
    for (int i = 1; i <= rights && lefts > 0; ++i)
        corners.push_back(stand.right + double(i) / rights * (right - stand.right));
    for (int i = 0; i < lefts; ++i)
        corners.push_back(left + double(i) / lefts * (stand.left - left));
    return corners;
}

// Makes a face on the free edge that starts at the dart `on` or, without a value, the axiom's face.
Result<FaceId> Leaf::make_face(char name, Fields const& fields, std::optional<Dart> on,
                               TextPlace const& place)
{
    if (faces_.size() >= kMaxFaces)
        return fail_at(place, fmt::format("the leaf would have more than {} faces", kMaxFaces));
    auto attributes = TRY(attributes_of(name, fields, place));
    if (grammar_->reaching.contains(name) && !outline_.empty()) {
        auto const start = attachment_for(attributes, on, Shape::Flat);
        attributes[kLength] *= TRY(reach(start, blade_on(on)));
    }
    auto grown = attributes;
    if (on && !outline_.empty() && !grammar_->bare.contains(name))
        pose(grown, on);
    auto const stand = attachment_for(grown, on, Shape::Grown);
    auto const corners = corners_of(grown, stand);
    auto const flat = corners_of(attributes, attachment_for(attributes, on, Shape::Flat));
    if (map_.dart_count() + 2 * corners.size() > kMaxDarts)
        return fail_at(place, "the leaf would have more than a million edges");
    TRY(spend(corners.size()));
    std::vector<Vertex> vertices;
    if (on)
        vertices = { map_.vertex(LeafMap::a0(*on)), map_.vertex(*on) };
    while (vertices.size() < corners.size())
        vertices.push_back(
            map_.add_vertex(corners[vertices.size()], flat[vertices.size()].head<2>()));
    auto const face = static_cast<FaceId>(faces_.size());
    auto const edge_count = static_cast<int>(attributes[kEdgeCount]);
    auto const first = map_.add_face(vertices, face, edge_labels(edge_count));
    if (on)
        map_.sew_in_place(first, LeafMap::a0(*on));
    faces_.push_back({ .name = name,
                       .attributes = attributes,
                       .frame = stand.frame,
                       .first = first,
                       .edge_count = edge_count,
                       .order = order_on(on),
                       .blade = blade_on(on) });
    if (!on || grammar_->bare.contains(name))
        begin_blade(face);
    return face;
}

Vec2 Leaf::Blade::to_outline(Vec2 const& flat) const
{
    Vec2 const at = (flat - base) / scale;
    return { at.x() * axis.y() - at.y() * axis.x(), at.dot(axis) };
}

Vec2 Leaf::Blade::to_flat(Vec2 const& on_outline) const
{
    return base + scale * (on_outline.x() * Vec2(axis.y(), -axis.x()) + on_outline.y() * axis);
}

// Begins a blade at the end of a stalk. The blade's scale is the current value of the grammar's
// variable `blade`.
void Leaf::begin_blade(FaceId stalk)
{
    auto& face = faces_[static_cast<std::size_t>(stalk)];
    auto const vein = vein_of(face);
    Blade blade { .base = vein ? vein->to : map_.flat_of(face.first) };
    if (vein && (vein->to - vein->from).norm() > 0)
        blade.axis = (vein->to - vein->from).normalized();
    if (auto const scale = values_[NameTable::kBlade]; scale > 0 && std::isfinite(scale))
        blade.scale = scale;
    face.blade = blades_.size();
    blades_.push_back(blade);
}

std::size_t Leaf::blade_on(std::optional<Dart> edge) const
{
    return edge ? faces_[static_cast<std::size_t>(map_.face(*edge))].blade : 0;
}

void Leaf::pose(Attributes& attributes, std::optional<Dart> on)
{
    double const length = blades_[blade_on(on)].scale * grammar_->outline.points.back().at.y();
    double const share = attributes[kTranslation] * attributes[kLength] / length;
    if (order_on(on) == 1) {
        attributes[kBend] += share * pose_.bend_deg;
        attributes[kTwist] += share * pose_.twist_deg;
    } else {
        attributes[kBend] -= share * pose_.curl_deg;
        attributes[kTwist] += pose_.uneven_deg * unevenness_.normal();
    }
}

// Returns the distance from the start of a face to the blade's outline, in the direction of the
// face.
Result<double> Leaf::reach(Stand const& start, std::size_t blade)
{
    if (blades_.empty())
        return 0;
    auto const& on = blades_[blade];
    Vec2 const flat = (0.5 * (start.left + start.right)).head<2>();
    Vec2 const from = on.to_outline(flat);
    Vec2 const way = on.to_outline(flat + on.scale * start.frame.x.head<2>()) - from;
    TRY(spend(outline_.line().size()));
    return on.scale * outline_.reach(from, way);
}

// Returns the order of a vein that begins on an edge. A vein that begins at the end of its parent
// or on a hub has the parent's order.
int Leaf::order_on(std::optional<Dart> edge) const
{
    if (!edge)
        return 1;
    constexpr int kMinHub = 5; // A face with at least this many edges is a hub.
    auto const& parent = faces_[static_cast<std::size_t>(map_.face(*edge))];
    bool const goes_on = map_.label(*edge) == EdgeLabel::Extremity || parent.edge_count >= kMinHub;
    return goes_on ? parent.order : parent.order + 1;
}

// Returns the vein along the middle of a face; no value for a face without an edge E.
std::optional<Leaf::Vein> Leaf::vein_of(Face const& face) const
{
    auto const half_width
        = [&](Dart d) { return 0.5 * (map_.flat_of(d) - map_.flat_of(LeafMap::a0(d))).norm(); };
    auto const middle
        = [&](Dart d) -> Vec2 { return 0.5 * (map_.flat_of(d) + map_.flat_of(LeafMap::a0(d))); };
    for (auto const d : map_.cycle(face.first))
        if (map_.label(d) == EdgeLabel::Extremity)
            return Vein { .from = middle(face.first),
                          .to = middle(d),
                          .half_width_from = half_width(face.first),
                          .half_width_to = half_width(d),
                          .order = face.order };
    return std::nullopt;
}

std::vector<Leaf::Vein> Leaf::veins() const
{
    std::vector<Vein> made;
    for (auto const& face : faces_)
        if (auto const vein = vein_of(face))
            made.push_back(*vein);
    return made;
}

// Finds the first free edge with a label, counter-clockwise from the face's first edge.
std::optional<Dart> Leaf::free_edge(FaceId face, EdgeLabel label) const
{
    auto const first = faces_[static_cast<std::size_t>(face)].first;
    auto x = first;
    do {
        if (map_.label(x) == label && map_.is_free(x))
            return x;
        x = map_.a1(LeafMap::a0(x));
    } while (x != first);
    return std::nullopt;
}

void Leaf::run(std::vector<Statement> const& block)
{
    for (auto const& statement : block) {
        auto const value = statement.value.value(values_, random_);
        auto const hidden = hidden_.find(statement.name);
        (hidden != hidden_.end() ? hidden->second : values_[statement.name]) = value;
    }
}

// Applies a rule to a face. Returns false if the rule does not match. While the rule is applied,
// its local names and its names for the face's attributes have values.
Result<bool> Leaf::apply(Rule const& rule, FaceId face)
{
    auto const& attributes = faces_[static_cast<std::size_t>(face)].attributes;
    for (std::size_t name = NameTable::kVariation + 1; name < values_.size(); ++name)
        if (!grammar_->variables.contains(name))
            values_[name] = std::nan("");
    for (std::size_t i = 0; i < rule.formal.size(); ++i)
        if (auto const name = rule.formal[i]) {
            if (grammar_->variables.contains(*name))
                hidden_.emplace(*name, values_[*name]);
            values_[*name] = attributes[i];
        }
    run(rule.always);
    bool fits = rule.condition.empty() || rule.condition.value(values_, random_) != 0;
    if (fits) {
        run(rule.if_met);
        if (auto const* const growing = std::get_if<Growing>(&rule.kind))
            TRY(grow(rule, *growing, face));
        else
            fits = TRY(split(std::get<Splitting>(rule.kind), face, rule.place));
    }
    for (auto const& [name, value] : hidden_)
        values_[name] = value;
    hidden_.clear();
    return fits;
}

Result<void> Leaf::grow(Rule const& rule, Growing const& growing, FaceId face)
{
    // Fields of the rule change the attributes that the parent face has for later rules.
    auto own = faces_[static_cast<std::size_t>(face)].attributes;
    for (std::size_t i = 0; i < growing.fields.size(); ++i)
        if (!growing.fields[i].empty())
            own[i] = growing.fields[i].value(values_, random_);
    if (!std::ranges::all_of(own, [](double value) { return std::isfinite(value); }))
        return fail_at(rule.place,
                       fmt::format("an attribute of a face {} is not a finite number", rule.face));
    faces_[static_cast<std::size_t>(face)].attributes = own;
    return grow_children(growing.children, face);
}

Result<void> Leaf::grow_children(std::vector<Child> const& children, FaceId parent)
{
    for (auto const& child : children) {
        auto const& face = faces_[static_cast<std::size_t>(parent)];
        if (!face.is_part && !has_edge(face.edge_count, child.edge))
            return fail_at(
                child.edge_place,
                fmt::format("a face {} of {} edges has no such edge", face.name, face.edge_count));
        auto const on = free_edge(parent, child.edge);
        if (!on)
            continue;
        auto const made = TRY(make_face(child.face, child.fields, on, child.place));
        TRY(grow_children(child.children, made));
    }
    return {};
}

Result<void> Leaf::derive()
{
    remove_limb();
    values_[NameTable::kStep] = ++step_;
    auto const standing = static_cast<FaceId>(faces_.size());
    for (FaceId face = 0; face < standing; ++face)
        for (auto const& rule : grammar_->rules) {
            if (rule.face != faces_[static_cast<std::size_t>(face)].name
                || std::holds_alternative<Gluing>(rule.kind))
                continue;
            auto const* const growing = std::get_if<Growing>(&rule.kind);
            auto const edges
                = static_cast<std::size_t>(faces_[static_cast<std::size_t>(face)].edge_count);
            TRY(spend(values_.size() + edges * (growing ? growing->children.size() : 1)));
            if (growing && std::ranges::none_of(growing->children, [&](Child const& child) {
                    return free_edge(face, child.edge).has_value();
                }))
                continue;
            if (TRY(apply(rule, face)))
                break;
        }
    return glue();
}

bool Leaf::is_bare(FaceId face) const
{
    auto const number = static_cast<std::size_t>(face);
    return number < faces_.size() && grammar_->bare.contains(faces_[number].name);
}

std::map<char, std::size_t> Leaf::face_counts() const
{
    std::map<char, std::size_t> counts;
    for (auto const& face : faces_)
        ++counts[face.name];
    return counts;
}

std::size_t Leaf::free_extremities() const
{
    auto const border = map_.border(border_start());
    return static_cast<std::size_t>(std::ranges::count_if(
        border, [&](Dart d) { return map_.label(d) == EdgeLabel::Extremity; }));
}

} // namespace tractus::leaf
