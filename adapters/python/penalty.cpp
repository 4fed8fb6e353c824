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

constexpr const char* forces_doc =
    R"(Forces of penalty contact between the boundary lines of two bodies, (S1)-(S4) of docs/contact.md: both in turn as
slave, t_n = eps_n |g| where a vertex is inside the other body by |g| <= depth_max, trial friction t_t + eps_t Delta g_t
returned to mu t_n. Plane: per metre; axisymmetric: components are (r, z), forces per radian.

    position_a, _b      (n, 2)      vertices [length]; the body lies on the left of the direction of travel
    velocity_a, _b      (n, 2)      that took the vertices here [length/time], with friction
    history_a, _b       (n, 2)      tangential and normal traction [stress], zero at first, in place; with friction
    closed_a, _b        the last vertex is joined to the first
    normal_stiffness    eps_n [stress/length], see penalty_stiffness
    depth_max           [length], about a cell of the grid
    tangential_stiffness  eps_t [stress/length], 0: eps_n
    friction_coefficient  mu [-], 0             time_step  [time], with friction

Returns a dict: force_a, force_b (n, 2) [force per metre or radian]; stiffness_a, stiffness_b (n,) for
penalty_stable_step; reports_a, reports_b (n,), structured: state (PENALTY_OPEN, _STICK, _SLIP), segment, place, gap, normal,
area, normal_traction (pressure +), tangential_traction, slip_rate; and totals, a dict of numbers. Raises BadCall or
BadState and changes nothing, if any shape, dtype or value is bad.)";

constexpr const char* remesh_doc =
    R"(A boundary line with segments no longer than longest and, where its shape allows, no shorter than shortest, (S5).

    position            (n, 2)      vertices [length]
    longest             [length], about a cell
    shortest            [length] in [0, longest / 2], 0: no vertex goes
    tolerance           [length] in [0, shortest]: how far a vertex may be from the line that replaces it
    closed              the last vertex is joined to the first
    history             (n, 2)      of penalty_forces

Returns a dict: position (m, 2); parents (m, 2), old vertices of each, and weight (m,) of the second,
x = (1 - w) x_0 + w x_1, for other data of the vertices; history (m, 2) if given.)";

struct Line {
    Arrays arrays;
    grit_penalty_surface surface{};
    py::array_t<double> force, stiffness;
    py::array_t<grit_penalty_report> reports;

    Line(const std::vector<const char*>& names, const py::object& position,
         const py::object& velocity, const py::object& history, bool closed)
        : arrays(names[0], position, {2}, false), force({arrays.points(), py::ssize_t{2}}),
          stiffness(arrays.points()), reports(arrays.points()) {
        surface.struct_size = sizeof surface;
        surface.closed = closed;
        surface.count = arrays.points();
        surface.position = arrays.read(names[0], position, 2);
        surface.velocity = arrays.read(names[1], velocity, 2);
        surface.history = arrays.write(names[2], history, 2);
        std::fill_n(force.mutable_data(), force.size(), 0.0);
        std::fill_n(stiffness.mutable_data(), stiffness.size(), 0.0);
        std::fill_n(reports.mutable_data(), reports.size(), grit_penalty_report{});
        surface.force = grit_mutable_view_of(force.mutable_data(), 2, 1);
        surface.stiffness = grit_mutable_view_of(stiffness.mutable_data(), 1, 1);
        surface.reports = reports.mutable_data();
    }
};

py::dict totals_of(const grit_penalty_totals& totals) {
    const auto vector = [](const double(&v)[2]) { return py::array_t<double>(2, v); };
    py::dict out;
    out["force_on_a"] = vector(totals.force_on_a);
    out["force_on_b"] = vector(totals.force_on_b);
    out["moment_on_a"] = totals.moment_on_a;
    out["moment_on_b"] = totals.moment_on_b;
    out["contact_area"] = totals.contact_area;
    out["normal_force"] = totals.normal_force;
    out["energy_normal"] = totals.energy_normal;
    out["energy_tangential"] = totals.energy_tangential;
    out["dissipation"] = totals.dissipation;
    out["largest_penetration"] = totals.largest_penetration;
    out["contacts_a"] = totals.contacts_a;
    out["contacts_b"] = totals.contacts_b;
    out["slips"] = totals.slips;
    return out;
}

grit_penalty_options options_of(double normal_stiffness, double tangential_stiffness,
                                double depth_max, bool axisymmetric) {
    grit_penalty_options options{};
    check(grit_penalty_options_init(&options, sizeof options), "grit_penalty_options_init");
    options.axisymmetric = axisymmetric;
    options.normal_stiffness = normal_stiffness;
    options.tangential_stiffness = tangential_stiffness;
    options.depth_max = depth_max;
    return options;
}

py::dict forces(const py::object& position_a, const py::object& position_b, double normal_stiffness,
                double depth_max, double tangential_stiffness, double friction_coefficient,
                double time_step, const py::object& velocity_a, const py::object& velocity_b,
                const py::object& history_a, const py::object& history_b, bool closed_a,
                bool closed_b, bool axisymmetric) {
    grit_penalty_options options =
        options_of(normal_stiffness, tangential_stiffness, depth_max, axisymmetric);
    options.friction_coefficient = friction_coefficient;
    options.time_step = time_step;
    Line a({"position_a", "velocity_a", "history_a"}, position_a, velocity_a, history_a, closed_a);
    Line b({"position_b", "velocity_b", "history_b"}, position_b, velocity_b, history_b, closed_b);
    a.arrays.check_overlap(&b.arrays);
    std::vector<double> workspace(
        grit_penalty_workspace_size(a.surface.count, b.surface.count) / sizeof(double) + 1);
    grit_penalty_totals totals{};
    totals.struct_size = sizeof totals;
    grit_error error{};
    grit_status status = GRIT_OK;
    {
        const py::gil_scoped_release others_may_run;
        status = grit_penalty_forces(&options, &a.surface, &b.surface, workspace.data(),
                                     workspace.size() * sizeof(double), &totals, &error);
    }
    check(status, error);
    py::dict out;
    out["force_a"] = a.force;
    out["force_b"] = b.force;
    out["stiffness_a"] = a.stiffness;
    out["stiffness_b"] = b.stiffness;
    out["reports_a"] = a.reports;
    out["reports_b"] = b.reports;
    out["totals"] = totals_of(totals);
    return out;
}

double stiffness(double multiple, double modulus, double cell_size) {
    double eps = 0.0;
    check(grit_penalty_stiffness(multiple, modulus, cell_size, &eps),
          "penalty_stiffness: multiple must be in [0, 1e6], modulus > 0 [stress], cell_size > 0 "
          "[length]");
    return eps;
}

py::array flush_stiffness(const py::object& position, double normal_stiffness,
                          double tangential_stiffness, double friction_coefficient, bool closed,
                          bool axisymmetric) {
    const py::none none;
    // Depth and step are judged, not read.
    grit_penalty_options options =
        options_of(normal_stiffness, tangential_stiffness, 1.0, axisymmetric);
    options.friction_coefficient = friction_coefficient;
    options.time_step = 1.0;
    Line line({"position", "velocity", "history"}, position, none, none, closed);
    grit_error error{};
    check(grit_penalty_flush_stiffness(&options, &line.surface, &error), error);
    return line.stiffness;
}

double stable_step(const py::object& mass_a, const py::object& stiffness_a,
                   const py::object& mass_b, const py::object& stiffness_b) {
    Arrays a("mass_a", mass_a);
    const grit_view of_a[2] = {a.read("mass_a", mass_a, 0), a.read("stiffness_a", stiffness_a, 0)};
    grit_view of_b[2] = {};
    ptrdiff_t n_b = 0;
    if (mass_b.is_none() != stiffness_b.is_none())
        refuse("%s is missing: body B has both, or none of them",
               mass_b.is_none() ? "mass_b" : "stiffness_b");
    if (!mass_b.is_none()) {
        Arrays b("mass_b", mass_b);
        of_b[0] = b.read("mass_b", mass_b, 0);
        of_b[1] = b.read("stiffness_b", stiffness_b, 0);
        n_b = b.points();
    }
    double step = 0.0;
    grit_error error{};
    check(grit_penalty_stable_step(a.points(), &of_a[0], &of_a[1], n_b, &of_b[0], &of_b[1], &step,
                                   &error),
          error);
    return step;
}

py::dict remesh(const py::object& position, double longest, double shortest, double tolerance,
                bool closed, const py::object& history) {
    Arrays arrays("position", position, {2}, false);
    grit_penalty_remeshing line{};
    line.struct_size = sizeof line;
    line.closed = closed;
    line.longest = longest;
    line.shortest = shortest;
    line.tolerance = tolerance;
    line.count = arrays.points();
    line.position = arrays.read("position", position, 2);
    line.history = arrays.read("history", history, 2);
    std::vector<double> workspace(
        grit_penalty_remesh_workspace_size(arrays.points()) / sizeof(double) + 1);
    ptrdiff_t count = 2 * arrays.points();
    grit_error error{};
    for (int attempt = 0;; ++attempt) {  // the first may say how many there are
        line.capacity = count;
        py::array_t<double> new_position({count, py::ssize_t{2}});
        py::array_t<double> new_history({count, py::ssize_t{2}});
        py::array_t<ptrdiff_t> parents({count, py::ssize_t{2}});
        py::array_t<double> weight(count);
        line.new_position = grit_mutable_view_of(new_position.mutable_data(), 2, 1);
        if (!history.is_none())
            line.new_history = grit_mutable_view_of(new_history.mutable_data(), 2, 1);
        line.parents = parents.mutable_data();
        line.weight = weight.mutable_data();
        const grit_status status = grit_penalty_remesh(
            &line, workspace.data(), workspace.size() * sizeof(double), &count, &error);
        if (attempt == 0 && status == GRIT_BAD_CALL && count > line.capacity) continue;
        check(status, error);
        const py::slice part(0, count, 1);
        py::dict out;
        out["position"] = new_position[part];
        out["parents"] = parents[part];
        out["weight"] = weight[part];
        if (!history.is_none()) out["history"] = new_history[part];
        return out;
    }
}

}  // namespace

void add_penalty(py::module_& module) {
    using py::arg;
    const py::none none;
    PYBIND11_NUMPY_DTYPE(grit_penalty_report, state, segment, place, gap, normal, area,
                         normal_traction, tangential_traction, slip_rate);
    module.attr("PENALTY_OPEN") = static_cast<int>(GRIT_PENALTY_OPEN);
    module.attr("PENALTY_STICK") = static_cast<int>(GRIT_PENALTY_STICK);
    module.attr("PENALTY_SLIP") = static_cast<int>(GRIT_PENALTY_SLIP);
    module.def("penalty_forces", &forces, arg("position_a"), arg("position_b"), py::kw_only(),
               arg("normal_stiffness"), arg("depth_max"), arg("tangential_stiffness") = 0.0,
               arg("friction_coefficient") = 0.0, arg("time_step") = 0.0, arg("velocity_a") = none,
               arg("velocity_b") = none, arg("history_a") = none, arg("history_b") = none,
               arg("closed_a") = false, arg("closed_b") = false, arg("axisymmetric") = false,
               forces_doc);
    module.def("penalty_stiffness", &stiffness, arg("multiple"), arg("modulus"), arg("cell_size"),
               "eps_n = multiple * modulus / cell_size [stress/length], (S2), with the P-wave "
               "modulus [stress] of the "
               "softer\nbody and the cell [length] of the grid; multiple 0 means 1.");
    module.def(
        "penalty_flush_stiffness", &flush_stiffness, arg("position"), py::kw_only(),
        arg("normal_stiffness"), arg("tangential_stiffness") = 0.0,
        arg("friction_coefficient") = 0.0, arg("closed") = false, arg("axisymmetric") = false,
        "Stiffness (n,) that each vertex (n, 2) [length] would have if the whole line were in "
        "flush contact:\n"
        "eps_n, with friction max(eps_n, eps_t), times half its two segments (times r), before "
        "there is any contact.");
    module.def("penalty_stable_step", &stable_step, arg("mass_a"), arg("stiffness_a"),
               arg("mass_b") = none, arg("stiffness_b") = none,
               "2 / sqrt(max_A k/m + max_B k/m) [time], (S5), of masses (n,) and stiffnesses (n,) "
               "at nodes; without B "
               "of a body\nthat touches what cannot move. inf without stiffness.");
    module.def("penalty_remesh", &remesh, arg("position"), py::kw_only(), arg("longest"),
               arg("shortest") = 0.0, arg("tolerance") = 0.0, arg("closed") = false,
               arg("history") = none, remesh_doc);
}

}  // namespace grit_python
