#pragma once

#include <memory>
#include <pybind11/numpy.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus::python {

// What an array shows. The array keeps it alive.
using ArrayOwner = std::shared_ptr<void const>;
using Extents = std::vector<pybind11::ssize_t>;

// Returns a read-only array that shows memory of `owner` without copying it. `strides` are in
// bytes; empty: the elements are contiguous.
pybind11::array show_array(ArrayOwner owner, pybind11::dtype const& type, void const* data,
                           Extents shape, Extents strides = {});

template<typename Scalar>
pybind11::array show_array(ArrayOwner owner, Scalar const* data, Extents shape,
                           Extents strides = {})
{
    return show_array(std::move(owner), pybind11::dtype::of<Scalar>(), data, std::move(shape),
                      std::move(strides));
}

// Returns an array that takes a vector over, without copying it.
template<typename Scalar> pybind11::array take_array(std::vector<Scalar> values, Extents shape)
{
    auto const owner = std::make_shared<std::vector<Scalar> const>(std::move(values));
    return show_array(owner, owner->data(), std::move(shape));
}

// A field of the elements of a record array.
struct RecordField {
    char const* name;
    std::string format; // As numpy writes it: "<u4", "(3,)<f8".
    std::size_t offset;
};

// Returns the type of a record array, whose elements have `size` bytes.
pybind11::dtype record_type(std::vector<RecordField> const& fields, std::size_t size);

// Offset of a member in an object.
template<typename Object, typename Member>
std::size_t offset_in(Object const& object, Member const& member)
{
    return static_cast<std::size_t>(reinterpret_cast<char const*>(&member)
                                    - reinterpret_cast<char const*>(&object));
}

inline pybind11::ssize_t extent(std::size_t size)
{
    return static_cast<pybind11::ssize_t>(size);
}

} // namespace tractus::python
