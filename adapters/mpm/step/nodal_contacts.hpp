// SPDX-License-Identifier: BSD-3-Clause
// All contacts at nodes, one after the other.
#pragma once

#include <vector>

#include "adapters/mpm/step/contact_pair.hpp"
#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/surface_contacts.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

class NodalContacts {
  public:
    NodalContacts(Model& of, Water& in_pores) : model(of), water(in_pores) {}
    void add(const ContactLaw& law) {
        contacts.emplace_back(law, model.settings, model.grid(), model.fixed_nodes);
        pore.emplace_back();
    }
    // Velocities after the momentum update become those after contact; adds what it took and what rigid bodies did.
    void correct(Energy& sums);
    // After all contacts: implicit pore pressures change, borne by the bodies that press.
    void change_pressures(SurfaceContacts& surfaces);

    const ContactPair& operator[](std::size_t i) const { return contacts[i]; }
    // Of implicit pore pressures on b beyond those of the start of the step, in the last one.
    const Faces& pore_faces(std::size_t i) const { return pore[i]; }
    std::size_t count() const { return contacts.size(); }
    template <class Self, class Archive> static void visit(Self& of, Archive& archive) {
        for (auto& contact : of.contacts) ContactPair::visit(contact, archive);
        for (auto& faces : of.pore) archive.value(faces);
    }

  private:
    ContactBody body(std::size_t i);
    void join(ContactPair& contact);
    void part(const ContactPair& contact);

    Model& model;
    Water& water;
    std::vector<ContactPair> contacts;
    std::vector<Faces> pore;  // of each
};

}  // namespace grit::mpm
