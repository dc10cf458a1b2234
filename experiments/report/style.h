// SPDX-License-Identifier: MIT
#pragma once

namespace bake::report {

/// The page's style sheet: light and dark, wide and narrow, screen and paper. Nothing is loaded from anywhere.
extern const char* const k_style;

}  // namespace bake::report
