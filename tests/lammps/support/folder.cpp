// SPDX-License-Identifier: BSD-3-Clause
#include "support/folder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

Folder::Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "grit_lammps_XXXXXX").string();
    place = ::mkdtemp(name.data());
}

Folder::~Folder() { std::filesystem::remove_all(place); }

void Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(place / name) << text;
}

std::string Folder::read(const std::string& name) const {
    std::ostringstream out;
    out << std::ifstream(place / name).rdbuf();
    return out.str();
}

Answer Folder::run(const std::string& command) const {
    Answer out;
    const std::string all = "cd '" + place.string() + "' && { " + command + "; } 2>&1";
    std::FILE* pipe = ::popen(all.c_str(), "r");
    if (!pipe) return out;
    char chunk[4096];
    while (const std::size_t size = std::fread(chunk, 1, sizeof chunk, pipe))
        out.text.append(chunk, size);
    const int status = ::pclose(pipe);
    out.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return out;
}
