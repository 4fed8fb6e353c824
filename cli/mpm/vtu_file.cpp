// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/vtu_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/process/cannot_write.hpp"
#include "cli/process/version.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

constexpr std::string_view byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

// RFC 4648.
std::string base64(const std::string& bytes) {
    constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve(4 * (bytes.size() / 3 + 1));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (k < have ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += k <= have ? letters[three >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default: out += c;
        }
    return out;
}

// Length and numbers as one block of base64: the header_type of the file is UInt64.
template <class Number>
void write_array(element::AtomicFile& file, std::string_view type, const std::string& attributes,
                 const std::vector<Number>& values) {
    const std::uint64_t length = values.size() * sizeof(Number);
    std::string bytes(sizeof length + length, '\0');
    std::memcpy(bytes.data(), &length, sizeof length);
    if (length > 0) std::memcpy(bytes.data() + sizeof length, values.data(), length);
    file.write(fmt::format("<DataArray type=\"{}\" {} format=\"binary\">{}</DataArray>\n", type,
                           attributes, base64(bytes)));
}

// z = 0 to pairs.
std::vector<double> in_space(const std::vector<double>& pairs) {
    std::vector<double> out;
    out.reserve(pairs.size() / 2 * 3);
    for (std::size_t i = 0; i < pairs.size(); i += 2)
        out.insert(out.end(), {pairs[i], pairs[i + 1], 0.0});
    return out;
}

void write_cells(element::AtomicFile& file, std::size_t cells, std::size_t corners_each) {
    constexpr std::uint8_t quadrilateral = 9, hexahedron = 12;
    std::vector<std::int64_t> connectivity(corners_each * cells), offsets(cells);
    for (std::size_t i = 0; i < connectivity.size(); ++i)
        connectivity[i] = static_cast<std::int64_t>(i);
    for (std::size_t i = 0; i < cells; ++i)
        offsets[i] = static_cast<std::int64_t>(corners_each * (i + 1));
    file.write("<Cells>\n");
    write_array(file, "Int64", "Name=\"connectivity\"", connectivity);
    write_array(file, "Int64", "Name=\"offsets\"", offsets);
    write_array(file, "UInt8", "Name=\"types\"",
                std::vector<std::uint8_t>(cells, corners_each == 4 ? quadrilateral : hexahedron));
    file.write("</Cells>\n");
}

std::string opening(std::string_view type) {
    return fmt::format("<?xml version=\"1.0\"?>\n<!-- Grit {} -->\n<VTKFile type=\"{}\" "
                       "version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n",
                       version(), type, byte_order);
}

constexpr std::string_view pvd_closing = "</Collection>\n</VTKFile>\n";

constexpr std::size_t page = 4096;  // the least of any system

std::vector<std::string> lines_of(const std::vector<PvdEntry>& entries) {
    std::vector<std::string> out;
    for (const PvdEntry& entry : entries)
        out.push_back(fmt::format("<DataSet timestep=\"{:.17g}\" part=\"{}\" file=\"{}\"/>\n",
                                  entry.time, entry.part, escaped(entry.file)));
    return out;
}

// Behind the text, each entry within a page while there is room; otherwise without gaps, and as much room again.
void append(std::string& text, const std::vector<PvdEntry>& frame, std::size_t& room) {
    const std::vector<std::string> lines = lines_of(frame);
    std::string within = text;
    for (const std::string& line : lines) {
        if (within.size() / page != (within.size() + line.size() - 1) / page)
            within.resize(within.size() + page - within.size() % page, ' ');
        within += line;
    }
    if (within.size() <= room) {
        text = std::move(within);
        return;
    }
    for (const std::string& line : lines) text += line;
    room = text.size() + std::max(page, text.size());
}

std::string read_begin(int file, const std::filesystem::path& place, std::size_t size) {
    std::string out(size, '\0');
    for (std::size_t done = 0; done < size;) {
        const ssize_t got = pread(file, out.data() + done, size - done, static_cast<off_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) cannot_write(place, got < 0 ? errno : EIO);
        done += static_cast<std::size_t>(got);
    }
    return out;
}

}  // namespace

void write_vtu(const std::filesystem::path& place, const VtuSheet& sheet) {
    const auto each = static_cast<std::size_t>(sheet.corners_each);
    const std::size_t cells = sheet.corners.size() / (each == 4 ? 8 : 24);
    element::AtomicFile file(place);
    file.write(opening("UnstructuredGrid"));
    file.write("<UnstructuredGrid>\n<FieldData>\n");
    write_array(file, "Float64", "Name=\"TimeValue\" NumberOfTuples=\"1\"",
                std::vector<double>{sheet.time});
    file.write(fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
                           "<Points>\n",
                           each * cells, cells));
    write_array(file, "Float64", "Name=\"corners\" NumberOfComponents=\"3\"",
                each == 4 ? in_space(sheet.corners) : sheet.corners);
    file.write("</Points>\n");
    write_cells(file, cells, each);
    file.write("<CellData>\n");
    for (const VtuArray& array : sheet.arrays)
        write_array(file, "Float64",
                    fmt::format("Name=\"{}\" NumberOfComponents=\"{}\"", escaped(array.name),
                                array.components == 2 ? 3 : array.components),
                    array.components == 2 ? in_space(array.values) : array.values);
    file.write("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    file.complete();
}

PvdFile::PvdFile(const std::filesystem::path& place,
                 const std::vector<std::vector<PvdEntry>>& frames)
    : name(place) {
    std::string text = opening("Collection") + "<Collection>\n";
    room = text.size();
    for (const std::vector<PvdEntry>& frame : frames) append(text, frame, room);
    write_whole(text);
}

void PvdFile::write_whole(const std::string& text) {
    element::AtomicFile whole(name);
    whole.write(text);
    whole.write(std::string(room - text.size(), ' '));
    whole.write(pvd_closing);
    whole.complete();
    if (file >= 0) close(file);
    file = open(name.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) cannot_write(name, errno);
    end = text.size();
}

PvdFile::~PvdFile() {
    if (file >= 0) close(file);
}

void PvdFile::add(const std::vector<PvdEntry>& frame) {
    std::string added(end % page, ' ');  // as far as pages tell
    const std::size_t before = added.size();
    const std::size_t room_now = room - (end - before);
    std::size_t room_then = room_now;
    append(added, frame, room_then);
    if (room_then != room_now) {
        std::string text = read_begin(file, name, end);
        std::size_t wider = room;
        append(text, frame, wider);
        std::swap(room, wider);
        try {
            write_whole(text);
        } catch (const element::CannotWrite&) {
            room = wider;
            throw;
        }
        return;
    }
    try {
        for (std::size_t from = before; from < added.size();) {
            const std::size_t next = std::min(added.size(), from + page - from % page);
            put(added.substr(from, next - from), end - before + from);
            from = next;
        }
    } catch (const element::CannotWrite&) {
        put(std::string(added.size() - before, ' '), end);
        throw;
    }
    end += added.size() - before;
}

// A second call is for the signals and disks that end a first one early.
void PvdFile::put(const std::string& text, std::size_t at) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written =
            pwrite(file, text.data() + done, text.size() - done, static_cast<off_t>(at + done));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) cannot_write(name, written < 0 ? errno : ENOSPC);
        done += static_cast<std::size_t>(written);
    }
}

}  // namespace cli
