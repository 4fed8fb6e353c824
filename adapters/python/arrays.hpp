// SPDX-License-Identifier: BSD-3-Clause
// The caller's NumPy arrays as views: judged, never copied.
#pragma once

#include <optional>
#include <vector>

#include <grit/grit.h>
#include <pybind11/numpy.h>

namespace grit_python {

namespace py = pybind11;

// Arrays of one call, each of n points: of one point (c,) or of n points (n, c). Everything that is
// written must be writeable and share no memory with anything else of the call.
class Arrays {
  public:
    // The first array says how many points there are: shape (n, components) or, where one may be without n, (components,)
    // with one of the numbers of components allowed.
    Arrays(const char* name, const py::object& first, const std::vector<py::ssize_t>& components,
           bool one_without_n = true);
    // Of shape (n,).
    Arrays(const char* name, const py::object& first);

    py::ssize_t points() const { return n; }
    int components() const { return c; }

    // None makes a view without a base. size 0: one number per point, shape (n,), or (1,) of one point.
    grit_view read(const char* name, const py::object& object, py::ssize_t size);
    grit_mutable_view write(const char* name, const py::object& object, py::ssize_t size);
    grit_matrix_view read_matrix(const char* name, const py::object& object, py::ssize_t rows,
                                 py::ssize_t columns);
    grit_mutable_matrix_view write_matrix(const char* name, const py::object& object,
                                          py::ssize_t rows, py::ssize_t columns);
    // (c,) for all points, or (n, c).
    grit_view read_same_or_each(const char* name, const py::object& object, py::ssize_t size);
    // (n, 3, 3) or (3, 3): copied where the matrices do not lie as C wants them.
    grit_view read_rotation(const char* name, const py::object& object);
    // int64 (m,): distinct, in 0 ... n - 1. Null for None.
    const ptrdiff_t* read_index(const py::object& object);
    // How many points are taken: n, or as many as the index has.
    py::ssize_t taken() const { return m; }

    // One that is held.
    py::array array(const std::string& name) const;

    // Call when all are known, with the other arrays of the call, if any.
    void check_overlap(const Arrays* other = nullptr) const;

  private:
    struct Held {
        const char* name;
        py::array array;
        bool written;
    };
    const py::array& hold(const char* name, const py::object& object, bool written,
                          const std::vector<py::ssize_t>& shape);
    std::vector<py::ssize_t> with_points(std::vector<py::ssize_t> shape) const;

    std::vector<Held> held;
    py::ssize_t n = 0, m = 0;
    int c = 0;
    bool single = false;
    std::vector<ptrdiff_t> index;
};

// Whole numbers of any of NumPy's types of integers, copied.
struct WholeNumbers {
    std::vector<py::ssize_t> shape;
    std::vector<ptrdiff_t> values;
};
WholeNumbers whole_numbers(const char* name, const py::object& object);
// (size,), as the C interface takes flags and labels; none of None.
std::vector<int> labels(const char* name, const py::object& object, py::ssize_t size);
// n + 1 numbers that begin and end parts of a list of so many entries.
std::vector<ptrdiff_t> offsets(const char* name, const py::object& object, py::ssize_t entries);

// A few numbers of one point, (size,): real ones of any type, or a list of them, copied where they are no doubles.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
Numbers several(const char* name, const py::object& object);  // of any number of them
Numbers few(const char* name, const py::object& object, py::ssize_t size);

// "(3, 6)"
std::string shape_text(const std::vector<py::ssize_t>& shape);

}  // namespace grit_python
