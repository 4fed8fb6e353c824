// SPDX-License-Identifier: BSD-3-Clause
// A host that says it is another version: it must come to no harm, for there is nothing behind its handle.
#include <dlfcn.h>

#include <cstdio>

extern "C" int lammps_version(void*) { return 20230802; }

int main(int, char** argv) {
    void* library = dlopen(argv[1], RTLD_NOW);
    if (!library) {
        std::fprintf(stderr, "%s\n", dlerror());
        return 2;
    }
    using Add = int (*)(void*);
    using Init = void (*)(void*, void*, void*);
    const auto add = reinterpret_cast<Add>(dlsym(library, "grit_lammps_add"));
    const auto init = reinterpret_cast<Init>(dlsym(library, "lammpsplugin_init"));
    init(nullptr, nullptr, nullptr);
    return add(nullptr) == 1 ? 0 : 1;
}
