#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-xarray 2023.01.0-1.1, python3-netcdf4 1.6.2-1+b1.
# Behaviour: xarray reads a variable in seconds as whole nanoseconds: 0.4 ns become 0, and what is beyond 292 years becomes some other time.
# There is no message, and a copy of the file has the new numbers too. Other words for the same unit, s for one, leave the numbers alone.
# Expected: the doubles of the file, or an error: the description of open_dataset tells that variables with units of time are made
# durations, not that they are rounded. Dates that nanoseconds cannot hold get another type, as that description says.
# Seen: 4e-10, 1.5e-9 and 1e12 in a variable in seconds are 0, 2e-09 and 3.87582e+09 in the copy; in s they are as before.
source "$(dirname "$0")/common.sh"
debian_packages python3-xarray=2023.01.0-1.1 python3-netcdf4=1.6.2-1+b1
cat >through_xarray.py <<'END'
import netCDF4
import xarray

with netCDF4.Dataset("run.nc", "w") as file:
    file.createDimension("run", 3)
    for unit in "s", "seconds":
        variable = file.createVariable(f"step_in_{unit}", "f8", ("run",))
        variable.units = unit
        variable[:] = [4e-10, 1.5e-9, 1e12]
with xarray.open_dataset("run.nc") as data:
    data.to_netcdf("copy.nc")
with netCDF4.Dataset("copy.nc") as file:
    for name, variable in file.variables.items():
        print(name, *(f"{x:g}" for x in variable[:]), variable.units, end=";\n")
END
look_at "$python" through_xarray.py
conclude "step_in_s 4e-10 1.5e-09 1e+12 s; step_in_seconds 0 2e-09 3.87582e+09 seconds;" \
  "a time step of 0.4 ns in seconds becomes 0 in xarray; in s it stays"
