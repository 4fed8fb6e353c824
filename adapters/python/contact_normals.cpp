// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <vector>

#include <pybind11/numpy.h>

#include "adapters/python/arrays.hpp"
#include "adapters/python/errors.hpp"
#include "adapters/python/parts.hpp"

namespace grit_python {
namespace {

constexpr const char* gradients_doc =
    R"(Unit normals from A to B at n grid nodes, for contact_correct, from gradients of the bodies' volumes or from given
vectors, (C2) of docs/contact.md.

    source              "a": A is the stiffer body, n = g_A / |g_A|; "b": n = -g_B / |g_B|;
                        "average": n along g_A - g_B; "given": n along given
    gradient_a, _b      (n, c)      g = sum_p V_p grad N(x_p) of each body, points out of it, any unit alike, c = 2 or 3
    given               (n, c)      from A to B, of any length
    scale               (n,)        >= 0, size of what a gradient sums, say sum_p V_p |grad N|; without it a node inside
                                    a body has the normal that roundoff gives it
    threshold           [-] in [0, 1), 0 means 1e-8: undefined where |v| <= threshold * size
    fixed               (n,)        integers, bits 1, 2, 4: components that symmetry keeps at zero

Returns normals (n, c), zero where undefined: contact_correct(..., allow_zero_normal=True) leaves these alone.
Raises BadCall or BadState if any shape, dtype or value is bad.)";

constexpr const char* regression_doc =
    R"(Unit normals from A to B at n grid nodes by logistic regression of the particles around each: w / |w| of the plane
w.x + b = 0 that minimises sum_p a_p log(1 + exp(-y_p (w.x_p + b))) + ridge / 2 |w|^2, y = -1 for A, +1 for B, x in units
of length, a_p half of the particle's share of the weight of its body.

    position            (m, c)      of all particles [length], c = 2 or 3
    body                (m,)        integers, 0: A, 1: B
    offset              (n + 1,)    integers: node i has particle[offset[i]] ... particle[offset[i + 1] - 1]
    particle            (k,)        integers in 0 ... m - 1; None: 0 ... m - 1 itself
    length              [length], a cell; particles of a node extend over 200 of it at most, along each axis
    weight              (m,)        >= 0, say volumes; 0: not there
    ridge               [-] in [1e-6, 1e3], 0 means 1e-3
    iteration_limit     evaluations of the loss, 0 means 100
    fixed               (n,)        integers, bits 1, 2, 4: components that symmetry keeps at zero

Returns normals (n, c), zero where one body alone is there or the clouds do not differ. Raises BadCall or BadState if any
shape, dtype or value is bad, NotConverged at the limit of iterations: its attribute normal has all others, zero where none was found.)";

py::array_t<double> zeros(py::ssize_t n, py::ssize_t c) {
    py::array_t<double> out({n, c});
    std::fill_n(out.mutable_data(), out.size(), 0.0);
    return out;
}

int source_of(const std::string& source) {
    const std::vector<std::string> words{"a", "b", "average", "given"};
    const auto at = std::find(words.begin(), words.end(), source);
    if (at == words.end())
        refuse("source must be \"a\", \"b\", \"average\" or \"given\", got \"%s\"", source.c_str());
    return static_cast<int>(at - words.begin());
}

py::array from_gradients(const std::string& source, const py::object& gradient_a,
                         const py::object& gradient_b, const py::object& given,
                         const py::object& scale, double threshold, const py::object& fixed) {
    grit_contact_gradients gradients{};
    gradients.struct_size = sizeof gradients;
    gradients.source = source_of(source);
    const bool of_b = gradients.source == GRIT_CONTACT_NORMAL_OF_B;
    const bool is_given = gradients.source == GRIT_CONTACT_NORMAL_GIVEN;
    const char* first = is_given ? "given" : of_b ? "gradient_b" : "gradient_a";
    Arrays arrays(first, is_given ? given : of_b ? gradient_b : gradient_a, {2, 3}, false);
    const int c = arrays.components();
    gradients.components = c;
    gradients.gradient_a = arrays.read("gradient_a", gradient_a, c);
    gradients.gradient_b = arrays.read("gradient_b", gradient_b, c);
    gradients.given = arrays.read("given", given, c);
    gradients.scale = arrays.read("scale", scale, 0);
    gradients.threshold = threshold;
    const std::vector<int> bits = labels("fixed", fixed, arrays.points());
    gradients.fixed = fixed.is_none() ? nullptr : bits.data();
    py::array_t<double> normal = zeros(arrays.points(), c);
    gradients.normal = grit_mutable_view_of(normal.mutable_data(), c, 1);
    grit_error error{};
    grit_status status = GRIT_OK;
    {
        const py::gil_scoped_release others_may_run;
        status = grit_contact_normals_from_gradients(arrays.points(), &gradients, nullptr, &error);
    }
    check(status, error);
    return normal;
}

py::array by_regression(const py::object& position, const py::object& body,
                        const py::object& offset, const py::object& particle, double length,
                        const py::object& weight, double ridge, int iteration_limit,
                        const py::object& fixed) {
    Arrays arrays("position", position, {2, 3}, false);
    const int c = arrays.components();
    std::vector<ptrdiff_t> ids;
    if (!particle.is_none()) ids = whole_numbers("particle", particle).values;
    const std::vector<ptrdiff_t> parts =
        offsets("offset", offset,
                particle.is_none() ? arrays.points() : static_cast<py::ssize_t>(ids.size()));
    const auto n = static_cast<py::ssize_t>(parts.size()) - 1;
    const std::vector<int> bodies = labels("body", body, arrays.points());
    if (body.is_none()) refuse("body must be a NumPy array of integers, got None");
    const std::vector<int> bits = labels("fixed", fixed, n);
    ptrdiff_t most = 1;
    for (std::size_t i = 1; i < parts.size(); ++i) most = std::max(most, parts[i] - parts[i - 1]);
    grit_contact_clouds clouds{};
    clouds.struct_size = sizeof clouds;
    clouds.components = c;
    clouds.offset = parts.data();
    clouds.particle = particle.is_none() ? nullptr : ids.data();
    clouds.particles = arrays.points();
    clouds.position = arrays.read("position", position, c);
    clouds.body = bodies.data();
    clouds.weight = arrays.read("weight", weight, 0);
    clouds.length = length;
    clouds.ridge = ridge;
    clouds.iteration_limit = iteration_limit;
    clouds.fixed = fixed.is_none() ? nullptr : bits.data();
    py::array_t<double> normal = zeros(n, c);
    clouds.normal = grit_mutable_view_of(normal.mutable_data(), c, 1);
    std::vector<char> workspace(grit_contact_regression_workspace_size(most, c));
    grit_error error{};
    grit_status status = GRIT_OK;
    {
        const py::gil_scoped_release others_may_run;
        status = grit_contact_normals_by_regression(n, &clouds, workspace.data(), workspace.size(),
                                                    nullptr, &error);
    }
    if (status == GRIT_NOT_CONVERGED) raise(error, "normal", normal);
    check(status, error);
    return normal;
}

}  // namespace

void add_contact_normals(py::module_& module) {
    using py::arg;
    const py::none none;
    module.def("contact_normals", &from_gradients, arg("source"), py::kw_only(),
               arg("gradient_a") = none, arg("gradient_b") = none, arg("given") = none,
               arg("scale") = none, arg("threshold") = 0.0, arg("fixed") = none, gradients_doc);
    module.def("contact_normals_by_regression", &by_regression, arg("position"), arg("body"),
               arg("offset"), arg("particle") = none, py::kw_only(), arg("length"),
               arg("weight") = none, arg("ridge") = 0.0, arg("iteration_limit") = 0,
               arg("fixed") = none, regression_doc);
}

}  // namespace grit_python
