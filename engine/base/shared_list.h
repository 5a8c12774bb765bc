#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace tractus {

// A long list that is kept in many versions, each differing from the one before by a few elements.
// Copies share all blocks of elements except those that contain a difference. Copies may move to
// other threads; a single copy may be used by one thread at a time.
template<typename T> class SharedList {
    // Number of elements in a block, which is shared or copied as a whole.
    static constexpr std::size_t kBlock = 32;
    using Block = std::vector<T>;

public:
    class Iterator {
    public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = T;
        using difference_type = std::ptrdiff_t;
        using pointer = T const*;
        using reference = T const&;

        Iterator() = default;
        Iterator(SharedList const& list, std::size_t index)
            : list_(&list)
            , index_(index)
        {
        }
        reference operator*() const { return (*list_)[index_]; }
        pointer operator->() const { return &(*list_)[index_]; }
        Iterator& operator++()
        {
            ++index_;
            return *this;
        }
        Iterator operator++(int)
        {
            auto const before = *this;
            ++index_;
            return before;
        }
        bool operator==(Iterator const&) const = default;

    private:
        SharedList const* list_ = nullptr;
        std::size_t index_ = 0;
    };
    using value_type = T;
    using const_iterator = Iterator;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T const& operator[](std::size_t index) const
    {
        return (*blocks_[index / kBlock])[index % kBlock];
    }
    T const& front() const { return (*this)[0]; }
    T const& back() const { return (*this)[size_ - 1]; }
    Iterator begin() const { return { *this, 0 }; }
    Iterator end() const { return { *this, size_ }; }

    void replace(std::size_t index, T element)
    {
        std::vector<std::pair<std::size_t, T>> one;
        one.emplace_back(index, std::move(element));
        replace(std::move(one));
    }

    // Replaces elements, given with their indices, in ascending order of the indices. A block that
    // contains several of the elements is copied only once.
    void replace(std::vector<std::pair<std::size_t, T>> elements)
    {
        for (std::size_t i = 0; i < elements.size();) {
            auto const number = elements[i].first / kBlock;
            auto block = *blocks_[number];
            for (; i < elements.size() && elements[i].first / kBlock == number; ++i)
                block[elements[i].first % kBlock] = std::move(elements[i].second);
            blocks_[number] = std::make_shared<Block const>(std::move(block));
        }
    }

    void push_back(T element)
    {
        std::vector<T> one;
        one.push_back(std::move(element));
        append(std::move(one));
    }

    // Appends elements. Of the existing blocks only the last is copied, if it is not full.
    void append(std::vector<T> elements)
    {
        for (std::size_t i = 0; i < elements.size();) {
            Block block;
            block.reserve(kBlock);
            if (size_ % kBlock > 0) {
                block.assign(blocks_.back()->begin(), blocks_.back()->end());
                blocks_.pop_back();
            }
            for (; i < elements.size() && block.size() < kBlock; ++i, ++size_)
                block.push_back(std::move(elements[i]));
            blocks_.push_back(std::make_shared<Block const>(std::move(block)));
        }
    }

    // Removes the elements at `indices`, which must be in ascending order; later elements move
    // forward.
    void erase(std::vector<std::size_t> const& indices)
    {
        if (indices.empty())
            return;
        // Index of the first element of the first changed block.
        auto const first = indices.front() / kBlock * kBlock;
        auto const before = std::exchange(*this, {});
        blocks_.assign(before.blocks_.begin(),
                       before.blocks_.begin() + static_cast<std::ptrdiff_t>(first / kBlock));
        size_ = first;
        std::vector<T> after;
        after.reserve(before.size() - first);
        auto removed = indices.begin();
        for (auto i = first; i < before.size(); ++i)
            if (removed != indices.end() && *removed == i)
                ++removed;
            else
                after.push_back(before[i]);
        append(std::move(after));
    }

    void clear() { *this = {}; }

    // Returns the list of `make` applied to each element. `made` must be the list that map()
    // returned for the list `before`: results for blocks that this list shares with `before` are
    // reused from it.
    template<typename U, typename Make>
    SharedList<U> map(SharedList const& before, SharedList<U> const& made, Make const& make) const
    {
        SharedList<U> result;
        result.size_ = size_;
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            if (i < before.blocks_.size() && before.blocks_[i] == blocks_[i]) {
                result.blocks_.push_back(made.blocks_[i]);
                continue;
            }
            std::vector<U> block;
            block.reserve(kBlock);
            for (auto const& element : *blocks_[i])
                block.push_back(make(element));
            result.blocks_.push_back(std::make_shared<std::vector<U> const>(std::move(block)));
        }
        return result;
    }

    // Returns all elements in order.
    std::vector<T> vector() const { return { begin(), end() }; }

private:
    template<typename U> friend class SharedList;

    // The blocks are shared between copies of the list and never modified: a change replaces a
    // whole block. All blocks but the last are full.
    std::vector<std::shared_ptr<Block const>> blocks_;
    std::size_t size_ = 0;
};

} // namespace tractus
