#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/limits.h"
#include "engine/lsystem/language/model.h"
#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::scene {

// How a plant is built from what was drawn or written. Not part of the document: the plant does not
// depend on it, only whether there is one.
struct LoadOptions {
    lsystem::ModelLimits limits {};
    std::function<void(std::string_view text)> print {}; // What a model prints; nowhere without.
};

// Gives what each plant may cost that is built from that moment on.
using MakeLoadOptions = std::function<LoadOptions()>;

struct BuiltSource {
    Plant plant {};
    std::vector<std::string> warnings {}; // Once each: what was asked for and is not done.
    AxisKeys axis_keys {};
};

// A model in cpfg's language, with the files that it includes, by their names.
struct SourceModel {
    lsystem::ModelSource source {};
    std::map<std::string, std::string> includes {};
};

// How far a plant of a collection is another one than what was drawn, and by which chance.
struct SourceVariation {
    std::uint64_t seed = 1;
    std::uint32_t plant = 0;  // Its number in the collection.
    std::uint32_t stream = 0; // Of plants whose numbers are the same: which.
    double spread = 1;        // 0: not at all; 1: as plants of a kind differ; at most 4.
};

// Rules that somebody has written in place of those that a model of a drawing has, and its view.
struct SourceRules {
    std::string text {};
    std::string view_text {};

    bool operator==(SourceRules const&) const = default;
};

// A way to make base plants from what was drawn or written: a row of functions on values of one
// type, which edits put into a document and nobody changes.
struct SourceKind {
    char const* word; // "lsystem".
    // Fails, in a sentence, for what gives no plant, or not within its limits.
    Result<BuiltSource> (*build)(void const* drawn, LoadOptions const& options);
    // Whether two give the same plant for certain.
    bool (*same)(void const* one, void const* other);
    // The model in cpfg's language whose plant it is, for other programs. Null where there is none.
    Result<SourceModel> (*model)(void const* drawn) = nullptr;
    // Another one of its type: what a hand has drawn is where it was drawn, or near it, and what
    // follows from that differs. Null where nothing does. The same variation, the same plant.
    std::shared_ptr<void const> (*vary)(void const* drawn, SourceVariation const& variation)
        = nullptr;
    // Another one of its type, whose model has these rules; no value: its own again. What is drawn
    // goes on to say the numbers in them. Null where nobody can write them.
    std::shared_ptr<void const> (*with_rules)(void const* drawn,
                                              std::optional<SourceRules> const& rules)
        = nullptr;
};

// The row for sources of type T, which can be compared.
template<typename T, Result<BuiltSource> (*build)(T const&, LoadOptions const&)>
constexpr SourceKind make_source_kind(char const* word)
{
    return { .word = word,
             .build =
                 [](void const* drawn, LoadOptions const& options) {
                     return build(*static_cast<T const*>(drawn), options);
                 },
             .same =
                 [](void const* one, void const* other) {
                     return *static_cast<T const*>(one) == *static_cast<T const*>(other);
                 } };
}

// What a base plant is made from. A value: copies share what was drawn.
class PlantSource {
public:
    PlantSource() = default; // Nothing yet: a plant without branches.

    template<typename T>
    PlantSource(SourceKind const& kind, T drawn)
        : kind_(&kind)
        , drawn_(std::make_shared<T const>(std::move(drawn)))
    {
    }

    bool empty() const { return kind_ == nullptr; }

    Result<BuiltSource> build(LoadOptions const& options) const
    {
        return empty() ? BuiltSource {} : kind_->build(drawn_.get(), options);
    }

    // The model whose plant it is; no value where the kind has none.
    Result<std::optional<SourceModel>> model() const
    {
        if (empty() || !kind_->model)
            return std::nullopt;
        return TRY(kind_->model(drawn_.get()));
    }

    bool can_vary() const { return !empty() && kind_->vary; }

    bool can_take_rules() const { return !empty() && kind_->with_rules; }

    PlantSource with_rules(std::optional<SourceRules> const& rules) const
    {
        auto other = *this;
        if (can_take_rules())
            other.drawn_ = kind_->with_rules(drawn_.get(), rules);
        return other;
    }

    PlantSource varied(SourceVariation const& variation) const
    {
        auto other = *this;
        if (can_vary() && variation.spread > 0)
            other.drawn_ = kind_->vary(drawn_.get(), variation);
        return other;
    }

    // Null for a source of another kind.
    template<typename T> T const* get(SourceKind const& kind) const
    {
        return kind_ == &kind ? static_cast<T const*>(drawn_.get()) : nullptr;
    }

    bool operator==(PlantSource const& other) const
    {
        return kind_ == other.kind_
            && (drawn_ == other.drawn_ || kind_->same(drawn_.get(), other.drawn_.get()));
    }

private:
    SourceKind const* kind_ = nullptr;
    std::shared_ptr<void const> drawn_; // Of the kind's type. Shared between copies.
};

} // namespace tractus::scene
