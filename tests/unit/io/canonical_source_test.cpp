// SPDX-License-Identifier: MIT
#include "solver/identity/canonical_source.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

void expect_same(const std::string& one, const std::string& other) {
  EXPECT_EQ(canonical_source(one), canonical_source(other)) << one << "\n-- and --\n" << other;
}

void expect_different(const std::string& one, const std::string& other) {
  EXPECT_NE(canonical_source(one), canonical_source(other)) << one << "\n-- and --\n" << other;
}

TEST(CanonicalSource, IsTheSameWhateverTheSourceLooksLike) {
  const std::string plain = "int f(int a) { return a + 1; }\n";
  expect_same(plain, "// why\nint f(int a) {\n\n  /* as in\n  the paper */ return a+1;  // so\r\n}");
  expect_same(plain, "int/**/f ( int a ){return a +1 ; }");
  expect_same(plain, "in\\\nt f(int a) { // spliced \\\n comment\nreturn a + /\\\n* a comment *\\\n/ 1; }");
  expect_same(plain, "#include \"solver/core/f.h\"\n  #  include \"g.h\"  // last\n" + plain + "#include \"at_the_end.h\"");
  expect_same("@INCLUDES@#include \"a.h\"\nint i;", "@INCLUDES@\n#include \"b.h\"\n\nint i;");
}

TEST(CanonicalSource, IsAnotherIfAnyTokenIs) {
  expect_different("a + b;", "a - b;");
  expect_different("a b;", "ab;");
  expect_different("a + +b;", "a ++b;");
  expect_different("1.5e-3", "1.5e -3");
  expect_different("f(one)", "f(two)");
  expect_different("#include <vector>\n", "#include <map>\n");
}

TEST(CanonicalSource, KeepsWhatIsQuoted) {
  expect_different("s = \"a b\";", "s = \"a  b\";");
  expect_different("s = \"// a\";", "s = \"// b\";");
  expect_different("s = \"\\\"/*\"; t(1); /* */", "s = \"\\\"/*\"; t(2); /* */");
  expect_different("c = '\"'; d(1); // \"", "c = '\"'; d(2); // \"");
  expect_different("c = '\\''; d = ' ';", "c = '\\''; d = '  ';");
  expect_different("s = R\"x(a // )\" \\\n b)x\";", "s = R\"x(a // )\"  b)x\";");
  expect_different("s = u8R\"(/* a */)\";", "s = u8R\"(/* b */)\";");
  expect_different("\"a\"s", "\"a\" s");
  expect_different("n = 1'000'0; c(1); // '", "n = 1'000'0; c(2); // '");
  expect_same("n = 1'000; // it's\nc();", "n = 1'000; c();");
}

TEST(CanonicalSource, KnowsWhereADirectiveEnds) {
  expect_different("#define A b\nc;", "#define A b c;\n");
  expect_same("#define A b \\\n  c\nd;", "#define  A  b c // e\n\nd;");
  expect_different("#define F(x) x\n", "#define F (x) x\n");
}

class CanonicalSources : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder.path() / name).parent_path());
    std::ofstream(folder.path() / name) << text;
  }
  std::string text() const { return canonical_sources(folder.path()); }

  TemporaryFolder folder;
};

TEST_F(CanonicalSources, DoNotKnowNamesAndPlaces) {
  write("core/a.h", "int a;");
  write("engine/b.cpp", "int b;");
  write("engine/c.cpp.in", "int @C@;");
  const std::string before = text();
  std::filesystem::create_directories(folder.path() / "grid");
  std::filesystem::rename(folder.path() / "core/a.h", folder.path() / "grid/z.h");
  std::filesystem::rename(folder.path() / "engine/b.cpp", folder.path() / "grid/a.cpp");
  EXPECT_EQ(text(), before);
  write("grid/a.cpp", "int b = 1;");
  EXPECT_NE(text(), before);
}

TEST_F(CanonicalSources, AreThoseThatDecideTheNumbers) {
  write("core/a.h", "int a;");
  const std::string before = text();
  write("program/p.cpp", "int p;");
  write("identity/i.cpp", "int i;");
  write("core/README.md", "words");
  EXPECT_EQ(text(), before);
  for (const char* file : {"core/b.h", "core/b.cpp", "core/b.cpp.in"}) {
    const std::string without = text();
    write(file, "int b;");
    EXPECT_NE(text(), without) << file;
  }
}

}  // namespace
}  // namespace bake
