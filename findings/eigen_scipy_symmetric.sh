#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: libeigen3-dev 3.4.0-4 and python3-scipy 1.10.1-2.
# Behaviour: a symmetric matrix has other elements when it goes through a Matrix Market file from Eigen to SciPy or back. For a file marked
# as symmetric, Eigen's saveMarket writes all elements, so that a reader counts those off the diagonal twice; loadMarket takes the lower
# triangle of such a file for the whole matrix. Both report success, and Eigen reads what Eigen wrote.
# Expected: the same matrix. The format has only the elements on and below the diagonal in a symmetric file and means those above too;
# saveMarket has an argument for the symmetry. Nothing but the mark in the header tells loadMarket's caller, who would have to look for it.
# Seen: the rows 2 1 and 1 3 are 2 2 and 2 3 from Eigen to SciPy, 2 0 and 1 3 from SciPy to Eigen, right from Eigen to Eigen.
source "$(dirname "$0")/common.sh"
debian_packages libeigen3-dev=3.4.0-4 python3-scipy=1.10.1-2
cat >market.cpp <<'END'
#include <Eigen/Sparse>
#include <cstdio>
#include <unsupported/Eigen/SparseExtra>

void print(const char* way, const Eigen::MatrixXd& a) {
  std::printf("%s %g %g, %g %g;\n", way, a(0, 0), a(0, 1), a(1, 0), a(1, 1));
}

int main() {
  Eigen::SparseMatrix<double> matrix = (Eigen::MatrixXd(2, 2) << 2, 1, 1, 3).finished().sparseView(), read;
  if (Eigen::saveMarket(matrix, "eigen.mtx", Eigen::Symmetric) && Eigen::loadMarket(read, "eigen.mtx")) print("Eigen to Eigen", read);
  if (Eigen::loadMarket(read, "scipy.mtx")) print("SciPy to Eigen", read);
}
END
cat >market.py <<'END'
import subprocess
import scipy.io, scipy.sparse

scipy.io.mmwrite("scipy.mtx", scipy.sparse.coo_matrix([[2.0, 1.0], [1.0, 3.0]]))
print(subprocess.run("./program", stdout=subprocess.PIPE, text=True, check=True).stdout, end="")
(a, b), (c, d) = scipy.io.mmread("eigen.mtx").toarray()
print(f"Eigen to SciPy {a:g} {b:g}, {c:g} {d:g};")
END
compile market.cpp
look_at "$python" market.py
conclude "Eigen to Eigen 2 1, 1 3; SciPy to Eigen 2 0, 1 3; Eigen to SciPy 2 2, 2 3;" \
  "a symmetric matrix changes in a Matrix Market file between Eigen and SciPy, both ways"
