#include "app/python/arrays.h"

namespace tractus::python {

namespace py = pybind11;

py::array show_array(ArrayOwner owner, py::dtype const& type, void const* data, Extents shape,
                     Extents strides)
{
    py::capsule const keeper(new ArrayOwner(std::move(owner)),
                             [](void* kept) { delete static_cast<ArrayOwner*>(kept); });
    py::array array(type, std::move(shape), std::move(strides), data, keeper);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

py::dtype record_type(std::vector<RecordField> const& fields, std::size_t size)
{
    py::list names;
    py::list formats;
    py::list offsets;
    for (auto const& [name, format, offset] : fields) {
        names.append(name);
        formats.append(format);
        offsets.append(offset);
    }
    return py::dtype(names, formats, offsets, extent(size));
}

} // namespace tractus::python
