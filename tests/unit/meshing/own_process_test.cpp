// SPDX-License-Identifier: MIT
// Work that never ends, takes all memory or dies takes nothing else with it.
#include "meshing/tets/own_process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <stdexcept>
#include <thread>

#include "meshing/tets/effort.h"
#include "solver/core/errors.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

using Made = std::variant<TetMesh, NoMesh>;

const WorkBounds k_wide{60, 4e9};
const TetMesh k_mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};

std::string why_not(const std::function<TetMesh(const Tell&)>& work, const WorkBounds& bounds = k_wide) {
  const Made made = in_own_process(work, bounds, tell_nobody);
  return std::holds_alternative<NoMesh>(made) ? std::get<NoMesh>(made).why : "";
}

TEST(AProcessOfItsOwn, GivesTheMeshAndWhatItTells) {
  std::vector<std::string> told;
  const Made made = in_own_process(
      [](const Tell& tell) {
        tell("one");
        tell("two\nlines");
        return k_mesh;
      },
      k_wide, [&](const std::string& line) { told.push_back(line); });
  ASSERT_TRUE(std::holds_alternative<TetMesh>(made));
  EXPECT_EQ(std::get<TetMesh>(made).points, k_mesh.points);
  EXPECT_EQ(std::get<TetMesh>(made).tets, k_mesh.tets);
  EXPECT_EQ(told, (std::vector<std::string>{"one", "two lines"}));
}

TEST(AProcessOfItsOwn, IsEndedInTime) {
  const auto start = std::chrono::steady_clock::now();
  const auto never = [](const Tell&) {
    for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
    return k_mesh;
  };
  EXPECT_EQ(why_not(never, {0.5, 1e9}), "it did not end within 0 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(AProcessOfItsOwn, MayThrowOrDie) {
  EXPECT_EQ(why_not([](const Tell&) -> TetMesh { throw InputError("5 vertices are too few"); }), "5 vertices are too few");
  EXPECT_EQ(why_not([](const Tell&) -> TetMesh { throw std::logic_error("CGAL: assertion"); }), "it met a case that it cannot handle");
  EXPECT_EQ(why_not([](const Tell&) -> TetMesh {
              std::raise(SIGKILL);
              return {};
            }),
            "it died");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(AProcessOfItsOwn, IsKeptFromTakingAllMemory) {
  EXPECT_EQ(why_not(
                [](const Tell&) {
                  std::vector<std::vector<char>> all;
                  for (;;) all.emplace_back(10'000'000, 'x');
                  return k_mesh;
                },
                {60, 1e9}),
            "it took more than 1 GB of memory");
}

TEST(AProcessOfItsOwn, MayTakeItsMemoryBesidesWhatTheProgramHas) {
  const std::unique_ptr<char[]> has(new char[2'000'000'000]);  // never touched: only address space
  EXPECT_EQ(why_not(
                [&](const Tell&) {
                  const std::vector<char> more(300'000'000, has == nullptr);
                  return k_mesh;
                },
                {60, 1e9}),
            "");
}
#endif

TEST(AnEffort, BeyondTheMachineIsRefusedWithTheEstimate) {
  require_effort("1000 vertices", lattice_effort(1000));
  const std::string error = message_of<InputError>([] { require_effort("100000000 vertices", lattice_effort(1e8)); });
  EXPECT_EQ(error.substr(0, error.find(", allowed: ")), "100000000 vertices would take about 83 min and 100 GB of memory");
  EXPECT_THROW(require_effort("edges of 1e-9 m", skin_effort(1, 1e-9)), InputError);
  EXPECT_THROW(require_effort("too long", {3601, 1e6}), InputError);
  EXPECT_THROW(require_effort("too large", {1, 1e18}), InputError);
}

}  // namespace
}  // namespace bake
