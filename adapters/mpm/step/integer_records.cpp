// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/integer_records.hpp"

#include "adapters/mpm/step/column_names.hpp"

namespace grit::mpm {

void fail_share(const Body& body, const char* of_what, double t) {
    fail_share(body.name, body.particles, column_names(body.material.get(), body.water), of_what,
               t);
}

void IntegerRecords::add_to(std::vector<NodeRecord>& records, Exchange& exchange) {
    share(exchange);
    add_to(reinterpret_cast<double*>(records.data()), 0, integers.size());
}

void IntegerRecords::add_to(NodeRecord* records, int each, Exchange& exchange) {
    exchange.sum_cells(integers.data(), static_cast<std::ptrdiff_t>(integers.size()) / each, each);
    add_to(reinterpret_cast<double*>(records), 0, integers.size());
}

}  // namespace grit::mpm
