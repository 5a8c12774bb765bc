#pragma once

#include "engine/base/result.h"

#include <atomic>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace tractus {

// Where elements can be read again that are not in memory.
template<typename T> class ElementSource {
public:
    virtual ~ElementSource() = default;

    // Always the same ones. Fails, in a sentence that names the place, where they cannot be read
    // now: the next call may succeed. Called from any thread.
    virtual Result<std::vector<T>> read() const = 0;
};

// A vector of which copies are cheap: they share their elements until one of them is changed, which
// then has its own. For values that are kept in many places and hardly ever changed. A copy may go
// to another thread; one copy belongs to one thread at a time, as any value does.
//
// Elements that have a source need not be in memory: those of a parked() copy are read when
// somebody looks at them, and stay from then on. Callers that look at many in turn take in_memory()
// copies instead, whose elements go with them.
template<typename T> class SharedVector {
public:
    using value_type = T;
    using Source = std::shared_ptr<ElementSource<T> const>; // Shared between the copies.

    SharedVector() = default;
    SharedVector(std::vector<T> elements) // NOLINT(google-explicit-constructor): is one.
        : SharedVector(std::move(elements), nullptr)
    {
    }
    SharedVector(std::initializer_list<T> elements)
        : SharedVector(std::vector<T>(elements))
    {
    }
    // Elements that are those of the source, too.
    SharedVector(std::vector<T> elements, Source source)
        : shared_(std::make_shared<Shared>(std::move(elements), std::move(source)))
    {
    }

    Source const& source() const
    {
        static Source const none;
        return shared_ ? shared_->source : none;
    }
    bool is_in_memory() const { return !shared_ || shared_->is_in_memory; }

    // Returns the same elements, left to their source, which they must have.
    SharedVector parked() const
    {
        if (!is_in_memory())
            return *this;
        SharedVector parked;
        parked.shared_ = std::make_shared<Shared>(shared_->source);
        return parked;
    }

    // Returns the same elements in memory, which those of this one need not be afterwards. Fails as
    // their source does, and then changes nothing: a later call reads again.
    Result<SharedVector> in_memory() const
    {
        if (is_in_memory())
            return *this;
        return SharedVector(TRY(shared_->source->read()), shared_->source);
    }

    // Identifies the elements: two with the same id have the same ones, as long as one of the two
    // is there; nobody needs to look at them to know.
    void const* id() const
    {
        return source() ? static_cast<void const*>(source().get()) : shared_.get();
    }

    // The elements; those that are not in memory are read, and stay. If they cannot be read, it is
    // empty for this call: callers that must know ask for in_memory().
    std::vector<T> const& vector() const { return shared_ ? shared_->look() : nothing(); }
    operator std::vector<T> const&() const
    {
        return vector();
    } // NOLINT(google-explicit-constructor)

    bool empty() const { return vector().empty(); }
    std::size_t size() const { return vector().size(); }
    T const* data() const { return vector().data(); }
    T const& operator[](std::size_t index) const { return vector()[index]; }
    T const& front() const { return vector().front(); }
    T const& back() const { return vector().back(); }
    auto begin() const { return vector().begin(); }
    auto end() const { return vector().end(); }

    // Elements to be changed: they are the source's no more. The reference holds until the next
    // copy is made.
    std::vector<T>& own()
    {
        if (!shared_)
            *this = SharedVector(std::vector<T>());
        else if (shared_.use_count() > 1 || shared_->source)
            *this = SharedVector(vector());
        return shared_->elements;
    }
    void push_back(T element) { own().push_back(std::move(element)); }
    void clear() { shared_.reset(); }

    bool operator==(SharedVector const& other) const
    {
        return id() == other.id() || vector() == other.vector();
    }

private:
    struct Shared {
        Shared(std::vector<T> all, Source from)
            : elements(std::move(all))
            , source(std::move(from))
            , is_in_memory(true)
        {
        }
        explicit Shared(Source from)
            : source(std::move(from))
        {
        }

        std::vector<T> const& look()
        {
            if (is_in_memory)
                return elements;
            std::lock_guard const lock(reading);
            if (!is_in_memory) {
                auto read = source->read();
                if (!read)
                    return nothing();
                elements = *std::move(read);
                is_in_memory = true;
            }
            return elements;
        }

        std::vector<T> elements;
        Source const source;
        std::mutex reading;
        std::atomic<bool> is_in_memory { false }; // Then nothing here changes any more.
    };

    static std::vector<T> const& nothing()
    {
        static std::vector<T> const none;
        return none;
    }

    std::shared_ptr<Shared> shared_; // Shared between the copies; null: none.
};

} // namespace tractus
