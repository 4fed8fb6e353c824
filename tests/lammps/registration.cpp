// SPDX-License-Identifier: BSD-3-Clause
// The packaged lmp, and hosts that are not the one.
#include <gtest/gtest.h>

#include <string>

#include "support/block.hpp"
#include "support/both_hosts.hpp"

namespace {

// As docs/lammps.md shows it.
std::string through_python() {
    return R"(python grit_add input 1 SELF format p here """
import ctypes
def grit_add(lammps):
    pointer = ctypes.pythonapi.PyCapsule_GetPointer
    pointer.restype, pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    grit = ctypes.CDLL(")" GRIT_LAMMPS R"(")
    if grit.grit_lammps_add(ctypes.c_void_p(pointer(lammps, None))):
        raise RuntimeError("Grit was not added")
"""
python grit_add invoke
)";
}

TEST(LammpsRegistration, ThePackagedProgramHasTheBitsOfTheDriver) {
    const BothHosts hosts(block_case("2, 1", "0.5"));
    for (const int processes : {1, 2}) {
        hosts.folder.write("stock.in", through_python() + "variable thermo_steps index 1\n" +
                                           hosts.script() +
                                           "write_dump all custom end.dump id f_mpm[*] "
                                           "modify format float %.17g\n");
        const Answer answer =
            hosts.folder.run(BothHosts::start(processes, STOCK_LMP " -in stock.in -log none"));
        EXPECT_EQ(answer.status, 0) << answer.text;
        EXPECT_EQ(first_difference(hosts.in_driver(1000000), hosts.read_told(answer.text)), "");
    }
}

TEST(LammpsRegistration, AnotherVersionIsLeftAlone) {
    const Folder folder;
    const Answer answer = folder.run(OTHER_HOST " " GRIT_LAMMPS " 20230802");
    EXPECT_EQ(answer.status, 1);
    const std::string refusal = "ERROR: Grit was built for LAMMPS 20210929 (29 Sep 2021), this is "
                                "20230802: nothing was added to it\n";
    EXPECT_EQ(answer.text, refusal + refusal);  // as a plugin, and else
}

TEST(LammpsRegistration, APluginIsRegisteredAsHostsWantIt) {
    const Folder folder;
    const Answer answer = folder.run(OTHER_HOST " " GRIT_LAMMPS " 20210929");
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.text, "plugin fix grit/mpm for 29 Sep 2021\n");
}

TEST(LammpsRegistration, TheFixIsThereAgainAfterAClear) {
    const BothHosts hosts(block_case("2, 1", "0.5"));
    const Answer cleared = hosts.lammps(1, "clear\n" + hosts.script());
    EXPECT_NE(cleared.status, 0);
    EXPECT_TRUE(cleared.says("ERROR: Unrecognized fix style 'grit/mpm'")) << cleared.text;
    EXPECT_EQ(hosts.lammps(1, "clear\ngrit\n" + hosts.script()).status, 0);
}

// The library exports its two doors and nothing else.
TEST(LammpsRegistration, TheLibraryExportsNothingElse) {
    const Folder folder;
    const Answer answer = folder.run("nm -D --defined-only " GRIT_LAMMPS " | cut -d' ' -f3");
    EXPECT_EQ(answer.text, "grit_lammps_add\nlammpsplugin_init\n");
}

}  // namespace
