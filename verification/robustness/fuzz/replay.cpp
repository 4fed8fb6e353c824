// SPDX-License-Identifier: BSD-3-Clause
// A fuzzer without libFuzzer, for the tests: what stands in files or folders, each as it is and then changed at random in N
// ways that depend on nothing else. The program ends where something must not be, and fails where a reader refuses a file, or
// takes one whose name ends in _refused.
//
//   fuzz_x [-N] [-any] FILE|FOLDER...    -any: beside them, files of any bytes
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "robustness/fuzz/refusal.hpp"
#include "support/trials/split_mix.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

void give(const std::string& bytes) {
    // Exactly as long: what is read beyond is seen by sanitizers.
    const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
    if (LLVMFuzzerTestOneInput(copy.data(), copy.size()) != 0) fuzz::refusal = "is not looked at";
}

// Is it taken, or refused, as its name says?
bool leads_somewhere(const fs::path& file, const std::string& bytes) {
    fuzz::refusal.clear();
    give(bytes);
    const bool is_to_be_refused = file.filename().string().ends_with("_refused");
    if (is_to_be_refused != fuzz::refusal.empty()) return true;
    std::fprintf(stderr, "%s: %s\n", file.c_str(),
                 is_to_be_refused ? "is not refused" : fuzz::refusal.c_str());
    return false;
}

std::string changed(std::string bytes, const std::string& other, grit::SplitMix& random) {
    for (int i = 1 + random.below(8); i > 0; --i) {
        const int n = static_cast<int>(bytes.size());
        const auto place = static_cast<std::size_t>(random.below(n + 1));
        const auto length = 1 + static_cast<std::size_t>(random.below(16));
        switch (random.below(6)) {
            case 0:
                if (place < bytes.size()) bytes[place] ^= static_cast<char>(1 << random.below(8));
                break;
            case 1: bytes.insert(place, 1, static_cast<char>(random.below(256))); break;
            case 2: bytes.erase(place, length); break;
            case 3:
                for (std::size_t k = place; k < std::min(bytes.size(), place + length); ++k)
                    bytes[k] = static_cast<char>(random.below(256));
                break;
            case 4:
                bytes.insert(place,
                             bytes.substr(static_cast<std::size_t>(random.below(n + 1)), length));
                break;
            default:
                bytes.insert(place, other.substr(static_cast<std::size_t>(random.below(
                                                     static_cast<int>(other.size()) + 1)),
                                                 length));
        }
    }
    return bytes;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<fs::path> files;
    int times = 0;
    bool any = false;
    for (int i = 1; i < argc; ++i) {
        if (argv[i] == std::string("-any")) any = true;
        else if (argv[i][0] == '-') times = std::atoi(argv[i] + 1);
        else if (fs::is_directory(argv[i]))
            for (const auto& entry : fs::directory_iterator(argv[i])) files.push_back(entry.path());
        else files.emplace_back(argv[i]);
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> seeds;
    for (const fs::path& file : files) {
        std::ifstream in(file, std::ios::binary);
        if (!in) {
            std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
            return 2;
        }
        seeds.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    if (any) {
        grit::SplitMix random(0);
        for (int i = 0; i < 16; ++i) {
            std::string& seed = seeds.emplace_back(512, '\0');
            for (char& each : seed) each = static_cast<char>(random.below(256));
        }
    }
    if (seeds.empty()) {
        std::fprintf(stderr, "no file to begin with\n");
        return 2;
    }
    grit::SplitMix random(1);
    int dead = 0;
    for (std::size_t i = 0; i < files.size(); ++i) dead += !leads_somewhere(files[i], seeds[i]);
    for (std::size_t i = files.size(); i < seeds.size(); ++i) give(seeds[i]);
    for (int i = 0; i < times; ++i) {
        const std::string& seed =
            seeds[static_cast<std::size_t>(random.below(static_cast<int>(seeds.size())))];
        const std::string& other =
            seeds[static_cast<std::size_t>(random.below(static_cast<int>(seeds.size())))];
        give(changed(seed, other, random));
    }
    std::printf("%zu files, %d changed ones\n", files.size(), times);
    return dead == 0 ? 0 : 1;
}
