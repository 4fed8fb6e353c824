// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/run_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include "adapters/mpm/io/archive.hpp"
#include "adapters/mpm/io/checksum.hpp"

namespace grit::lammps {
namespace {

constexpr std::uint64_t format = 0x677269746d706d08;  // "gritmpm", 8

// In front: LAMMPS hands over no length, so that this one must be believed.
struct Head {
    std::uint64_t size, not_size;  // of what follows [bytes], and all its bits turned round
    std::uint64_t sum;             // of what follows
};

}  // namespace

std::string to_bytes(const StoredRun* run, std::uint64_t fingerprint) {
    mpm::ByteWriter writer, head;
    writer.value(format);
    writer.value(fingerprint);
    writer.value(static_cast<std::uint64_t>(run ? 1 : 0));
    if (run) StoredRun::visit(*run, writer);
    const auto size = static_cast<std::uint64_t>(writer.out.size());
    head.value(Head{size, ~size, mpm::checksum(writer.out.data(), writer.out.size())});
    return head.out + writer.out;
}

std::unique_ptr<StoredRun> from_bytes(const char* bytes, std::uint64_t fingerprint) {
    Head head{};
    std::memcpy(&head, bytes, sizeof head);
    if (head.size != ~head.not_size || head.sum != mpm::checksum(bytes + sizeof head, head.size))
        throw std::runtime_error("the restart file is damaged, or of another version of Grit");
    mpm::ByteReader reader(bytes + sizeof head, head.size);
    std::uint64_t stamp = 0, of_words = 0, has_begun = 0;
    reader.value(stamp);
    if (stamp != format) throw std::runtime_error("the restart file is of another version of Grit");
    reader.value(of_words);
    if (of_words != fingerprint)
        throw std::runtime_error("the restart file is of a fix with other words; only names of "
                                 "files and threads may change");
    reader.value(has_begun);
    if (has_begun == 0) return nullptr;
    auto out = std::make_unique<StoredRun>();
    StoredRun::visit(*out, reader);
    constexpr std::size_t most = 1 << 20;  // bodies and contacts have some each
    if (out->nodes.words_each > most)
        throw std::runtime_error("the restart file is damaged: nodes have " +
                                 std::to_string(out->nodes.words_each) + " words");
    return out;
}

}  // namespace grit::lammps
