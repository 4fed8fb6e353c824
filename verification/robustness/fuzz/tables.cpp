// SPDX-License-Identifier: BSD-3-Clause
// Tables that people hand over: CSV of any country, workbooks, folders of incrementalDriver. The first letter says which; parts
// are separated by lines "====".
#include <zip.h>

#include <cstdint>
#include <string>

#include "cli/process/exit_code.hpp"
#include "cli/table/foreign_columns.hpp"
#include "cli/table/sheet.hpp"
#include "cli/table/table.hpp"
#include "cli/table/workbook.hpp"
#include "element/incremental_driver/classic_props.hpp"
#include "element/incremental_driver/initial_conditions.hpp"
#include "element/incremental_driver/lines.hpp"
#include "element/incremental_driver/parameters.hpp"
#include "element/incremental_driver/test_file.hpp"
#include "robustness/fuzz/refusal.hpp"
#include "robustness/fuzz/scratch.hpp"

namespace {

using fuzz::part_of;
using fuzz::scratch;

// A workbook of these parts, as laboratories' programs write them.
std::filesystem::path workbook_of(const std::string& text) {
    std::filesystem::path path = scratch().path() / "book.xlsx";
    std::filesystem::remove(path);
    zip_t* zip = zip_open(path.c_str(), ZIP_CREATE, nullptr);
    constexpr const char* names[] = {"xl/worksheets/sheet1.xml", "xl/workbook.xml",
                                     "xl/_rels/workbook.xml.rels", "xl/sharedStrings.xml",
                                     "xl/styles.xml"};
    constexpr const char* otherwise[] = {
        "", R"(<workbook><sheets><sheet name="A" r:id="rId1"/></sheets></workbook>)",
        R"(<Relationships><Relationship Id="rId1" Target="worksheets/sheet1.xml"/></Relationships>)",
        "<sst><si><t>p</t></si></sst>", ""};
    std::string parts[5];
    for (std::size_t i = 0; i < 5; ++i) {
        parts[i] = part_of(text, i);
        if (parts[i].empty()) parts[i] = otherwise[i];
        if (parts[i].empty()) continue;
        const zip_int64_t at = zip_file_add(
            zip, names[i], zip_source_buffer(zip, parts[i].data(), parts[i].size(), 0), 0);
        zip_set_file_compression(zip, static_cast<zip_uint64_t>(at), ZIP_CM_STORE, 0);
    }
    zip_close(zip);
    return path;
}

void read_incremental_driver(const std::string& text) {
    using namespace incremental_driver;
    if (text.find('/') != std::string::npos) throw BadInput("files elsewhere");
    const Parameters parameters =
        read_parameters(scratch().write("parameters.inp", part_of(text, 0)));
    const InitialConditions start =
        read_initial_conditions(scratch().write("initialconditions.inp", part_of(text, 1)));
    scratch().write("table.txt", part_of(text, 3));
    read_test(scratch().write("test.inp", part_of(text, 2)), {"h_11", "e"});
    read_classic_props(parameters, scratch().path() / "parameters.inp");
}

void read(char kind, const std::string& text) {
    switch (kind) {
        case 'c': cli::standardised(cli::read_table(scratch().write("table.csv", text), "")); break;
        case 'l': {
            cli::SheetFormat layout;
            layout.decimal_comma = true;
            layout.separator = ';';
            cli::read_sheet(scratch().write("sheet.csv", text), layout);
            cli::line_with(scratch().path() / "sheet.csv", layout, "p");
            break;
        }
        case 'x': cli::read_sheet(workbook_of(text), {}); break;
        case 'z': cli::read_workbook(scratch().write("raw.xlsx", text), ""); break;
        default: read_incremental_driver(text);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) return -1;
    try {
        read(static_cast<char>(data[0]), {reinterpret_cast<const char*>(data) + 2, size - 2});
    } catch (const cli::BadInput& refused) {
        fuzz::refusal = refused.what();
    } catch (const incremental_driver::BadInput& refused) {
        fuzz::refusal = refused.what();
    }
    return 0;
}
