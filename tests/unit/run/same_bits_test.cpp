// SPDX-License-Identifier: MIT
// A run in double precision ends in the same bits whichever variants of its functions glibc takes for this processor.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "solver/io/checksum.h"
#include "solver/run/simulation.h"
#include "solver/scene/scene_builder.h"

namespace bake {
namespace {

/// What is built from powers, sines and angles: a turned box of dough falls on a turning, rounded stone, and is torn and warmed.
Scene turned_dough() {
  SceneBuilder builder;
  builder.effects = "motion, heat, elasticity, plasticity";
  builder.dx = 0.003;
  builder.frame_s = 0.01;
  builder.low = {-0.05, -0.05, -0.01}, builder.high = {0.05, 0.05, 0.06};
  builder.gravity = "";
  builder.material =
      "density_kg_per_m3 = 1100\nyoung_modulus_Pa = 2e4\npoisson_ratio = 0.3\nyield_stress_Pa = 400\nspecific_heat_J_per_kgK = 2800\n"
      "conductivity_W_per_mK = 0.4\n";
  builder.shape = "box = { half_extents_m = [0.012, 0.010, 0.008] }, rotate_deg = [11, 21.5, 31], move_m = [0, 0, 0.02]";
  builder.body = "velocity_m_per_s = [0, 0, -2]";
  builder.tables =
      "[[collider]]\ncontact = \"sticky\"\ntemperature_C = 180\nexchange_W_per_m2K = 200\n"
      "shape = { superellipsoid = { half_axes_m = [0.02, 0.018, 0.01], plan_exponent = 2.1, profile_exponent = 3.1 }, "
      "rotate_deg = [5, 1, 7] }\nmotion = [{ time_s = 0 }, { time_s = 0.1, rotation_deg = [10, 20, 70] }]\n";
  return builder.scene();
}

std::uint64_t bits_of_a_run() {
  const auto s = Simulation::begin(turned_dough());
  s->advance(0.01, 0.02);
  const Snapshot now = s->snapshot();
  std::uint64_t sum = checksum(std::as_bytes(std::span(now.position)), 0);
  sum = checksum(std::as_bytes(std::span(now.velocity)), sum);
  for (const auto& [name, values] : now.columns) sum = checksum(std::as_bytes(std::span(values)), sum);
  return sum;
}

TEST(SameBits, AreTold) { std::printf("bits %016lx\n", static_cast<unsigned long>(bits_of_a_run())); }

/// Lines of this program's own output with other variants of glibc's functions.
std::string told_under(const std::string& tunables) {
  const std::string command =
      tunables + " '" + std::filesystem::read_symlink("/proc/self/exe").string() + "' --gtest_filter=SameBits.AreTold 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string all;
  std::array<char, 256> text;
  while (std::fgets(text.data(), static_cast<int>(text.size()), pipe)) all += text.data();
  pclose(pipe);
  const std::size_t at = all.find("bits ");
  return at == all.npos ? all : all.substr(at, 21);
}

TEST(SameBits, ComeOutWhateverTheProcessorLetsGlibcDo) {
  const std::string usual = told_under("");
  ASSERT_EQ(usual.substr(0, 5), "bits ") << usual;
  EXPECT_EQ(told_under("GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2"), usual);
}

}  // namespace
}  // namespace bake
