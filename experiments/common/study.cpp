// SPDX-License-Identifier: MIT
#include "experiments/common/study.h"

#include <nlohmann/json.hpp>

#include "solver/io/atomic_file.h"
#include "solver/io/provenance.h"

namespace bake::studies {

const std::vector<Study>& all_studies() {
  static const std::vector<Study> studies{
      {"accuracy", "What an error costs: work-precision of every setting, and the scenes' defaults among them", run_accuracy},
      {"convergence", "Orders of convergence against exact solutions", run_convergence},
      {"departures", "What the printed equations do where this solver departs from them", run_departures},
      {"effects", "What each effect costs in time and memory, and what leaving it out changes", run_effects},
      {"stability", "The largest stable steps, and how close the time-step rule comes to them", run_stability},
      {"surface", "The area that the surface measure finds, in its standard and its published form", run_surface},
  };
  return studies;
}

void write_tables(const StudyOptions& options, const std::string& file, nlohmann::json measured, const std::string& page) {
  measured["quick"] = options.quick;
  measured["provenance"] = provenance();
  std::filesystem::create_directories(options.out);
  write_text_atomically(options.out / (file + ".json"), measured.dump(2) + "\n");
  write_text_atomically(options.out / (file + ".md"), page);
}

}  // namespace bake::studies
