#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace tractus {

// A vector of which copies are cheap: they share their elements until one of them is changed, which
// then has its own. For values that are kept in many places and hardly ever changed. A copy may go
// to another thread; one copy belongs to one thread at a time, as any value does.
template<typename T> class SharedVector {
public:
    using value_type = T;

    SharedVector() = default;
    SharedVector(std::vector<T> elements) // NOLINT(google-explicit-constructor): is one.
        : elements_(std::make_shared<std::vector<T>>(std::move(elements)))
    {
    }
    SharedVector(std::initializer_list<T> elements)
        : SharedVector(std::vector<T>(elements))
    {
    }

    std::vector<T> const& vector() const { return elements_ ? *elements_ : nothing(); }
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

    // To change them. Holds until the next copy is made.
    std::vector<T>& own()
    {
        if (!elements_)
            elements_ = std::make_shared<std::vector<T>>();
        else if (elements_.use_count() > 1)
            elements_ = std::make_shared<std::vector<T>>(*elements_);
        return *elements_;
    }
    void push_back(T element) { own().push_back(std::move(element)); }
    void clear() { elements_.reset(); }

    bool operator==(SharedVector const& other) const
    {
        return elements_ == other.elements_ || vector() == other.vector();
    }

private:
    static std::vector<T> const& nothing()
    {
        static std::vector<T> const none;
        return none;
    }

    std::shared_ptr<std::vector<T>> elements_; // Shared between the copies; null: none.
};

} // namespace tractus
