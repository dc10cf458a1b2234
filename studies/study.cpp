// SPDX-License-Identifier: MIT
#include "studies/study.h"

#include "studies/convergence/convergence.h"
#include "studies/surface/surface.h"

namespace bake::studies {

const std::vector<Study>& all_studies() {
  static const std::vector<Study> studies{
      {"convergence", "Orders of convergence against exact solutions", run_convergence},
      {"surface", "The area that the surface measure finds, in its standard and its published form", run_surface},
  };
  return studies;
}

}  // namespace bake::studies
