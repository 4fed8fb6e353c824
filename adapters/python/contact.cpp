// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <pybind11/numpy.h>

#include "adapters/python/arrays.hpp"
#include "adapters/python/errors.hpp"
#include "adapters/python/parts.hpp"

namespace grit_python {
namespace {

constexpr const char* correct_doc =
    R"(Take the approach velocity of bodies A and B away at n grid nodes, in place: Geo-contact, or
frictional contact. One impulse per node: momentum is kept, kinetic energy never grows but by
what a contact_stiffness holds in an overlap, half of that times its square.

    mass_a, mass_b      (n,)          nodal masses [mass]; a node of one body only is left alone
    normal              (n, c)        unit normal from A to B [-], c = 2 or 3
    velocity_a, _b      (n, c)        in: after the momentum update, out: corrected [length/time]
    distance            (n,)          s [length]: surface of the stiffer body to the node, negative
                                      inside, +inf for none (not for frictional contact)
    cell_size           (n,)          d [length], the cell along the normal; or
    spacing             (c,), (n, c)  edges of the cell [length]
    gap                 (n,)          surface of A to that of B along the normal [length]
    contact_area        (n,)          [area], with adhesion or contact_stiffness
    pore_impulse        (n,)          of pore water between the bodies, which does not rub [mass velocity]
    acceleration_a, _b  (n, c)        corrected alike; needs time_step
    index               (m,) int64    the nodes to be taken
    law                 "geo" or "frictional"
    penalty_power       k [-], 6      friction_coefficient  mu [-], 0
    adhesion            [stress], 0   time_step             [time], 0: not given
    relaxation_time     [time], 0: the step
    contact_stiffness   [stress/length], 0: none; needs gap and contact_area
    rigid               None, "a" or "b"
    allow_zero_normal   a node with a zero normal is open

Returns the reports (m,), a structured array: status, state (INACTIVE, OPEN, STICK, SLIP),
penalty_factor, impulse (3,) on B, force (3,) on B, energies. Arrays as in Sand.update. Raises BadCall or
BadState and changes nothing, if any shape, dtype or value is bad.)";

int law_of(const std::string& law) {
    if (law != "geo" && law != "frictional")
        refuse("law must be \"geo\" or \"frictional\", got \"%s\"", law.c_str());
    return law == "geo" ? GRIT_CONTACT_GEO : GRIT_CONTACT_FRICTIONAL;
}

int rigid_of(const py::object& rigid) {
    if (rigid.is_none()) return GRIT_CONTACT_NONE_RIGID;
    const std::string body = py::str(rigid);
    if (body != "a" && body != "b")
        refuse("rigid must be None, \"a\" or \"b\", got \"%s\"", body.c_str());
    return body == "a" ? GRIT_CONTACT_A_RIGID : GRIT_CONTACT_B_RIGID;
}

py::array correct(const py::object& mass_a, const py::object& mass_b, const py::object& normal,
                  const py::object& velocity_a, const py::object& velocity_b,
                  const py::object& distance, const py::object& cell_size,
                  const py::object& spacing, const py::object& gap, const py::object& contact_area,
                  const py::object& pore_impulse, const py::object& acceleration_a,
                  const py::object& acceleration_b, const py::object& index, const std::string& law,
                  double penalty_power, double friction_coefficient, double adhesion,
                  double time_step, double relaxation_time, double contact_stiffness,
                  const py::object& rigid, bool allow_zero_normal) {
    Arrays arrays("normal", normal, {2, 3});
    const int c = arrays.components();
    for (const auto& [name, object] : {std::pair{"mass_a", &mass_a},
                                       {"mass_b", &mass_b},
                                       {"velocity_a", &velocity_a},
                                       {"velocity_b", &velocity_b}})
        if (object->is_none()) refuse("%s must be a NumPy array of float64, got None", name);
    grit_contact_options options{};
    check(grit_contact_options_init(&options, sizeof options), "grit_contact_options_init");
    options.components = c;
    options.law = law_of(law);
    options.penalty_power = penalty_power;
    options.friction_coefficient = friction_coefficient;
    options.adhesion = adhesion;
    options.time_step = time_step;
    options.relaxation_time = relaxation_time;
    options.contact_stiffness = contact_stiffness;
    options.rigid = rigid_of(rigid);
    options.allow_zero_normal = allow_zero_normal;
    grit_contact_nodes nodes{};
    nodes.struct_size = sizeof nodes;
    nodes.mass_a = arrays.read("mass_a", mass_a, 0);
    nodes.mass_b = arrays.read("mass_b", mass_b, 0);
    nodes.normal = arrays.read("normal", normal, c);
    nodes.distance = arrays.read("distance", distance, 0);
    nodes.cell_size = arrays.read("cell_size", cell_size, 0);
    nodes.spacing = arrays.read_same_or_each("spacing", spacing, c);
    nodes.gap = arrays.read("gap", gap, 0);
    nodes.contact_area = arrays.read("contact_area", contact_area, 0);
    nodes.pore_impulse = arrays.read("pore_impulse", pore_impulse, 0);
    nodes.velocity_a = arrays.write("velocity_a", velocity_a, c);
    nodes.velocity_b = arrays.write("velocity_b", velocity_b, c);
    nodes.acceleration_a = arrays.write("acceleration_a", acceleration_a, c);
    nodes.acceleration_b = arrays.write("acceleration_b", acceleration_b, c);
    nodes.index = arrays.read_index(index);
    arrays.check_overlap();
    py::array_t<grit_contact_report> reports(arrays.taken());
    grit_contact_report* report = reports.mutable_data();
    std::fill_n(report, arrays.taken(), grit_contact_report{});
    grit_error error{};
    grit_status status = GRIT_OK;
    {
        const py::gil_scoped_release others_may_run;
        options.validate_only = 1;  // so that bad input of one node changes no other
        status = grit_contact_correct(&options, arrays.taken(), &nodes, report, nullptr, &error);
        options.validate_only = 0;
        if (status == GRIT_OK)
            status =
                grit_contact_correct(&options, arrays.taken(), &nodes, report, nullptr, &error);
    }
    if (status != GRIT_OK) raise(error, "reports", reports);
    return reports;
}

double penalty_factor(double s, double d, double k) {
    double f_p = 0.0;
    check(grit_contact_penalty_factor(s, d, k, &f_p),
          "penalty_factor: s must be > -inf [length], d > 0 [length], k in (0, 1e6]");
    return f_p;
}

}  // namespace

void add_contact(py::module_& module) {
    using py::arg;
    const py::none none;
    PYBIND11_NUMPY_DTYPE(grit_contact_report, status, state, penalty_factor, impulse, force,
                         trial_energy_normal, trial_energy_tangential, dissipation_normal,
                         dissipation_tangential);
    module.def("contact_correct", &correct, arg("mass_a"), arg("mass_b"), arg("normal"),
               arg("velocity_a"), arg("velocity_b"), py::kw_only(), arg("distance") = none,
               arg("cell_size") = none, arg("spacing") = none, arg("gap") = none,
               arg("contact_area") = none, arg("pore_impulse") = none, arg("acceleration_a") = none,
               arg("acceleration_b") = none, arg("index") = none, arg("law") = "geo",
               arg("penalty_power") = 6.0, arg("friction_coefficient") = 0.0, arg("adhesion") = 0.0,
               arg("time_step") = 0.0, arg("relaxation_time") = 0.0, arg("contact_stiffness") = 0.0,
               arg("rigid") = none, arg("allow_zero_normal") = false, correct_doc);
    module.def(
        "penalty_factor", &penalty_factor, arg("s"), arg("d"), arg("k") = 6.0,
        "f_p = 1 - (min(max(s, 0), d)/d)^k [-] at the distance s [length] in a cell d [length].");
    module.attr("INACTIVE") = static_cast<int>(GRIT_CONTACT_INACTIVE);
    module.attr("OPEN") = static_cast<int>(GRIT_CONTACT_OPEN);
    module.attr("STICK") = static_cast<int>(GRIT_CONTACT_STICK);
    module.attr("SLIP") = static_cast<int>(GRIT_CONTACT_SLIP);
}

}  // namespace grit_python
