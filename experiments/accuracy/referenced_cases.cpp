// SPDX-License-Identifier: MIT
// Scenes in which everything acts at once: no exact solution, but a fine run.
#include "experiments/accuracy/reference.h"

namespace bake::studies::accuracy {

Case drying_cube() {
  Case c;
  c.measured = "water lost, mean temperature and temperature of the middle after an hour, rms, each relative to its change";
  c.cells_of = "the cube's 40 mm";
  c.cells = {4, 6, 8};
  c.full_cells = {12, 16};
  c.quality = {8, 16, 32};
  c.knobs = {"step", "kernel", "precision", "euler", "surface", "textbook"};
  refer(c, {"drying_cube",
            "teaching/drying_cube",
            0.04,
            32,
            {{"water lost", "water_lost_share"},
             {"mean temperature", "mean_temperature", {}, 20},
             {"temperature of the middle", "temperature_at", {.point_m = Vector3{0, 0, 0}}, 20}}});
  return c;
}

Case rising_ball() {
  Case c;
  c.measured = "volume gain, mean temperature, water lost and gas made at the end, rms, each relative to its change";
  c.cells_of = "the ball's radius of 0.1 m";
  c.cells = {3, 4, 5};
  c.full_cells = {7, 10};
  c.quality = {5, 10, 20};
  c.knobs = {"step", "kernel", "transfer", "precision", "p_ref", "inertia", "surface", "textbook"};
  c.from = Effort::usual;
  refer(c, {"rising_ball",
            "teaching/rising_ball",
            0.1,
            20,
            {{"volume gain", "volume_gain", {}, 1},
             {"mean temperature", "mean_temperature", {}, 10},
             {"water lost", "water_lost_share"},
             {"gas made", "gas_made"}},
            {"motion.inertia_scale=1"}});
  return c;
}

Case dough_pull() {
  Case c;
  // its length is the grips', and where on it the neck is thinnest goes with dx
  c.measured = "plastic work until the end, when the right grip has let go, relative to that of a fine run";
  c.cells_of = "the cylinder's radius of 0.08 m";
  c.cells = {3, 4, 5};
  c.full_cells = {6, 8};
  c.quality = {4, 8, 16};
  c.knobs = {"step", "kernel", "transfer", "particles", "precision"};
  c.from = Effort::usual;
  refer(c, {"dough_pull", "teaching/dough_pull", 0.08, 24, {{"plastic work", "dissipated"}}, {"time.safety=0.5"}});
  return c;
}

Case cookie() {
  Case c;
  c.measured =
      "height gain, width gain, mean temperature and gas made at the end, rms, each relative to its change, against a fine run with the "
      "scene's own inertia and p_ref";
  c.cells_of = "20.4 mm, dx at draft";
  c.cells = {1, 2};
  c.full_cells = {3, 4};
  c.quality = {1, 2, 4};
  c.knobs = {"step", "kernel", "p_ref", "inertia", "surface", "keep"};
  c.from = Effort::full;
  refer(c, {"cookie",
            "fig03_cookies/cookie",
            0.0204,
            4,
            {{"height gain", "height_gain", {}, 1},
             {"width gain", "extent_x_gain", {}, 1},
             {"mean temperature", "mean_temperature", {}, 0},
             {"gas made", "gas_made"}},
            {"time.safety=0.5", "surface.keep_dx=0"}});
  return c;
}

Case bread() {
  Case c;
  c.measured =
      "volume gain, temperature of the core, thickness of the crust (what has lost a tenth of its water), width of the middle slit at the "
      "end, rms, each relative to its change";
  c.cells_of = "80 mm, the tray's depth";
  c.cells = {2, 3};
  c.full_cells = {4};
  c.quality = {2, 4, 8};
  c.knobs = {"step", "kernel", "p_ref", "inertia", "surface", "keep"};
  c.from = Effort::full;
  refer(c, {"bread",
            "fig15_bread/bread",
            0.08,
            8,
            {{"volume gain", "volume_gain", {}, 1},
             {"temperature of the core", "temperature_at", {.point_m = Vector3{0, 0, 0.1}}, 1},
             // a tenth: drier than that at draft, too, where a crust of less than a cell is smeared over one
             {"thickness of the crust", "crust_thickness", {.dried_share = 0.1}},
             {"width of the slit", "distance_gain", {.from_m = Vector3{-0.028, -0.0195, 0.28}, .to_m = Vector3{0.028, 0.0195, 0.28}}, 1}},
            {"surface.keep_dx=0"}});
  return c;
}

}  // namespace bake::studies::accuracy
