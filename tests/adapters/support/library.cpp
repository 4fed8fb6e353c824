// SPDX-License-Identifier: BSD-3-Clause
#include "support/library.hpp"

#include <dlfcn.h>

#include <map>
#include <stdexcept>
#include <string>

namespace {

std::map<std::string, void*>& loaded() {
    static std::map<std::string, void*> handles;
    return handles;
}

}  // namespace

void* symbol_of(const char* library, const char* name) {
    void*& handle = loaded()[library];
    if (!handle) handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (!handle) throw std::runtime_error(dlerror());
    return dlsym(handle, name);
}

void unload(const char* library) {
    void*& handle = loaded()[library];
    if (handle && dlclose(handle) != 0) throw std::runtime_error(dlerror());
    handle = nullptr;
}
