// SPDX-License-Identifier: MIT
// The columns of the ledger and of frames: each with its name, unit, meaning and value in one place.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/boundary/shape.h"
#include "solver/engine/engine_types.h"

namespace bake {

class Simulation;
struct Scene;

struct LedgerColumn {
  std::string name;                                                    ///< in ledger.csv: "heat_content_J"
  std::string unit;                                                    ///< "J"
  std::string meaning;                                                 ///< one sentence without its full stop
  std::string how;                                                     ///< how its number comes about
  std::string effect;                                                  ///< whose it is; empty: of every run
  std::function<double(const Simulation&, const Box3& extent)> value;  ///< `extent`: of the particles, found once a row
};

/// All columns in their order; those of effects that a scene does not list are zero.
const std::vector<LedgerColumn>& ledger();
std::vector<std::string> ledger_columns();
/// The columns of a scene's run: those, and behind them those of each of its givers (solver/scene/givers.h).
std::vector<std::string> ledger_columns(const Scene& scene);
/// A column that a scene has for each of its givers.
struct GiverColumn {
  std::string end;  ///< of its name, behind that of the giver: "_heat_J"
  std::string unit, meaning;
  bool is_heat;
  std::function<double(const Given&)> value;
};
const std::vector<GiverColumn>& giver_columns();
/// One row: what a simulation's ledger says now, at its last sample.
std::vector<double> ledger_row(const Simulation& simulation);
/// Does the scene list the effect whose column this is?
bool is_of_scene(const Scene& scene, std::string_view column);

/// A column of a frame's particles.
struct FrameColumnWords {
  std::string name, unit, meaning, effect;
};
std::vector<FrameColumnWords> frame_columns();
/// The same of the vertices of skins.
std::vector<FrameColumnWords> skin_columns();

/// What a column of the ledger or of a frame is, for `bake explain`; empty if there is none of that name.
std::string explain_column(std::string_view name);
/// docs/columns.md.
std::string columns_page();
/// docs/notation.md: every symbol with its name in the code, unit and equation.
std::string notation_page();

}  // namespace bake
