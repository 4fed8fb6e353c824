// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/python/arrays.hpp"

#include <algorithm>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "adapters/python/errors.hpp"

namespace grit_python {
namespace {

constexpr py::ssize_t double_size = sizeof(double);

std::vector<py::ssize_t> shape_of(const py::array& a) { return {a.shape(), a.shape() + a.ndim()}; }

std::string type_name(const py::object& object) {
    return py::str(py::type::of(object).attr("__name__"));
}

// Its mask would be ignored.
void refuse_masked(const char* name, const py::object& object) {
    if (!py::isinstance<py::array>(object) ||
        Py_TYPE(object.ptr()) == py::detail::npy_api::get().PyArray_Type_)
        return;
    if (py::isinstance(object, py::module_::import("numpy.ma").attr("MaskedArray")))
        refuse("%s must have no mask, got a MaskedArray: an index tells which points are taken",
               name);
}

// Two of its numbers may lie at the same place.
bool overlaps_itself(const py::array& a) {
    std::vector<std::pair<py::ssize_t, py::ssize_t>> axes;  // |stride|, size
    for (py::ssize_t i = 0; i < a.ndim(); ++i) {
        if (a.shape(i) == 0) return false;
        if (a.shape(i) > 1) axes.emplace_back(std::abs(a.strides(i)), a.shape(i));
    }
    std::sort(axes.begin(), axes.end());
    py::ssize_t reach = a.itemsize();
    for (const auto& [stride, size] : axes) {
        if (stride < reach) return true;
        reach += stride * (size - 1);
    }
    return false;
}

// float64 in this machine's bytes, aligned, writeable if asked for.
py::array judged(const char* name, const py::object& object, bool written) {
    if (!py::isinstance<py::array>(object))
        refuse("%s must be a NumPy array of float64, got %s", name, type_name(object).c_str());
    refuse_masked(name, object);
    auto array = py::reinterpret_borrow<py::array>(object);
    if (!py::isinstance<py::array_t<double>>(object))
        refuse("%s must be an array of float64, got %s", name,
               std::string(py::str(array.dtype())).c_str());
    bool whole = reinterpret_cast<std::uintptr_t>(array.data()) % alignof(double) == 0;
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
        whole = whole && (array.shape(i) <= 1 || array.strides(i) % double_size == 0);
    if (!whole && array.size() > 0)
        refuse("%s must be aligned, with strides that are multiples of 8 bytes: pass a copy", name);
    if (written && !array.writeable()) refuse("%s is written to, but is read-only", name);
    if (written && overlaps_itself(array))
        refuse("%s is written to, but its elements overlap in memory", name);
    return array;
}

ptrdiff_t stride(const py::array& a, py::ssize_t axis) { return a.strides(axis) / double_size; }

double* base_of(const py::array& a) { return static_cast<double*>(const_cast<void*>(a.data())); }

}  // namespace

std::string shape_text(const std::vector<py::ssize_t>& shape) {
    std::string text = "(";
    for (std::size_t i = 0; i < shape.size(); ++i)
        text += (i ? ", " : "") + std::to_string(shape[i]);
    return text + (shape.size() == 1 ? ",)" : ")");
}

Numbers several(const char* name, const py::object& object) {
    refuse_masked(name, object);
    const py::array given = py::array::ensure(object);
    if (!given || std::string("fiu").find(given.dtype().kind()) == std::string::npos)
        refuse("%s must be real numbers, got %s", name,
               given ? std::string(py::str(given.dtype())).c_str() : type_name(object).c_str());
    return Numbers(given);
}

Numbers few(const char* name, const py::object& object, py::ssize_t size) {
    Numbers out = several(name, object);
    const auto shape = shape_of(out);
    if (shape.size() != 1 || shape[0] != size)
        refuse("%s must be (%td,), got %s", name, size, shape_text(shape).c_str());
    return out;
}

Arrays::Arrays(const char* name, const py::object& first) {
    const auto shape = shape_of(judged(name, first, false));
    if (shape.size() != 1) refuse("%s must be (n,), got %s", name, shape_text(shape).c_str());
    n = m = shape[0];
    c = 1;
}

Arrays::Arrays(const char* name, const py::object& first,
               const std::vector<py::ssize_t>& components, bool one_without_n) {
    const py::array array = judged(name, first, false);
    const auto shape = shape_of(array);
    const bool fits =
        (shape.size() == 2 || (shape.size() == 1 && one_without_n)) &&
        std::find(components.begin(), components.end(), shape.back()) != components.end();
    if (!fits) {
        std::string wanted;
        for (const py::ssize_t k : components)
            wanted += (wanted.empty() ? "" : " or ") + ("(n, " + std::to_string(k) + ")");
        refuse("%s must be %s%s, got %s", name, wanted.c_str(),
               one_without_n ? ", without n for one point" : "", shape_text(shape).c_str());
    }
    single = shape.size() == 1;
    n = m = single ? 1 : shape[0];
    c = static_cast<int>(shape.back());
}

std::vector<py::ssize_t> Arrays::with_points(std::vector<py::ssize_t> shape) const {
    if (!single || shape.empty()) shape.insert(shape.begin(), n);
    return shape;
}

const py::array& Arrays::hold(const char* name, const py::object& object, bool written,
                              const std::vector<py::ssize_t>& shape) {
    held.push_back({name, judged(name, object, written), written});
    const py::array& array = held.back().array;
    if (shape_of(array) != shape)
        refuse("%s must be %s, got %s", name, shape_text(shape).c_str(),
               shape_text(shape_of(array)).c_str());
    return array;
}

grit_view Arrays::read(const char* name, const py::object& object, py::ssize_t size) {
    if (object.is_none()) return {};
    const auto shape =
        with_points(size ? std::vector<py::ssize_t>{size} : std::vector<py::ssize_t>{});
    const py::array& a = hold(name, object, false, shape);
    if (size == 0) return grit_view_of(base_of(a), stride(a, 0), 1);
    return grit_view_of(base_of(a), single ? 0 : stride(a, 0), stride(a, single ? 0 : 1));
}

grit_mutable_view Arrays::write(const char* name, const py::object& object, py::ssize_t size) {
    if (object.is_none()) return {};
    const grit_view view = read(name, object, size);
    Held& last = held.back();
    last.array = judged(name, object, true);
    last.written = true;
    return grit_mutable_view_of(const_cast<double*>(view.base), view.point_stride,
                                view.component_stride);
}

grit_matrix_view Arrays::read_matrix(const char* name, const py::object& object, py::ssize_t rows,
                                     py::ssize_t columns) {
    if (object.is_none()) return {};
    const py::array& a = hold(name, object, false, with_points({rows, columns}));
    const py::ssize_t row = single ? 0 : 1;
    // Where there is one of them, NumPy may give it any stride.
    const auto step = [&](py::ssize_t axis) {
        return a.shape(axis) > 1 ? stride(a, axis) : ptrdiff_t{1};
    };
    return grit_matrix_view_of(base_of(a), single ? 0 : step(0), step(row), step(row + 1));
}

grit_mutable_matrix_view Arrays::write_matrix(const char* name, const py::object& object,
                                              py::ssize_t rows, py::ssize_t columns) {
    if (object.is_none()) return {};
    const grit_matrix_view view = read_matrix(name, object, rows, columns);
    Held& last = held.back();
    last.array = judged(name, object, true);
    last.written = true;
    return grit_mutable_matrix_view_of(const_cast<double*>(view.base), view.point_stride,
                                       view.row_stride, view.column_stride);
}

grit_view Arrays::read_same_or_each(const char* name, const py::object& object, py::ssize_t size) {
    if (object.is_none()) return {};
    if (single || judged(name, object, false).ndim() != 1) return read(name, object, size);
    const py::array& a = hold(name, object, false, {size});
    return grit_view_of(base_of(a), 0, stride(a, 0));
}

grit_view Arrays::read_rotation(const char* name, const py::object& object) {
    if (object.is_none()) return {};
    hold(name, object, false, with_points({3, 3}));
    Held& last = held.back();
    last.array = py::array_t<double, py::array::c_style | py::array::forcecast>(last.array);
    return grit_view_of(base_of(last.array), 9, 1);
}

const ptrdiff_t* Arrays::read_index(const py::object& object) {
    if (object.is_none()) return nullptr;
    if (single) refuse("index needs arrays of n points");
    if (!py::isinstance<py::array_t<std::int64_t>>(object))
        refuse("index must be an array of int64, got %s",
               py::isinstance<py::array>(object)
                   ? std::string(py::str(py::reinterpret_borrow<py::array>(object).dtype())).c_str()
                   : type_name(object).c_str());
    refuse_masked("index", object);
    const auto list = py::reinterpret_borrow<py::array_t<std::int64_t>>(object);
    if (list.ndim() != 1) refuse("index must be (m,), got %s", shape_text(shape_of(list)).c_str());
    std::vector<bool> seen(static_cast<std::size_t>(n), false);
    for (py::ssize_t i = 0; i < list.shape(0); ++i) {
        const std::int64_t at = list.at(i);
        if (at < 0 || at >= n)
            refuse("index[%td] must be in [0, %td), got %lld", i, n, static_cast<long long>(at));
        if (seen[static_cast<std::size_t>(at)])
            refuse("index[%td] = %lld is there twice", i, static_cast<long long>(at));
        seen[static_cast<std::size_t>(at)] = true;
        index.push_back(at);
    }
    m = list.shape(0);
    return index.data();
}

py::array Arrays::array(const std::string& name) const {
    for (const Held& each : held)
        if (name == each.name) return each.array;
    return {};
}

void Arrays::check_overlap(const Arrays* other) const {
    const py::object shares = py::module_::import("numpy").attr("shares_memory");
    std::vector<const Held*> all;
    for (const Arrays* each : {this, other})
        for (std::size_t i = 0; each && i < each->held.size(); ++i) all.push_back(&each->held[i]);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (!all[i]->written && !all[j]->written) continue;
            if (shares(all[i]->array, all[j]->array).cast<bool>())
                refuse("%s and %s share memory, and one of them is written to", all[i]->name,
                       all[j]->name);
        }
}

WholeNumbers whole_numbers(const char* name, const py::object& object) {
    if (!py::isinstance<py::array>(object))
        refuse("%s must be a NumPy array of integers, got %s", name, type_name(object).c_str());
    refuse_masked(name, object);
    const auto array = py::reinterpret_borrow<py::array>(object);
    const char kind = array.dtype().kind();
    if (kind != 'i' && kind != 'u')
        refuse("%s must be an array of integers, got %s", name,
               std::string(py::str(array.dtype())).c_str());
    const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> list(array);
    if (kind == 'u' && array.itemsize() == 8)
        for (py::ssize_t i = 0; i < list.size(); ++i)
            if (list.data()[i] < 0)
                refuse("%s must be below 2^63, got %llu", name,
                       static_cast<unsigned long long>(list.data()[i]));
    return {shape_of(array), {list.data(), list.data() + list.size()}};
}

std::vector<int> labels(const char* name, const py::object& object, py::ssize_t size) {
    if (object.is_none()) return {};
    const WholeNumbers list = whole_numbers(name, object);
    if (list.shape != std::vector<py::ssize_t>{size})
        refuse("%s must be (%td,), got %s", name, size, shape_text(list.shape).c_str());
    std::vector<int> out;
    for (const ptrdiff_t value : list.values)
        out.push_back(static_cast<int>(std::clamp<ptrdiff_t>(value, INT_MIN, INT_MAX)));
    return out;
}

std::vector<ptrdiff_t> offsets(const char* name, const py::object& object, py::ssize_t entries) {
    const WholeNumbers list = whole_numbers(name, object);
    if (list.shape.size() != 1 || list.values.empty())
        refuse("%s must be (n + 1,), got %s", name, shape_text(list.shape).c_str());
    if (list.values.front() < 0 || list.values.back() > entries ||
        !std::is_sorted(list.values.begin(), list.values.end()))
        refuse("%s must rise from 0 or more to %td or less, the entries of the list", name,
               entries);
    return list.values;
}

}  // namespace grit_python
