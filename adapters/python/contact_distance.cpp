// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include <pybind11/numpy.h>

#include "adapters/python/arrays.hpp"
#include "adapters/python/errors.hpp"
#include "adapters/python/parts.hpp"

namespace grit_python {
namespace {

constexpr const char* surfaces_doc =
    R"(Surfaces of bodies A and B as n grid nodes see them: the distance s and the gap of contact_correct, (C3) and (C4) of
docs/contact.md, from the domains of the particles.

    position            (n, c)      of the nodes [length], c = 2 or 3
    normal              (n, c)      unit normals from A to B, zero where undefined
    centres             True: also the distances to the nearest centres

Position and normal are kept, not copied: leave them as they are until all is added.

    surface             (n, 2)      distance from the surface of A, of B to the node along the normal, negative inside
                                    [length]: smallest (x_node - x).n over the corners x of A's particles, smallest
                                    (x - x_node).n over those of B's; +inf at first. Processes reduce it by minimum.
    centre              (n, 2)      smallest |x_p - x_node| of A's, of B's particles, or None)";

constexpr const char* add_doc =
    R"(Add m particles of one body, in place: smaller distances replace larger ones.

    body                "a" or "b"
    position            (m, c)      of the particles [length]
    node                (m, k)      integers: nodes where the particle has weight, -1: none; or (l,) with
    offset              (m + 1,)    integers: particle p has node[offset[p]] ... node[offset[p + 1] - 1]
    side                (m, k, c)   k = 1 ... 3 half-sides r_j of the domain [length], whose farthest corner along n is at
                                    x_p.n + sum_j |r_j.n|; None: points

Raises BadCall or BadState and changes nothing, if any shape, dtype or value is bad.)";

constexpr const char* distance_doc =
    R"(s (n,) [length] from the surface of the stiffer body, "a" or "b": +inf where none of its particles reached the node.
measure: "support", signed, (C4); "edge", the absolute value of that; "nearest centre", for which the surfaces need centres.)";

int body_of(const char* name, const std::string& body) {
    if (body != "a" && body != "b")
        refuse("%s must be \"a\" or \"b\", got \"%s\"", name, body.c_str());
    return body == "a" ? GRIT_CONTACT_BODY_A : GRIT_CONTACT_BODY_B;
}

class Surfaces {
  public:
    // Nothing where Python makes an instance without __init__.
    static void* operator new(std::size_t size) {
        return std::memset(::operator new(size), 0, size);
    }
    static void* operator new(std::size_t, void* place) { return place; }

    Surfaces(const py::object& position, const py::object& normal, bool centres)
        : nodes("position", position, {2, 3}, false), view{} {
        const int c = nodes.components();
        if (normal.is_none()) refuse("normal must be a NumPy array of float64, got None");
        view.struct_size = sizeof view;
        view.components = c;
        view.nodes = nodes.points();
        view.position = nodes.read("position", position, c);
        view.normal = nodes.read("normal", normal, c);
        surface = minima();
        if (centres) centre = minima();
        grit_error error{};
        const grit_contact_surfaces all = viewed();
        check(grit_contact_surfaces_reset(&all, &error), error);
    }

    void add(const std::string& body, const py::object& position, const py::object& node,
             const py::object& offset, const py::object& side) {
        const grit_contact_surfaces all = viewed();
        Arrays arrays("position", position, {view.components}, false);
        grit_contact_domains domains{};
        domains.struct_size = sizeof domains;
        domains.body = body_of("body", body);
        domains.position = arrays.read("position", position, view.components);
        const WholeNumbers list = whole_numbers("node", node);
        std::vector<ptrdiff_t> parts;
        if (!offset.is_none()) {
            parts = offsets("offset", offset, static_cast<py::ssize_t>(list.values.size()));
            if (static_cast<py::ssize_t>(parts.size()) != arrays.points() + 1)
                refuse("offset must be (%td,), got (%td,)", arrays.points() + 1,
                       static_cast<py::ssize_t>(parts.size()));
            domains.offset = parts.data();
        } else if (list.shape.size() != 2 || list.shape[0] != arrays.points()) {
            refuse("node must be (%td, k), or have an offset, got %s", arrays.points(),
                   shape_text(list.shape).c_str());
        } else {
            domains.nodes_each = list.shape[1];
        }
        domains.node = list.values.data();
        if (!side.is_none()) {
            const py::array sides = py::array::ensure(side);
            if (!sides || sides.ndim() != 3 || sides.shape(1) < 1 || sides.shape(1) > 3)
                refuse("side must be (%td, k, %d), k = 1 ... 3", arrays.points(), view.components);
            domains.sides = static_cast<int>(sides.shape(1));
            domains.side = arrays.read_matrix("side", side, sides.shape(1), view.components);
        }
        const py::array_t<double> surface_before(surface.attr("copy")());
        const py::object centre_before = centre.is_none() ? centre : centre.attr("copy")();
        grit_error error{};
        grit_status status = GRIT_OK;
        {
            const py::gil_scoped_release others_may_run;
            status = grit_contact_surfaces_add(&all, arrays.points(), &domains, &error);
        }
        if (status == GRIT_OK) return;
        std::copy_n(surface_before.data(), surface.size(), surface.mutable_data());
        if (!centre.is_none()) centre.attr("__setitem__")(py::ellipsis(), centre_before);
        raise(error);
    }

    void merge(const Surfaces& from) {
        const grit_contact_surfaces into = viewed(), other = from.viewed();
        const py::object equal = py::module_::import("numpy").attr("array_equal");
        for (const char* name : {"position", "normal"})
            if (!equal(nodes.array(name), from.nodes.array(name)).cast<bool>())
                refuse("other has surfaces of nodes with another %s", name);
        grit_error error{};
        check(grit_contact_surfaces_merge(&into, &other, &error), error);
    }

    py::object shown(const py::object& array) const {
        viewed();
        return array.is_none() ? array : array.attr("view")();
    }

    py::array distance(const std::string& stiffer, const std::string& measure) const {
        grit_contact_distances wanted{};
        wanted.stiffer = body_of("stiffer", stiffer);
        const std::vector<std::string> words{"support", "edge", "nearest centre"};
        const auto at = std::find(words.begin(), words.end(), measure);
        if (at == words.end())
            refuse("measure must be \"support\", \"edge\" or \"nearest centre\", got \"%s\"",
                   measure.c_str());
        wanted.measure = static_cast<int>(at - words.begin());
        return finished(wanted, wanted.distance);
    }

    py::array gap() const {
        grit_contact_distances wanted{};
        return finished(wanted, wanted.gap);
    }

    py::array_t<double> surface;
    py::object centre = py::none();

  private:
    py::array_t<double> minima() const {
        return py::array_t<double>({nodes.points(), py::ssize_t{2}});
    }

    grit_contact_surfaces viewed() const {
        if (view.struct_size == 0) refuse("these ContactSurfaces were never made: call the class");
        grit_contact_surfaces all = view;
        const auto seen = [](const py::object& array) {
            auto own = py::reinterpret_borrow<py::array_t<double>>(array);
            return grit_mutable_view_of(own.mutable_data(), 2, 1);
        };
        all.surface = seen(surface);
        if (!centre.is_none()) all.centre = seen(centre);
        return all;
    }

    py::array finished(grit_contact_distances& wanted, grit_mutable_view& out) const {
        wanted.struct_size = sizeof wanted;
        const grit_contact_surfaces all = viewed();
        py::array_t<double> numbers(nodes.points());
        out = grit_mutable_view_of(numbers.mutable_data(), 1, 1);
        grit_error error{};
        check(grit_contact_surfaces_finish(&all, nodes.points(), &wanted, &error), error);
        return numbers;
    }

    Arrays nodes;
    grit_contact_surfaces view;
};

}  // namespace

void add_contact_distance(py::module_& module) {
    using py::arg;
    const py::none none;
    py::class_<Surfaces>(module, "ContactSurfaces", surfaces_doc)
        .def("__reduce_ex__", &reduce)
        .def(py::init<const py::object&, const py::object&, bool>(), arg("position"), arg("normal"),
             arg("centres") = false)
        .def("add", &Surfaces::add, arg("body"), arg("position"), arg("node"), py::kw_only(),
             arg("offset") = none, arg("side") = none, add_doc)
        .def("merge", &Surfaces::merge, arg("other"),
             "The smaller of these and other's minima, in place: threads fill surfaces of their "
             "own.")
        .def("distance", &Surfaces::distance, arg("stiffer"), arg("measure") = "support",
             distance_doc)
        .def("gap", &Surfaces::gap,
             "Gap (n,) from the surface of A to that of B along the normal [length], negative: "
             "overlap; +inf unless\n"
             "both bodies reached the node.")
        // Views, which nobody can give another size.
        .def_property_readonly("surface",
                               [](const Surfaces& self) { return self.shown(self.surface); })
        .def_property_readonly("centre",
                               [](const Surfaces& self) { return self.shown(self.centre); });
}

}  // namespace grit_python
