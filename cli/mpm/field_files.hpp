// SPDX-License-Identifier: BSD-3-Clause
// A time series of fields for ParaView: STEM_000012_sand.vtu, one file for each body and time, and
// STEM.pvd, the list of all, which is complete after every time.
#pragma once

#include <filesystem>
#include <optional>

#include "cli/mpm/fields.hpp"
#include "cli/mpm/vtu_file.hpp"

namespace cli {

class MpmFieldFiles {
  public:
    // stem: folder and name without ending. The fields outlive this.
    MpmFieldFiles(std::filesystem::path stem, std::vector<MpmField> variables,
                  const ShownFields& fields);

    // The simulation as it is now. Throws element::CannotWrite.
    void write();
    // Of what has been written [s]; what a run must know to go on.
    const std::vector<double>& times() const { return written; }
    void resume(std::vector<double> times) { written = std::move(times); }

  private:
    void begin_list();
    std::vector<PvdEntry> entries_of(std::size_t frame) const;
    std::string file_name(std::size_t frame, std::size_t body) const;

    std::filesystem::path stem;
    std::vector<MpmField> variables;
    const ShownFields& fields;
    std::vector<std::string> body_names;  // for files, all different
    std::vector<double> written;
    std::optional<PvdFile> list;  // from the first frame of this program on
};

}  // namespace cli
