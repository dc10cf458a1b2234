// SPDX-License-Identifier: MIT
#include "studies/study.h"

#include "studies/convergence/convergence.h"

namespace bake::studies {

const std::vector<Study>& all_studies() {
  static const std::vector<Study> studies{
      {"convergence", "Orders of convergence against exact solutions", run_convergence},
  };
  return studies;
}

}  // namespace bake::studies
