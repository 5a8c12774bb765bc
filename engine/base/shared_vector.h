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

// A place, such as a file, from which the elements of a vector can be read again.
template<typename T> class ElementSource {
public:
    virtual ~ElementSource() = default;

    // Returns the same elements on every call. Fails, in a sentence that names the source, if they
    // cannot be read now; a later call may succeed. Called from any thread.
    virtual Result<std::vector<T>> read() const = 0;
};

// A vector with cheap copies: they share their elements until one of them is modified (copy on
// write). For values that are kept in many places and rarely changed. Copies may move to other
// threads; a single copy may be used by one thread at a time.
//
// Elements that have a source need not be in memory: a parked() copy reads its elements on first
// access and then keeps them. Callers that visit many vectors in turn should use temporary
// in_memory() copies, whose elements are freed with the copy.
template<typename T> class SharedVector {
public:
    using value_type = T;
    using Source = std::shared_ptr<ElementSource<T> const>; // Shared by all copies of a vector.

    SharedVector() = default;
    SharedVector(std::vector<T> elements) // NOLINT(google-explicit-constructor): is one.
        : SharedVector(std::move(elements), nullptr)
    {
    }
    SharedVector(std::initializer_list<T> elements)
        : SharedVector(std::vector<T>(elements))
    {
    }
    // `elements` must equal the elements of the source.
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

    // Returns a copy without elements in memory, which will read them from the source. The vector
    // must have a source.
    SharedVector parked() const
    {
        if (!is_in_memory())
            return *this;
        SharedVector parked;
        parked.shared_ = std::make_shared<Shared>(shared_->source);
        return parked;
    }

    // Returns a copy whose elements are in memory; this vector itself stays parked. Fails like the
    // source; a later call then reads again.
    Result<SharedVector> in_memory() const
    {
        if (is_in_memory())
            return *this;
        return SharedVector(TRY(shared_->source->read()), shared_->source);
    }

    // Identifies the elements without reading them: two vectors with the same id have the same
    // elements. An id is valid only while a vector with these elements exists.
    void const* id() const
    {
        return source() ? static_cast<void const*>(source().get()) : shared_.get();
    }

    // Returns the elements. Parked elements are read and stay in memory. If they cannot be read,
    // returns an empty vector this time; callers that must notice such a failure use in_memory().
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

    // Returns the elements for modification, detached from other copies and from the source. The
    // reference is valid until the next copy is made.
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
        std::atomic<bool> is_in_memory { false }; // Once this is true, no member changes any more.
    };

    static std::vector<T> const& nothing()
    {
        static std::vector<T> const none;
        return none;
    }

    // Shared between copies of the vector; null if the vector is empty.
    std::shared_ptr<Shared> shared_;
};

} // namespace tractus
