// SPDX-License-Identifier: BSD-3-Clause
// What both corrections check before a node is touched, and how a bad node is put into words.
#pragma once

#include <cstddef>

#include <grit/contact.h>

namespace grit {

grit_contact_options default_contact_options();

// Options as the caller knows them over the defaults; null gives the defaults. Not judged yet.
grit_status read_given_options(const grit_contact_options* caller, grit_contact_options& ours,
                               grit_error* error);

// The same, judged.
grit_status read_options(const grit_contact_options* caller, grit_contact_options& ours,
                         grit_error* error);

grit_status check_contact_options(const grit_contact_options& options, grit_error* error);

// Views that are needed, and strides of those that are written.
grit_status check_nodes(const grit_contact_nodes& nodes, const grit_contact_options& options,
                        std::ptrdiff_t n, grit_error* error);

// The error of node i, found again in the numbers that the kernel saw.
grit_status describe_node(const grit_contact_nodes& nodes, const grit_contact_options& options,
                          std::ptrdiff_t i, grit_error* error);

}  // namespace grit
