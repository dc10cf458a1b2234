// SPDX-License-Identifier: MIT
// Files beside this one that stand in the page as they are; CMake makes strings of them.
#pragma once

namespace bake::report {

extern const char* const k_style;   ///< page.css
extern const char* const k_viewer;  ///< viewer.js

}  // namespace bake::report
