// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/registration.hpp"

#include <cstdio>

#include <library.h>

#include "adapters/lammps/fix_grit_mpm.hpp"
#include "adapters/lammps/shim/host.hpp"
#include "adapters/lammps/version.hpp"

namespace {

using LAMMPS_NS::Fix;
using LAMMPS_NS::LAMMPS;

constexpr const char* style = "grit/mpm";

Fix* make_fix(LAMMPS* host, int count, char** words) {
    return new grit::lammps::FixGritMpm(host, count, words);
}

void add_fix_style(LAMMPS* host) { (*host->modify->fix_map)[style] = &make_fix; }

class GritCommand : public LAMMPS_NS::Command {
  public:
    using Command::Command;
    void command(int, char**) override { add_fix_style(lmp); }
};

LAMMPS_NS::Command* make_command(LAMMPS* host) { return new GritCommand(host); }

// As lammpsplugin.h of the hosts that have plugins declares it.
struct Plugin {
    const char *version, *style, *name, *info, *author;
    union {
        void* (*of_one)(void*);
        void* (*of_fix)(void*, int, char**);
    } creator;
    void* handle;
};

void* make_plugin_fix(void* host, int count, char** words) {
    return make_fix(static_cast<LAMMPS*>(host), count, words);
}

}  // namespace

int grit_lammps_add(void* lammps) {
    const std::string why = grit::lammps::refusal(lammps_version(lammps));
    if (!why.empty()) {
        std::fprintf(stderr, "ERROR: %s\n", why.c_str());
        return 1;
    }
    auto* host = static_cast<LAMMPS*>(lammps);
    add_fix_style(host);
    (*host->input->command_map)["grit"] = &make_command;
    return 0;
}

void lammpsplugin_init(void* lammps, void* handle, void* register_plugin) {
    const std::string why = grit::lammps::refusal(lammps_version(lammps));
    if (!why.empty()) {
        std::fprintf(stderr, "ERROR: %s\n", why.c_str());
        return;
    }
    const Plugin plugin{.version = "29 Sep 2021",
                        .style = "fix",
                        .name = style,
                        .info = "material points of Grit",
                        .author = "the authors of Grit",
                        .creator = {.of_fix = &make_plugin_fix},
                        .handle = handle};
    using Register = void (*)(const Plugin*, void*);
    reinterpret_cast<Register>(register_plugin)(&plugin, lammps);
}
