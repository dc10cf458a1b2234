#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: netcdfjs 4.0.0 (npm), and python3-netcdf4 1.6.2-1+b1 to make the file.
# Behaviour: netcdfjs gives the padding bytes behind bytes and shorts as values: three bytes become four, and a variable of three shorts a
# record has four a record, in a file of netCDF-3 with more than one record variable.
# Expected: as many values as the dimensions say. The format fills each variable, and each record of it, up to a multiple of four bytes;
# netcdfjs counts the values by the size in bytes, which includes that. With 4-byte and 8-byte types the two agree.
# Seen: the bytes 1, 2, 3 are read as 1, 2, 3, 129; the shorts 0, 1, 2 in each of two records as 0, 1, 2, -32767. What is added is the fill
# value of the type (that of bytes without its sign), so that at best it passes for missing data.
source "$(dirname "$0")/common.sh"
npm_packages netcdfjs@4.0.0
debian_packages python3-netcdf4=1.6.2-1+b1
cat >file.py <<'END'
import netCDF4

with netCDF4.Dataset("three.nc", "w", format="NETCDF3_CLASSIC") as file:
    file.createDimension("time", None)
    file.createDimension("x", 3)
    file.createVariable("time", "f8", ("time",))[:] = 0.5, 1.5
    file.createVariable("bytes", "i1", ("x",))[:] = 1, 2, 3
    file.createVariable("shorts", "i2", ("time", "x"))[:] = [[0, 1, 2]] * 2
    file.createVariable("ints", "i4", ("x",))[:] = 1, 2, 3
END
"$python" file.py || cannot_try "netCDF4 does not work"
cat >read.mjs <<'END'
import fs from 'fs';
import {NetCDFReader} from 'netcdfjs';
const file = new NetCDFReader(fs.readFileSync('three.nc'));
for (const name of ['ints', 'bytes', 'shorts']) console.log(name, file.getDataVariable(name).join() + ';');
END
look_at node read.mjs
conclude "ints 1,2,3; bytes 1,2,3,129; shorts 0,1,2,-32767,0,1,2,-32767;" "netcdfjs reads the padding of a netCDF file as values"
