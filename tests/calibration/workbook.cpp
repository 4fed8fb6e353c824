// SPDX-License-Identifier: BSD-3-Clause
// Workbooks as spreadsheet programs write them.
#include <gtest/gtest.h>

#include "cli/process/exit_code.hpp"
#include "cli/table/sheet.hpp"
#include "cli/table/workbook.hpp"

#include "book.hpp"

namespace {

Parts usual() {
    return {
        {"xl/workbook.xml",
         "<workbook xmlns:r=\"x\"><sheets><sheet name=\"Deckblatt\" r:id=\"rId1\"/>"
         "<sheet name=\"TMD 1\" r:id=\"rId2\"/></sheets></workbook>"},
        {"xl/_rels/workbook.xml.rels",
         "<Relationships><Relationship Id=\"rId1\" Target=\"worksheets/sheet1.xml\"/>"
         "<Relationship Id=\"rId2\" Target=\"/xl/worksheets/sheet2.xml\"/></Relationships>"},
        {"xl/sharedStrings.xml",
         "<sst><si><t>eps [%]</t></si><si><r><t>q </t></r><r><t>[kPa]</t></r>"
         "<rPh><t>aloud</t></rPh></si></sst>"},
        {"xl/worksheets/sheet1.xml", "<worksheet><sheetData/></worksheet>"},
        {"xl/worksheets/sheet2.xml",
         "<x:worksheet xmlns:x=\"y\"><x:sheetData>"
         "<x:row r=\"1\"><x:c r=\"A1\" "
         "t=\"inlineStr\"><x:is><x:t>Projekt</x:t></x:is></x:c></x:row>"
         "<x:row r=\"3\"><x:c r=\"A3\" t=\"s\"><x:v>0</x:v></x:c><x:c r=\"C3\" t=\"s\"><x:v>1</x:v>"
         "</x:c></x:row>"
         "<x:row r=\"5\"><x:c r=\"A5\"><x:v>0.1</x:v></x:c><x:c r=\"C5\"><x:f>A5*2</x:f>"
         "<x:v>1.5E1</x:v></x:c></x:row>"
         "</x:sheetData></x:worksheet>"}};
}

TEST(Workbook, HasTheCellsOfItsSheetWhereTheyStand) {
    const Book book(usual());
    const cli::WorkbookSheet sheet = cli::read_workbook(book.path, "TMD 1");
    ASSERT_EQ(sheet.rows.size(), 5U);
    EXPECT_EQ(sheet.rows[0], std::vector<std::string>{"Projekt"});
    EXPECT_EQ(sheet.rows[2], (std::vector<std::string>{"eps [%]", "", "q [kPa]"}));
    EXPECT_EQ(sheet.rows[4], (std::vector<std::string>{"0.1", "", "1.5E1"}));
    EXPECT_EQ(cli::read_workbook(book.path, "").name, "Deckblatt");
}

TEST(Workbook, IsReadAsATableFromItsHeaderOn) {
    const Book book(usual());
    cli::SheetFormat layout;
    layout.sheet = "TMD 1";
    layout.header_line = 2;
    const cli::Cells cells = cli::read_sheet(book.path, layout);
    EXPECT_EQ(cells.rows[0], (std::vector<std::string>{"eps [%]", "", "q [kPa]"}));
    EXPECT_EQ(cells.lines, (std::vector<int>{3, 5}));
    EXPECT_NE(cli::place_in(book.path, layout, 5).find("sheet TMD 1, row 5"), std::string::npos);
}

TEST(Workbook, TellsDatesAndTruthsFromNumbers) {
    Parts parts = usual();
    parts["xl/styles.xml"] =
        "<styleSheet><numFmts><numFmt numFmtId=\"164\" formatCode=\"0.00&quot; day&quot;\"/>"
        "<numFmt numFmtId=\"165\" formatCode=\"dd/mm/yyyy\"/></numFmts><cellXfs><xf "
        "numFmtId=\"0\"/>"
        "<xf numFmtId=\"164\"/><xf numFmtId=\"165\"/><xf numFmtId=\"14\"/></cellXfs></styleSheet>";
    parts["xl/worksheets/sheet2.xml"] =
        "<worksheet><sheetData><row r=\"1\"><c s=\"0\"><v>1</v></c><c s=\"1\"><v>2</v></c>"
        "<c s=\"2\"><v>3</v></c><c s=\"3\"><v>4</v></c><c t=\"b\"><v>1</v></c></row></sheetData>"
        "</worksheet>";
    const Book book(parts);
    EXPECT_EQ(cli::read_workbook(book.path, "TMD 1").rows[0],
              (std::vector<std::string>{"1", "2", "3 (a date)", "4 (a date)", "TRUE"}));
}

TEST(Workbook, HasTheTextOfMergedCellsInAllOfThem) {
    Parts parts = usual();
    parts["xl/worksheets/sheet2.xml"] =
        "<worksheet><sheetData><row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>p</t></is></c>"
        "<c r=\"B1\" t=\"inlineStr\"><is><t>q</t></is></c></row><row r=\"2\"><c "
        "r=\"C2\"><v>7</v></c>"
        "</row></sheetData><mergeCells><mergeCell ref=\"A1:A2\"/><mergeCell ref=\"B1:C1\"/>"
        "<mergeCell ref=\"A1:XFD1048576\"/><mergeCell ref=\"Z9:A1\"/></mergeCells></worksheet>";
    const Book book(parts);
    const auto rows = cli::read_workbook(book.path, "TMD 1").rows;
    EXPECT_EQ(rows[0], (std::vector<std::string>{"p", "q", "q"}));
    EXPECT_EQ(rows[1], (std::vector<std::string>{"p", "", "7"}));
}

TEST(Workbook, IsReadBetweenItsLinesAndWithCommasInItsTexts) {
    Parts parts = usual();
    parts["xl/worksheets/sheet2.xml"] =
        "<worksheet><sheetData><row r=\"1\"><c t=\"inlineStr\"><is><t>q\n "
        "[kN/m\xC2\xB2]</t></is></c></row>"
        "<row r=\"2\"><c t=\"inlineStr\"><is><t>(mean)</t></is></c></row>"
        "<row r=\"3\"><c><v>1.5</v></c></row><row r=\"4\"><c "
        "t=\"inlineStr\"><is><t>2,5</t></is></c></row>"
        "<row r=\"5\"><c t=\"inlineStr\"><is><t>removed on "
        "3.4.</t></is></c></row></sheetData></worksheet>";
    const Book book(parts);
    cli::SheetFormat layout;
    layout.sheet = "TMD 1";
    layout.first_line = 3;
    layout.last_line = 4;
    layout.decimal_comma = true;
    const cli::Cells cells = cli::read_sheet(book.path, layout);
    EXPECT_EQ(cells.rows,
              (std::vector<std::vector<std::string>>{{"q [kN/m\xC2\xB2]"}, {"1.5"}, {"2.5"}}));
}

TEST(Workbook, HasPercentagesAsTheyAreShownAndSaysWhereAFormulaHasNoValue) {
    Parts parts = usual();
    parts["xl/styles.xml"] =
        "<styleSheet><numFmts><numFmt numFmtId=\"164\" formatCode=\"0.0%\"/></numFmts><cellXfs><xf "
        "numFmtId=\"0\"/><xf numFmtId=\"10\"/><xf numFmtId=\"164\"/></cellXfs></styleSheet>";
    parts["xl/worksheets/sheet2.xml"] =
        "<worksheet><sheetData><row r=\"1\"><c s=\"1\"><v>0.005</v></c><c/><c "
        "s=\"2\"><v>1.2E-2</v></c><c><f>A1*2</f></c>"
        "</row></sheetData></worksheet>";
    const Book book(parts);
    EXPECT_EQ(cli::read_workbook(book.path, "TMD 1").rows[0],
              (std::vector<std::string>{"0.5 %", "", "1.2 %", "(a formula without its value)"}));
}

TEST(Workbook, OfManyCellsWithoutAnythingTakesNoMemory) {
    Parts parts = usual();
    std::string sheet = "<worksheet><sheetData>";
    for (int row = 1; row <= 20000; ++row)
        sheet += "<row r=\"" + std::to_string(row) + "\"><c r=\"XFD" + std::to_string(row) +
                 "\"/></row>";
    parts["xl/worksheets/sheet2.xml"] = sheet + "</sheetData></worksheet>";
    const Book book(parts);
    for (const auto& row : cli::read_workbook(book.path, "TMD 1").rows) EXPECT_TRUE(row.empty());
}

std::string refusal(const Parts& parts, const std::string& sheet) {
    const Book book(parts);
    try {
        cli::read_workbook(book.path, sheet);
    } catch (const cli::BadInput& error) {
        return error.what();
    }
    return "";
}

TEST(Workbook, ThatIsWrongIsRefusedWithAReason) {
    EXPECT_NE(refusal(usual(), "TMD1").find("has no sheet \"TMD1\"; nearest: TMD 1"),
              std::string::npos);
    Parts parts = usual();
    parts["xl/worksheets/sheet2.xml"] = "<worksheet><sheetData>";
    EXPECT_NE(refusal(parts, "TMD 1").find("is no XML"), std::string::npos);
    parts = usual();
    parts["xl/sharedStrings.xml"] = "<sst/>";
    EXPECT_NE(refusal(parts, "TMD 1").find("cell A3 names a string that is not there"),
              std::string::npos);
    parts = usual();
    parts["xl/worksheets/sheet2.xml"] =
        "<worksheet><sheetData><row r=\"4000000000\"/></sheetData></worksheet>";
    EXPECT_NE(refusal(parts, "TMD 1").find("has a row 4000000000"), std::string::npos);
    std::string wide = "<worksheet><sheetData>";
    for (int row = 1; row <= 1300; ++row)
        wide += "<row r=\"" + std::to_string(row) + "\"><c r=\"XFD" + std::to_string(row) +
                "\"><v>1</v></c></row>";
    parts["xl/worksheets/sheet2.xml"] = wide + "</sheetData></worksheet>";
    EXPECT_NE(refusal(parts, "TMD 1").find("has more than 20000000 cells"), std::string::npos);
    EXPECT_NE(refusal({{"readme", "no"}}, "").find("is no workbook"), std::string::npos);
}

// What a few bytes of a workbook stand for.
std::string refusal(const Parts& parts) {
    const Book book(parts);
    try {
        cli::read_sheet(book.path, {});
    } catch (const cli::BadInput& error) {
        return error.what();
    }
    return "read";
}

TEST(Workbook, ThatUnpacksToMoreThanASheetIsRefusedByName) {
    Parts parts = usual();
    std::string& sheet = parts["xl/worksheets/sheet1.xml"];
    parts["xl/sharedStrings.xml"] = "<sst><si><t>" + std::string(1 << 20, 'x') + "</t></si></sst>";
    sheet = "<worksheet><sheetData><row>";
    for (int i = 0; i < 300; ++i) sheet += "<c t=\"s\"><v>0</v></c>";
    sheet += "</row></sheetData></worksheet>";
    EXPECT_NE(refusal(parts).find("sheet Deckblatt has more than 256 MiB of text"),
              std::string::npos);

    sheet = "<worksheet><sheetData><row><c r=\"XFD1\"><v>1</v></c></row>";
    for (int i = 0; i < 1300; ++i) sheet += "<row><c><v>1</v></c></row>";
    sheet += "</sheetData></worksheet>";
    EXPECT_NE(refusal(parts).find(
                  "row 1222: more than 20000000 cells in rows as long as the header, 16384"),
              std::string::npos)
        << refusal(parts);

    sheet = std::string((64 << 20) + 1, ' ');
    EXPECT_NE(refusal(parts).find("xl/worksheets/sheet1.xml is too large"), std::string::npos);
}

TEST(Workbook, SpreadsHeadingsAndNoBooks) {
    Parts parts = usual();
    parts["xl/worksheets/sheet1.xml"] =
        "<worksheet><sheetData><row><c t=\"inlineStr\"><is><t>" + std::string(2000, 'x') +
        "</t></is></c></row><row r=\"3\"><c r=\"A3\"><v>1</v></c></row></sheetData>"
        "<mergeCells><mergeCell ref=\"A1:B3\"/></mergeCells></worksheet>";
    const Book book(parts);
    EXPECT_EQ(cli::read_workbook(book.path, "").rows[2], std::vector<std::string>{"1"});
}

}  // namespace
