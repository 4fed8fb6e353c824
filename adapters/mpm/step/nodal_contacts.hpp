// SPDX-License-Identifier: BSD-3-Clause
// All contacts at nodes, one after the other.
#pragma once

#include <vector>

#include "adapters/mpm/step/contact_pair.hpp"
#include "adapters/mpm/step/model.hpp"

namespace grit::mpm {

class NodalContacts {
  public:
    explicit NodalContacts(Model& of) : model(of) {}
    void add(const ContactLaw& law) {
        contacts.emplace_back(law, model.settings, model.grid(), model.fixed_nodes);
    }
    // Velocities after the momentum update become those after contact; adds what it took and what rigid bodies did.
    void correct(Energy& sums);

    const ContactPair& operator[](std::size_t i) const { return contacts[i]; }
    std::size_t count() const { return contacts.size(); }
    template <class Self, class Archive> static void visit(Self& of, Archive& archive) {
        for (auto& contact : of.contacts) ContactPair::visit(contact, archive);
    }

  private:
    ContactBody body(std::size_t i);

    Model& model;
    std::vector<ContactPair> contacts;
};

}  // namespace grit::mpm
