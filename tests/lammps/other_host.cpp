// SPDX-License-Identifier: BSD-3-Clause
// A host that says it is some version, with nothing behind its handle: other_host LIBRARY VERSION. Prints what
// the library registers as a plugin. Its exit status is that of adding the fix; 0 where that is not tried.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

namespace {

int version = 0;

// lammpsplugin_t, as lammpsplugin.h declares it.
struct Plugin {
    const char *version, *style, *name, *info, *author;
    void* creator;
    void* handle;
};

void accept(const Plugin* plugin, void*) {
    std::printf("plugin %s %s for %s%s\n", plugin->style, plugin->name, plugin->version,
                plugin->creator && plugin->handle == &version ? "" : ", incomplete");
}

}  // namespace

extern "C" int lammps_version(void*) { return version; }

int main(int, char** argv) {
    version = std::atoi(argv[2]);
    void* library = dlopen(argv[1], RTLD_NOW);
    if (!library) {
        std::fprintf(stderr, "%s\n", dlerror());
        return 2;
    }
    using Add = int (*)(void*);
    using Init = void (*)(void*, void*, void*);
    const auto add = reinterpret_cast<Add>(dlsym(library, "grit_lammps_add"));
    const auto init = reinterpret_cast<Init>(dlsym(library, "lammpsplugin_init"));
    init(nullptr, &version, reinterpret_cast<void*>(&accept));
    return version == 20210929 ? 0 : add(nullptr);
}
