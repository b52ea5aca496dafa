// SPDX-License-Identifier: Apache-2.0
// Molecule files: what is read of each format, and where and how a bad one is refused.
#include "io/molecule_file.hpp"

#include <zlib.h>

#include <cmath>
#include <cstdio>

#include "io/sphere_look.hpp"
#include "reference/parts.hpp"
#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::expectError;
using cdsm::test::replaced;
using cdsm::test::TemporaryFolder;

/// One record by the columns of the format.
std::string record(const char* kind, int serial, const char* name, char alternate, const char* residue, int number,
                   double x, double y, double z, const char* element) {
  char line[96];
  std::snprintf(line, sizeof line, "%-6s%5d %-4s%c%3s A%4d    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n", kind, serial,
                name, alternate, residue, number, x, y, z, element);
  return line;
}

/// Two places of a side chain, water, an ion whose name begins like carbon's, and a second model.
std::string pdb() {
  return "HEADER    TEST\nMODEL        1\n" + record("ATOM", 1, " N  ", ' ', "SER", 1, 1, 2, 3, " N") +
         record("ATOM", 2, " CA ", 'A', "SER", 1, 4, 5, 6, " C") +
         record("ATOM", 3, " CA ", 'B', "SER", 1, 7, 8, 9, " C") +
         record("ATOM", 4, " CB ", 'B', "GLY", 1, 7, 7, 7, " C") +
         record("HETATM", 5, "CA  ", ' ', " CA", 2, -1, -2, -3.5, "CA") +
         record("HETATM", 6, " O  ", ' ', "HOH", 3, 0, 0, 9, " O") + "ENDMDL\nMODEL        2\n" +
         record("ATOM", 1, " N  ", ' ', "SER", 1, 9, 9, 9, " N") + "ENDMDL\nEND\n";
}

std::string mmcif() {
  return "data_TEST\n#\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
         "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n"
         "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\n"
         "ATOM   1 N  N  . SER A 1 1.0 2.0 3.0 1\n"
         "ATOM   2 C  CA A SER A 1 4.0 5.0 6.0 1\n"
         "ATOM   3 C  CA B SER A 1 7.0 8.0 9.0 1\n"
         "ATOM   4 C  CB B GLY A 1 7.0 7.0 7.0 1\n"
         "HETATM 5 CA CA . CA  A 2 -1.0 -2.0 -3.5(2) 1\n"
         "HETATM 6 O  O  . HOH A 3 0.0 0.0 9.0 1\n"
         "ATOM   1 N  N  . SER A 1 9.0 9.0 9.0 2\n#\n";
}

constexpr const char* kXyz =
    "4\ncomment\nN 1 2 3\nC 4 5 6 0.1 0.2 0.3\nCa -1 -2 -3.5\n O 0 0 9\n4\nnext frame\nN 1 2 3\n";

void expectTheMolecule(const io::Molecule& molecule, bool hasWater) {
  ASSERT_EQ(molecule.atoms.size(), 4u);
  const glm::vec3 positions[] = {{1, 2, 3}, {4, 5, 6}, {-1, -2, -3.5}, {0, 0, 9}};
  const int numbers[] = {7, 6, 20, 8};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(molecule.atoms[i].position, positions[i]) << i;
    EXPECT_EQ(molecule.atoms[i].element, numbers[i]) << i;
    EXPECT_EQ(molecule.atoms[i].water, hasWater && i == 3) << i;
  }
  EXPECT_FALSE(molecule.unknown.has_value());
}

class MoleculeFile : public testing::Test {
 protected:
  io::Molecule read(const std::string& name, const std::string& text) {
    return *io::readMolecule(folder_.write(name, text));
  }
  void expectBad(const std::string& name, const std::string& text, const std::string& part, int line = 0,
                 int column = 0) {
    expectError([&] { read(name, text); }, part, line, column);
  }

  TemporaryFolder folder_;
};

TEST_F(MoleculeFile, PdbHasTheFirstModelAndTheFirstConformation) { expectTheMolecule(read("m.pdb", pdb()), true); }

TEST_F(MoleculeFile, MmcifHasTheFirstModelAndTheFirstConformation) { expectTheMolecule(read("m.cif", mmcif()), true); }

TEST_F(MoleculeFile, XyzHasTheFirstFrame) { expectTheMolecule(read("m.xyz", kXyz), false); }

TEST_F(MoleculeFile, ReadsOldPdbWithoutElementsAndEnd) {
  std::string text =
      record("ATOM", 1, " CA ", ' ', "ALA", 1, 1, 2, 3, "  ") + record("ATOM", 2, "1HB ", ' ', "ALA", 1, 1, 2, 4, "  ");
  text.resize(text.size() - 25);  // ends in the last coordinate's column
  const io::Molecule molecule = read("m.ent", text);
  ASSERT_EQ(molecule.atoms.size(), 2u);
  EXPECT_EQ(molecule.atoms[0].element, 6);
  EXPECT_EQ(molecule.atoms[1].element, 1);
}

TEST_F(MoleculeFile, KeepsAtomsWhoseNumbersRepeat) {
  const std::string water = record("ATOM", 1, " OW ", ' ', "SOL", 1, 1, 2, 3, " O");
  EXPECT_EQ(read("m.pdb", water + record("ATOM", 2, " OW ", ' ', "SOL", 1, 5, 2, 3, " O")).atoms.size(), 2u);
}

TEST_F(MoleculeFile, UnpacksGzip) {
  const std::string path = folder_.path("m.xyz.gz");
  gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_GT(gzputs(file, kXyz), 0);
  gzclose(file);
  expectTheMolecule(*io::readMolecule(path), false);
  const std::string bytes = test::readBytes(path);
  expectBad("cut.xyz.gz", bytes.substr(0, bytes.size() - 3), "end too early");
  expectBad("no.xyz.gz", kXyz, "damaged");
}

TEST_F(MoleculeFile, ReadsParticlesWithoutElements) {
  for (const char* text : {"2\n\n1 2 3\n4 5 6\n", "1 2 3\n4 5 6\n", "1 2 3 0.5 0.5\n4 5 6 0.5 0.5\n",
                           "2\n\n1 1 2 3\n2 4 5 6", "A 1 2 3\nBead 4 5 6\n"}) {
    const io::Molecule molecule = read("p.xyz", text);
    ASSERT_EQ(molecule.atoms.size(), 2u) << text;
    EXPECT_EQ(molecule.atoms[1].position, glm::vec3(4, 5, 6)) << text;
    EXPECT_EQ(molecule.atoms[1].element, io::kUnknownElement) << text;
    EXPECT_TRUE(molecule.unknown.has_value()) << text;
  }
}

TEST_F(MoleculeFile, ReadsTheColumnsThatExtendedXyzNames) {
  const io::Molecule molecule =
      read("p.xyz",
           "1\nLattice=\"1 0 0\" Properties=id:I:1:force:R:3:pos:R:3:species:S:1 pbc=\"T T T\"\n7 8 8 8 1 2 3 Fe\n");
  ASSERT_EQ(molecule.atoms.size(), 1u);
  EXPECT_EQ(molecule.atoms[0].position, glm::vec3(1, 2, 3));
  EXPECT_EQ(molecule.atoms[0].element, 26);
  expectBad("p.xyz", "1\nProperties=species:S:1:x:R:3\nFe 1 2 3\n", "no pos:R:3", 2);
  expectBad("p.xyz", "1\nProperties=species:S\nFe 1 2 3\n", "NAME:TYPE:COLUMNS", 2);
}

TEST_F(MoleculeFile, RefusesBadPdb) {
  expectBad("m.pdb", replaced(pdb(), "   4.000", "     nan"), "\"nan\" is no coordinate", 4, 31);
  expectBad("m.pdb", replaced(pdb(), "   5.000", "     inf"), "\"inf\" is no coordinate", 4, 39);
  expectBad("m.pdb", replaced(pdb(), "   6.000", "    ****"), "\"****\" is no coordinate", 4, 47);
  expectBad("m.pdb", pdb().substr(0, 130), "too short for three coordinates", 4);
  expectBad("m.pdb", pdb().substr(0, pdb().find("ENDMDL")), "no ENDMDL; is the file cut short?", 8);
  expectBad("m.pdb", "HEADER    TEST\n" + record("ATOM", 1, " N  ", ' ', "SER", 1, 1, 2, 3, " N"), "has no END", 2);
  expectBad("m.pdb", "HEADER    TEST\nEND\n", "holds no atoms");
  expectBad("m.pdb", mmcif(), "is mmCIF", 1);
  expectBad("m.pdb", "", "is empty");
}

TEST_F(MoleculeFile, RefusesBadMmcif) {
  expectBad("m.cif", replaced(mmcif(), "4.0 5.0", "nan 5.0"), "\"nan\" is no coordinate", 17);
  expectBad("m.cif", replaced(mmcif(), "4.0 5.0", "? 5.0"), "\"?\" is no coordinate", 17);
  expectBad("m.cif", mmcif().substr(0, mmcif().size() - 10), "Wrong number of values");
  expectBad("m.cif", replaced(mmcif(), "_atom_site.Cartn_y", "_atom_site.fract_y"), "holds no atoms");
  expectBad("m.cif", "data_TEST\n_cell.length_a 3\n", "holds no atoms");
  expectBad("m.cif", pdb(), "cannot be read as mmCIF", 1);
  expectBad("m.cif", std::string("data_x\nloop_\n_a.b\n\"open"), "cannot be read as mmCIF");
}

TEST_F(MoleculeFile, RefusesBadXyz) {
  expectBad("m.xyz", "3\n\nC 0 0 0\nC 1 1 1\n", "ends after 2 of its 3 atoms", 4);
  expectBad("m.xyz", "1\n\nC 0 0 0\nC 1 1 1\n", "more rows than the 1 atoms", 4);
  expectBad("m.xyz", "99999999999999\n\nC 0 0 0\n", "ends after 1 of its 99999999999999 atoms", 3);
  expectBad("m.xyz", "-1\n\nC 0 0 0\n", "must be the number of atoms", 1);
  expectBad("m.xyz", "two\n\nC 0 0 0\n", "must be the number of atoms", 1);
  expectBad("m.xyz", "2\n\nC 0 0 0\nC 1 1\n", "has 3 columns, at least 4 are needed", 4);
  expectBad("m.xyz", "1\n\nC 0 0\n", "\"C\" is no coordinate", 3);
  expectBad("m.xyz", "1\n\nC 0 nan 0\n", "\"nan\" is no coordinate", 3);
  expectBad("m.xyz", "1\n\nC 0 1e10 0\n", "must be a number in [-1e+09, 1e+09]", 3);
  expectBad("m.xyz", "0\n\n", "holds no atoms");
  expectBad("m.mol", "x", "by its ending; spheres are read from");
}

/// Linear values by the formula of sRGB.
float linear(int byte) { return std::pow((float(byte) / 255.0f + 0.055f) / 1.055f, 2.4f); }

TEST_F(MoleculeFile, AtomsHaveTheRadiiAndColoursOfTheirElements) {
  const auto spheres = io::makeSpheres(read("m.pdb", pdb()), {});
  EXPECT_EQ(reference::valuesOf(spheres->radii), (std::vector<float>{1.55f, 1.7f, 2.31f, 1.52f}));
  ASSERT_EQ(spheres->colors.size(), 4u);
  const glm::vec3 expected[] = {{linear(48), linear(80), linear(248)}, glm::vec3(linear(144))};
  for (int i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(spheres->colors[i][c], expected[i][c], 1e-6f);
  EXPECT_NEAR(io::elementColor(109).r, linear(0xEB), 1e-6f);
  EXPECT_EQ(io::elementColor(io::elementOf("d")), io::elementColor(io::elementOf("D")));
  EXPECT_EQ(io::elementOf("Cl1"), io::kUnknownElement);
}

TEST_F(MoleculeFile, TheSceneMayChooseRadiusColourAndWater) {
  const io::Molecule molecule = read("m.pdb", pdb());
  const auto spheres = io::makeSpheres(molecule, {0.5f, glm::vec3(1, 0, 0), false});
  EXPECT_EQ(reference::valuesOf(spheres->radii), std::vector<float>(3, 0.5f));
  EXPECT_EQ(reference::valuesOf(spheres->colors), std::vector<glm::vec3>(3, {1, 0, 0}));
  const std::string water = record("HETATM", 6, " O  ", ' ', "HOH", 3, 0, 0, 9, " O");
  EXPECT_THROW(io::makeSpheres(read("w.pdb", water), {0.0f, {}, false}), Error);
}

TEST_F(MoleculeFile, UnknownElementsNeedARadius) {
  const std::string text = "2\n\nC 0 0 0\nBead 1 1 1\n";
  const auto spheres = io::makeSpheres(read("p.xyz", text), {2.0f, {}, true});
  EXPECT_EQ(spheres->colors.size(), 2u);
  EXPECT_TRUE(io::makeSpheres(read("p.xyz", "1\n\n0 0 0\n"), {2.0f, {}, true})->colors.empty());
  expectError([&] { io::makeSpheres(read("p.xyz", text), {}); }, "\"Bead\" is no known element", 4);
  expectError([&] { io::makeSpheres(read("p.xyz", "1\n\n0 0 0\n"), {}); }, "no element is no known element", 3);
  const std::string strange = record("ATOM", 1, " Q1 ", ' ', "UNK", 1, 1, 2, 3, " Q");
  expectError([&] { io::makeSpheres(read("m.pdb", pdb().substr(0, 30) + strange + "ENDMDL\nEND\n"), {}); },
              "\"Q1\" is no known element", 3);
  expectError([&] { io::makeSpheres(read("m.cif", replaced(mmcif(), "2 C ", "2 Qq")), {}); },
              "\"Qq\" is no known element", 17);
}

}  // namespace
